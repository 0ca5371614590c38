#include "CausticField.h"

#include "RayArrays.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

namespace swellray
{

namespace
{

constexpr const char* ArrayName = "CausticPoints";

constexpr std::array<const char*, 16> ComponentNames{ "RayId", "Number", "X", "Y", "RayDirectionX", "RayDirectionY",
  "Phase", "TravelTime", "WavenumberX", "WavenumberY", "PhaseRate", "WidthRate", "FanWavenumber", "AlongRate",
  "AlongChange" };

}

void setCaustics(vtkPolyData* rays, const std::vector<RayCaustic>& caustics)
{
  rays->GetFieldData()->RemoveArray(ArrayName);
  if (caustics.empty())
  {
    return;
  }
  constexpr int components = static_cast<int>(ComponentNames.size());
  double* values =
    addArray<vtkDoubleArray>(rays->GetFieldData(), ArrayName, static_cast<vtkIdType>(caustics.size()), components);
  vtkDataArray* array = rays->GetFieldData()->GetArray(ArrayName);
  for (int i = 0; i < components; ++i)
  {
    array->SetComponentName(i, ComponentNames[static_cast<std::size_t>(i)]);
  }
  for (const RayCaustic& caustic : caustics)
  {
    for (const double value : { static_cast<double>(caustic.ray), static_cast<double>(caustic.number),
           caustic.position.x, caustic.position.y, caustic.rayDirection.x, caustic.rayDirection.y, caustic.phase,
           caustic.travelTime, caustic.wavenumber.x, caustic.wavenumber.y, caustic.phaseRate, caustic.widthRate,
           caustic.fanWavenumber, caustic.alongRate, caustic.alongChange, caustic.scale })
    {
      *values++ = value;
    }
  }
}

RayCaustics causticsOf(vtkPolyData* rays)
{
  RayCaustics result;
  const auto count = static_cast<std::size_t>(rays->GetNumberOfCells());
  result.offsets.assign(count + 1, 0);
  vtkDataArray* array = rays->GetFieldData()->GetArray(ArrayName);
  if (!array)
  {
    return result;
  }
  if (array->GetNumberOfComponents() != static_cast<int>(ComponentNames.size()))
  {
    throw std::invalid_argument(std::string("the field data array ") + ArrayName + " of the input has " +
      std::to_string(array->GetNumberOfComponents()) + " components, not 16; give it the output of vtkSwellRayTracer");
  }
  const auto id = requireIntegers(rays->GetCellData(), "RayId", static_cast<vtkIdType>(count));
  std::unordered_map<int, std::int32_t> rayOf;
  for (std::size_t ray = 0; ray < count; ++ray)
  {
    rayOf[id->GetValue(static_cast<vtkIdType>(ray))] = static_cast<std::int32_t>(ray);
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const auto value = [&](int component) { return array->GetComponent(i, component); };
    const auto found = rayOf.find(static_cast<int>(value(0)));
    if (found == rayOf.end())
    {
      continue;
    }
    RayCaustic caustic;
    caustic.ray = found->second;
    caustic.number = static_cast<std::int32_t>(value(1));
    caustic.position = { value(2), value(3) };
    caustic.rayDirection = { value(4), value(5) };
    caustic.phase = value(6);
    caustic.travelTime = value(7);
    caustic.wavenumber = { value(8), value(9) };
    caustic.phaseRate = value(10);
    caustic.widthRate = value(11);
    caustic.fanWavenumber = value(12);
    caustic.alongRate = value(13);
    caustic.alongChange = value(14);
    caustic.scale = value(15);
    result.caustics.push_back(caustic);
    ++result.offsets[static_cast<std::size_t>(caustic.ray) + 1];
  }
  std::stable_sort(result.caustics.begin(), result.caustics.end(),
    [](const RayCaustic& a, const RayCaustic& b) { return a.ray < b.ray; });
  std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  return result;
}

}
