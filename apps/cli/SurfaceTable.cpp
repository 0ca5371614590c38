#include "SurfaceTable.h"

#include "Console.h"
#include "FieldValues.h"
#include "Pipeline.h"

#include <fmt/format.h>

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <fstream>

namespace swellray::cli
{

namespace
{

void setTimes(vtkPolyData* places, const std::vector<double>& times)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Time");
  array->SetNumberOfValues(static_cast<vtkIdType>(times.size()));
  std::copy(times.begin(), times.end(), array->GetPointer(0));
  places->GetPointData()->AddArray(array);
}

// Components of vectors as columns of their own.
void addColumn(vtkPointData* values, const char* vector, int component, const char* name)
{
  vtkDataArray* array = values->GetArray(vector);
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  column->SetNumberOfValues(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    column->SetValue(i, array->GetComponent(i, component));
  }
  values->AddArray(column);
}

}

void writeSurfaceTable(Pipeline& pipeline, const StationTable& points, vtkDataObject* scene, const OutputFile& file,
  const Request& request, Console& console)
{
  const vtkSmartPointer<vtkPolyData> places = points.places(georeferenceOf(scene));
  const bool own = !points.times().empty();
  std::vector<double> times(1, request.surface.time.value_or(0.0));
  if (request.surface.times)
  {
    times.resize(request.surface.times->count());
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      times[i] = request.surface.times->at(i);
    }
  }
  std::vector<std::string> columns{ "SurfaceElevation", "NormalX", "NormalY", "NormalZ", "VelocityX", "VelocityY",
    "VelocityZ", "Depth", "Foam", "Breaking", "Waves" };
  if (!own)
  {
    columns.insert(columns.begin(), "Time");
  }
  std::ofstream table(file.temporary(), std::ios::trunc);
  table << points.heading(columns) << '\n';
  std::size_t dry = 0;
  for (std::size_t frame = 0; frame < (own ? 1 : times.size()); ++frame)
  {
    setTimes(places, own ? points.times() : std::vector<double>(points.size(), times[frame]));
    vtkPointData* values = pipeline.probeSurface(places)->GetPointData();
    for (int c = 0; c < 3; ++c)
    {
      addColumn(values, "Normals", c, columns[columns.size() - 10 + static_cast<std::size_t>(c)].c_str());
      addColumn(values, "Velocity", c, columns[columns.size() - 7 + static_cast<std::size_t>(c)].c_str());
    }
    std::size_t without = 0;
    for (const std::string& row : points.rows(values, columns, "SurfaceElevation", without))
    {
      table << row << '\n';
    }
    dry = std::max(dry, without);
    console.progress("surface", static_cast<double>(frame + 1) / static_cast<double>(own ? 1 : times.size()));
  }
  console.endProgress();
  table.close();
  if (!table)
  {
    file.fail("the disk is full, or files may not get so large");
  }
  console.say(fmt::format(
    "points   {} at {} times", points.size(), own ? std::string("their own") : std::to_string(times.size())));
  if (dry > 0)
  {
    console.warn(fmt::format(
      "no wave came to {} of {} points of '{}': their fields are empty", dry, points.size(), request.surface.at));
  }
}

}
