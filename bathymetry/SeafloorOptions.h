#pragma once

#include <array>
#include <optional>
#include <string>

namespace swellray
{

/** Which way the values of a file count. */
enum class Positive
{
  Auto, ///< as the file's metadata say, otherwise elevation, up
  Up,   ///< values are elevations
  Down, ///< values are depths
};

/** The Earth that a geographic grid lies on. */
enum class EarthModel
{
  Plane,    ///< a plane map of a small scene
  Ellipsoid ///< that of its CRS, on Mercator's map with the scale known everywhere
};

/** How a seafloor file is read. */
struct SeafloorOptions
{
  std::optional<double> resample; ///< node distance of the result, both axes, m, > 0; the file's own where not set
  double smooth = 0.0;            ///< standard deviation of the Gaussian that smooths the grid, m, >= 0; 0: none
  std::optional<std::array<double, 4>> crop; ///< x0, y0, x1, y1 in the file's own coordinates, x0 < x1, y0 < y1
  Positive positive = Positive::Auto;
  std::string crs;              ///< anything GDAL takes (EPSG:n, WKT, PROJ); "local": metres; empty: the file's own
  std::optional<double> nodata; ///< value, as stored in the file, that stands for no data, beside the file's own
  std::optional<double> maxGap; ///< widest gap at the border of the grid that is filled, m, >= 0; 5 cells.
                                ///< Soundings: see gridSoundings()
  std::string variable;         ///< variable of a NetCDF file, or number or description of a raster band
  double waterLevel = 0.0;      ///< m, positive up
  bool dropOutliers = false;    ///< soundings: those far off their natural neighbours take no part
  bool crossValidate = false;   ///< soundings: measure the error by leaving out a tenth at a time, ten times
  EarthModel earth = EarthModel::Plane; ///< ellipsoid: of a grid in longitude and latitude; no resample, no smooth

  /** @throws std::invalid_argument naming the option that is out of range */
  void validate() const;
};

}
