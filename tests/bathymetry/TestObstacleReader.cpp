#include "bathymetry/ObstacleReader.h"

#include "RasterFile.h"
#include "bathymetry/QuietGdal.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

using namespace swellray;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

// Of coordinates of some hundred kilometres through a map projection, m.
constexpr double PlaceTolerance = 1e-3;

const Rectangle Everywhere{ { -1e7, -1e7 }, { 1e7, 1e7 } };

class ObstacleFiles : public testing::Test
{
protected:
  std::string write(const std::string& name, const std::string& words) const
  {
    std::ofstream(this->Files.file(name)) << words;
    return this->Files.file(name);
  }

  std::string collection(const std::string& features) const
  {
    return this->write("walls.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}");
  }

  static std::string feature(
    const std::string& type, const std::string& coordinates, const std::string& properties = "")
  {
    return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":")" + type +
      R"(","coordinates":)" + coordinates + "}}";
  }

  static std::string failure(const std::function<void()>& call)
  {
    try
    {
      call();
    }
    catch (const std::exception& error)
    {
      return error.what();
    }
    return "";
  }

  test::Folder Files;
  Georeference Local; // file coordinates are metres
};

double area(const std::vector<glm::dvec2>& ring)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const glm::dvec2& a = ring[i];
    const glm::dvec2& b = ring[(i + 1) % ring.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

}

TEST_F(ObstacleFiles, holdPolygonsWithHolesAndLines)
{
  // Outer ring clockwise, hole anticlockwise, as they must not be; a point twice and one on a straight side.
  const std::string path = this->collection(
    feature("Polygon", "[[[0,0],[0,10],[0,20],[20,20],[20,20],[20,0],[0,0]],[[5,5],[9,5],[9,9],[5,9],[5,5]]]",
      R"("reflection":0.4)") +
    "," + feature("LineString", "[[30,0],[40,0],[50,10]]"));
  const ObstacleFile file = readObstacles(path, this->Local, Everywhere, 0.7);
  ASSERT_EQ(file.obstacles.size(), 3u);
  EXPECT_EQ(file.obstacles[0].points.size(), 4u);
  EXPECT_NEAR(area(file.obstacles[0].points), 400.0, 1e-9) << "anticlockwise around land";
  EXPECT_NEAR(area(file.obstacles[1].points), -16.0, 1e-9) << "clockwise around water";
  EXPECT_TRUE(file.obstacles[0].closed && file.obstacles[1].closed);
  EXPECT_EQ(file.obstacles[0].reflection, 0.4);
  EXPECT_EQ(file.obstacles[1].reflection, 0.4);
  EXPECT_FALSE(file.obstacles[2].closed);
  EXPECT_EQ(file.obstacles[2].points.size(), 3u);
  EXPECT_EQ(file.obstacles[2].reflection, 0.7);
  const Obstacles walls(file.obstacles);
  EXPECT_TRUE(walls.inside({ 2.0, 2.0 }));
  EXPECT_FALSE(walls.inside({ 7.0, 7.0 }));
}

TEST_F(ObstacleFiles, comeFromAnyCrs)
{
  // The corner of a breakwater at Hilo by longitude and latitude, in UTM zone 5 and on the scene's own map.
  const glm::dvec2 corner(-155.0645, 19.7395);
  const std::string path = this->collection(feature("LineString", "[[-155.0645,19.7395],[-155.0600,19.7380]]"));
  const Georeference geographic(crsToWkt("EPSG:4326"), { -155.06, 19.74 }, glm::dvec2(0.0));
  EXPECT_NEAR(
    glm::distance(readObstacles(path, geographic, Everywhere, 0.0).obstacles[0].points[0], geographic.fromFile(corner)),
    0.0, 1e-6);

  const Georeference utm(crsToWkt("EPSG:32605"), glm::dvec2(0.0), { 280000.0, 2180000.0 });
  const glm::dvec2 inUtm = readObstacles(path, utm, Everywhere, 0.0).obstacles[0].points[0];
  const auto back = utm.toLonLat(inUtm);
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->x, corner.x, 1e-8);
  EXPECT_NEAR(back->y, corner.y, 1e-8);

  // And from UTM to the geographic scene, through a GeoPackage.
  const QuietGdal quiet;
  const std::string packed = this->Files.file("walls.gpkg");
  {
    std::unique_ptr<GDALDataset> dataset(
      GetGDALDriverManager()->GetDriverByName("GPKG")->Create(packed.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    ASSERT_TRUE(dataset);
    OGRSpatialReference reference;
    reference.importFromEPSG(32605);
    OGRLayer* layer = dataset->CreateLayer("walls", &reference, wkbLineString, nullptr);
    OGRFieldDefn field("reflection", OFTReal);
    layer->CreateField(&field);
    OGRFeature feature(layer->GetLayerDefn());
    OGRLineString line;
    line.addPoint(inUtm.x + 280000.0, inUtm.y + 2180000.0);
    line.addPoint(inUtm.x + 280500.0, inUtm.y + 2180000.0);
    feature.SetGeometry(&line);
    feature.SetField(0, 0.25);
    ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
  }
  const ObstacleFile file = readObstacles(packed, geographic, Everywhere, 0.0);
  EXPECT_NEAR(glm::distance(file.obstacles[0].points[0], geographic.fromFile(corner)), 0.0, PlaceTolerance);
  EXPECT_EQ(file.obstacles[0].reflection, 0.25);
}

TEST_F(ObstacleFiles, sayWhatTheyLeaveOut)
{
  const std::string path =
    this->collection(feature("LineString", "[[0,0],[10,0]]") + "," + feature("LineString", "[[900,900],[910,900]]") +
      "," + feature("Point", "[5,5]") + "," + feature("Polygon", "[[[20,0],[30,10],[30,0],[20,12],[20,0]]]") + "," +
      feature("Polygon", "[[[1,1],[1,1],[1,1],[1,1]]]"));
  const ObstacleFile file = readObstacles(path, this->Local, { { -50.0, -50.0 }, { 50.0, 50.0 } }, 0.0);
  EXPECT_EQ(file.obstacles.size(), 2u);
  EXPECT_THAT(file.notes,
    ElementsAre(HasSubstr("1 points of the obstacles are passed over"), "1 obstacles lie outside of the scene",
      HasSubstr("1 rings of obstacles cross themselves"), "1 obstacles have no size",
      HasSubstr("taken in the coordinates of the scene's file")));
  // A polygon around all of the scene is in it.
  const std::string around = this->collection(feature("Polygon", "[[[-99,-99],[99,-99],[99,99],[-99,99],[-99,-99]]]"));
  EXPECT_EQ(readObstacles(around, this->Local, { { -50.0, -50.0 }, { 50.0, 50.0 } }, 0.0).obstacles.size(), 1u);
}

TEST_F(ObstacleFiles, sayWhatIsWrong)
{
  const auto read = [this](const std::string& path, double reflection = 0.0) {
    return [=] { readObstacles(path, this->Local, { { 0.0, 0.0 }, { 50.0, 50.0 } }, reflection); };
  };
  EXPECT_THAT(failure(read("none.geojson")), HasSubstr("obstacles 'none.geojson': no such file"));
  EXPECT_THAT(failure(read(this->write("text.geojson", "not json"))), HasSubstr("text.geojson': "));
  EXPECT_THAT(failure(read(this->collection(""))), HasSubstr("no polygons and no lines"));
  EXPECT_THAT(failure(read(this->collection(feature("Point", "[1,2]")))), HasSubstr("only points"));
  EXPECT_THAT(failure(read(this->collection(feature("LineString", "[[600,0],[700,0]]")))),
    HasSubstr("none of its 1 polygons and lines comes near the scene"));
  EXPECT_THAT(failure(read(this->collection(feature("LineString", "[[6,0],[7,0]]", R"("reflection":1.2)")))),
    HasSubstr("its property reflection must be 0 to 1, not '1.2'"));
  EXPECT_EQ(failure(read("any.geojson", -0.1)), "reflection must be 0 to 1, not -0.1");
}

TEST_F(ObstacleFiles, ofAllKindsAreReadOrRefused)
{
  // Collections are taken apart; a solid is no wall.
  const std::string path =
    this->collection(feature("MultiPolygon", "[[[[0,0],[9,0],[9,9],[0,0]]],[[[20,0],[29,0],[29,9],[20,0]]]]") + "," +
      feature("MultiLineString", "[[[30,0],[39,0]],[[30,5],[39,5]]]"));
  EXPECT_EQ(readObstacles(path, this->Local, Everywhere, 0.0).obstacles.size(), 4u);
}

TEST(ObstacleSites, HiloIsLandBehindItsBreakwater)
{
  const char* set = std::getenv("SWELLRAY_DATA");
  const std::filesystem::path path =
    std::filesystem::path(set ? set : SWELLRAY_DATA_DEFAULT) / "sites/_shorelines/hilo_land_polygons.geojson";
  if (!std::filesystem::exists(path))
  {
    GTEST_SKIP() << "no " << path;
  }
  const Georeference place(crsToWkt("EPSG:4326"), { -155.06, 19.74 }, glm::dvec2(0.0));
  const ObstacleFile file = readObstacles(path.string(), place, { { -5000.0, -5000.0 }, { 5000.0, 5000.0 } }, 0.0);
  EXPECT_EQ(file.obstacles.size(), 4u) << "the rings of two polygons, one with lagoons";
  const Obstacles walls(file.obstacles);
  // The town, and the open bay.
  EXPECT_TRUE(walls.inside(place.fromFile({ -155.08, 19.71 })));
  EXPECT_FALSE(walls.inside(place.fromFile({ -155.05, 19.76 })));
}
