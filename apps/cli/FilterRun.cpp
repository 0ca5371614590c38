#include "FilterRun.h"

#include "Failure.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <mutex>

namespace swellray::cli
{

namespace
{

// Takes what no observer caught: of use only where a filter fails without a word of its own.
class SilentWindow : public vtkOutputWindow
{
public:
  static SilentWindow* New();
  vtkTypeMacro(SilentWindow, vtkOutputWindow)
  void DisplayText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->First.empty())
    {
      this->First = text;
    }
  }
  std::string words()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->First;
  }

private:
  std::mutex Mutex;
  std::string First;
};
vtkStandardNewMacro(SilentWindow);

// "ERROR: In file, line n\nvtkClass (0x...): words\n\n" to the words, on one line.
std::string wordsOf(const std::string& message)
{
  const auto mark = message.find("): ");
  std::string words = mark == std::string::npos ? message : message.substr(mark + 3);
  while (!words.empty() && (words.back() == '\n' || words.back() == ' '))
  {
    words.pop_back();
  }
  std::replace(words.begin(), words.end(), '\n', ' ');
  return words;
}

class FilterWatch : public vtkCommand
{
public:
  static FilterWatch* New() { return new FilterWatch; }

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    switch (event)
    {
    case vtkCommand::ErrorEvent:
      if (this->Error.empty())
      {
        this->Error = wordsOf(static_cast<const char*>(data));
      }
      break;
    case vtkCommand::WarningEvent:
      this->Screen->warn(wordsOf(static_cast<const char*>(data)));
      break;
    default:
      this->Screen->progress(this->Task, static_cast<vtkAlgorithm*>(caller)->GetProgress());
    }
  }

  Console* Screen = nullptr;
  std::string Task;
  std::string Error;
};

}

void silenceVtk()
{
  vtkNew<SilentWindow> window;
  vtkOutputWindow::SetInstance(window);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

void runFilter(vtkAlgorithm* filter, const std::string& task, Console& console)
{
  vtkNew<FilterWatch> watch;
  watch->Screen = &console;
  watch->Task = task;
  const unsigned long observers[] = { filter->AddObserver(vtkCommand::ErrorEvent, watch),
    filter->AddObserver(vtkCommand::WarningEvent, watch), filter->AddObserver(vtkCommand::ProgressEvent, watch) };
  const int done = filter->GetExecutive()->Update();
  for (const unsigned long observer : observers)
  {
    filter->RemoveObserver(observer);
  }
  console.endProgress();
  if (!watch->Error.empty())
  {
    throw WorkError(watch->Error);
  }
  if (!done)
  {
    auto* window = SilentWindow::SafeDownCast(vtkOutputWindow::GetInstance());
    throw WorkError(task + " failed: " + (window ? wordsOf(window->words()) : std::string()));
  }
}

}
