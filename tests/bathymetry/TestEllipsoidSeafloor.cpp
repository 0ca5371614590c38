// Grids in longitude and latitude on the ellipsoid: where they lie and what is read of them.
#include "RasterFile.h"

#include "bathymetry/Geodesics.h"
#include "bathymetry/MapWriter.h"
#include "bathymetry/SeafloorReader.h"
#include "sim/EllipsoidMercator.h"
#include "sim/GeographicSeafloor.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <memory>

using namespace swellray;
using testing::HasSubstr;

namespace
{

double bedAt(const glm::dvec2& lonLat)
{
  return -3000.0 + 800.0 * std::sin(0.4 * lonLat.x) * std::cos(0.3 * lonLat.y) + 20.0 * lonLat.y;
}

// 165 to 195 degrees east, across the antimeridian.
ElevationGrid pacific()
{
  ElevationGrid grid;
  grid.columns = 121;
  grid.rows = 81;
  grid.origin = { 165.0, -50.0 };
  grid.spacing = { 0.25, 0.25 };
  grid.elevation.resize(grid.columns * grid.rows);
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    for (std::size_t column = 0; column < grid.columns; ++column)
    {
      grid.at(column, row) = bedAt(grid.node(column, row));
    }
  }
  return grid;
}

std::shared_ptr<const EllipsoidMercator> pacificMap()
{
  return std::make_shared<EllipsoidMercator>(6378137.0, 1.0 / 298.257223563, 180.0, -40.0);
}

std::string messageOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "nothing was thrown";
}

}

TEST(GeographicSeafloor, IsTheSplineOfItsGridThroughTheMap)
{
  const ElevationGrid grid = pacific();
  const auto map = pacificMap();
  const GeographicSeafloor seafloor(grid, map);
  const SplineSeafloor spline(grid);
  constexpr double rounding = 1e-8; // m; degrees are rounded to 3e-14, the bed falls 300 m a degree
  for (const glm::dvec2 lonLat : { glm::dvec2(165.0, -50.0), glm::dvec2(195.0, -30.0), glm::dvec2(180.0, -40.1),
         glm::dvec2(179.99, -33.3), glm::dvec2(188.88, -48.4) })
  {
    const glm::dvec2 p = map->toMap(lonLat);
    EXPECT_NEAR(seafloor.elevation(p), spline.elevation(lonLat), rounding);

    // Derivatives against differences over 2 km: their own error is of second order.
    constexpr double h = 1000.0;
    const BedSample bed = seafloor.bed(p);
    const auto at = [&](double x, double y) { return seafloor.elevation(p + h * glm::dvec2(x, y)); };
    constexpr double slope = 3e-7;
    constexpr double curvature = 3e-11; // the spline's third derivative jumps from cell to cell
    EXPECT_NEAR(bed.gradient.x, (at(1, 0) - at(-1, 0)) / (2.0 * h), slope);
    EXPECT_NEAR(bed.gradient.y, (at(0, 1) - at(0, -1)) / (2.0 * h), slope);
    EXPECT_NEAR(bed.xx, (at(1, 0) + at(-1, 0) - 2.0 * at(0, 0)) / (h * h), curvature);
    EXPECT_NEAR(bed.yy, (at(0, 1) + at(0, -1) - 2.0 * at(0, 0)) / (h * h), curvature);
    EXPECT_NEAR(bed.xy, (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4.0 * h * h), curvature);
    EXPECT_GT(glm::length(bed.gradient), 10.0 * slope);
    EXPECT_GT(std::abs(bed.xx) + std::abs(bed.yy), 10.0 * curvature);
  }
  // A quarter of a degree: 27.8 km of latitude, which is more than that of longitude at 40 degrees.
  EXPECT_NEAR(seafloor.cellSize(), 27757.0, 10.0);
  EXPECT_LE(seafloor.lowestElevation(seafloor.bounds()), -3000.0);
  EXPECT_GE(seafloor.highestElevation(seafloor.bounds()), -3000.0);
}

TEST(GeographicSeafloor, HasTheHolesAndTheOutlineOfItsGrid)
{
  ElevationGrid grid = pacific();
  // Nothing south of a line across the grid, and a gap in the middle.
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    for (std::size_t column = 0; column < grid.columns; ++column)
    {
      const glm::dvec2 node = grid.node(column, row);
      const bool gap = std::abs(node.x - 185.0) < 1.0 && std::abs(node.y + 35.0) < 1.0;
      grid.at(column, row) = gap || node.y < -60.0 + 0.5 * (node.x - 165.0) ? test::Missing : grid.at(column, row);
    }
  }
  const auto map = pacificMap();
  const GeographicSeafloor seafloor(grid, map);
  EXPECT_TRUE(seafloor.isHole(map->toMap({ 185.0, -35.0 })));
  EXPECT_TRUE(seafloor.isHole(map->toMap({ 192.0, -49.0 })));
  EXPECT_FALSE(seafloor.isHole(map->toMap({ 170.0, -40.0 })));
  const std::vector<glm::dvec2> outline = seafloor.outline();
  ASSERT_GE(outline.size(), 5u);
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const glm::dvec2 from = outline[i];
    const glm::dvec2 to = outline[(i + 1) % outline.size()];
    for (int part = 0; part < 50; ++part)
    {
      const glm::dvec2 p = from + (to - from) * (part / 50.0);
      EXPECT_FALSE(seafloor.isHole(p)) << map->toLonLat(p).x << ", " << map->toLonLat(p).y;
      EXPECT_TRUE(seafloor.bounds().contains(p));
    }
  }
  ElevationGrid polar = pacific();
  polar.origin.y = 70.0;
  EXPECT_THAT(messageOf([&] { GeographicSeafloor(polar, map); }), HasSubstr("reach beyond 85"));
}

TEST(EllipsoidGeoreference, ItsMapIsMercatorForGdalToo)
{
  const Georeference place = Georeference::onEllipsoid("EPSG:4326", 179.123456789, -41.25);
  EXPECT_EQ(place.kind(), GeoreferenceKind::Geographic);
  EXPECT_EQ(place.originLongitude(), 179.123457);
  EXPECT_EQ(place.originLatitude(), 0.0);
  EXPECT_EQ(place.convergence({ 1e6, -3e6 }), 0.0);

  OGRSpatialReference map;
  ASSERT_EQ(map.importFromWkt(mapCrs(place).c_str()), OGRERR_NONE);
  OGRSpatialReference wgs84;
  wgs84.SetWellKnownGeogCS("WGS84");
  map.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> way(OGRCreateCoordinateTransformation(&map, &wgs84));
  ASSERT_TRUE(way);
  const Georeference again = Georeference::fromMercator(mapCrs(place));
  for (const glm::dvec2 point :
    { glm::dvec2(0.0), glm::dvec2(2e6, -4e6), glm::dvec2(-5e6, 6e6), glm::dvec2(3e5, -9e6), glm::dvec2(-1.0, 1.0) })
  {
    double x = point.x;
    double y = point.y;
    ASSERT_TRUE(way->Transform(1, &x, &y));
    const glm::dvec2 lonLat = place.toFile(point);
    constexpr double micrometre = 1e-11; // degrees
    EXPECT_NEAR(std::remainder(lonLat.x - x, 360.0), 0.0, micrometre);
    EXPECT_NEAR(lonLat.y, y, micrometre);
    EXPECT_LE(std::abs(lonLat.x), 180.0);
    const glm::dvec2 back = place.fromFile(lonLat);
    EXPECT_LT(glm::length(back - point), 1e-8);
    EXPECT_LT(glm::length(place.fromFile(lonLat + glm::dvec2(360.0, 0.0)) - point), 1e-8);
    EXPECT_EQ(again.toFile(point), lonLat);
    EXPECT_EQ(place.scale(point), place.mercator()->scale(point));
  }
  EXPECT_THAT(
    messageOf([] { Georeference::onEllipsoid("EPSG:28992", 5.0, 52.0); }), HasSubstr("longitude and latitude"));
  EXPECT_THAT(messageOf([] { Georeference::fromMercator("nonsense"); }), HasSubstr("no Mercator map"));
  EXPECT_THAT(messageOf([] { Georeference::fromMercator(crsToWkt("EPSG:28992")); }), HasSubstr("no Mercator map"));
  EXPECT_FALSE(Georeference("EPSG:4326", { 1.0, 2.0 }, glm::dvec2(0.0)).mercator());
}

TEST(EllipsoidReader, KeepsTheGridAsItIs)
{
  const test::Folder folder;
  test::NetcdfFile file;
  file.x = test::steps(170.0, 0.5, 60);
  file.y = test::steps(10.0, -0.5, 70); // north first, across the equator
  file.bed = bedAt;
  file.attributes["positive"] = "up";
  const std::string path = folder.file("pacific.nc");
  file.write(path);
  SeafloorOptions options;
  options.crs = "EPSG:4326";
  options.earth = EarthModel::Ellipsoid;
  const Bathymetry read = readSeafloor(path, options);
  ASSERT_TRUE(read.geographic);
  const ElevationGrid& grid = *read.geographic;
  ASSERT_EQ(grid.columns, 60u);
  ASSERT_EQ(grid.rows, 70u);
  EXPECT_NEAR(std::remainder(grid.origin.x - 170.0, 360.0), 0.0, 1e-12);
  EXPECT_NEAR(grid.origin.y, 10.0 - 0.5 * 69, 1e-12);
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    for (std::size_t column = 0; column < grid.columns; ++column)
    {
      EXPECT_EQ(grid.at(column, row), bedAt({ file.x[column], file.y[69 - row] }));
    }
  }
  // The image beside it is its spline, and georeferenced; columns are those of the file.
  const GeographicSeafloor seafloor(grid, read.georeference.mercator());
  ASSERT_EQ(read.grid.columns, 60u);
  for (const std::size_t row : { 0u, 31u, 69u })
  {
    for (const std::size_t column : { 0u, 13u, 59u })
    {
      const glm::dvec2 node = read.grid.node(column, row);
      EXPECT_NEAR(read.grid.at(column, row), seafloor.elevation(node), 1e-8);
      EXPECT_NEAR(std::remainder(read.georeference.toFile(node).x - file.x[column], 360.0), 0.0, 1e-9);
    }
  }
  EXPECT_THAT(read.report.lines(), testing::Contains(testing::Pair("Earth", HasSubstr("scale 1 at latitude -7.25"))));

  options.smooth = 100.0;
  EXPECT_THAT(messageOf([&] { readSeafloor(path, options); }), HasSubstr("leave out smooth"));
  options.smooth = 0.0;
  options.resample = 100.0;
  EXPECT_THAT(messageOf([&] { readSeafloor(path, options); }), HasSubstr("leave out resample"));
  options.resample.reset();
  options.crs = "local";
  EXPECT_THAT(messageOf([&] { readSeafloor(path, options); }), HasSubstr("must be in longitude and latitude"));
  file.y = test::steps(80.0, 0.5, 12);
  file.write(path);
  options.crs = "EPSG:4326";
  EXPECT_THAT(messageOf([&] { readSeafloor(path, options); }), HasSubstr("reach beyond latitude 85"));
}

TEST(EllipsoidReader, TakesABasinThatIsTooWideForAPlane)
{
  const test::Folder folder;
  test::NetcdfFile file;
  file.x = test::steps(120.0, 1.0, 170);
  file.y = test::steps(-70.0, 1.0, 135);
  file.bed = bedAt;
  const std::string path = folder.file("ocean.nc");
  file.write(path);
  SeafloorOptions options;
  options.crs = "EPSG:4326";
  options.positive = Positive::Up;
  EXPECT_THAT(messageOf([&] { readSeafloor(path, options); }), HasSubstr("earth ellipsoid"));
  options.earth = EarthModel::Ellipsoid;
  const Bathymetry read = readSeafloor(path, options);
  EXPECT_EQ(read.grid.columns, 170u);
  const glm::dvec2 corner = read.georeference.toFile(read.grid.bounds().high);
  EXPECT_NEAR(corner.x, 289.0 - 360.0, 1e-9);
  EXPECT_NEAR(corner.y, 64.0, 1e-9);
}

TEST(EllipsoidReader, GridsSoundingsInLongitudeAndLatitude)
{
  // A plane over longitude, which Mercator's map keeps straight: natural neighbours meet it everywhere.
  const auto bed = [](double longitude) { return -4000.0 + 15.0 * std::remainder(longitude - 180.0, 360.0); };
  const test::Folder folder;
  const std::string path = folder.file("survey.csv");
  {
    std::ofstream file(path);
    file << "lon,lat,elevation\n" << std::setprecision(12);
    for (int i = 0; i < 4000; ++i)
    {
      // Scattered evenly over 80 x 100 degrees, across the antimeridian (Kronecker's sequence).
      const double longitude = 140.0 + 80.0 * std::fmod(0.7548776662466927 * i, 1.0);
      const double latitude = -50.0 + 100.0 * std::fmod(0.5698402909980532 * i, 1.0);
      file << std::remainder(longitude, 360.0) << ',' << latitude << ',' << bed(longitude) << '\n';
    }
  }
  SeafloorOptions options;
  EXPECT_THAT(messageOf([&] { readSeafloor(path, options); }), HasSubstr("or --earth ellipsoid"));
  options.earth = EarthModel::Ellipsoid;
  const Bathymetry read = readSeafloor(path, options);
  ASSERT_TRUE(read.geographic);
  ASSERT_TRUE(read.report.soundings);
  EXPECT_EQ(read.report.soundings->count, 4000u);
  const ElevationGrid& grid = *read.geographic;
  EXPECT_NEAR(grid.bounds().size().x, 80.0, 3.0);
  EXPECT_NEAR(grid.bounds().size().y, 100.0, 3.0);
  // As far apart as the soundings are, the same number of metres along both axes in the middle of the scene.
  EXPECT_NEAR(grid.spacing.x / grid.spacing.y, 1.0, 0.01) << "on the equator";
  std::size_t count = 0;
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    for (std::size_t column = 0; column < grid.columns; ++column)
    {
      if (!std::isnan(grid.at(column, row)))
      {
        constexpr double rounding = 1e-6; // m: printed digits of longitude, 1e-9 degrees of 15 m each, and some more
        EXPECT_NEAR(grid.at(column, row), bed(grid.node(column, row).x), rounding);
        ++count;
      }
    }
  }
  EXPECT_GT(count, grid.elevation.size() * 8 / 10);
  EXPECT_THAT(read.report.lines(), testing::Contains(testing::Pair("Earth", HasSubstr("ellipsoid"))));

  options.resample = 500000.0;
  options.crop = { 160.0, -20.0, 200.0, 20.0 };
  const Bathymetry part = readSeafloor(path, options);
  EXPECT_NEAR(part.geographic->spacing.x, 500.0 / 111.32, 0.01);
  EXPECT_NEAR(part.geographic->spacing.y, 500.0 / 110.57, 0.01);
  EXPECT_LT(part.geographic->bounds().size().x, 40.0);
  options.crop = { 10.0, -20.0, 50.0, 20.0 };
  EXPECT_THAT(messageOf([&] { readSeafloor(path, options); }), HasSubstr("crop lies outside of its soundings"));
  options.crop.reset();
  options.crs = "EPSG:32601";
  EXPECT_THAT(messageOf([&] { readSeafloor(path, options); }), HasSubstr("ogr2ogr -t_srs EPSG:4326"));
}

TEST(Geodesics, AreThoseOfGeodSolve)
{
  // GeodSolve -E on WGS 84 (Karney 2013), to its last printed digits.
  const Geodesics earth;
  const Geodesic way = earth.direct({ 150.0, -50.0 }, 40.0, 13e6);
  EXPECT_NEAR(way.to.y, 52.049929591703901, 1e-13);
  EXPECT_NEAR(way.to.x - 360.0, -141.93125092953545, 1e-12);
  EXPECT_NEAR(way.azimuthTo, 42.20456254087545, 1e-12);
  EXPECT_NEAR(way.reducedLength, 5665732.8866293672, 1e-6);
  EXPECT_NEAR(way.scale, -0.4539907029594642, 1e-13);
  const Geodesic back = earth.inverse({ -170.0, -60.0 }, { -120.0, 30.0 });
  const Geodesic there = earth.direct({ -170.0, -60.0 }, back.azimuthFrom, back.length);
  EXPECT_NEAR(there.to.x, -120.0, 1e-12);
  EXPECT_NEAR(there.to.y, 30.0, 1e-12);
  EXPECT_NEAR(there.reducedLength, back.reducedLength, 1e-6);
  EXPECT_NEAR(there.scaleBack, back.scaleBack, 1e-12);
  EXPECT_THROW(Geodesics(-1.0, 0.0), std::invalid_argument);
}
