#pragma once

#include "bathymetry/RasterSource.h"
#include "sim/ElevationGrid.h"

#include <array>
#include <optional>
#include <string>

namespace swellray
{

/** Elevations on the nodes of a file, and where these lie in the file's coordinates. */
struct FileGrid
{
  ElevationGrid values;         ///< position of node (i, j): (i, j); elevations in m; NaN: no data
  glm::dvec2 first{ 0.0 };      ///< file coordinates of node (0, 0)
  glm::dvec2 columnStep{ 0.0 }; ///< file coordinates, from a node to the next of its row
  glm::dvec2 rowStep{ 0.0 };    ///< from a node to the next of its column

  /** File coordinates of the place `index`, in nodes from node (0, 0). */
  glm::dvec2 toFile(const glm::dvec2& index) const;

  /** The reverse. */
  glm::dvec2 toIndex(const glm::dvec2& file) const;

  /** Rows along x and columns along y, but for rounding. */
  bool axisAligned() const;

  /** Turn the order of rows and columns of an axis-aligned grid so that x and y ascend. */
  void ascend();

  /** Smallest box around the nodes, file coordinates. */
  Rectangle extent() const;

  /** Nodes of the far corner, in nodes from node (0, 0). */
  glm::dvec2 lastIndex() const;
};

/**
 * The window of nodes in a box of file coordinates (of a rotated grid: the window around them).
 * @param crop x0, y0, x1, y1; everything where not set
 * @param longitudes true where x is a longitude: the box may count it 360 degrees off
 * @throws std::runtime_error where fewer than 4 x 4 nodes are left or the grid cannot be worked with
 */
RasterWindow selectWindow(
  const RasterHeader& header, const std::optional<std::array<double, 4>>& crop, bool longitudes);

/** @throws std::runtime_error where a grid to be read has more than MostNodes */
void limitNodes(std::size_t columns, std::size_t rows);

/** Fewest nodes along each axis: what a cubic spline needs. */
constexpr std::size_t FewestNodes = 4;

/** Most nodes of a grid, read or made: some GB of memory. */
constexpr std::size_t MostNodes = 100000000;

}
