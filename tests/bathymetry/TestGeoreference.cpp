#include "bathymetry/Georeference.h"

#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <memory>
#include <thread>
#include <vector>

using namespace swellray;

namespace
{

constexpr double Millimetre = 1e-3;

// Two implementations of the same series: rounding at distances of 1e6 m.
constexpr double Series = 1e-6;

Georeference geographic(double longitude, double latitude, const char* crs = "EPSG:4326")
{
  return Georeference(crs, { longitude, latitude }, glm::dvec2(0.0));
}

std::vector<glm::dvec2> scene(double size)
{
  std::vector<glm::dvec2> points;
  for (int j = -5; j <= 5; ++j)
  {
    for (int i = -5; i <= 5; ++i)
    {
      points.emplace_back(size * i / 5.0, size * j / 5.0);
    }
  }
  return points;
}

}

TEST(Georeference, LocalPlane)
{
  const Georeference plane;
  EXPECT_EQ(plane.kind(), GeoreferenceKind::Local);
  EXPECT_TRUE(plane.crs().empty());
  EXPECT_TRUE(std::isnan(plane.originLongitude()));
  EXPECT_FALSE(plane.toLonLat({ 1.0, 2.0 }).has_value());
  EXPECT_EQ(plane.convergence({ 1.0, 2.0 }), 0.0);
  const Georeference moved("", glm::dvec2(0.0), { 100.0, 200.0 });
  EXPECT_EQ(moved.toFile({ 1.0, 2.0 }), glm::dvec2(101.0, 202.0));
  EXPECT_EQ(moved.fromFile({ 101.0, 202.0 }), glm::dvec2(1.0, 2.0));
}

TEST(Georeference, GeographicRoundTrip)
{
  for (const glm::dvec2& centre :
    { glm::dvec2(-73.75, 40.3), glm::dvec2(115.6, -32.6), glm::dvec2(179.99, 0.0), glm::dvec2(4.6, 78.0) })
  {
    const Georeference map = geographic(centre.x, centre.y);
    for (const glm::dvec2& p : scene(500e3))
    {
      const glm::dvec2 back = map.fromFile(map.toFile(p));
      EXPECT_NEAR(back.x, p.x, Millimetre);
      EXPECT_NEAR(back.y, p.y, Millimetre);
      const glm::dvec2 turned = map.fromFile(map.toFile(p) + glm::dvec2(360.0, 0.0));
      EXPECT_NEAR(turned.x, p.x, Millimetre);
    }
    const glm::dvec2 middle = map.toFile(glm::dvec2(0.0));
    EXPECT_NEAR(middle.x, centre.x, 1e-12);
    EXPECT_NEAR(middle.y, centre.y, 1e-12);
  }
}

TEST(Georeference, GeographicAgreesWithProj)
{
  OGRSpatialReference lonLat;
  lonLat.SetFromUserInput("EPSG:4326");
  lonLat.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference plane;
  plane.SetFromUserInput("+proj=tmerc +lon_0=-73.75 +lat_0=40.325 +k=1 +ellps=WGS84 +datum=WGS84 +units=m");
  const std::unique_ptr<OGRCoordinateTransformation> proj(OGRCreateCoordinateTransformation(&lonLat, &plane));
  ASSERT_NE(proj, nullptr);
  const Georeference map = geographic(-73.75, 40.325);
  for (const glm::dvec2& p : scene(400e3))
  {
    const glm::dvec2 file = map.toFile(p);
    double x = file.x;
    double y = file.y;
    ASSERT_TRUE(proj->Transform(1, &x, &y));
    EXPECT_NEAR(x, p.x, Series);
    EXPECT_NEAR(y, p.y, Series);
  }
}

TEST(Georeference, EllipsoidIsThatOfTheCrs)
{
  // Bessel's radius is 740 m, 1.2e-4, shorter: 6 m in 50 km.
  const glm::dvec2 file(5.0, 52.45);
  const double wgs84 = geographic(5.0, 52.0).fromFile(file).y;
  const double bessel = geographic(5.0, 52.0, "EPSG:4289").fromFile(file).y;
  EXPECT_NEAR(wgs84 - bessel, 1.2e-4 * 50e3, 1.0);
}

TEST(Georeference, ProjectedIsAnOriginAndAUnit)
{
  const Georeference metres("EPSG:32618", glm::dvec2(0.0), { 580000.0, 4480000.0 });
  EXPECT_EQ(metres.toFile({ 10.0, 20.0 }), glm::dvec2(580010.0, 4480020.0));
  const Georeference feet("EPSG:2263", glm::dvec2(0.0), { 980000.0, 150000.0 });
  EXPECT_NEAR(feet.metresPerUnit(), 1200.0 / 3937.0, 1e-15);
  EXPECT_NEAR(feet.toFile({ 1200.0, 0.0 }).x, 983937.0, 1e-6);
  EXPECT_NEAR(feet.fromFile({ 983937.0, 150000.0 }).x, 1200.0, 1e-6);
}

TEST(Georeference, ProjectedToLongitudeAndLatitude)
{
  // UTM zone 18: on the central meridian 75 W easting is 500 km, on the equator northing 0.
  const Georeference utm("EPSG:32618", glm::dvec2(0.0), { 500000.0, 0.0 });
  const auto origin = utm.toLonLat(glm::dvec2(0.0));
  ASSERT_TRUE(origin.has_value());
  EXPECT_NEAR(origin->x, -75.0, 1e-9);
  EXPECT_NEAR(origin->y, 0.0, 1e-9);
  EXPECT_NEAR(utm.originLongitude(), -75.0, 1e-9);

  std::vector<glm::dvec2> points = scene(200e3);
  std::vector<glm::dvec2> lonLat(points.size());
  ASSERT_TRUE(utm.toLonLat(points.size(), points.data(), lonLat.data()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto one = utm.toLonLat(points[i]);
    ASSERT_TRUE(one.has_value());
    EXPECT_EQ(one->x, lonLat[i].x);
    EXPECT_EQ(one->y, lonLat[i].y);
  }
  EXPECT_TRUE(utm.toLonLat(points.size(), points.data(), points.data())) << "in place";
  EXPECT_EQ(points, lonLat);
}

TEST(Georeference, ConvergenceIsTheBearingOfGridNorth)
{
  // On a sphere tan(gamma) = tan(longitude from the meridian) sin(latitude); the ellipsoid changes it by 1e-3 of it.
  const double latitude = 40.0;
  const double away = 2.0;
  const double radian = std::acos(-1.0) / 180.0;
  const double gamma = std::atan(std::tan(away * radian) * std::sin(latitude * radian)) / radian;
  const Georeference map = geographic(-75.0, latitude);
  EXPECT_NEAR(map.convergence(map.fromFile({ -75.0 + away, latitude })), gamma, 2e-3);
  EXPECT_NEAR(map.convergence(map.fromFile({ -75.0 - away, latitude })), -gamma, 2e-3);
  EXPECT_NEAR(map.convergence(glm::dvec2(0.0)), 0.0, 1e-9);

  const Georeference utm("EPSG:32618", glm::dvec2(0.0), glm::dvec2(0.0));
  for (const glm::dvec2& p : { glm::dvec2(650e3, 4.4e6), glm::dvec2(400e3, 4.4e6), glm::dvec2(300e3, 1e6) })
  {
    const auto lonLat = utm.toLonLat(p);
    ASSERT_TRUE(lonLat.has_value());
    const Georeference same = geographic(-75.0, 0.0);
    const double exact = same.convergence(same.fromFile(*lonLat));
    EXPECT_NEAR(utm.convergence(p), exact, 1e-5);
  }
}

TEST(Georeference, ScaleOfTheMap)
{
  const Georeference map = geographic(10.0, 50.0);
  EXPECT_NEAR(map.scale(glm::dvec2(0.0)), 1.0, 1e-12);
  // k - 1 = x^2/(2 R^2), R the Gaussian radius of curvature at 50 N, 6,382 km.
  const double x = 100e3;
  EXPECT_NEAR(map.scale({ x, 0.0 }) - 1.0, 0.5 * x * x / (6.382e6 * 6.382e6), 1e-8);
}

TEST(Georeference, BuiltAgainFromItsFields)
{
  for (const Georeference& first :
    { geographic(-155.07 + 360.0, 19.74), Georeference("EPSG:28992", glm::dvec2(0.0), { 101131.0, 511890.0 }),
      Georeference("", glm::dvec2(0.0), { 3.0, 4.0 }) })
  {
    const Georeference again(
      first.crs(), { first.originLongitude(), first.originLatitude() }, { first.originX(), first.originY() });
    EXPECT_EQ(again.kind(), first.kind());
    EXPECT_EQ(again.crs(), first.crs());
    EXPECT_EQ(again.crsName(), first.crsName());
    const glm::dvec2 p(1234.5, -678.9);
    EXPECT_EQ(again.toFile(p), first.toFile(p));
  }
  EXPECT_NEAR(geographic(-155.07 + 360.0, 19.74).originLongitude(), -155.07, 1e-9);
}

TEST(Georeference, RefusesWhatItCannotMap)
{
  EXPECT_THROW(Georeference("no such CRS", glm::dvec2(0.0), glm::dvec2(0.0)), std::runtime_error);
  EXPECT_THROW(Georeference("EPSG:4978", glm::dvec2(0.0), glm::dvec2(0.0)), std::runtime_error) << "geocentric";
  EXPECT_THROW(Georeference("EPSG:4807", glm::dvec2(0.0), glm::dvec2(0.0)), std::runtime_error) << "grads from Paris";
  EXPECT_THROW(geographic(0.0, 91.0), std::runtime_error);
  EXPECT_THROW(geographic(0.0, std::nan("")), std::runtime_error);
}

TEST(Georeference, ThreadsMayShareIt)
{
  const Georeference utm("EPSG:32618", glm::dvec2(0.0), { 500000.0, 4000000.0 });
  const std::vector<glm::dvec2> points = scene(100e3);
  std::vector<std::vector<glm::dvec2>> results(4, std::vector<glm::dvec2>(points.size()));
  std::vector<std::thread> threads;
  for (auto& result : results)
  {
    threads.emplace_back([&] { utm.toLonLat(points.size(), points.data(), result.data()); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& result : results)
  {
    EXPECT_EQ(result, results[0]);
    EXPECT_FALSE(std::isnan(result[0].x));
  }
}
