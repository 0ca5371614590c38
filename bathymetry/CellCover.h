#pragma once

#include "sim/ElevationGrid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/**
 * Which nodes of a grid lie in a cell of a mesh, or on its rim (to a millionth of the grid's spacing).
 *
 * @param grid its nodes
 * @param corners n points in the grid's coordinates; NaN: a corner that makes its cells cover nothing
 * @param offsets m + 1 values; cell c has the corners nodes[offsets[c]] to nodes[offsets[c + 1] - 1], in order
 * @param nodes indices into corners
 * @return columns x rows flags, as the elevations of the grid
 */
std::vector<bool> cellCover(const ElevationGrid& grid, const std::vector<glm::dvec2>& corners,
  const std::vector<std::size_t>& offsets, const std::vector<std::uint32_t>& nodes);

/** Area of all cells that cover something. */
double cellArea(const std::vector<glm::dvec2>& corners, const std::vector<std::size_t>& offsets,
  const std::vector<std::uint32_t>& nodes);

}
