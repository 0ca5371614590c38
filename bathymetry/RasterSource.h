#pragma once

#include "bathymetry/VerticalMeaning.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace swellray
{

/** A block of nodes of a raster: columns firstColumn to firstColumn + columns - 1, rows likewise. */
struct RasterWindow
{
  std::size_t firstColumn = 0;
  std::size_t firstRow = 0;
  std::size_t columns = 0;
  std::size_t rows = 0;
};

/** Where the nodes of a raster lie (the centres of its cells) and what its values mean. */
struct RasterHeader
{
  std::string driver;
  std::string variable; ///< name of variable or band, may be empty
  std::size_t columns = 0;
  std::size_t rows = 0;
  glm::dvec2 first{ 0.0 };      ///< file coordinates of node (0, 0)
  glm::dvec2 columnStep{ 0.0 }; ///< step from a node to the next of its row, file coordinates
  glm::dvec2 rowStep{ 0.0 };    ///< step from a node to the next of its column
  std::string crs;              ///< WKT, empty where there is none
  std::string crsSource;        ///< where the CRS comes from if not a CRS in the file, e.g. axes in degrees
  VerticalMetadata vertical;
  std::vector<std::string> notes;
  std::vector<std::string> files; ///< that it was read from where there are several

  glm::dvec2 node(double column, double row) const
  {
    return this->first + column * this->columnStep + row * this->rowStep;
  }
};

/** One variable or band of an open raster file. */
class RasterSource
{
public:
  virtual ~RasterSource() = default;

  const RasterHeader& header() const { return this->Header; }

  /**
   * Values of a window, columns x rows, first row first: the file's scale and offset applied, no data as NaN.
   * @param nodata further value, as stored, that stands for no data; NaN: none
   * @throws std::runtime_error where the file cannot be read
   */
  virtual std::vector<double> read(const RasterWindow& window, double nodata) const = 0;

  /**
   * Read from now on from the coarsest copy that the file has of itself (an overview) whose cells are at most `factor`
   * times as large; the header changes with it.
   * @return false, and nothing changed, where there is none
   */
  virtual bool useOverview(double factor)
  {
    static_cast<void>(factor);
    return false;
  }

protected:
  RasterHeader Header;
};

/**
 * Open a raster with GDAL.
 * @param variable NetCDF variable, or band number or description, or CF standard name; empty: the only one that can be a seafloor
 * @throws std::runtime_error where it cannot be read, naming the file
 */
std::unique_ptr<RasterSource> openRaster(const std::string& path, const std::string& variable);

/** Values that a file marks as no data. Comparison is in the type the file stores. */
class NoDataMark
{
public:
  void add(double value, bool singlePrecision);
  bool operator()(double value) const;

private:
  std::vector<double> Low;
  std::vector<double> High;
};

}
