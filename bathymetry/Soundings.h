#pragma once

#include "bathymetry/VerticalMeaning.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swellray
{

/**
 * Places of known elevation without order: a survey, or the nodes of a model's mesh. What a reader of such a file hands
 * to gridSoundings(), which brings them to elevations on a grid in metres.
 *
 * Values are as stored: in the unit and with the sign of the file, which `vertical` tells (gridSoundings() makes
 * elevations in metres, positive up, of them by understandVertical(), and --positive overrides). Where a format's
 * values count down, set vertical.rule = "down" and name the format in vertical.ruleSource.
 */
struct Soundings
{
  std::string driver;            ///< name of the format, e.g. "text", "netCDF", "SWAN"
  std::string variable;          ///< column or variable of the values, may be empty
  std::vector<double> x;         ///< n file coordinates: longitude in degrees, easting, or a plane's own
  std::vector<double> y;         ///< n file coordinates: latitude in degrees, northing, or a plane's own
  std::vector<double> z;         ///< n values as stored; NaN: no data there
  VerticalMetadata vertical;     ///< what the file says about z
  std::string crs;               ///< WKT or EPSG:n, empty where the file has none
  std::string crsSource;         ///< where the CRS comes from if not a CRS in the file, e.g. "columns lon and lat"
  std::optional<double> spacing; ///< nominal distance of neighbours, file coordinates, > 0, where the format has one

  /**
   * Cells of a mesh, polygons of 3 or more nodes in order (either sense): cell c has the nodes
   * cellNodes[cellOffsets[c]] to cellNodes[cellOffsets[c + 1] - 1], indices into x, y and z. Both empty: no cells.
   * Where there are cells, the seafloor is what they cover, and the rest is hole: concavities, islands cut out of the
   * mesh. A cell of which a node has no data (NaN) covers nothing.
   */
  std::vector<std::size_t> cellOffsets;
  std::vector<std::uint32_t> cellNodes;

  /**
   * Corners of the cells where these are no soundings: k file coordinates, and cellNodes counts these; as many cells as
   * soundings, each the one around its sounding. A cell whose sounding has no data covers nothing. Empty: as above.
   */
  std::vector<double> cornerX;
  std::vector<double> cornerY;

  std::vector<std::string> notes; ///< what a user should know, one line each
  std::vector<std::string> files; ///< that they were read from where there are several

  std::size_t size() const { return this->z.size(); }

  void add(double eastward, double northward, double value)
  {
    this->x.push_back(eastward);
    this->y.push_back(northward);
    this->z.push_back(value);
  }
};

}
