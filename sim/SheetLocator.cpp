#include "sim/SheetLocator.h"

#include "sim/SheetWeights.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellray
{

namespace
{

// Places are looked up this share of the size of the scene beside where they are: off the corners and edges of triangles.
constexpr double NudgeShare = 1e-10;

}

SheetLocator::SheetLocator(const SurfaceSheet& sheet)
  : Sheet(sheet)
{
  const auto rayPoints = static_cast<std::int64_t>(sheet.rayPointCount());
  std::vector<std::uint32_t> triangles;
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high(-std::numeric_limits<double>::infinity());
  double area = 0.0;
  for (std::size_t t = 0; t < sheet.Triangles.size(); ++t)
  {
    const auto& triangle = sheet.Triangles[t];
    if (*std::max_element(triangle.begin(), triangle.end()) >= rayPoints)
    {
      continue; // on the beach
    }
    glm::dvec2 least(std::numeric_limits<double>::infinity());
    glm::dvec2 most(-std::numeric_limits<double>::infinity());
    for (const std::int64_t i : triangle)
    {
      const auto at = 3 * static_cast<std::size_t>(i);
      const glm::dvec2 place(sheet.Position[at], sheet.Position[at + 1]);
      least = glm::min(least, place);
      most = glm::max(most, place);
    }
    low = glm::min(low, least);
    high = glm::max(high, most);
    area += (most.x - least.x) * (most.y - least.y);
    triangles.push_back(static_cast<std::uint32_t>(t));
  }
  if (triangles.empty())
  {
    return;
  }
  this->Bounds = { low, high };
  this->Nudge = NudgeShare * glm::length(this->Bounds.size());
  // As large as the box of a triangle, but no more cells than triangles by far.
  constexpr double mostCells = 4.0;
  const glm::dvec2 size = glm::max(this->Bounds.size(), glm::dvec2(this->Nudge));
  const auto count = static_cast<double>(triangles.size());
  this->CellSize = std::sqrt(std::max(area / count, size.x * size.y / (mostCells * count)));
  this->CellSize = std::max(this->CellSize, std::max(size.x, size.y) / (mostCells * count));
  this->Columns = static_cast<std::size_t>(size.x / this->CellSize) + 1;
  this->Rows = static_cast<std::size_t>(size.y / this->CellSize) + 1;

  this->Offsets.assign(this->Columns * this->Rows + 1, 0);
  const auto forCells = [&](std::uint32_t t, const auto& visit)
  {
    const auto cells = this->cellsOf(sheet.Triangles[t]);
    for (std::size_t row = cells[2]; row <= cells[3]; ++row)
    {
      for (std::size_t column = cells[0]; column <= cells[1]; ++column)
      {
        visit(row * this->Columns + column);
      }
    }
  };
  for (const std::uint32_t t : triangles)
  {
    forCells(t, [&](std::size_t cell) { ++this->Offsets[cell + 1]; });
  }
  for (std::size_t cell = 0; cell + 1 < this->Offsets.size(); ++cell)
  {
    this->Offsets[cell + 1] += this->Offsets[cell];
  }
  this->Items.resize(this->Offsets.back());
  std::vector<std::uint32_t> next(this->Offsets.begin(), this->Offsets.end() - 1);
  for (const std::uint32_t t : triangles)
  {
    forCells(t, [&](std::size_t cell) { this->Items[next[cell]++] = t; });
  }
}

std::size_t SheetLocator::column(double x) const
{
  const double at = std::floor((x - this->Bounds.low.x) / this->CellSize);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(this->Columns - 1)));
}

std::size_t SheetLocator::row(double y) const
{
  const double at = std::floor((y - this->Bounds.low.y) / this->CellSize);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(this->Rows - 1)));
}

std::array<std::size_t, 4> SheetLocator::cellsOf(const std::array<std::int64_t, 3>& triangle) const
{
  std::array<std::size_t, 4> cells{ this->Columns, 0, this->Rows, 0 };
  for (const std::int64_t i : triangle)
  {
    const double* place = this->Sheet.Position.data() + 3 * i;
    cells[0] = std::min(cells[0], this->column(place[0] - this->Nudge));
    cells[1] = std::max(cells[1], this->column(place[0] + this->Nudge));
    cells[2] = std::min(cells[2], this->row(place[1] - this->Nudge));
    cells[3] = std::max(cells[3], this->row(place[1] + this->Nudge));
  }
  return cells;
}

void SheetLocator::find(const glm::dvec2& place, std::vector<SheetCover>& covers) const
{
  covers.clear();
  if (this->Items.empty())
  {
    return;
  }
  // Towards the middle, so that what lies on the edge of the sheet is on it, and along no edge of a regular one.
  const glm::dvec2 middle = 0.5 * (this->Bounds.low + this->Bounds.high);
  const glm::dvec2 beside(place.x + (place.x < middle.x ? this->Nudge : -this->Nudge),
    place.y + 0.7 * (place.y < middle.y ? this->Nudge : -this->Nudge));
  if (!this->Bounds.contains(beside))
  {
    return;
  }
  const std::size_t cell = this->row(beside.y) * this->Columns + this->column(beside.x);
  for (std::uint32_t i = this->Offsets[cell]; i < this->Offsets[cell + 1]; ++i)
  {
    const auto& triangle = this->Sheet.Triangles[this->Items[i]];
    const SheetWeights weights(this->Sheet.Position.data(), triangle, beside);
    if (weights.inside)
    {
      covers.push_back({ triangle, weights.weight });
    }
  }
}

}
