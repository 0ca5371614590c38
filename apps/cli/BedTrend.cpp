#include "BedTrend.h"

#include "sim/Angles.h"
#include "sim/LaunchLine.h"
#include "sim/SplineSeafloor.h"

#include <glm/geometric.hpp>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

namespace swellray::cli
{

std::optional<BedTrend> bedTrendOf(vtkImageData* seafloor, double waterLevel)
{
  ElevationGrid grid;
  grid.columns = static_cast<std::size_t>(seafloor->GetDimensions()[0]);
  grid.rows = static_cast<std::size_t>(seafloor->GetDimensions()[1]);
  grid.origin = { seafloor->GetOrigin()[0], seafloor->GetOrigin()[1] };
  grid.spacing = { seafloor->GetSpacing()[0], seafloor->GetSpacing()[1] };
  vtkDataArray* elevation = seafloor->GetPointData()->GetArray("Elevation");
  grid.elevation.resize(grid.columns * grid.rows);
  for (std::size_t i = 0; i < grid.elevation.size(); ++i)
  {
    grid.elevation[i] = elevation->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  const BedPlane plane = fitWetPlane(SplineSeafloor(grid), waterLevel);
  const double slope = glm::length(plane.slope);
  if (!plane.valid || slope == 0.0)
  {
    return {};
  }
  return BedTrend{ nauticalFromVector(plane.slope), slope };
}

}
