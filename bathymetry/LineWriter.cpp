#include "bathymetry/LineWriter.h"

#include "bathymetry/QuietGdal.h"
#include "sim/Angles.h"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <stdexcept>

namespace swellray
{

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// A setting of GDAL for this thread, as long as it lives.
class Setting
{
public:
  Setting(const char* name, const char* value)
    : Name(name)
  {
    CPLSetThreadLocalConfigOption(name, value);
  }
  ~Setting() { CPLSetThreadLocalConfigOption(this->Name, nullptr); }
  Setting(const Setting&) = delete;
  void operator=(const Setting&) = delete;

private:
  const char* Name;
};

struct CloseDataset
{
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

void require(bool done)
{
  if (!done || QuietGdal::failed())
  {
    throw std::runtime_error(QuietGdal::lastError("no reason given"));
  }
}

Dataset create(const char* driverName, const std::string& path)
{
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driverName);
  if (!driver)
  {
    throw std::runtime_error(std::string("this GDAL has no driver ") + driverName);
  }
  // The name may be taken by an empty file that holds it.
  std::remove(path.c_str());
  Dataset dataset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  require(dataset != nullptr);
  return dataset;
}

double valueAt(const LineField& field, std::size_t i)
{
  return field.numbers ? field.numbers[i] : field.integers ? field.integers[i] : field.bytes[i];
}

/** What the points of a line tell of it: one field of the layer. */
struct Summary
{
  const LineField* field = nullptr;
  enum Kind
  {
    Mean,
    MeanAngle,
    Largest
  } kind = Mean;

  std::string name() const { return this->field->name + (this->kind == Largest ? "Max" : "Mean"); }
  OGRFieldType type() const { return this->kind == Largest && !this->field->numbers ? OFTInteger : OFTReal; }

  double of(std::size_t begin, std::size_t end) const
  {
    double sum = 0.0;
    double sine = 0.0;
    double largest = -std::numeric_limits<double>::infinity();
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      const double value = valueAt(*this->field, i);
      if (std::isfinite(value))
      {
        sum += this->kind == MeanAngle ? std::cos(radians(value)) : value;
        sine += this->kind == MeanAngle ? std::sin(radians(value)) : 0.0;
        largest = std::max(largest, value);
        ++count;
      }
    }
    if (count == 0)
    {
      return NotANumber;
    }
    if (this->kind == MeanAngle)
    {
      const double mean = degrees(std::atan2(sine, sum));
      return mean < 0.0 ? mean + 360.0 : mean;
    }
    return this->kind == Mean ? sum / static_cast<double>(count) : largest;
  }
};

std::vector<Summary> summariesOf(const std::vector<LineField>& fields)
{
  std::vector<Summary> summaries;
  for (const LineField& field : fields)
  {
    if (field.name == "Longitude" || field.name == "Latitude")
    {
      continue; // the geometry says it
    }
    const bool angle = field.name == "DirectionFrom";
    if (field.numbers)
    {
      summaries.push_back({ &field, angle ? Summary::MeanAngle : Summary::Mean });
    }
    if (!angle)
    {
      summaries.push_back({ &field, Summary::Largest });
    }
  }
  return summaries;
}

void addField(OGRLayer& layer, const std::string& name, OGRFieldType type)
{
  OGRFieldDefn definition(name.c_str(), type);
  require(layer.CreateField(&definition) == OGRERR_NONE);
}

void put(OGRFeature& feature, int index, OGRFieldType type, double value)
{
  if (!std::isfinite(value))
  {
    feature.SetFieldNull(index);
  }
  else if (type == OFTReal)
  {
    feature.SetField(index, value);
  }
  else
  {
    feature.SetField(index, static_cast<int>(value));
  }
}

OGRFieldType typeOf(const LineField& field)
{
  return field.numbers ? OFTReal : OFTInteger;
}

std::unique_ptr<OGRSpatialReference> referenceOf(const Georeference& place)
{
  if (place.crs().empty())
  {
    return nullptr;
  }
  auto reference = std::make_unique<OGRSpatialReference>();
  require(reference->importFromWkt(place.crs().c_str()) == OGRERR_NONE);
  reference->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

OGRSpatialReference wgs84()
{
  OGRSpatialReference reference;
  reference.SetWellKnownGeogCS("WGS84");
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

std::vector<glm::dvec2> planeOf(const LineImage& image)
{
  std::vector<glm::dvec2> places(image.lines > 0 ? static_cast<std::size_t>(image.offsets[image.lines]) : 0);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    places[i] = { image.points[3 * i], image.points[3 * i + 1] };
  }
  return places;
}

void writeLines(OGRLayer& layer, const LineImage& image, const std::vector<glm::dvec2>& places)
{
  const std::vector<Summary> summaries = summariesOf(image.ofPoints);
  for (const LineField& field : image.ofLines)
  {
    addField(layer, field.name, typeOf(field));
  }
  for (const Summary& summary : summaries)
  {
    addField(layer, summary.name(), summary.type());
  }
  for (std::size_t line = 0; line < image.lines; ++line)
  {
    const auto begin = static_cast<std::size_t>(image.offsets[line]);
    const auto end = static_cast<std::size_t>(image.offsets[line + 1]);
    if (end - begin < 2)
    {
      continue;
    }
    OGRFeature feature(layer.GetLayerDefn());
    auto geometry = std::make_unique<OGRLineString>();
    geometry->setNumPoints(static_cast<int>(end - begin), FALSE);
    for (std::size_t i = begin; i < end; ++i)
    {
      geometry->setPoint(static_cast<int>(i - begin), places[i].x, places[i].y);
    }
    feature.SetGeometryDirectly(geometry.release());
    int index = 0;
    for (const LineField& field : image.ofLines)
    {
      put(feature, index++, typeOf(field), valueAt(field, line));
    }
    for (const Summary& summary : summaries)
    {
      put(feature, index++, summary.type(), summary.of(begin, end));
    }
    require(layer.CreateFeature(&feature) == OGRERR_NONE);
  }
}

void writePoints(OGRLayer& layer, const LineImage& image, const std::vector<glm::dvec2>& places)
{
  addField(layer, "Line", OFTInteger);
  for (const LineField& field : image.ofPoints)
  {
    addField(layer, field.name, typeOf(field));
  }
  for (std::size_t line = 0; line < image.lines; ++line)
  {
    for (auto i = static_cast<std::size_t>(image.offsets[line]); i < static_cast<std::size_t>(image.offsets[line + 1]);
         ++i)
    {
      OGRFeature feature(layer.GetLayerDefn());
      feature.SetGeometryDirectly(new OGRPoint(places[i].x, places[i].y));
      feature.SetField(0, static_cast<int>(line));
      int index = 1;
      for (const LineField& field : image.ofPoints)
      {
        put(feature, index++, typeOf(field), valueAt(field, i));
      }
      require(layer.CreateFeature(&feature) == OGRERR_NONE);
    }
  }
}

// Longitudes jump where a line crosses the antimeridian.
void goOnBeyondAntimeridian(const LineImage& image, std::vector<glm::dvec2>& places)
{
  for (std::size_t line = 0; line < image.lines; ++line)
  {
    for (auto i = static_cast<std::size_t>(image.offsets[line]) + 1;
         i < static_cast<std::size_t>(image.offsets[line + 1]); ++i)
    {
      places[i].x = places[i - 1].x + std::remainder(places[i].x - places[i - 1].x, 360.0);
    }
  }
}

bool endsAsJson(const std::string& path)
{
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  constexpr std::streamoff tail = 4; // "]\n}\n"
  if (!file || file.tellg() < tail)
  {
    return false;
  }
  std::string end(static_cast<std::size_t>(tail), '\0');
  file.seekg(-tail, std::ios::end);
  file.read(end.data(), tail);
  return file.good() && end == "]\n}\n";
}

}

void writeGeoPackage(const std::string& path, const LineImage& image, bool withPoints)
{
  const QuietGdal quiet;
  // Nothing but the one file, and no time lost on a half-written one that is thrown away.
  const Setting journal("OGR_SQLITE_JOURNAL", "OFF");
  const Setting synchronous("OGR_SQLITE_SYNCHRONOUS", "OFF");
  Dataset dataset = create("GPKG", path);
  const auto reference = referenceOf(image.place);
  const std::vector<glm::dvec2> plane = planeOf(image);
  std::vector<glm::dvec2> places(plane.size());
  image.place.toFile(plane.size(), plane.data(), places.data());
  if (image.place.kind() == GeoreferenceKind::Geographic)
  {
    goOnBeyondAntimeridian(image, places);
  }
  require(dataset->SetMetadataItem("Source", image.source.c_str()) == CE_None);
  require(dataset->SetMetadataItem("History", image.history.c_str()) == CE_None);
  require(dataset->StartTransaction() == OGRERR_NONE);
  OGRLayer* lines = dataset->CreateLayer(image.layer.c_str(), reference.get(), wkbLineString, nullptr);
  require(lines != nullptr);
  writeLines(*lines, image, places);
  if (withPoints)
  {
    OGRLayer* points = dataset->CreateLayer((image.layer + "_points").c_str(), reference.get(), wkbPoint, nullptr);
    require(points != nullptr);
    writePoints(*points, image, places);
  }
  require(dataset->CommitTransaction() == OGRERR_NONE);
  dataset->FlushCache(true);
  dataset.reset();
  require(true);
}

void writeGeoJson(const std::string& path, const LineImage& image)
{
  const QuietGdal quiet;
  const std::vector<glm::dvec2> plane = planeOf(image);
  std::vector<glm::dvec2> places(plane.size());
  if (image.place.kind() == GeoreferenceKind::Local)
  {
    throw std::runtime_error(
      "GeoJSON holds longitude and latitude, and the seafloor has no place on Earth: give its --crs, or write .gpkg");
  }
  image.place.toLonLat(plane.size(), plane.data(), places.data());
  OGRSpatialReference reference = wgs84();
  const auto own = referenceOf(image.place);
  if (image.place.kind() == GeoreferenceKind::Geographic && !own->IsSame(&reference))
  {
    const std::unique_ptr<OGRCoordinateTransformation> toWgs84(
      OGRCreateCoordinateTransformation(own.get(), &reference));
    require(toWgs84 != nullptr);
    for (glm::dvec2& place : places)
    {
      require(toWgs84->Transform(1, &place.x, &place.y));
    }
  }
  if (std::any_of(
        places.begin(), places.end(), [](const glm::dvec2& place) { return !std::isfinite(place.x + place.y); }))
  {
    throw std::runtime_error("a point has no longitude and latitude");
  }
  Dataset dataset = create("GeoJSON", path);
  const std::string description = "DESCRIPTION=" + image.source + ": " + image.history;
  const char* const options[] = { "RFC7946=YES", "COORDINATE_PRECISION=9", "SIGNIFICANT_FIGURES=10",
    description.c_str(), nullptr };
  OGRLayer* lines = dataset->CreateLayer(image.layer.c_str(), &reference, wkbLineString, const_cast<char**>(options));
  require(lines != nullptr);
  writeLines(*lines, image, places);
  dataset->FlushCache(true);
  dataset.reset();
  require(true);
  if (!endsAsJson(path))
  {
    throw std::runtime_error("the disk is full, or files may not get so large");
  }
}

}
