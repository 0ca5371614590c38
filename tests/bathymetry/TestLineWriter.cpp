#include "bathymetry/LineWriter.h"

#include "RasterFile.h"
#include "bathymetry/QuietGdal.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

using namespace swellray;
using testing::HasSubstr;

namespace
{

// Asked for, m.
constexpr double RoundTrip = 1e-3;

struct CloseDataset
{
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

class LineFiles : public testing::Test
{
protected:
  LineFiles()
  {
    this->Image.layer = "rays";
    this->Image.lines = 3;
    this->Image.offsets = this->Offsets.data();
    this->Image.points = this->Points.data();
    LineField id{ "RayId" };
    id.integers = this->Ids.data();
    LineField lee{ "LeeRay" };
    lee.bytes = this->Flags.data();
    LineField parameter{ "LaunchParameter" };
    parameter.numbers = this->Parameters.data();
    this->Image.ofLines = { id, lee, parameter };
    LineField height{ "WaveHeight" };
    height.numbers = this->Heights.data();
    LineField direction{ "DirectionFrom" };
    direction.numbers = this->Directions.data();
    LineField caustics{ "Caustics" };
    caustics.integers = this->Caustics.data();
    LineField longitude{ "Longitude" };
    longitude.numbers = this->Heights.data();
    this->Image.ofPoints = { height, direction, caustics, longitude };
    this->Image.source = "Swellray";
    this->Image.history = "swellray trace";
  }

  Dataset open(const std::string& path) const
  {
    return Dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  }

  // Largest distance of the points that a layer of lines has from those that were written, through the georeference, m.
  double largestMiss(OGRLayer& layer, const Georeference& place) const
  {
    double miss = 0.0;
    std::size_t at = 0;
    for (const auto& feature : layer)
    {
      const OGRLineString& line = *feature->GetGeometryRef()->toLineString();
      for (int i = 0; i < line.getNumPoints(); ++i, ++at)
      {
        const glm::dvec2 point = place.fromFile({ line.getX(i), line.getY(i) });
        miss = std::max(miss, glm::distance(point, glm::dvec2(this->Points[3 * at], this->Points[3 * at + 1])));
      }
    }
    EXPECT_EQ(at, 5u) << "points read";
    return miss;
  }

  static std::string failure(const std::function<void()>& call)
  {
    try
    {
      call();
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return "";
  }

  static constexpr double None = std::numeric_limits<double>::quiet_NaN();
  // Two lines of 3 and 2 points, and a ray of one point, which is no line.
  std::vector<std::int64_t> Offsets{ 0, 3, 5, 6 };
  std::vector<double> Points{ 0.0, 0.0, 0.0, 1234.5678, 0.25, 0.0, 2000.001, -3000.002, 0.0, -5000.0, 400.0, 0.0,
    -4000.0, 410.0, 0.0, 7.0, 7.0, 0.0 };
  std::vector<std::int32_t> Ids{ 0, 1, 2 };
  std::vector<std::uint8_t> Flags{ 0, 1, 0 };
  std::vector<double> Parameters{ 0.5, None, 2.5 };
  std::vector<double> Heights{ 1.0, None, 2.0, None, std::numeric_limits<double>::infinity(), 1.0 };
  std::vector<double> Directions{ 350.0, 0.0, 10.0, 180.0, 200.0, 0.0 };
  std::vector<std::int32_t> Caustics{ 0, 1, 2, 0, 0, 0 };
  LineImage Image;
  test::Folder Files;
  QuietGdal Quiet;
};

}

TEST_F(LineFiles, goToAGeoPackageInTheCrsOfTheSeafloor)
{
  // Degrees, UTM metres, and the feet of the New York state plane.
  const Georeference places[] = {
    Georeference(crsToWkt("EPSG:4326"), { -155.06, 19.74 }, glm::dvec2(0.0)),
    Georeference(crsToWkt("EPSG:4269"), { -71.9, 41.0 }, glm::dvec2(0.0)),
    Georeference(crsToWkt("EPSG:32605"), glm::dvec2(0.0), { 280000.0, 2180000.0 }),
    Georeference(crsToWkt("EPSG:2263"), glm::dvec2(0.0), { 1000000.0, 150000.0 }),
    Georeference(),
  };
  const std::string path = this->Files.file("lines.gpkg");
  for (const Georeference& place : places)
  {
    this->Image.place = place;
    writeGeoPackage(path, this->Image, false);
    const Dataset file = this->open(path);
    ASSERT_TRUE(file);
    ASSERT_EQ(file->GetLayerCount(), 1);
    OGRLayer* layer = file->GetLayerByName("rays");
    ASSERT_TRUE(layer);
    EXPECT_LT(this->largestMiss(*layer, place), RoundTrip) << place.crsName();
    if (place.kind() != GeoreferenceKind::Local)
    {
      ASSERT_TRUE(layer->GetSpatialRef());
      EXPECT_EQ(layer->GetSpatialRef()->GetName(), place.crsName());
    }
  }
}

TEST_F(LineFiles, areInGeoJsonByLongitudeAndLatitudeOnWgs84)
{
  const std::string path = this->Files.file("lines.geojson");
  this->Image.place = Georeference(crsToWkt("EPSG:4326"), { -155.06, 19.74 }, glm::dvec2(0.0));
  writeGeoJson(path, this->Image);
  {
    const Dataset file = this->open(path);
    ASSERT_TRUE(file);
    EXPECT_LT(this->largestMiss(*file->GetLayer(0), this->Image.place), RoundTrip);
  }
  // Of a projected seafloor they are the longitudes and latitudes that the points carry.
  this->Image.place = Georeference(crsToWkt("EPSG:32605"), glm::dvec2(0.0), { 280000.0, 2180000.0 });
  writeGeoJson(path, this->Image);
  const Dataset file = this->open(path);
  const std::unique_ptr<OGRFeature> feature(file->GetLayer(0)->GetNextFeature());
  const OGRLineString& line = *feature->GetGeometryRef()->toLineString();
  const auto exact = this->Image.place.toLonLat({ this->Points[6], this->Points[7] });
  ASSERT_TRUE(exact);
  constexpr double Millimetre = 9e-9; // degrees
  EXPECT_NEAR(line.getX(2), exact->x, Millimetre);
  EXPECT_NEAR(line.getY(2), exact->y, Millimetre);
  std::ifstream words(path);
  std::stringstream text;
  text << words.rdbuf();
  EXPECT_THAT(text.str(), testing::Not(HasSubstr("\"crs\""))) << "RFC 7946 knows one";

  this->Image.place = Georeference();
  EXPECT_THAT(failure([&] { writeGeoJson(path, this->Image); }), HasSubstr("the seafloor has no place on Earth"));
}

TEST_F(LineFiles, haveTheirQuantitiesAsFields)
{
  const std::string path = this->Files.file("lines.gpkg");
  writeGeoPackage(path, this->Image, true);
  const Dataset file = this->open(path);
  ASSERT_EQ(file->GetLayerCount(), 2);
  OGRLayer& lines = *file->GetLayerByName("rays");
  EXPECT_EQ(lines.GetFeatureCount(), 2) << "a point alone is no line";
  const std::unique_ptr<OGRFeature> first(lines.GetNextFeature());
  const std::unique_ptr<OGRFeature> second(lines.GetNextFeature());
  EXPECT_EQ(first->GetFieldAsInteger("RayId"), 0);
  EXPECT_EQ(second->GetFieldAsInteger("LeeRay"), 1);
  EXPECT_EQ(first->GetFieldAsDouble("LaunchParameter"), 0.5);
  EXPECT_TRUE(second->IsFieldNull(second->GetFieldIndex("LaunchParameter")));
  EXPECT_EQ(first->GetFieldAsDouble("WaveHeightMean"), 1.5);
  EXPECT_EQ(first->GetFieldAsDouble("WaveHeightMax"), 2.0);
  EXPECT_TRUE(second->IsFieldNull(second->GetFieldIndex("WaveHeightMean")));
  // A mean direction across north.
  EXPECT_NEAR(std::remainder(first->GetFieldAsDouble("DirectionFromMean"), 360.0), 0.0, 1e-12);
  EXPECT_NEAR(second->GetFieldAsDouble("DirectionFromMean"), 190.0, 1e-12);
  EXPECT_EQ(first->GetFieldIndex("DirectionFromMax"), -1);
  EXPECT_EQ(first->GetFieldAsInteger("CausticsMax"), 2);
  EXPECT_EQ(first->GetFieldIndex("LongitudeMean"), -1);

  OGRLayer& points = *file->GetLayerByName("rays_points");
  EXPECT_EQ(points.GetFeatureCount(), 6);
  int number = 0;
  for (const auto& feature : points)
  {
    const OGRPoint& point = *feature->GetGeometryRef()->toPoint();
    EXPECT_NEAR(point.getX(), this->Points[static_cast<std::size_t>(3 * number)], RoundTrip);
    EXPECT_EQ(feature->GetFieldAsInteger("Line"), number < 3 ? 0 : number < 5 ? 1 : 2);
    EXPECT_EQ(feature->GetFieldAsInteger("Caustics"), this->Caustics[static_cast<std::size_t>(number)]);
    EXPECT_EQ(feature->GetFieldAsDouble("DirectionFrom"), this->Directions[static_cast<std::size_t>(number)]);
    EXPECT_EQ(feature->IsFieldNull(feature->GetFieldIndex("WaveHeight")),
      !std::isfinite(this->Heights[static_cast<std::size_t>(number)]));
    ++number;
  }
}

TEST_F(LineFiles, crossTheAntimeridian)
{
  this->Image.place = Georeference(crsToWkt("EPSG:4326"), { 179.99, -16.0 }, glm::dvec2(0.0));
  const std::string packed = this->Files.file("lines.gpkg");
  writeGeoPackage(packed, this->Image, false);
  const Dataset file = this->open(packed);
  const std::unique_ptr<OGRFeature> feature(file->GetLayer(0)->GetNextFeature());
  const OGRLineString& line = *feature->GetGeometryRef()->toLineString();
  EXPECT_GT(line.getX(2), 180.0);
  EXPECT_LT(line.getX(2), 180.02);
  EXPECT_LT(this->largestMiss(*file->GetLayer(0), this->Image.place), RoundTrip);

  const std::string path = this->Files.file("lines.geojson");
  writeGeoJson(path, this->Image);
  const Dataset cut = this->open(path);
  const std::unique_ptr<OGRFeature> parts(cut->GetLayer(0)->GetNextFeature());
  ASSERT_EQ(wkbFlatten(parts->GetGeometryRef()->getGeometryType()), wkbMultiLineString) << "RFC 7946, 3.1.9";
  EXPECT_EQ(parts->GetGeometryRef()->toMultiLineString()->getNumGeometries(), 2);
}

TEST_F(LineFiles, sayWhyTheyCannotBeWritten)
{
  this->Image.place = Georeference(crsToWkt("EPSG:4326"), { 0.0, 0.0 }, glm::dvec2(0.0));
  EXPECT_NE(failure([&] { writeGeoPackage(this->Files.file("no/such/folder.gpkg"), this->Image, false); }), "");
  EXPECT_NE(failure([&] { writeGeoJson(this->Files.file("no/such/folder.geojson"), this->Image); }), "");
}
