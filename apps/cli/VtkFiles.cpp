#include "VtkFiles.h"

#include "Failure.h"
#include "FieldValues.h"
#include "FilterRun.h"

#include <fmt/format.h>

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLWriter.h>

#include <filesystem>
#include <fstream>

namespace swellray::cli
{

namespace
{

// vtkXMLWriter does not notice every failed write, so look for the end of the file.
bool isComplete(const std::string& path)
{
  const std::string ending = "</VTKFile>";
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  constexpr std::streamoff Tail = 32;
  if (!file || size < Tail)
  {
    return false;
  }
  std::string tail(static_cast<std::size_t>(Tail), '\0');
  file.seekg(size - Tail);
  file.read(tail.data(), Tail);
  return file.good() && tail.find(ending) != std::string::npos;
}

template <typename Reader>
auto readFile(const std::string& path, const char* ending, Console& console)
{
  if (!std::ifstream(path).good())
  {
    throw WorkError(fmt::format("cannot read '{}': no such file, or it may not be read", path));
  }
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  try
  {
    runFilter(reader, "reading", console);
  }
  catch (const WorkError&)
  {
    throw WorkError(fmt::format("cannot read '{}': it is no {} file, or damaged", path, ending));
  }
  return vtkSmartPointer(reader->GetOutput());
}

}

void writeXml(
  vtkXMLWriter* writer, vtkDataObject* data, const OutputFile& file, const Request& request, Console& console)
{
  setFieldText(data, "CommandLine", request.commandLine);
  setFieldText(data, "SwellrayVersion", SWELLRAY_VERSION);
  writer->SetInputData(data);
  writer->SetFileName(file.temporary().c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  if (request.output.compress)
  {
    writer->SetCompressorTypeToZLib();
  }
  else
  {
    writer->SetCompressorTypeToNone();
  }
  std::string reason;
  try
  {
    runFilter(writer, "writing", console);
  }
  catch (const WorkError& error)
  {
    reason = error.what();
  }
  const unsigned long code = writer->GetErrorCode();
  if (code != vtkErrorCode::NoError)
  {
    // VTK takes every write that fails for a full disk.
    reason = code == vtkErrorCode::OutOfDiskSpaceError ? "the disk is full, or files may not get so large"
                                                       : vtkErrorCode::GetStringFromErrorCode(code);
  }
  if (!reason.empty() || !isComplete(file.temporary()))
  {
    file.fail(reason.empty() ? "the file is not complete" : reason);
  }
}

vtkSmartPointer<vtkPolyData> readLines(const std::string& path, Console& console)
{
  return readFile<vtkXMLPolyDataReader>(path, ".vtp", console);
}

vtkSmartPointer<vtkDataSet> readFrame(const std::string& path, Console& console)
{
  if (std::filesystem::path(path).extension() == ".vti")
  {
    return readImage(path, console);
  }
  return readLines(path, console);
}

vtkSmartPointer<vtkImageData> readImage(const std::string& path, Console& console)
{
  return readFile<vtkXMLImageDataReader>(path, ".vti", console);
}

}
