#include "RayValues.h"

#include "Console.h"
#include "FilterRun.h"

#include <fmt/format.h>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSwellMap.h>
#include <vtkSwellStations.h>

namespace swellray::cli
{

namespace
{

// Share of the nodes in water that no ray reaches.
void sayCoverage(vtkImageData* map, const Console& console)
{
  vtkDataArray* depth = map->GetPointData()->GetArray("Depth");
  vtkDataArray* count = map->GetPointData()->GetArray("RayCount");
  vtkIdType wet = 0;
  vtkIdType covered = 0;
  vtkIdType crossed = 0;
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    wet += depth->GetComponent(i, 0) > 0.0 ? 1 : 0;
    covered += count->GetComponent(i, 0) > 0.0 ? 1 : 0;
    crossed += count->GetComponent(i, 0) > 1.0 ? 1 : 0;
  }
  const auto share = [=](vtkIdType part)
  { return wet > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(wet) : 0.0; };
  const int* size = map->GetDimensions();
  console.say(
    fmt::format("map      {} x {} nodes {:.4g} m apart; rays reach {:.3g} % of those in water, several {:.3g} %",
      size[0], size[1], map->GetSpacing()[0], share(covered), share(crossed)));
}

}

vtkSmartPointer<vtkImageData> mapOfRays(
  vtkPolyData* rays, vtkImageData* seafloor, const Request& request, Console& console)
{
  vtkNew<vtkSwellMap> filter;
  filter->SetInputData(0, rays);
  filter->SetInputData(1, seafloor);
  filter->SetWaterLevel(request.seafloor.options.waterLevel);
  filter->SetSpacing(request.map.spacing.value_or(0.0));
  filter->SetCombineRule(request.map.combine == CombineRule::Phase ? vtkSwellMap::PHASE : vtkSwellMap::ENERGY);
  runFilter(filter, "map", console);
  sayCoverage(filter->GetOutput(), console);
  return filter->GetOutput();
}

const std::vector<std::string>& stationColumns()
{
  static const std::vector<std::string> columns{ "Elevation", "Depth", "WaveHeight", "DirectionFrom", "Wavelength",
    "Breaking", "LeeRay", "RayCount" };
  return columns;
}

vtkSmartPointer<vtkPolyData> wavesAt(
  vtkPolyData* places, vtkPolyData* rays, vtkImageData* seafloor, const Request& request, Console& console)
{
  vtkNew<vtkSwellStations> filter;
  filter->SetInputData(0, rays);
  filter->SetInputData(1, seafloor);
  filter->SetInputData(2, places);
  filter->SetWaterLevel(request.seafloor.options.waterLevel);
  filter->SetCombineRule(
    request.map.combine == CombineRule::Phase ? vtkSwellStations::PHASE : vtkSwellStations::ENERGY);
  runFilter(filter, "stations", console);
  return filter->GetOutput();
}

}
