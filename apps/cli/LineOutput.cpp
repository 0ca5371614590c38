#include "LineOutput.h"

#include "Console.h"
#include "Failure.h"
#include "FieldValues.h"
#include "OptionKinds.h"
#include "Pipeline.h"
#include "VtkFiles.h"

#include "bathymetry/LineWriter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <filesystem>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

// Vectors are left out: a field of a map is one number.
std::vector<LineField> fieldsOf(vtkDataSetAttributes* data)
{
  std::vector<LineField> fields;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (!array || array->GetNumberOfComponents() != 1)
    {
      continue;
    }
    LineField field;
    field.name = array->GetName();
    if (auto* numbers = vtkDoubleArray::SafeDownCast(array))
    {
      field.numbers = numbers->GetPointer(0);
    }
    else if (auto* integers = vtkIntArray::SafeDownCast(array))
    {
      field.integers = integers->GetPointer(0);
    }
    else if (auto* bytes = vtkUnsignedCharArray::SafeDownCast(array))
    {
      field.bytes = bytes->GetPointer(0);
    }
    else
    {
      continue;
    }
    fields.push_back(field);
  }
  return fields;
}

}

const std::vector<std::string>& lineEndings()
{
  static const std::vector<std::string> endings{ ".vtp", ".gpkg", ".geojson" };
  return endings;
}

std::vector<OptionSpec> lineOptions(OutputRequest& output)
{
  return { flag("--compress", "compress .vtp and .vti files (smaller, slower)", "Output", output.compress),
    flag("--points", "in .gpkg files also a layer of the points, with their own quantities", "Output", output.points) };
}

std::string viewerOf(const std::string& path)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".gpkg" || ending == ".geojson" ? "qgis" : "paraview";
}

void checkLines(const OutputRequest& output)
{
  const auto packed = [](const std::string& path) { return std::filesystem::path(path).extension() == ".gpkg"; };
  if (output.points && !packed(output.file) && !packed(output.crests) && !packed(output.breakerLine))
  {
    throw UsageError("--points needs a file of lines that ends in .gpkg");
  }
}

void writeLines(vtkPolyData* lines, const char* layer, const OutputFile& file, const Request& request, Console& console)
{
  const std::string ending = std::filesystem::path(file.path()).extension().string();
  if (ending == ".vtp")
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writeXml(writer, lines, file, request, console);
    return;
  }
  std::vector<std::int64_t> offsets{ 0 };
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    offsets.push_back(offsets.back() + lines->GetLines()->GetCellSize(line));
  }
  auto* positions = lines->GetPoints() ? vtkDoubleArray::SafeDownCast(lines->GetPoints()->GetData()) : nullptr;
  LineImage image;
  image.layer = layer;
  image.lines = offsets.size() - 1;
  image.offsets = offsets.data();
  image.points = positions ? positions->GetPointer(0) : nullptr;
  image.ofLines = fieldsOf(lines->GetCellData());
  image.ofPoints = fieldsOf(lines->GetPointData());
  image.place = georeferenceOf(lines);
  image.source = "Swellray " SWELLRAY_VERSION;
  image.history = request.commandLine;
  try
  {
    if (ending == ".gpkg")
    {
      writeGeoPackage(file.temporary(), image, request.output.points);
    }
    else
    {
      writeGeoJson(file.temporary(), image);
    }
  }
  catch (const std::runtime_error& error)
  {
    file.fail(error.what());
  }
}

}
