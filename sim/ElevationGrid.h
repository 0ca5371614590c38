#pragma once

#include "sim/Seafloor.h"

#include <cstddef>
#include <vector>

namespace swellray
{

/**
 * Elevations at the nodes of a regular grid.
 */
struct ElevationGrid
{
  std::size_t columns = 0;       ///< nodes along x
  std::size_t rows = 0;          ///< nodes along y
  glm::dvec2 origin{ 0.0 };      ///< position of node (0, 0), the south-west corner, m
  glm::dvec2 spacing{ 1.0 };     ///< distance of nodes, m, > 0
  std::vector<double> elevation; ///< columns x rows values, m, positive up, x fastest, south row first; NaN: a hole

  double& at(std::size_t column, std::size_t row) { return elevation[row * columns + column]; }
  double at(std::size_t column, std::size_t row) const { return elevation[row * columns + column]; }

  glm::dvec2 node(std::size_t column, std::size_t row) const
  {
    return origin + spacing * glm::dvec2(static_cast<double>(column), static_cast<double>(row));
  }

  Rectangle bounds() const { return { origin, node(columns > 0 ? columns - 1 : 0, rows > 0 ? rows - 1 : 0) }; }
};

}
