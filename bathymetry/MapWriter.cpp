#include "bathymetry/MapWriter.h"

#include "bathymetry/GdalOutput.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "bathymetry/Wkt.h"
#include "sim/EllipsoidMercator.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <limits>
#include <memory>
#include <stdexcept>

namespace swellray
{

using namespace gdaloutput;

namespace
{

GDALDataType typeOf(const MapVariable& variable)
{
  return variable.numbers ? GDT_Float64 : variable.integers ? GDT_Int32 : GDT_Byte;
}

const void* valuesOf(const MapVariable& variable)
{
  return variable.numbers ? static_cast<const void*>(variable.numbers)
    : variable.integers   ? static_cast<const void*>(variable.integers)
                          : variable.bytes;
}

// North up: the first row of a raster is the last of the map.
void writeRows(GDALRasterBand* band, const MapImage& map, const MapVariable& variable)
{
  const GDALDataType type = typeOf(variable);
  const auto rowSize = static_cast<std::size_t>(GDALGetDataTypeSizeBytes(type)) * map.columns;
  const auto* values = static_cast<const unsigned char*>(valuesOf(variable));
  const auto width = static_cast<int>(map.columns);
  for (std::size_t row = 0; row < map.rows; ++row)
  {
    // The band reads from what the interface takes as writable.
    void* from = const_cast<unsigned char*>(values + (map.rows - 1 - row) * rowSize);
    require(
      band->RasterIO(GF_Write, 0, static_cast<int>(row), width, 1, from, width, 1, type, 0, 0, nullptr) == CE_None);
  }
}

// Where the nodes lie in the coordinates of the file.
struct FileAxes
{
  glm::dvec2 origin{ 0.0 }; // of the south-west node
  glm::dvec2 spacing{ 1.0 };
};

FileAxes fileAxes(const MapImage& map)
{
  if (map.place.kind() == GeoreferenceKind::Geographic)
  {
    return { map.origin, map.spacing };
  }
  return { map.place.toFile(map.origin), map.spacing / map.place.metresPerUnit() };
}

std::unique_ptr<OGRSpatialReference> referenceOf(const std::string& crs)
{
  if (crs.empty())
  {
    return nullptr;
  }
  auto reference = std::make_unique<OGRSpatialReference>();
  require(reference->importFromWkt(crs.c_str()) == OGRERR_NONE);
  reference->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

// As CF (UDUNITS) writes it.
std::string lengthUnit(const Georeference& place)
{
  const double metres = place.kind() == GeoreferenceKind::Geographic ? 1.0 : place.metresPerUnit();
  return metres == 1.0 ? "m" : text(metres) + " m";
}

void setPlace(GDALDataset& dataset, const MapImage& map)
{
  const FileAxes axes = fileAxes(map);
  const glm::dvec2 northWest = axes.origin + axes.spacing * glm::dvec2(-0.5, static_cast<double>(map.rows) - 0.5);
  std::array<double, 6> transform = { northWest.x, axes.spacing.x, 0.0, northWest.y, 0.0, -axes.spacing.y };
  require(dataset.SetGeoTransform(transform.data()) == CE_None);
  if (const auto crs = referenceOf(mapCrs(map.place)))
  {
    require(dataset.SetSpatialRef(crs.get()) == CE_None);
  }
}

struct Axis
{
  std::string name;
  std::string direction;
  std::string unit;
  bool ofProjection = false;
  double first = 0.0;
  double step = 1.0;
  std::size_t count = 0;
};

std::shared_ptr<GDALDimension> addAxis(GDALGroup& root, const Axis& axis)
{
  const bool isX = axis.name == "x";
  auto dimension = root.CreateDimension(
    axis.name, isX ? GDAL_DIM_TYPE_HORIZONTAL_X : GDAL_DIM_TYPE_HORIZONTAL_Y, isX ? "EAST" : "NORTH", axis.count);
  require(dimension != nullptr);
  const auto type = GDALExtendedDataType::Create(GDT_Float64);
  const auto array = root.CreateMDArray(axis.name, { dimension }, type);
  require(array != nullptr);
  setText(*array, "long_name", "distance " + axis.direction);
  if (axis.ofProjection)
  {
    setText(*array, "standard_name", "projection_" + axis.name + "_coordinate");
  }
  setText(*array, "units", axis.unit);
  setText(*array, "axis", isX ? "X" : "Y");
  std::vector<double> values(axis.count);
  for (std::size_t i = 0; i < axis.count; ++i)
  {
    values[i] = axis.first + axis.step * static_cast<double>(i);
  }
  const GUInt64 start = 0;
  require(array->Write(&start, &axis.count, nullptr, nullptr, type, values.data()));
  return dimension;
}

void addVariable(GDALGroup& root, const std::vector<std::shared_ptr<GDALDimension>>& dimensions,
  const OGRSpatialReference* crs, const MapVariable& variable, std::size_t nodes)
{
  const char* const options[] = { "COMPRESS=DEFLATE", "ZLEVEL=1", nullptr };
  const auto type = GDALExtendedDataType::Create(typeOf(variable));
  const auto array = root.CreateMDArray(variable.name, dimensions, type, options);
  require(array != nullptr);
  if (variable.numbers)
  {
    require(array->SetNoDataValue(std::numeric_limits<double>::quiet_NaN()));
  }
  setText(*array, "long_name", variable.longName);
  setText(*array, "units", variable.unit);
  if (!variable.standardName.empty())
  {
    setText(*array, "standard_name", variable.standardName);
  }
  if (!variable.flagMeanings.empty())
  {
    const auto flags = array->CreateAttribute("flag_values", { 2 }, type);
    const std::array<unsigned char, 2> values = { 0, 1 };
    require(flags && flags->Write(values.data(), values.size()));
    setText(*array, "flag_meanings", variable.flagMeanings);
  }
  if (crs)
  {
    require(array->SetSpatialRef(crs));
  }
  const std::array<GUInt64, 2> start = { 0, 0 };
  const std::array<std::size_t, 2> count = { static_cast<std::size_t>(dimensions[0]->GetSize()),
    static_cast<std::size_t>(dimensions[1]->GetSize()) };
  require(array->Write(start.data(), count.data(), nullptr, nullptr, type, valuesOf(variable), valuesOf(variable),
    nodes * type.GetSize()));
}

// Values as they are, and something for the rest.
std::size_t roomOf(const MapImage& map)
{
  std::size_t size = 0;
  for (const MapVariable& variable : map.variables)
  {
    size += map.columns * map.rows * static_cast<std::size_t>(GDALGetDataTypeSizeBytes(typeOf(variable)));
  }
  return size;
}

}

std::string mapCrs(const Georeference& place)
{
  if (place.kind() != GeoreferenceKind::Geographic)
  {
    return place.crs();
  }
  const QuietGdal quiet;
  OGRSpatialReference reference;
  require(reference.importFromWkt(place.crs().c_str()) == OGRERR_NONE);
  OGRSpatialReference map;
  const std::shared_ptr<const EllipsoidMercator>& mercator = place.mercator();
  const std::string name =
    (mercator ? "Mercator of the scene, over " : "Transverse Mercator centred on the scene, over ") + place.crsName();
  require(map.SetProjCS(name.c_str()) == OGRERR_NONE);
  require(map.CopyGeogCSFrom(&reference) == OGRERR_NONE);
  if (mercator)
  {
    require(map.SetMercator2SP(mercator->standardLatitude(), 0.0, place.originLongitude(), 0.0, 0.0) == OGRERR_NONE);
    return wktOf(map);
  }
  require(map.SetTM(place.originLatitude(), place.originLongitude(), 1.0, 0.0, 0.0) == OGRERR_NONE);
  return wktOf(map);
}

void writeGeoTiff(const std::string& path, const MapImage& map)
{
  const QuietGdal quiet;
  const NoSideCars noSideCars;
  const char* const options[] = { "COMPRESS=DEFLATE", "PREDICTOR=3", "BIGTIFF=IF_SAFER", "INTERLEAVE=BAND", nullptr };
  Dataset dataset(driverNamed("GTiff")->Create(path.c_str(), static_cast<int>(map.columns), static_cast<int>(map.rows),
    static_cast<int>(map.variables.size()), GDT_Float32, const_cast<char**>(options)));
  require(dataset != nullptr);
  setPlace(*dataset, map);
  dataset->SetMetadataItem("TIFFTAG_SOFTWARE", map.source.c_str());
  dataset->SetMetadataItem("TIFFTAG_IMAGEDESCRIPTION", map.history.c_str());
  for (std::size_t i = 0; i < map.variables.size(); ++i)
  {
    const MapVariable& variable = map.variables[i];
    GDALRasterBand* band = dataset->GetRasterBand(static_cast<int>(i) + 1);
    band->SetDescription(variable.name.c_str());
    band->SetUnitType(variable.unit.c_str());
    band->SetMetadataItem("long_name", variable.longName.c_str());
    band->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  }
  for (std::size_t i = 0; i < map.variables.size(); ++i)
  {
    writeRows(dataset->GetRasterBand(static_cast<int>(i) + 1), map, map.variables[i]);
  }
  close(dataset);
}

void writeNetcdf(const std::string& path, const MapImage& map)
{
  const QuietGdal quiet;
  const NoSideCars noSideCars;
  requireRoom(path, roomOf(map));
  Dataset dataset = createNetcdf(path);
  {
    const std::shared_ptr<GDALGroup> root = dataset->GetRootGroup();
    require(root != nullptr);
    setText(*root, "Conventions", "CF-1.8");
    setText(*root, "title", "Waves refracted over a seafloor");
    setText(*root, "source", map.source);
    setText(*root, "history", map.history);

    const FileAxes axes = fileAxes(map);
    const std::string unit = lengthUnit(map.place);
    const std::unique_ptr<OGRSpatialReference> crs = referenceOf(mapCrs(map.place));
    const bool projected = map.place.kind() != GeoreferenceKind::Local;
    const auto y = addAxis(*root, { "y", "north", unit, projected, axes.origin.y, axes.spacing.y, map.rows });
    const auto x = addAxis(*root, { "x", "east", unit, projected, axes.origin.x, axes.spacing.x, map.columns });
    for (const MapVariable& variable : map.variables)
    {
      addVariable(*root, { y, x }, crs.get(), variable, map.columns * map.rows);
    }
  }
  close(dataset);
}

}
