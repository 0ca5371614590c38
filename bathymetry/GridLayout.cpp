#include "bathymetry/GridLayout.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/Text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

// Nodes at equal distances that fit a length.
std::size_t nodesIn(double length, double spacing)
{
  constexpr double rounding = 1e-9;
  const double steps = std::floor(length / spacing * (1.0 + rounding) + rounding);
  return steps < static_cast<double>(MostNodes) ? static_cast<std::size_t>(std::max(0.0, steps)) + 1 : MostNodes + 1;
}

}

ElevationGrid layOutGrid(const Rectangle& box, const glm::dvec2& spacing, bool centred)
{
  ElevationGrid grid;
  grid.spacing = spacing;
  grid.columns = nodesIn(box.size().x, spacing.x);
  grid.rows = nodesIn(box.size().y, spacing.y);
  const std::string size =
    text(spacing.x) + " x " + text(spacing.y) + " m on " + text(box.size().x) + " x " + text(box.size().y) + " m";
  if (grid.columns < FewestNodes || grid.rows < FewestNodes)
  {
    throw std::runtime_error("a grid of " + size + " has fewer than 4 x 4 nodes; choose a smaller --resample");
  }
  if (grid.columns > MostNodes / grid.rows)
  {
    throw std::runtime_error("a grid of " + size + " has more than " + std::to_string(MostNodes / 1000000) +
      " million nodes; choose a larger --resample or a --crop");
  }
  const glm::dvec2 covered =
    spacing * glm::dvec2(static_cast<double>(grid.columns - 1), static_cast<double>(grid.rows - 1));
  grid.origin = box.low + (centred ? 0.5 * (box.size() - covered) : glm::dvec2(0.0));
  grid.elevation.resize(grid.columns * grid.rows);
  return grid;
}

}
