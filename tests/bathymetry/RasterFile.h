#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace swellray::test
{

/** A folder of its own for the files of one test, removed with them. */
class Folder
{
public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const;

private:
  std::string Path;
};

/** A bed as a function of file coordinates. */
using Bed = std::function<double(const glm::dvec2&)>;

/** A raster to be written. Values are row by row as the file has them, first row first. */
struct RasterFile
{
  int columns = 40;
  int rows = 30;
  std::array<double, 6> transform{ 0.0, 10.0, 0.0, 300.0, 0.0, -10.0 }; ///< GDAL's, of cell corners
  std::string crs;                                                      ///< as OGR takes it; empty: none
  std::optional<double> nodata;
  std::optional<double> scale;
  std::optional<double> offset;
  std::string units;
  std::map<std::string, std::string> metadata;
  int bands = 1;
  std::vector<double> values;

  /** File coordinates of the centre of a cell. */
  glm::dvec2 centre(int column, int row) const;
  double& at(int column, int row) { return this->values[static_cast<std::size_t>(row * this->columns + column)]; }
  /** Values of a bed at the cells' centres. */
  void fill(const Bed& bed);
  void writeGeoTiff(const std::string& path) const;
  void writeAscii(const std::string& path) const;
};

/** A NetCDF file to be written through GDAL's multidimensional interface. */
struct NetcdfFile
{
  std::vector<double> x;
  std::vector<double> y;
  std::string xName = "lon";
  std::string yName = "lat";
  std::string xUnits = "degrees_east";
  std::string yUnits = "degrees_north";
  bool xFirst = false; ///< dimensions (x, y) in place of (y, x)
  bool packed = false; ///< stored as 16 bit integers with scale and offset
  double scale = 1.0;
  double offset = 0.0;
  std::optional<double> nodata;
  std::string units = "m";
  std::map<std::string, std::string> attributes;
  std::vector<std::string> variables{ "z" };
  Bed bed;

  void write(const std::string& path) const;
};

/** Evenly spaced values. */
std::vector<double> steps(double first, double step, int count);

constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

}
