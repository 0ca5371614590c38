#pragma once

#include "bathymetry/RasterSource.h"
#include "bathymetry/Soundings.h"

#include <glm/vec2.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace swellray
{

/**
 * Values on the nodes of a wave or flow model's grid, as its files give them: rows of nodes that lie evenly (a regular
 * grid, which may be rotated), or each at a place of its own (a curvilinear grid).
 */
struct ModelGrid
{
  std::string format;   ///< of the files, e.g. "SWAN"
  std::string variable; ///< of the values, may be empty
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> values; ///< columns x rows, first row first, as stored; NaN: none

  std::vector<glm::dvec2> places; ///< of a curvilinear grid: columns x rows, file coordinates; NaN: no node there
  std::optional<double> spacing;  ///< nominal distance of these nodes; fineSpacing() where not set
  glm::dvec2 first{ 0.0 };        ///< of a regular one (no places): that of node (0, 0)
  glm::dvec2 columnStep{ 0.0 };   ///< from a node to the next of its row
  glm::dvec2 rowStep{ 0.0 };      ///< from a node to the next of its column

  std::string crs; ///< anything GDAL takes, empty where there is none
  std::string crsSource;
  VerticalMetadata vertical;
  std::vector<std::string> notes;
  std::vector<std::string> files; ///< that it was read from

  /** Lay the columns along `azimuth` (degrees anticlockwise from x), the rows a quarter turn to their left. */
  void layOut(const glm::dvec2& origin, double azimuth, double columnSpacing, double rowSpacing);

  /**
   * Make a grid of places regular where each node lies within a fiftieth of a cell of where even steps between the
   * corners would have it (coordinates are often rounded).
   * @return false where it is not
   */
  bool makeRegular();
};

/** A regular model grid as a raster. */
std::unique_ptr<RasterSource> rasterOf(ModelGrid&& grid);

/**
 * The nodes of a curvilinear grid, and its cells with four nodes as cells. Their nominal spacing is that of
 * the grid, or fineSpacing().
 * @throws std::runtime_error where no cell has four nodes
 */
Soundings soundingsOf(ModelGrid&& grid);

}
