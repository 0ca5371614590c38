#include "PictureSeries.h"

#include "Failure.h"
#include "OutputFile.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

namespace swellray::cli
{

namespace
{

namespace fs = std::filesystem;

/** Where a file's name counts: %d, or %0Nd with N digits. One digit of width: nobody has a billion pictures. */
struct NumberField
{
  std::size_t begin = std::string::npos;
  std::size_t end = std::string::npos;
  int width = 1;
};

NumberField findNumber(const std::string& name)
{
  for (std::size_t i = name.find('%'); i != std::string::npos; i = name.find('%', i + 1))
  {
    if (name.compare(i + 1, 1, "d") == 0)
    {
      return { i, i + 2, 1 };
    }
    const std::string digits = name.substr(i + 1, 3);
    if (digits.size() == 3 && digits[0] == '0' && digits[1] >= '1' && digits[1] <= '9' && digits[2] == 'd')
    {
      return { i, i + 4, digits[1] - '0' };
    }
  }
  return {};
}

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
  return findNumber(fs::path(file).filename().string()).begin != std::string::npos;
}

std::string numberedName(const std::string& file, std::size_t number)
{
  const fs::path path(file);
  const std::string name = path.filename().string();
  const NumberField field = findNumber(name);
  return (path.parent_path() /
    fmt::format("{}{:0{}}{}", name.substr(0, field.begin), number, field.width, name.substr(field.end)))
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

std::string pictureCommand(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    throw WorkError(fmt::format("cannot read '{}': it is no .png picture, or damaged", path));
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return textOf(reader, CommandKey);
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
