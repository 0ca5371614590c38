#include "bathymetry/TransferFile.h"

#include "bathymetry/GdalOutput.h"
#include "bathymetry/NetcdfArrays.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "sim/Angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace swellray
{

using namespace gdaloutput;

namespace
{

using Dimensions = std::vector<std::shared_ptr<GDALDimension>>;

constexpr const char* Kind = "Swellray transfer table, version 1";
constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

// NaN of NaN.
double nauticalOf(double heading)
{
  return std::isnan(heading) ? NoValue : wrapDegrees(270.0 - degrees(heading));
}

struct Column
{
  const char* name;
  const char* longName;
  const char* unit;
  const char* standardName;
};

void addColumn(GDALGroup& root, const Dimensions& dimensions, const Column& column, const std::vector<double>& values)
{
  const auto type = GDALExtendedDataType::Create(GDT_Float64);
  const auto array = root.CreateMDArray(column.name, dimensions, type);
  require(array != nullptr);
  setText(*array, "long_name", column.longName);
  setText(*array, "units", column.unit);
  if (*column.standardName)
  {
    setText(*array, "standard_name", column.standardName);
  }
  std::vector<GUInt64> start(dimensions.size(), 0);
  std::vector<std::size_t> count;
  for (const auto& dimension : dimensions)
  {
    count.push_back(static_cast<std::size_t>(dimension->GetSize()));
  }
  require(array->Write(start.data(), count.data(), nullptr, nullptr, type, values.data()));
}

void write(const std::string& path, const TransferTable& table, const std::string& history)
{
  const QuietGdal quiet;
  const NoSideCars noSideCars;
  const std::size_t places = table.places.size();
  const std::size_t directions = table.rays.directionCount();
  const std::size_t raysAPlace = table.rays.grid.frequencies.size() * directions;
  requireRoom(path, 2 * places * raysAPlace * sizeof(double));
  Dataset dataset = createNetcdf(path);
  {
    const std::shared_ptr<GDALGroup> root = dataset->GetRootGroup();
    require(root != nullptr);
    setText(*root, "Conventions", "CF-1.8");
    setText(*root, "title", Kind);
    setText(*root, "history", history);
    std::string scene;
    for (const std::string& entry : table.scene)
    {
      scene += (scene.empty() ? "" : "; ") + entry;
    }
    setText(*root, "scene", scene);
    setText(*root, "rays_per_direction", std::to_string(table.rays.perDirection));

    const auto dimension = [&](const char* name, std::size_t size)
    {
      auto made = root->CreateDimension(name, "", "", size);
      require(made != nullptr);
      return made;
    };
    const auto place = dimension("place", places);
    const auto frequency = dimension("frequency", table.rays.grid.frequencies.size());
    const auto direction = dimension("direction", directions);
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> depth;
    std::vector<double> from;
    std::vector<double> gain;
    for (const SpectralOrigins& origins : table.places)
    {
      x.push_back(origins.place.x);
      y.push_back(origins.place.y);
      depth.push_back(origins.depth);
      for (std::size_t i = 0; i < raysAPlace; ++i)
      {
        from.push_back(origins.headings.empty() ? NoValue : nauticalOf(origins.headings[i]));
        gain.push_back(origins.headings.empty() ? 0.0 : origins.gains[i]);
      }
    }
    std::vector<double> here;
    for (std::size_t i = 0; i < directions; ++i)
    {
      here.push_back(nauticalOf(table.rays.heading(i)));
    }
    addColumn(*root, { frequency }, { "frequency", "frequency", "Hz", "wave_frequency" }, table.rays.grid.frequencies);
    addColumn(*root, { direction },
      { "direction", "direction the wave comes from at the place, clockwise from north", "degree",
        "sea_surface_wave_from_direction" },
      here);
    addColumn(*root, { place }, { "x", "place, east in the plane of the scene", "m", "" }, x);
    addColumn(*root, { place }, { "y", "place, north in the plane of the scene", "m", "" }, y);
    addColumn(*root, { place },
      { "depth", "depth below the still-water level", "m", "sea_floor_depth_below_sea_surface" }, depth);
    addColumn(*root, { place, frequency, direction },
      { "offshore_direction", "direction the wave comes from offshore, clockwise from north", "degree", "" }, from);
    addColumn(*root, { place, frequency, direction },
      { "gain", "spectral density at the place over that offshore", "1", "" }, gain);
  }
  close(dataset);
}

std::vector<double> readColumn(GDALGroup& root, const char* name, std::size_t size)
{
  const auto array = root.OpenMDArray(name);
  if (!array || !isNumeric(*array) || array->GetTotalElementsCount() != size)
  {
    throw std::runtime_error(std::string("its variable '") + name + "' is missing or has another size");
  }
  std::vector<double> values(size);
  std::vector<GUInt64> start(array->GetDimensionCount(), 0);
  std::vector<std::size_t> count;
  for (const auto& dimension : array->GetDimensions())
  {
    count.push_back(static_cast<std::size_t>(dimension->GetSize()));
  }
  if (size > 0)
  {
    require(array->Read(
      start.data(), count.data(), nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), values.data()));
  }
  return values;
}

std::string textOf(GDALGroup& root, const char* name)
{
  const auto attribute = root.GetAttribute(name);
  const char* value = attribute ? attribute->ReadAsString() : nullptr;
  return value ? value : "";
}

std::size_t sizeOf(GDALGroup& root, const char* name)
{
  constexpr GUInt64 Most = 100000000;
  for (const auto& dimension : root.GetDimensions())
  {
    if (dimension->GetName() == name && dimension->GetSize() <= Most)
    {
      return static_cast<std::size_t>(dimension->GetSize());
    }
  }
  throw std::runtime_error(std::string("its dimension '") + name + "' is missing");
}

TransferTable read(GDALGroup& root)
{
  if (textOf(root, "title") != Kind)
  {
    throw std::runtime_error("it is no transfer table");
  }
  TransferTable table;
  const std::string scene = textOf(root, "scene");
  for (std::size_t from = 0; from < scene.size();)
  {
    const std::size_t to = std::min(scene.find("; ", from), scene.size());
    table.scene.push_back(scene.substr(from, to - from));
    from = to + 2;
  }
  const std::size_t places = sizeOf(root, "place");
  const std::size_t frequencies = sizeOf(root, "frequency");
  const std::size_t directions = sizeOf(root, "direction");
  const double perDirection = std::atof(textOf(root, "rays_per_direction").c_str());
  if (!(perDirection >= 1.0 && perDirection <= static_cast<double>(directions)) ||
    directions % static_cast<std::size_t>(perDirection) != 0)
  {
    throw std::runtime_error("its attribute 'rays_per_direction' does not fit its directions");
  }
  table.rays.perDirection = static_cast<std::size_t>(perDirection);
  table.rays.grid.frequencies = readColumn(root, "frequency", frequencies);
  const std::size_t bins = directions / table.rays.perDirection;
  for (std::size_t j = 0; j < bins; ++j)
  {
    table.rays.grid.headings.push_back(2.0 * Pi * static_cast<double>(j) / static_cast<double>(bins));
  }
  table.rays.validate();
  const std::vector<double> x = readColumn(root, "x", places);
  const std::vector<double> y = readColumn(root, "y", places);
  const std::vector<double> depth = readColumn(root, "depth", places);
  const std::size_t raysAPlace = frequencies * directions;
  const std::vector<double> from = readColumn(root, "offshore_direction", places * raysAPlace);
  const std::vector<double> gain = readColumn(root, "gain", places * raysAPlace);
  for (std::size_t p = 0; p < places; ++p)
  {
    SpectralOrigins origins;
    origins.place = { x[p], y[p] };
    origins.depth = depth[p];
    for (std::size_t i = p * raysAPlace; i < (p + 1) * raysAPlace && depth[p] > 0.0; ++i)
    {
      if (!(gain[i] >= 0.0 && std::isfinite(gain[i])) || std::isinf(from[i]))
      {
        throw std::runtime_error("it has a gain or a direction that makes no sense");
      }
      origins.headings.push_back(headingFromNautical(from[i]));
      origins.gains.push_back(gain[i]);
    }
    table.places.push_back(std::move(origins));
  }
  return table;
}

}

std::string transferTablePart(const std::string& path)
{
  const std::filesystem::path target(path);
  return (target.parent_path() / ("." + target.filename().string() + ".part")).string();
}

void writeTransferTable(const std::string& path, const TransferTable& table, const std::string& history)
{
  namespace fs = std::filesystem;
  const fs::path target(path);
  const std::string temporary = transferTablePart(path);
  try
  {
    write(temporary, table, history);
    fs::rename(temporary, target);
  }
  catch (const std::exception& error)
  {
    std::error_code none;
    fs::remove(temporary, none);
    throw std::runtime_error("cannot write '" + path + "': " + error.what());
  }
}

TransferTable readTransferTable(const std::string& path)
{
  const QuietGdal quiet;
  try
  {
    const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER));
    const std::shared_ptr<GDALGroup> root = dataset ? dataset->GetRootGroup() : nullptr;
    if (!root)
    {
      throw std::runtime_error(QuietGdal::lastError("it is no NetCDF file"));
    }
    return read(*root);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error("cannot read the transfer table '" + path + "': " + error.what());
  }
}

void requireScene(const std::string& path, const TransferTable& table, const std::vector<std::string>& scene)
{
  for (std::size_t i = 0; i < std::max(scene.size(), table.scene.size()); ++i)
  {
    const std::string has = i < table.scene.size() ? table.scene[i] : "nothing";
    const std::string wanted = i < scene.size() ? scene[i] : "nothing";
    if (has != wanted)
    {
      throw std::runtime_error("the transfer table '" + path + "' belongs to another scene: it has " + has + ", not " +
        wanted + "; name another file, or take this one away");
    }
  }
}

}
