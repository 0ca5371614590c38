#include "SurfaceCut.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace swellray::drawing
{

namespace
{

/** A corner of a triangle as the line sees it. */
struct Corner
{
  vtkIdType id = 0;
  double along = 0.0;
  double aside = 0.0;
  double up = 0.0;
  double foam = 0.0;
};

/** Along, up and foam where an edge meets the plane: the same from either of its triangles. */
glm::dvec3 crossing(Corner a, Corner b)
{
  if (a.id > b.id)
  {
    std::swap(a, b);
  }
  const double w = a.aside / (a.aside - b.aside);
  return { a.along + w * (b.along - a.along), a.up + w * (b.up - a.up), a.foam + w * (b.foam - a.foam) };
}

}

double CutLine::length() const
{
  return glm::distance(this->from, this->to);
}

std::vector<CutSegment> cutSurface(vtkPolyData* surface, const CutLine& line)
{
  const double length = line.length();
  if (!(length > 0.0))
  {
    throw std::invalid_argument("a line to cut along needs a length above 0");
  }
  const glm::dvec2 forward = (line.to - line.from) / length;
  const glm::dvec2 left(-forward.y, forward.x);
  vtkDataArray* foam = surface->GetPointData()->GetArray("Foam");
  const auto corner = [&](vtkIdType id)
  {
    double p[3];
    surface->GetPoint(id, p);
    const glm::dvec2 way = glm::dvec2(p[0], p[1]) - line.from;
    return Corner{ id, glm::dot(way, forward), glm::dot(way, left), p[2], foam ? foam->GetTuple1(id) : 0.0 };
  };
  std::vector<CutSegment> segments;
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    if (count != 3)
    {
      continue;
    }
    const std::array<Corner, 3> corners{ corner(ids[0]), corner(ids[1]), corner(ids[2]) };
    // A corner on the plane counts to its left side, so that the pieces of neighbours still meet.
    std::array<glm::dvec3, 2> ends{};
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Corner& a = corners[i];
      const Corner& b = corners[(i + 1) % 3];
      if ((a.aside >= 0.0) != (b.aside >= 0.0))
      {
        ends[found++] = crossing(a, b);
      }
    }
    if (found == 2)
    {
      segments.push_back(
        { { ends[0].x, ends[0].y }, { ends[1].x, ends[1].y }, std::clamp(0.5 * (ends[0].z + ends[1].z), 0.0, 1.0) });
    }
  }
  return segments;
}

std::vector<double> cutSeafloor(vtkImageData* seafloor, const CutLine& line, int count)
{
  double bounds[6];
  seafloor->GetBounds(bounds);
  const double* origin = seafloor->GetOrigin();
  const double* spacing = seafloor->GetSpacing();
  const int* size = seafloor->GetDimensions();
  vtkDataArray* elevation = seafloor->GetPointData()->GetArray("Elevation");
  std::vector<double> values(static_cast<std::size_t>(count), std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec2 place = line.from + (i / std::max(1.0, count - 1.0)) * (line.to - line.from);
    if (place.x < bounds[0] || place.x > bounds[1] || place.y < bounds[2] || place.y > bounds[3])
    {
      continue;
    }
    const auto cell = [&](double at, int axis, double& share)
    {
      const double node = (at - origin[axis]) / spacing[axis];
      const int low = std::clamp(static_cast<int>(std::floor(node)), 0, std::max(0, size[axis] - 2));
      share = std::clamp(node - low, 0.0, 1.0);
      return low;
    };
    double u = 0.0;
    double v = 0.0;
    const int column = cell(place.x, 0, u);
    const int row = cell(place.y, 1, v);
    const auto at = [&](int dx, int dy)
    { return elevation->GetTuple1((row + dy) * static_cast<vtkIdType>(size[0]) + column + dx); };
    values[static_cast<std::size_t>(i)] =
      (1.0 - v) * ((1.0 - u) * at(0, 0) + u * at(1, 0)) + v * ((1.0 - u) * at(0, 1) + u * at(1, 1));
  }
  return values;
}

}
