#include "bathymetry/CurrentReader.h"

#include "RasterFile.h"

#include "sim/Angles.h"
#include "sim/SplineCurrent.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
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
  EXPECT_THAT(messageOf(folder.file("rd.tif"), Georeference("EPSG:32631", {}, {})), ::testing::HasSubstr("gdalwarp"));
  EXPECT_EQ(messageOf(folder.file("rd.tif"), Georeference("EPSG:28992", {}, {})), "");
}
