#include "Recorder.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

namespace swellray::view
{

namespace fs = std::filesystem;

namespace
{

vtkSmartPointer<vtkImageData> grab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetInputBufferTypeToRGB();
  filter->ReadFrontBufferOff();
  filter->ShouldRerenderOff();
  filter->Update();
  return filter->GetOutput();
}

}

Recorder::Recorder(vtkRenderWindow* window, const fs::path& folder, const std::string& name)
  : Window(window)
  , Folder(folder)
  , Name(name)
{
}

Recorder::~Recorder()
{
  this->end();
}

fs::path Recorder::freeName(const char* ending) const
{
  std::error_code none;
  int number = 1;
  fs::path path;
  do
  {
    path = this->Folder / fmt::format("{}-{}{}", this->Name, number++, ending);
  } while (fs::exists(path, none));
  return path;
}

fs::path Recorder::hiddenName(const fs::path& path) const
{
  return this->Folder / ("." + path.filename().string());
}

std::string Recorder::takePicture()
{
  const fs::path path = this->freeName(".png");
  const fs::path hidden = this->hiddenName(path);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(grab(this->Window));
  writer->SetFileName(hidden.c_str());
  writer->Write();
  std::error_code error;
  if (writer->GetErrorCode() == 0)
  {
    fs::rename(hidden, path, error);
  }
  if (writer->GetErrorCode() != 0 || error)
  {
    fs::remove(hidden, error);
    return fmt::format("cannot write {}", path.filename().string());
  }
  return fmt::format("wrote {}", path.filename().string());
}

std::string Recorder::begin()
{
  this->MoviePath = this->freeName(".ogv");
  this->Movie = vtkSmartPointer<vtkOggTheoraWriter>::New();
  this->Movie->SetFileName(this->hiddenName(this->MoviePath).c_str());
  this->Movie->SetRate(Rate);
  this->Movie->SetQuality(2);
  this->Movie->SetInputData(grab(this->Window));
  this->Movie->Start();
  // The writer opens its file with the first picture.
  this->Movie->Write();
  this->Frames = 1;
  std::copy(this->Window->GetSize(), this->Window->GetSize() + 2, this->MovieSize);
  if (this->Movie->GetError() != 0)
  {
    this->Movie = nullptr;
    std::error_code none;
    fs::remove(this->hiddenName(this->MoviePath), none);
    return fmt::format("cannot write {}", this->MoviePath.filename().string());
  }
  return fmt::format("recording {}: m ends it", this->MoviePath.filename().string());
}

bool Recorder::addFrame()
{
  if (!this->Movie || this->Window->GetSize()[0] != this->MovieSize[0] ||
    this->Window->GetSize()[1] != this->MovieSize[1])
  {
    return false;
  }
  this->Movie->SetInputData(grab(this->Window));
  this->Movie->Write();
  ++this->Frames;
  return this->Movie->GetError() == 0;
}

std::string Recorder::end()
{
  if (!this->Movie)
  {
    return {};
  }
  this->Movie->End();
  const bool whole = this->Movie->GetError() == 0;
  this->Movie = nullptr;
  const fs::path hidden = this->hiddenName(this->MoviePath);
  std::error_code error;
  if (whole)
  {
    fs::rename(hidden, this->MoviePath, error);
  }
  if (!whole || error)
  {
    fs::remove(hidden, error);
    return fmt::format("cannot write {}", this->MoviePath.filename().string());
  }
  return fmt::format(
    "wrote {}, {:.1f} s", this->MoviePath.filename().string(), static_cast<double>(this->Frames) / Rate);
}

}
