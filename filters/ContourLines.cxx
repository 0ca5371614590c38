#include "ContourLines.h"

#include "bathymetry/LevelRegions.h"

#include <vtkCellArray.h>
#include <vtkFlyingEdges2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace swellray
{

namespace
{

/** Point of a contour: it lies on the edge between two neighbouring nodes. */
struct Crossing
{
  glm::dvec2 index{ 0.0 };    // middle of the edge, in nodes
  glm::dvec2 higher{ 0.0 };   // from there to its higher node
  glm::dvec2 position{ 0.0 }; // m
  vtkIdType next = -1;        // along the line
  vtkIdType previous = -1;
};

/**
 * Where contours cross the edges of the grid: vtkFlyingEdges2D on the two values "below" and "not below", so that each
 * point it gives is the exact middle of an edge. Its own points are in single precision, which is half a metre a
 * thousand kilometres from the origin.
 */
vtkSmartPointer<vtkPolyData> edgesCrossed(const ElevationGrid& grid, double elevation, double relief)
{
  vtkNew<vtkUnsignedCharArray> above;
  above->SetNumberOfValues(static_cast<vtkIdType>(grid.elevation.size()));
  const std::vector<std::uint8_t> sides = sidesOfLevel(grid, elevation, relief);
  std::copy(sides.begin(), sides.end(), above->GetPointer(0));
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(grid.columns), static_cast<int>(grid.rows), 1);
  image->GetPointData()->SetScalars(above);
  vtkNew<vtkFlyingEdges2D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.5);
  edges->ComputeScalarsOff();
  edges->Update();
  return edges->GetOutput();
}

Crossing crossingAt(const ElevationGrid& grid, double elevation, const glm::dvec2& middle)
{
  const glm::dvec2 low = glm::floor(middle);
  const glm::dvec2 high = glm::ceil(middle);
  const double lowElevation = grid.at(static_cast<std::size_t>(low.x), static_cast<std::size_t>(low.y));
  const double highElevation = grid.at(static_cast<std::size_t>(high.x), static_cast<std::size_t>(high.y));
  Crossing crossing;
  crossing.index = middle;
  crossing.higher = lowElevation >= elevation ? low - middle : high - middle;
  const double share = (elevation - lowElevation) / (highElevation - lowElevation);
  crossing.position = grid.origin + grid.spacing * (low + share * (high - low));
  return crossing;
}

bool touchesHole(const ElevationGrid& grid, const glm::dvec2& inCell)
{
  const auto column = static_cast<std::size_t>(inCell.x);
  const auto row = static_cast<std::size_t>(inCell.y);
  return std::isnan(
    grid.at(column, row) + grid.at(column + 1, row) + grid.at(column, row + 1) + grid.at(column + 1, row + 1));
}

void follow(std::vector<Crossing>& crossings, std::size_t start, LineSet& lines)
{
  const std::size_t first = lines.points.size();
  auto at = static_cast<vtkIdType>(start);
  do
  {
    Crossing& crossing = crossings[static_cast<std::size_t>(at)];
    // Where a node has just this elevation the line crosses several edges in one place.
    if (lines.points.size() == first || lines.points.back() != crossing.position)
    {
      lines.points.push_back(crossing.position);
    }
    at = crossing.next;
    crossing.next = -1;
  } while (at >= 0);
  if (lines.points.size() - first > 1)
  {
    lines.offsets.push_back(lines.points.size());
  }
  else
  {
    lines.points.resize(first);
  }
}

}

void addContourLines(const ElevationGrid& grid, double elevation, double relief, LineSet& lines)
{
  const vtkSmartPointer<vtkPolyData> edges = edgesCrossed(grid, elevation, relief);
  std::vector<Crossing> crossings(static_cast<std::size_t>(edges->GetNumberOfPoints()));
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    double middle[3];
    edges->GetPoint(static_cast<vtkIdType>(i), middle);
    crossings[i] = crossingAt(grid, elevation, { middle[0], middle[1] });
  }

  vtkCellArray* segments = edges->GetLines();
  for (vtkIdType cell = 0; cell < segments->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ends = nullptr;
    segments->GetCellAtId(cell, size, ends);
    vtkIdType from = ends[0];
    vtkIdType to = ends[1];
    const Crossing& a = crossings[static_cast<std::size_t>(from)];
    const glm::dvec2 along = crossings[static_cast<std::size_t>(to)].index - a.index;
    if (touchesHole(grid, a.index + 0.5 * along))
    {
      continue;
    }
    if (along.x * a.higher.y - along.y * a.higher.x < 0.0)
    {
      std::swap(from, to);
    }
    crossings[static_cast<std::size_t>(from)].next = to;
    crossings[static_cast<std::size_t>(to)].previous = from;
  }

  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    if (crossings[i].previous < 0 && crossings[i].next >= 0)
    {
      follow(crossings, i, lines);
    }
  }
  // What is left is closed.
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    if (crossings[i].next >= 0)
    {
      follow(crossings, i, lines);
    }
  }
}

}
