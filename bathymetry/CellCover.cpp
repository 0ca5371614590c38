#include "bathymetry/CellCover.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace swellray
{

namespace
{

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

// Corners of a cell; empty where one of them has no data.
void cellAt(std::size_t cell, const std::vector<glm::dvec2>& corners, const std::vector<std::size_t>& offsets,
  const std::vector<std::uint32_t>& nodes, std::vector<glm::dvec2>& polygon)
{
  polygon.clear();
  for (std::size_t i = offsets[cell]; i < offsets[cell + 1]; ++i)
  {
    polygon.push_back(corners[nodes[i]]);
    if (std::isnan(polygon.back().x + polygon.back().y))
    {
      polygon.clear();
      return;
    }
  }
}

double distanceToEdge(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
  const glm::dvec2 edge = b - a;
  const double square = glm::dot(edge, edge);
  const double along = square > 0.0 ? std::clamp(glm::dot(p - a, edge) / square, 0.0, 1.0) : 0.0;
  return glm::length(p - a - along * edge);
}

bool covers(const std::vector<glm::dvec2>& polygon, const glm::dvec2& p, double rim)
{
  bool inside = false;
  for (std::size_t i = 0, before = polygon.size() - 1; i < polygon.size(); before = i++)
  {
    const glm::dvec2& a = polygon[before];
    const glm::dvec2& b = polygon[i];
    if (distanceToEdge(p, a, b) <= rim)
    {
      return true;
    }
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
    {
      inside = !inside;
    }
  }
  return inside;
}

}

std::vector<bool> cellCover(const ElevationGrid& grid, const std::vector<glm::dvec2>& corners,
  const std::vector<std::size_t>& offsets, const std::vector<std::uint32_t>& nodes)
{
  constexpr double rimOfSpacing = 1e-6;
  const double rim = rimOfSpacing * std::min(grid.spacing.x, grid.spacing.y);
  const glm::dvec2 last = glm::dvec2(static_cast<double>(grid.columns), static_cast<double>(grid.rows)) - 1.0;
  std::vector<bool> covered(grid.columns * grid.rows, false);
  std::vector<glm::dvec2> polygon;
  for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell)
  {
    cellAt(cell, corners, offsets, nodes, polygon);
    if (polygon.empty())
    {
      continue;
    }
    glm::dvec2 low = polygon.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& corner : polygon)
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    const glm::dvec2 from = glm::max(glm::ceil((low - rim - grid.origin) / grid.spacing), glm::dvec2(0.0));
    const glm::dvec2 to = glm::min(glm::floor((high + rim - grid.origin) / grid.spacing), last);
    for (double row = from.y; row <= to.y; row += 1.0)
    {
      for (double column = from.x; column <= to.x; column += 1.0)
      {
        const std::size_t node = static_cast<std::size_t>(row) * grid.columns + static_cast<std::size_t>(column);
        if (!covered[node] && covers(polygon, grid.origin + grid.spacing * glm::dvec2(column, row), rim))
        {
          covered[node] = true;
        }
      }
    }
  }
  return covered;
}

double cellArea(const std::vector<glm::dvec2>& corners, const std::vector<std::size_t>& offsets,
  const std::vector<std::uint32_t>& nodes)
{
  double area = 0.0;
  std::vector<glm::dvec2> polygon;
  for (std::size_t cell = 0; cell + 1 < offsets.size(); ++cell)
  {
    cellAt(cell, corners, offsets, nodes, polygon);
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    {
      twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    }
    area += 0.5 * std::abs(twice);
  }
  return area;
}

}
