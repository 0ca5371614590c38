#include "bathymetry/CurrentReader.h"

#include "RasterFile.h"

#include "sim/Angles.h"
#include "sim/SplineCurrent.h"

#include <ogr_spatialref.h>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

using namespace swellray;
using namespace swellray::test;

namespace
{

const Rectangle Scene{ { 0.0, 0.0 }, { 300.0, 200.0 } };

std::string messageOf(const std::string& path, const Georeference& scene, const Rectangle& bounds = Scene)
{
  try
  {
    readCurrent(path, scene, bounds);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

NetcdfFile plane()
{
  NetcdfFile file;
  file.x = steps(1000.0, 10.0, 40);
  file.y = steps(5000.0, 10.0, 30);
  file.xName = "x";
  file.yName = "y";
  file.xUnits = file.yUnits = "m";
  file.units = "m s-1";
  file.variables = { "u", "v" };
  file.bed = [](const glm::dvec2& p) { return 1e-3 * (p.x - 1000.0) - 2e-3 * (p.y - 5000.0); };
  return file;
}

}

TEST(CurrentReader, keepsTheNodesOfTheScenesPlane)
{
  const Folder folder;
  plane().write(folder.file("c.nc"));
  const Georeference scene("", {}, { 1040.0, 5030.0 });
  const CurrentGrids grids = readCurrent(folder.file("c.nc"), scene, Scene);
  EXPECT_EQ(grids.u.columns, 40u);
  EXPECT_EQ(grids.u.rows, 30u);
  EXPECT_EQ(grids.u.origin, glm::dvec2(-40.0, -30.0));
  EXPECT_EQ(grids.u.spacing, glm::dvec2(10.0, 10.0));
  // A plane is kept by the spline to rounding.
  const SplineCurrent current(grids.u, grids.v);
  EXPECT_NEAR(current.velocity({ 12.0, 33.0 }).x, 1e-3 * 52.0 - 2e-3 * 63.0, 1e-12);
  EXPECT_TRUE(grids.notes.empty());
}

TEST(CurrentReader, knowsUnitsAndOtherNames)
{
  const Folder folder;
  NetcdfFile file = plane();
  file.units = "cm/s";
  file.variables = { "water_u", "water_v", "temperature" };
  file.write(folder.file("c.nc"));
  const CurrentGrids grids = readCurrent(folder.file("c.nc"), Georeference(), Scene);
  EXPECT_NEAR(grids.v.at(10, 0), 0.01 * 0.1, 1e-12);
  file.units = "degC";
  file.write(folder.file("d.nc"));
  EXPECT_THAT(messageOf(folder.file("d.nc"), Georeference()), ::testing::HasSubstr("unit 'degC' is not understood"));
}

TEST(CurrentReader, turnsWhatIsEastAndNorthIntoTheScenesAxes)
{
  const Folder folder;
  NetcdfFile file;
  file.x = steps(3.0, 0.01, 101);
  file.y = steps(52.0, 0.01, 101);
  file.units = "m/s";
  file.variables = { "uo", "vo" };
  file.bed = [](const glm::dvec2& p) { return 0.5 + 0.2 * (p.x - 3.0) - 0.1 * (p.y - 52.0); };
  file.write(folder.file("c.nc"));
  const Georeference scene("EPSG:4326", { 3.5, 52.5 }, {});
  const Rectangle bounds{ { -20000.0, -20000.0 }, { 20000.0, 20000.0 } };
  const CurrentGrids grids = readCurrent(folder.file("c.nc"), scene, bounds);
  EXPECT_EQ(grids.u.bounds().low, bounds.low);
  EXPECT_NEAR(grids.u.bounds().high.x, bounds.high.x, 1e-9);
  for (const auto& [column, row] : { std::pair<std::size_t, std::size_t>{ 0, 0 }, { 7, 20 }, { 30, 5 } })
  {
    const glm::dvec2 point = grids.u.node(column, row);
    const double speed = file.bed(*scene.toLonLat(point));
    // Both components are the speed: towards north-east, which the meridian's convergence turns.
    const double heading = radians(45.0) + radians(scene.convergence(point));
    EXPECT_NEAR(grids.u.at(column, row), std::sqrt(2.0) * speed * std::cos(heading), 1e-9);
    EXPECT_NEAR(grids.v.at(column, row), std::sqrt(2.0) * speed * std::sin(heading), 1e-9);
  }
  // The west of the scene lies west of its central meridian, where true north leans to the right of the map's.
  EXPECT_LT(scene.convergence({ -20000.0, 0.0 }), 0.0);

  const Rectangle wide{ { -60000.0, -20000.0 }, { 20000.0, 20000.0 } };
  EXPECT_THAT(messageOf(folder.file("c.nc"), scene, wide), ::testing::HasSubstr("not all of the scene"));
  EXPECT_THAT(messageOf(folder.file("c.nc"), Georeference()), ::testing::HasSubstr("where on Earth"));
}

TEST(CurrentReader, bringsAnotherProjectionToTheScene)
{
  // The Dutch grid seen in UTM, whose meridians differ by some two degrees, and in longitude and latitude.
  const Folder folder;
  RasterFile file;
  file.crs = "EPSG:28992";
  file.columns = 60;
  file.rows = 60;
  file.transform = { 85000.0, 500.0, 0.0, 465000.0, 0.0, -500.0 };
  file.bands = 2;
  const auto speedAt = [](const glm::dvec2& p) { return 0.5 + 1e-5 * (p.x - 1e5) - 2e-5 * (p.y - 4.5e5); };
  file.fill(speedAt);
  file.writeGeoTiff(folder.file("c.tif"));
  OGRSpatialReference dutch;
  dutch.importFromEPSG(28992);
  const Rectangle bounds{ { -4000.0, -3000.0 }, { 4000.0, 3000.0 } };
  for (const char* crs : { "EPSG:32631", "EPSG:4326" })
  {
    OGRSpatialReference other;
    other.SetFromUserInput(crs);
    dutch.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    other.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> way(OGRCreateCoordinateTransformation(&dutch, &other));
    const auto toOther = [&](glm::dvec2 p)
    {
      EXPECT_TRUE(way->Transform(1, &p.x, &p.y));
      return p;
    };
    const glm::dvec2 middle = toOther({ 100000.0, 450000.0 });
    const Georeference scene(crs, middle, middle);
    const CurrentGrids grids = readCurrent(folder.file("c.tif"), scene, bounds);
    const SplineCurrent current(grids.u, grids.v);
    for (const glm::dvec2 place : { glm::dvec2(100000.0, 450000.0), { 98000.0, 451500.0 }, { 102500.0, 448700.0 } })
    {
      // Both components are the speed: along the Dutch diagonal, as 100 m of it lie in the scene. A bed of degree 1 in the file is
      // one in the scene but for 1e-6 over the scene.
      const glm::dvec2 here = scene.fromFile(toOther(place));
      const glm::dvec2 there = scene.fromFile(toOther(place + glm::dvec2(50.0 * std::sqrt(2.0))));
      const glm::dvec2 expected = std::sqrt(2.0) * speedAt(place) * glm::normalize(there - here);
      EXPECT_LT(glm::length(current.velocity(here) - expected), 2e-5) << crs;
      if (std::string(crs) == "EPSG:32631")
      {
        EXPECT_GT(
          glm::length(current.velocity(here) - glm::dvec2(speedAt(place))), 0.01); // not as it stands in the file
      }
    }
  }
}

TEST(CurrentReader, refusesWhatIsNoCurrent)
{
  const Folder folder;
  EXPECT_THAT(messageOf(folder.file("none.nc"), Georeference()), ::testing::HasSubstr("none.nc': no such file"));
  NetcdfFile file = plane();
  file.variables = { "z" };
  file.write(folder.file("z.nc"));
  EXPECT_THAT(messageOf(folder.file("z.nc"), Georeference()), ::testing::HasSubstr("named u and v"));
  file = plane();
  file.bed = [](const glm::dvec2&) { return 999.0; };
  file.write(folder.file("fast.nc"));
  EXPECT_THAT(messageOf(folder.file("fast.nc"), Georeference()), ::testing::HasSubstr("999 m/s"));
  RasterFile raster;
  raster.crs = "EPSG:28992";
  raster.bands = 2;
  raster.fill([](const glm::dvec2&) { return 0.5; });
  raster.writeGeoTiff(folder.file("rd.tif"));
  EXPECT_THAT(
    messageOf(folder.file("rd.tif"), Georeference("EPSG:32631", {}, {})), ::testing::HasSubstr("not all of the scene"));
  EXPECT_EQ(messageOf(folder.file("rd.tif"), Georeference("EPSG:28992", {}, {})), "");
}
