#include "bathymetry/NetcdfRaster.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/NetcdfArrays.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "bathymetry/Wkt.h"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Longitudes that jump by a turn, as from 180 to -180, count on instead.
void countOn(std::vector<double>& longitudes)
{
  double turn = 0.0;
  for (std::size_t i = 1; i < longitudes.size(); ++i)
  {
    const double jump = longitudes[i] + turn - longitudes[i - 1];
    turn -= std::abs(jump) > 180.0 ? std::copysign(360.0, jump) : 0.0;
    longitudes[i] += turn;
  }
}

}

struct NetcdfRaster::Axis
{
  std::size_t count = 0;
  double first = 0.0;
  double step = 0.0;
  std::string units;
};

struct NetcdfRaster::Candidate
{
  std::size_t xDimension = 0;
  std::size_t yDimension = 0;
  std::shared_ptr<GDALMDArray> x;
  std::shared_ptr<GDALMDArray> y;
};

NetcdfRaster::NetcdfRaster(const std::string& path, const std::string& variable)
{
  this->Dataset.reset(
    GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  const std::shared_ptr<GDALGroup> root = this->Dataset ? this->Dataset->GetRootGroup() : nullptr;
  if (!root)
  {
    throw std::runtime_error("not a NetCDF file that GDAL can read: " + QuietGdal::lastError("no reason given"));
  }
  this->Header.driver = "netCDF";
  this->Arrays = listArrays(*root);
  this->select(variable);
  this->readMeaning();
}

NetcdfRaster::~NetcdfRaster()
{
  const QuietGdal quiet;
  this->Array.reset();
  this->Arrays.clear();
  this->Dataset.reset();
}

// The coordinate variable of a dimension: its own, or a one-dimensional variable on it that says which axis it is.
std::shared_ptr<GDALMDArray> NetcdfRaster::coordinates(const GDALMDArray& array, std::size_t dimension) const
{
  const auto& wanted = array.GetDimensions()[dimension];
  std::shared_ptr<GDALMDArray> own = wanted->GetIndexingVariable();
  if (own && own->GetDimensionCount() == 1 && isNumeric(*own))
  {
    return own;
  }
  for (const NetcdfArray& named : this->Arrays)
  {
    const GDALMDArray& other = *named.array;
    if (other.GetDimensionCount() == 1 && isNumeric(other) &&
      other.GetDimensions()[0]->GetFullName() == wanted->GetFullName() && axisLetter(other))
    {
      return named.array;
    }
  }
  return nullptr;
}

bool NetcdfRaster::findAxes(const GDALMDArray& array, Candidate& candidate) const
{
  if (!isNumeric(array))
  {
    return false;
  }
  std::vector<std::size_t> wide;
  const auto& dimensions = array.GetDimensions();
  for (std::size_t i = 0; i < dimensions.size(); ++i)
  {
    if (dimensions[i]->GetSize() > 1)
    {
      wide.push_back(i);
    }
  }
  // A grid of one row: its last two dimensions are the axes.
  if (wide.size() < 2 && dimensions.size() >= 2)
  {
    wide = { dimensions.size() - 2, dimensions.size() - 1 };
  }
  if (wide.size() != 2)
  {
    return false;
  }
  candidate.yDimension = wide[0];
  candidate.xDimension = wide[1];
  candidate.y = this->coordinates(array, wide[0]);
  candidate.x = this->coordinates(array, wide[1]);
  if (!candidate.x || !candidate.y)
  {
    return false;
  }
  if (axisLetter(*candidate.y) == 'x' && axisLetter(*candidate.x) != 'x')
  {
    std::swap(candidate.x, candidate.y);
    std::swap(candidate.xDimension, candidate.yDimension);
  }
  return true;
}

void NetcdfRaster::select(const std::string& variable)
{
  std::vector<std::pair<const NetcdfArray*, Candidate>> candidates;
  std::string names;
  for (const NetcdfArray& named : this->Arrays)
  {
    Candidate candidate;
    if (this->findAxes(*named.array, candidate))
    {
      candidates.emplace_back(&named, candidate);
      names += (names.empty() ? "" : ", ") + named.name;
    }
  }
  const auto takeOnly = [&candidates](auto accepts) -> const std::pair<const NetcdfArray*, Candidate>*
  {
    const auto first = std::find_if(candidates.begin(), candidates.end(), accepts);
    const bool only =
      first != candidates.end() && std::find_if(first + 1, candidates.end(), accepts) == candidates.end();
    return only ? &*first : nullptr;
  };

  const std::pair<const NetcdfArray*, Candidate>* chosen = nullptr;
  if (!variable.empty())
  {
    chosen = takeOnly([&variable](const auto& c) { return c.first->name == variable; });
    if (!chosen)
    {
      chosen = takeOnly([&variable](const auto& c) { return attribute(*c.first->array, "standard_name") == variable; });
    }
    if (!chosen)
    {
      throw std::runtime_error("it has no variable '" + variable +
        "' on a regular grid with coordinates; there are: " + (names.empty() ? "none" : names));
    }
  }
  else
  {
    if (candidates.empty())
    {
      throw std::runtime_error("it has no variable on a regular grid with coordinates (one-dimensional x and y)");
    }
    chosen = takeOnly([](const auto&) { return true; });
    if (!chosen)
    {
      chosen = takeOnly([](const auto& c) { return isElevationName(attribute(*c.first->array, "standard_name")); });
    }
    if (!chosen)
    {
      throw std::runtime_error("it has several variables; choose one with --variable: " + names);
    }
  }
  this->Header.variable = chosen->first->name;
  this->Array = chosen->first->array;
  this->readPlace(chosen->second);
}

NetcdfRaster::Axis NetcdfRaster::readAxis(const GDALMDArray& coordinate) const
{
  Axis axis;
  axis.count = coordinate.GetDimensions()[0]->GetSize();
  axis.units = coordinate.GetUnit();
  if (axis.units.empty())
  {
    axis.units = attribute(coordinate, "units");
  }
  if (axis.count > MostNodes)
  {
    throw std::runtime_error("axis '" + coordinate.GetName() + "' has " + std::to_string(axis.count) +
      " values, above the limit of " + std::to_string(MostNodes / 1000000) + " million");
  }
  std::vector<double> values(axis.count);
  const GUInt64 start = 0;
  const std::size_t count = axis.count;
  if (axis.count < 2)
  {
    throw std::runtime_error("axis '" + coordinate.GetName() + "' has fewer than 2 values");
  }
  if (!coordinate.Read(&start, &count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), values.data()))
  {
    throw std::runtime_error(
      "axis '" + coordinate.GetName() + "' cannot be read: " + QuietGdal::lastError("no reason given"));
  }
  if (isDegrees(axis.units))
  {
    countOn(values);
  }
  axis.first = values.front();
  axis.step = (values.back() - values.front()) / static_cast<double>(axis.count - 1);
  if (!std::isfinite(axis.step) || axis.step == 0.0)
  {
    throw std::runtime_error("axis '" + coordinate.GetName() + "' has spacing " + text(axis.step));
  }
  // Coordinates are often rounded, to single precision or a few digits; a grid that really varies is refused.
  constexpr double rounding = 0.02; // cells
  const bool single = coordinate.GetDataType().GetNumericDataType() == GDT_Float32;
  const double largest = std::max(std::abs(values.front()), std::abs(values.back()));
  const double allowed =
    rounding * std::abs(axis.step) + (single ? 2.0 * largest * std::numeric_limits<float>::epsilon() : 0.0);
  for (std::size_t i = 0; i < axis.count; ++i)
  {
    if (!(std::abs(values[i] - (axis.first + static_cast<double>(i) * axis.step)) <= allowed))
    {
      throw std::runtime_error("axis '" + coordinate.GetName() + "' is not evenly spaced (value " +
        std::to_string(i + 1) + " is " + text(values[i], 12) + "); bring it to a regular grid first (gdalwarp)");
    }
  }
  const double scale = coordinate.GetScale();
  axis.first = axis.first * scale + coordinate.GetOffset();
  axis.step *= scale;
  return axis;
}

void NetcdfRaster::readPlace(const Candidate& candidate)
{
  RasterHeader& header = this->Header;
  this->XDimension = candidate.xDimension;
  this->YDimension = candidate.yDimension;
  Axis x = this->readAxis(*candidate.x);
  Axis y = this->readAxis(*candidate.y);

  const std::shared_ptr<OGRSpatialReference> crs = this->Array->GetSpatialRef();
  if (crs)
  {
    header.crs = wktOf(*crs);
  }
  if (header.crs.empty() && isDegrees(x.units) && isDegrees(y.units))
  {
    header.crs = "EPSG:4326";
    header.crsSource = "axes in " + x.units + " and " + y.units;
  }

  // Axes in another unit than their CRS: the coordinates of this file are those of the CRS.
  const double crsUnit = crs && crs->IsProjected() ? crs->GetLinearUnits() : 1.0;
  for (Axis* axis : { &x, &y })
  {
    const double metres = metresPerUnit(axis->units);
    if (metres > 0.0 && std::abs(metres / crsUnit - 1.0) > 1e-9)
    {
      axis->first *= metres / crsUnit;
      axis->step *= metres / crsUnit;
      header.notes.push_back(std::string(axis == &x ? "x" : "y") + " axis converted from " + axis->units + " to " +
        (crsUnit == 1.0 ? "metres" : "the unit of its CRS"));
    }
  }

  header.columns = x.count;
  header.rows = y.count;
  header.first = glm::dvec2(x.first, y.first);
  header.columnStep = glm::dvec2(x.step, 0.0);
  header.rowStep = glm::dvec2(0.0, y.step);
}

void NetcdfRaster::readMeaning()
{
  VerticalMetadata& vertical = this->Header.vertical;
  vertical.positive = attribute(*this->Array, "positive");
  vertical.standardName = attribute(*this->Array, "standard_name");
  vertical.units = this->Array->GetUnit();
}

std::vector<double> NetcdfRaster::read(const RasterWindow& window, double nodata) const
{
  const QuietGdal quiet;
  const std::size_t dimensions = this->Array->GetDimensionCount();
  std::vector<GUInt64> start(dimensions, 0);
  std::vector<std::size_t> count(dimensions, 1);
  std::vector<GPtrDiff_t> stride(dimensions, 0);
  start[this->XDimension] = window.firstColumn;
  start[this->YDimension] = window.firstRow;
  count[this->XDimension] = window.columns;
  count[this->YDimension] = window.rows;
  stride[this->XDimension] = 1;
  stride[this->YDimension] = static_cast<GPtrDiff_t>(window.columns);
  std::vector<double> values(window.columns * window.rows);
  if (!this->Array->Read(
        start.data(), count.data(), nullptr, stride.data(), GDALExtendedDataType::Create(GDT_Float64), values.data()) ||
    QuietGdal::failed())
  {
    throw std::runtime_error(
      "variable '" + this->Header.variable + "' cannot be read: " + QuietGdal::lastError("no reason given"));
  }

  maskAndScale(*this->Array, nodata, values);
  return values;
}

}
