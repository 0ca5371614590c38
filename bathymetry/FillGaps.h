#pragma once

#include "sim/ElevationGrid.h"

#include <cstddef>
#include <optional>

namespace swellray
{

/** What became of the nodes without data. */
struct GapCount
{
  std::size_t filled = 0; ///< nodes
  std::size_t left = 0;   ///< nodes: holes
};

/** Width of a gap at the border of the grid, in cells, up to which it is filled unless said otherwise. */
constexpr double DefaultGapCells = 5.0;

/**
 * Fill gaps (NaN) smoothly, as fillHoles() in sim does: those enclosed by data whatever their size, those that reach
 * the border of the grid where they are nowhere wider than maxGap. Diagonal neighbours do not join two gaps. The
 * width at a node is the shorter of the gap's runs through it along the row and along the column.
 *
 * @param grid values at columns x rows nodes; the other nodes without data stay NaN
 * @param cell distance of nodes along both axes, m, > 0
 * @param maxGap m; DefaultGapCells cells where not set
 */
GapCount fillGaps(ElevationGrid& grid, const glm::dvec2& cell, const std::optional<double>& maxGap);

}
