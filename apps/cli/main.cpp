#include "CommandLine.h"
#include "Commands.h"
#include "Failure.h"
#include "FilterRun.h"
#include "OutputFile.h"

#include <vtkSMPTools.h>

#include <cstdio>
#include <exception>
#include <new>

namespace
{

using namespace swellray::cli;

void run(const Request& request)
{
  if (request.threads > 0)
  {
    vtkSMPTools::Initialize(request.threads);
  }
  Console console(request.quiet);
  switch (request.command)
  {
  case Command::Info:
    runInfo(request, console);
    break;
  case Command::Contour:
    runContour(request, console);
    break;
  case Command::Trace:
    runTrace(request, console);
    break;
  case Command::List:
    runList();
    break;
  case Command::Render:
    runRender(request, console);
    break;
  case Command::Validate:
    runValidate(request, console);
    break;
  }
}

int report(const char* message, int code)
{
  std::fprintf(stderr, "swellray: %s\n", message);
  return code;
}

}

int main(int argc, char** argv)
{
  try
  {
    installSignalHandlers();
    silenceVtk();
    const auto request = readCommandLine(argc, argv);
    if (request)
    {
      run(*request);
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
    {
      return report("cannot write to the standard output", WorkFailed);
    }
    return Done;
  }
  catch (const UsageError& error)
  {
    return report(error.what(), WrongCall);
  }
  catch (const std::bad_alloc&)
  {
    return report(
      "out of memory: take a part of the seafloor with --crop, or a coarser one with --resample", WorkFailed);
  }
  catch (const std::exception& error)
  {
    return report(error.what(), WorkFailed);
  }
}
