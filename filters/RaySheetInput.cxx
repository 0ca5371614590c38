#include "RaySheetInput.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <stdexcept>

namespace swellray
{

namespace
{

vtkSmartPointer<vtkDoubleArray> doubleTriples(vtkDataArray* array, vtkIdType n, const char* name)
{
  if (!array || array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != n)
  {
    throw std::invalid_argument(
      std::string("the input has no array ") + name + " of three components; give it the output of vtkSwellRayTracer");
  }
  if (auto* doubles = vtkDoubleArray::FastDownCast(array))
  {
    return doubles;
  }
  auto copy = vtkSmartPointer<vtkDoubleArray>::New();
  copy->DeepCopy(array);
  return copy;
}

template <typename Array, typename Value>
void copyOut(const std::vector<Value>& values, vtkFieldData* attributes, const char* name)
{
  std::copy(values.begin(), values.end(), addArray<Array>(attributes, name, static_cast<vtkIdType>(values.size())));
}

}

SheetArrays::SheetArrays(vtkPolyData* rays)
  : Offsets(rayOffsets(rays))
{
  const auto hold = [this](const auto& array)
  {
    this->Held.push_back(array);
    return array->GetPointer(0);
  };
  const vtkIdType points = rays->GetNumberOfPoints();
  const auto count = static_cast<vtkIdType>(this->Offsets.size() - 1);
  vtkPointData* ofPoints = rays->GetPointData();
  vtkCellData* ofRays = rays->GetCellData();
  SheetRays& arrays = this->Rays;
  arrays.lines.rays = this->Offsets.size() - 1;
  arrays.lines.offsets = this->Offsets.data();
  if (points > 0)
  {
    arrays.lines.positions = hold(doubleTriples(rays->GetPoints()->GetData(), points, "of points"));
  }
  if (const auto scale = mapScaleOf(rays))
  {
    arrays.lines.scale = hold(scale);
  }
  arrays.lines.phase = hold(requireDoubles(ofPoints, "Phase", points));
  arrays.lines.launchParameter = hold(requireDoubles(ofRays, "LaunchParameter", count));
  arrays.lines.launchSegment = hold(requireIntegers(ofRays, "LaunchSegment", count));
  arrays.parent = hold(requireIntegers(ofRays, "ParentRay", count));
  arrays.lee = hold(requireBytes(ofRays, "LeeRay", count));
  if (ofRays->GetArray("Reflections"))
  {
    arrays.reflections = hold(requireIntegers(ofRays, "Reflections", count));
  }
  this->Walls = obstaclesOf(rays);
  arrays.obstacles = this->Walls.get();
  if (this->Walls || ofRays->GetArray("EndReason"))
  {
    arrays.endReason = hold(requireBytes(ofRays, "EndReason", count));
  }
  arrays.direction = hold(doubleTriples(ofPoints->GetArray("Direction"), points, "Direction"));
  arrays.wavenumber = hold(requireDoubles(ofPoints, "Wavenumber", points));
  arrays.height = hold(requireDoubles(ofPoints, "WaveHeight", points));
  arrays.caustics = hold(requireIntegers(ofPoints, "Caustics", points));
  arrays.breaking = hold(requireBytes(ofPoints, "Breaking", points));
  arrays.state = hold(requireBytes(ofPoints, "RayState", points));
  if (fieldString(rays, "CausticRule").value_or("cap") != "cap")
  {
    arrays.refraction = hold(requireDoubles(ofPoints, "RefractionCoefficient", points));
    arrays.tubeWidth = hold(requireDoubles(ofPoints, "TubeWidth", points));
    this->Touched = causticsOf(rays).caustics;
    arrays.touched = this->Touched.data();
    arrays.touchedCount = this->Touched.size();
  }
}

RaySheetInput::RaySheetInput(vtkPolyData* rays)
  : Arrays(rays)
  , Sheets(this->Arrays.rays(), fieldValue(rays, "MaxSpacing").value_or(0.0))
{
}

std::vector<double> RaySheetInput::wetDepths(const std::vector<glm::dvec2>& places, const double* depths) const
{
  std::vector<double> wet(depths, depths + places.size());
  const Obstacles* walls = this->Arrays.obstacles();
  parallelFor(walls ? places.size() : 0,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        wet[i] = walls->inside(places[i]) ? 0.0 : wet[i];
      }
    });
  return wet;
}

void addMapArrays(vtkFieldData* attributes, const RayMap& map)
{
  copyOut<vtkDoubleArray>(map.height, attributes, "WaveHeight");
  copyOut<vtkDoubleArray>(map.directionFrom, attributes, "DirectionFrom");
  copyOut<vtkDoubleArray>(map.wavelength, attributes, "Wavelength");
  copyOut<vtkUnsignedCharArray>(map.breaking, attributes, "Breaking");
  copyOut<vtkUnsignedCharArray>(map.lee, attributes, "LeeRay");
  copyOut<vtkIntArray>(map.count, attributes, "RayCount");
}

}
