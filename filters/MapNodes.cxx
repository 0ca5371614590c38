#include "MapNodes.h"

#include "AlgorithmExecution.h"
#include "RayArrays.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

// More nodes a side are a mistake in the spacing.
constexpr double MostNodes = 100000.0;

int nodesOver(double length, double spacing)
{
  // A length that is whole spacings but for rounding keeps its last node.
  constexpr double rounding = 1e-9;
  const double nodes = std::floor(length / spacing + rounding) + 1.0;
  if (!(nodes <= MostNodes))
  {
    throw std::invalid_argument("a map of nodes " + std::to_string(spacing) + " m apart over " +
      std::to_string(length) + " m would have more than 100000 of them a side; choose a larger spacing");
  }
  return static_cast<int>(nodes);
}

}

void setMapNodes(vtkInformation* seafloor, vtkInformation* map, double spacing)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!(spacing >= 0.0) || std::isinf(spacing))
  {
    throw std::invalid_argument(
      "Spacing is " + std::to_string(spacing) + " m; it must be 0 (that of the seafloor) or more");
  }
  std::array<int, 6> extent{};
  std::array<double, 3> origin{};
  std::array<double, 3> distance{};
  seafloor->Get(Pipeline::WHOLE_EXTENT(), extent.data());
  seafloor->Get(vtkDataObject::ORIGIN(), origin.data());
  seafloor->Get(vtkDataObject::SPACING(), distance.data());
  for (int axis = 0; axis < 2; ++axis)
  {
    int& first = extent[2 * axis];
    int& last = extent[2 * axis + 1];
    origin[axis] += first * distance[axis];
    last -= first;
    first = 0;
    if (spacing > 0.0)
    {
      last = nodesOver(last * distance[axis], spacing) - 1;
      distance[axis] = spacing;
    }
  }
  map->Set(Pipeline::WHOLE_EXTENT(), extent.data(), 6);
  map->Set(vtkDataObject::ORIGIN(), origin.data(), 3);
  map->Set(vtkDataObject::SPACING(), distance.data(), 3);
  vtkDataObject::SetPointDataActiveScalarInfo(map, VTK_DOUBLE, 1);
}

MapGrid makeMapNodes(vtkInformation* info, vtkImageData* map)
{
  std::array<int, 6> extent{};
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data());
  map->SetExtent(extent.data());
  map->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  map->SetSpacing(info->Get(vtkDataObject::SPACING()));
  MapGrid grid;
  grid.columns = static_cast<std::size_t>(extent[1] + 1);
  grid.rows = static_cast<std::size_t>(extent[3] + 1);
  grid.origin = { map->GetOrigin()[0], map->GetOrigin()[1] };
  grid.spacing = { map->GetSpacing()[0], map->GetSpacing()[1] };
  return grid;
}

const double* addMapDepths(vtkImageData* map, const MapGrid& grid, const Seafloor& seafloor, double waterLevel)
{
  vtkPointData* out = map->GetPointData();
  const vtkIdType nodes = map->GetNumberOfPoints();
  double* elevation = addArray<vtkDoubleArray>(out, "Elevation", nodes);
  double* depth = addArray<vtkDoubleArray>(out, "Depth", nodes);
  parallelFor(grid.rows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t row = begin; row < end; ++row)
      {
        for (std::size_t column = 0; column < grid.columns; ++column)
        {
          const glm::dvec2 node =
            grid.origin + grid.spacing * glm::dvec2(static_cast<double>(column), static_cast<double>(row));
          const std::size_t i = row * grid.columns + column;
          elevation[i] = seafloor.isHole(node) ? std::numeric_limits<double>::quiet_NaN() : seafloor.elevation(node);
          depth[i] = waterLevel - elevation[i];
        }
      }
    });
  return depth;
}

}
