#include "bathymetry/EvenCells.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace swellray
{

namespace
{

constexpr double MostParts = 8.0;

// Nodes that a grid is not refined beyond.
constexpr std::size_t MostRefined = 1000000;

// Of the cells' ratios of length to width, nine tenths are smaller than that to which they are refined.
constexpr double Share = 0.9;

// A value and its place: what is interpolated.
struct Node
{
  glm::dvec2 place{ 0.0 };
  double value = 0.0;

  bool known() const { return std::isfinite(this->place.x + this->place.y + this->value); }
};

Node operator*(double factor, const Node& node)
{
  return { factor * node.place, factor * node.value };
}

Node operator+(const Node& a, const Node& b)
{
  return { a.place + b.place, a.value + b.value };
}

// Between b and c, a and d lying before and behind them; t from 0 to 1.
Node between(const Node& a, const Node& b, const Node& c, const Node& d, double t)
{
  if (!a.known() || !d.known())
  {
    return (1.0 - t) * b + t * c;
  }
  const double u = 1.0 - t;
  return -0.5 * t * u * u * a + (1.0 + t * t * (1.5 * t - 2.5)) * b + (1.0 + u * u * (1.5 * u - 2.5)) * c +
    -0.5 * u * t * t * d;
}

double quantile(std::vector<double>& values, double share)
{
  if (values.empty())
  {
    return 1.0;
  }
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Put parts - 1 nodes between any two of a row.
void refineRows(ModelGrid& grid, std::size_t parts)
{
  const Node none{ glm::dvec2(std::numeric_limits<double>::quiet_NaN()), std::numeric_limits<double>::quiet_NaN() };
  ModelGrid fine;
  fine.columns = (grid.columns - 1) * parts + 1;
  fine.values.reserve(fine.columns * grid.rows);
  fine.places.reserve(fine.columns * grid.rows);
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    const auto node = [&](std::size_t column)
    {
      const std::size_t i = row * grid.columns + column;
      return column < grid.columns ? Node{ grid.places[i], grid.values[i] } : none;
    };
    for (std::size_t column = 0; column < grid.columns; ++column)
    {
      const Node b = node(column);
      fine.places.push_back(b.place);
      fine.values.push_back(b.value);
      for (std::size_t part = 1; part < parts && column + 1 < grid.columns; ++part)
      {
        const double t = static_cast<double>(part) / static_cast<double>(parts);
        const Node made = between(column > 0 ? node(column - 1) : none, b, node(column + 1), node(column + 2), t);
        fine.places.push_back(made.place);
        fine.values.push_back(made.value);
      }
    }
  }
  grid.columns = fine.columns;
  grid.places = std::move(fine.places);
  grid.values = std::move(fine.values);
}

void turn(ModelGrid& grid)
{
  std::vector<double> values(grid.values.size());
  std::vector<glm::dvec2> places(grid.places.size());
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    for (std::size_t column = 0; column < grid.columns; ++column)
    {
      values[column * grid.rows + row] = grid.values[row * grid.columns + column];
      places[column * grid.rows + row] = grid.places[row * grid.columns + column];
    }
  }
  grid.values = std::move(values);
  grid.places = std::move(places);
  std::swap(grid.columns, grid.rows);
}

}

void evenCells(ModelGrid& grid, const std::optional<double>& nodata)
{
  NoDataMark missing;
  missing.add(nodata.value_or(std::numeric_limits<double>::quiet_NaN()), false);
  for (double& value : grid.values)
  {
    value = missing(value) ? std::numeric_limits<double>::quiet_NaN() : value;
  }
  const std::size_t nodes = grid.values.size();
  std::vector<double> longer; // length along the row over that along the column, of each cell
  std::vector<double> wider;
  for (std::size_t row = 0; row + 1 < grid.rows; ++row)
  {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column)
    {
      const glm::dvec2& corner = grid.places[row * grid.columns + column];
      const double along = glm::length(grid.places[row * grid.columns + column + 1] - corner);
      const double across = glm::length(grid.places[(row + 1) * grid.columns + column] - corner);
      if (along > 0.0 && across > 0.0 && std::isfinite(along + across))
      {
        longer.push_back(along / across);
        wider.push_back(across / along);
      }
    }
  }
  const double longest = quantile(longer, Share);
  const double widest = quantile(wider, Share);
  const double room = static_cast<double>(MostRefined) / static_cast<double>(std::max<std::size_t>(nodes, 1));
  const double parts = std::floor(std::min({ std::max(longest, widest) + 0.5, MostParts, room }));
  if (parts < 2.0)
  {
    return;
  }
  grid.spacing = soundingsOf(ModelGrid(grid)).spacing;
  const bool acrossRows = widest > longest;
  if (acrossRows)
  {
    turn(grid);
  }
  refineRows(grid, static_cast<std::size_t>(parts));
  if (acrossRows)
  {
    turn(grid);
  }
  grid.notes.push_back("its cells are longer than wide: gridded with nodes put between its own, " +
    std::to_string(grid.values.size()) + " for " + std::to_string(nodes));
}

}
