#include "bathymetry/NetcdfArrays.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"

#include <gdal_priv.h>

#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// What NetCDF writes where nothing was written (netcdf.h, NC_FILL_FLOAT and NC_FILL_DOUBLE).
constexpr double NetcdfFill = 9.9692099683868690e+36;

void listInto(std::vector<NetcdfArray>& arrays, GDALGroup& group, const std::string& prefix, int depth)
{
  for (const std::string& name : group.GetMDArrayNames())
  {
    if (auto array = group.OpenMDArray(name))
    {
      arrays.push_back({ prefix + name, array });
    }
  }
  constexpr int deepest = 8; // more nesting than any data set has
  for (const std::string& name : group.GetGroupNames())
  {
    const auto inner = depth < deepest ? group.OpenGroup(name) : nullptr;
    if (inner)
    {
      listInto(arrays, *inner, prefix + name + "/", depth + 1);
    }
  }
}

}

std::vector<NetcdfArray> listArrays(GDALGroup& root)
{
  std::vector<NetcdfArray> arrays;
  listInto(arrays, root, "", 0);
  return arrays;
}

std::string attribute(const GDALMDArray& array, const char* name)
{
  const auto found = array.GetAttribute(name);
  const char* value = found ? found->ReadAsString() : nullptr;
  return value ? value : "";
}

std::vector<double> numbers(const GDALMDArray& array, const char* name)
{
  const auto found = array.GetAttribute(name);
  if (!found || found->GetDataType().GetClass() != GEDTC_NUMERIC)
  {
    return {};
  }
  return found->ReadAsDoubleArray();
}

std::string unitOf(const GDALMDArray& array)
{
  return array.GetUnit().empty() ? attribute(array, "units") : array.GetUnit();
}

bool isNumeric(const GDALMDArray& array)
{
  return array.GetDataType().GetClass() == GEDTC_NUMERIC &&
    !GDALDataTypeIsComplex(array.GetDataType().GetNumericDataType());
}

bool isDegrees(const std::string& units)
{
  return plain(units).compare(0, 6, "degree") == 0;
}

char axisLetter(const GDALMDArray& coordinate)
{
  const std::string axis = plain(attribute(coordinate, "axis"));
  const std::string standard = plain(attribute(coordinate, "standard_name"));
  const std::string units = plain(coordinate.GetUnit());
  const std::string name = plain(coordinate.GetName());
  const bool east = units == "degrees_east" || units == "degree_east" || units == "degrees_e" || units == "degree_e";
  const bool north = units == "degrees_north" || units == "degree_north" || units == "degrees_n" || units == "degree_n";
  if (axis == "x" || standard == "longitude" || standard == "projection_x_coordinate" || east)
  {
    return 'x';
  }
  if (axis == "y" || standard == "latitude" || standard == "projection_y_coordinate" || north)
  {
    return 'y';
  }
  if (name == "x" || name == "lon" || name == "longitude" || name == "easting")
  {
    return 'x';
  }
  if (name == "y" || name == "lat" || name == "latitude" || name == "northing")
  {
    return 'y';
  }
  return 0;
}

std::vector<double> readStored(const GDALMDArray& array)
{
  std::size_t size = 1;
  std::vector<GUInt64> start;
  std::vector<std::size_t> count;
  for (const auto& dimension : array.GetDimensions())
  {
    // A size that is only claimed takes no memory.
    const GUInt64 length = dimension->GetSize();
    if (length == 0 || length > MostNodes / size)
    {
      throw std::runtime_error("variable '" + array.GetName() + "' has no values, or more than " +
        std::to_string(MostNodes / 1000000) + " million");
    }
    start.push_back(0);
    count.push_back(static_cast<std::size_t>(length));
    size *= static_cast<std::size_t>(length);
  }
  std::vector<double> values(size);
  if (!array.Read(
        start.data(), count.data(), nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), values.data()) ||
    QuietGdal::failed())
  {
    throw std::runtime_error(
      "variable '" + array.GetName() + "' cannot be read: " + QuietGdal::lastError("no reason given"));
  }
  return values;
}

std::vector<double> readAll(const GDALMDArray& array)
{
  std::vector<double> values = readStored(array);
  maskAndScale(array, std::numeric_limits<double>::quiet_NaN(), values);
  return values;
}

void maskAndScale(const GDALMDArray& array, double nodata, std::vector<double>& values)
{
  const bool single = array.GetDataType().GetNumericDataType() == GDT_Float32;
  NoDataMark missing;
  bool has = false;
  const double fill = array.GetNoDataValueAsDouble(&has);
  missing.add(has ? fill : NetcdfFill, single || !has);
  missing.add(nodata, single);
  for (const double mark : numbers(array, "missing_value"))
  {
    missing.add(mark, single);
  }
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  const std::vector<double> range = numbers(array, "valid_range");
  const std::vector<double> lowest = numbers(array, "valid_min");
  const std::vector<double> highest = numbers(array, "valid_max");
  low = range.size() == 2 ? range[0] : lowest.size() == 1 ? lowest[0] : low;
  high = range.size() == 2 ? range[1] : highest.size() == 1 ? highest[0] : high;

  const double scale = array.GetScale();
  const double offset = array.GetOffset();
  for (double& value : values)
  {
    value =
      missing(value) || value < low || value > high ? std::numeric_limits<double>::quiet_NaN() : value * scale + offset;
  }
}

}
