#include "PictureSeries.h"

#include "OutputFile.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <regex>

namespace swellray::cli
{

namespace
{

namespace fs = std::filesystem;

// One digit of width: nobody has a billion pictures.
const std::regex Number("%(?:0([1-9]))?d");

const char* const CommandKey = "CommandLine";
const char* const TimeKey = "Time";

std::string timeText(double time)
{
  return fmt::format("{}", time);
}

std::string textOf(vtkPNGReader* reader, const char* key)
{
  int range[2];
  reader->GetTextChunks(key, range);
  return range[1] > range[0] ? reader->GetTextValue(range[0]) : std::string();
}

}

bool isNumbered(const std::string& file)
{
  return std::regex_search(fs::path(file).filename().string(), Number);
}

std::string numberedName(const std::string& file, std::size_t number)
{
  const fs::path path(file);
  const std::string name = path.filename().string();
  std::smatch found;
  std::regex_search(name, found, Number);
  const int width = found[1].matched ? std::stoi(found[1]) : 1;
  return (path.parent_path() / fmt::format("{}{:0{}}{}", found.prefix().str(), number, width, found.suffix().str()))
    .string();
}

void writePicture(vtkImageData* picture, const PictureOrigin& origin, const OutputFile& file)
{
  vtkSmartPointer<vtkImageWriter> writer;
  if (fs::path(file.path()).extension() == ".jpg")
  {
    vtkNew<vtkJPEGWriter> jpeg;
    jpeg->SetQuality(95);
    writer = jpeg;
  }
  else
  {
    vtkNew<vtkPNGWriter> png;
    png->AddText(CommandKey, origin.commandLine.c_str());
    png->AddText(TimeKey, timeText(origin.time).c_str());
    writer = png;
  }
  writer->SetInputData(picture);
  writer->SetFileName(file.temporary().c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    file.fail("the picture could not be stored");
  }
}

bool isPictureOf(const std::string& path, const PictureOrigin& origin)
{
  std::error_code none;
  vtkNew<vtkPNGReader> reader;
  if (!fs::exists(path, none) || !reader->CanReadFile(path.c_str()))
  {
    return false;
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetErrorCode() == 0 && textOf(reader, CommandKey) == origin.commandLine &&
    textOf(reader, TimeKey) == timeText(origin.time);
}

}
