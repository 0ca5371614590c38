// Rays on the ellipsoid against geodesics (GeographicLib) and against the invariant of a zonal depth.
#include "bathymetry/Geodesics.h"
#include "sim/Angles.h"
#include "sim/EllipsoidMercator.h"
#include "sim/GeographicSeafloor.h"

#include "MapOfEarth.h"
#include "ZonalRay.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

using namespace swellray;

namespace
{

const double SemiMajor = GeographicLib::Constants::WGS84_a();
const double Flattening = GeographicLib::Constants::WGS84_f();

constexpr double DeepSea = 1e5; // m: no swell feels it

struct Shot
{
  double latitude;
  double longitude;
  double azimuth; // degrees
  double length;  // m
};

// Both hemispheres, across the equator and the antimeridian, towards the pole and away from it.
const std::vector<Shot> Shots{ { -50.0, 150.0, 40.0, 13e6 }, { 55.0, -35.0, 140.0, 10e6 },
  { -60.0, 170.0, 58.0, 11.8e6 }, { -35.0, 20.0, 100.0, 10e6 }, { 5.0, 178.0, 275.0, 10e6 }, { 0.0, 0.0, 0.0, 8e6 },
  { 20.0, -157.0, 200.0, 9e6 } };

/** An ocean of one depth over the whole map. */
class Ocean
{
public:
  explicit Ocean(const Shot& shot, double period = 15.0, double depth = DeepSea)
    : Map(SemiMajor, Flattening, shot.longitude, 30.0)
    , Floor([depth](double, double& h, double& h1, double& h2) { h = depth, h1 = h2 = 0.0; }, this->Map,
        { this->Map.toMap({ shot.longitude - 360.0, -84.0 }), this->Map.toMap({ shot.longitude + 360.0, 84.0 }) })
  {
    this->Medium.seafloor = &this->Floor;
    this->Medium.angularFrequency = 2.0 * Pi / period;
    this->Medium.map = &this->Map;
  }

  EllipsoidMercator Map;
  reference::ZonalSeafloor Floor;
  RayMedium Medium;
};

glm::dvec2 headingOf(double azimuth)
{
  return { std::sin(radians(azimuth)), std::cos(radians(azimuth)) };
}

/** A fan of rays from one point; the launch parameter is the heading, anticlockwise, rad. */
RayStart fanStart(const Ocean& ocean, const Shot& shot)
{
  const glm::dvec2 position = ocean.Map.toMap({ shot.longitude, shot.latitude });
  RayStart start = reference::startAzimuth(ocean.Medium, position, radians(shot.azimuth), glm::dvec2(0.0));
  start.dWavenumber = glm::dvec2(-start.wavenumber.y, start.wavenumber.x);
  return start;
}

/** Rays that start parallel: across a geodesic that is at a right angle to them. */
RayStart parallelStart(const Ocean& ocean, const Shot& shot)
{
  const glm::dvec2 position = ocean.Map.toMap({ shot.longitude, shot.latitude });
  ScaleSample m;
  ocean.Map.evaluate(position, m);
  const glm::dvec2 heading = headingOf(shot.azimuth);
  const glm::dvec2 left(-heading.y, heading.x);
  RayStart start = reference::startAzimuth(ocean.Medium, position, radians(shot.azimuth), m.scale * left);
  // On the map that geodesic is curved: to the left by the derivative of -ln m to its left, which is backward.
  const double turn = glm::dot(m.gradient, heading); // a metre on the Earth
  start.dWavenumber += turn * glm::length(start.wavenumber) * left;
  return start;
}

}

TEST(EllipsoidMercator, IsTheMapOfItsFormulas)
{
  const EllipsoidMercator map(SemiMajor, Flattening, 170.0, -40.0);
  // EPSG guidance note 7-2 (2019), section 3.5.1.2, Mercator variant B with the ellipsoid and parameters below.
  const EllipsoidMercator caspian(6378245.0, 1.0 / 298.3, 51.0, 42.0);
  constexpr double printed = 0.006; // m: the example is printed to the centimetre
  EXPECT_NEAR(caspian.toMap({ 53.0, 53.0 }).x, 165704.29, printed);
  EXPECT_NEAR(caspian.toMap({ 53.0, 53.0 }).y, 5171848.07, printed);

  // Nanometres on the globe, both ways, at any latitude, beyond the antimeridian.
  for (const glm::dvec2 lonLat : { glm::dvec2(170.0, 0.0), glm::dvec2(200.0, 85.0), glm::dvec2(-100.0, -85.0),
         glm::dvec2(300.0, 1e-9), glm::dvec2(170.0, -40.0), glm::dvec2(171.0, 45.0) })
  {
    const glm::dvec2 back = map.toLonLat(map.toMap(lonLat));
    EXPECT_NEAR(back.x, lonLat.x, 1e-13 * 360.0);
    EXPECT_NEAR(back.y, lonLat.y, 1e-14 * 360.0);
  }
  EXPECT_NEAR(map.scale(map.toMap({ 0.0, -40.0 })), 1.0, 1e-15);
  EXPECT_THROW(EllipsoidMercator(SemiMajor, Flattening, 0.0, 86.0), std::invalid_argument);
  EXPECT_THROW(EllipsoidMercator(-1.0, Flattening, 0.0, 0.0), std::invalid_argument);
  EXPECT_THROW(EllipsoidMercator(SemiMajor, 1.0, 0.0, 0.0), std::invalid_argument);
}

TEST(EllipsoidMercator, ItsScaleIsThatOfLengths)
{
  const EllipsoidMercator map(SemiMajor, Flattening, 0.0, 20.0);
  const GeographicLib::Geodesic judge(SemiMajor, Flattening);
  for (const double latitude : { -80.0, -33.0, 0.0, 12.0, 60.0, 84.0 })
  {
    const glm::dvec2 point = map.toMap({ 10.0, latitude });
    // Steps of 100 m either way: differences of second order, and rounding of 1e-16 of the Earth's radius.
    constexpr double step = 100.0;
    constexpr double second = 1e-7;
    for (const double azimuth : { 0.0, 50.0, 90.0 })
    {
      double ahead[2];
      double behind[2];
      judge.Direct(latitude, 10.0, azimuth, step, ahead[1], ahead[0]);
      judge.Direct(latitude, 10.0, azimuth, -step, behind[1], behind[0]);
      const glm::dvec2 way = map.toMap({ ahead[0], ahead[1] }) - map.toMap({ behind[0], behind[1] });
      EXPECT_NEAR(glm::length(way) / (2.0 * step) / map.scale(point), 1.0, second);
      EXPECT_NEAR(degrees(std::atan2(way.x, way.y)), azimuth, 1e-5); // conformal
    }
    ScaleSample m;
    map.evaluate(point, m);
    EXPECT_EQ(m.scale, map.scale(point));
    constexpr double h = 1000.0;
    const glm::dvec2 dy(0.0, h);
    const double up = map.scale(point + dy);
    const double down = map.scale(point - dy);
    EXPECT_NEAR(m.gradient.y, (up - down) / (2.0 * h), 1e-6 * std::abs(m.gradient.y) + 1e-13);
    EXPECT_NEAR(m.yy, (up + down - 2.0 * m.scale) / (h * h), 1e-3 * m.yy);
    EXPECT_EQ(m.gradient.x, 0.0);
    const ParallelSample parallel = map.parallel(point.y);
    const ParallelSample north = map.parallel(point.y + h);
    const ParallelSample south = map.parallel(point.y - h);
    EXPECT_NEAR(degrees(parallel.latitude), latitude, 1e-12);
    EXPECT_NEAR(parallel.dy, (north.latitude - south.latitude) / (2.0 * h), 1e-6 * parallel.dy);
    EXPECT_NEAR(parallel.dyy, (north.dy - south.dy) / (2.0 * h), 1e-6 * std::abs(parallel.dyy) + 1e-21);
  }
}

TEST(EllipsoidRays, AreGeodesicsInDeepWater)
{
  // Default tolerance: 1e-8 of a wavelength of 351 m a step; asked for is 1 m.
  constexpr double position = 1e-3; // m after 8,000 to 13,000 km
  constexpr double angle = 1e-9;    // degrees
  constexpr double relative = 1e-9;
  const GeographicLib::Geodesic judge(SemiMajor, Flattening);
  for (const Shot& shot : Shots)
  {
    const Ocean ocean(shot);
    HamiltonianRay ray(ocean.Medium, fanStart(ocean, shot), 1e-8);
    HamiltonianRay beside(ocean.Medium, parallelStart(ocean, shot), 1e-8);
    const double k = solveWavenumber(ocean.Medium.angularFrequency, DeepSea, ocean.Medium.gravity);
    const double speed = 0.5 * ocean.Medium.angularFrequency / k;
    constexpr int parts = 20;
    for (int i = 1; i <= parts; ++i)
    {
      const double s = shot.length * i / parts;
      double lat = 0.0;
      double lon = 0.0;
      double azimuth = 0.0;
      double m12 = 0.0;
      double m12Scale = 0.0;
      double back = 0.0;
      judge.Direct(shot.latitude, shot.longitude, shot.azimuth, s, lat, lon, azimuth, m12, m12Scale, back);
      RayPoint point;
      RayPoint parallel;
      ASSERT_TRUE(ray.advance(FrontMeasure::Length, s, point));
      ASSERT_TRUE(beside.advance(FrontMeasure::Length, s, parallel));
      const glm::dvec2 place = ocean.Map.toLonLat(point.position);
      double distance = 0.0;
      judge.Inverse(lat, lon, place.y, place.x, distance);
      EXPECT_LT(distance, position) << shot.azimuth << " after " << s;
      EXPECT_NEAR(
        std::remainder(degrees(std::atan2(point.wavenumber.x, point.wavenumber.y)) - azimuth, 360.0), 0.0, angle);
      EXPECT_NEAR(glm::length(point.wavenumber), k, relative * k);
      EXPECT_NEAR(point.phase, k * s, relative * k * s);
      EXPECT_NEAR(point.travelTime, s / speed, relative * s / speed);
      // The tube of the point source is the reduced length, that of the parallel rays the geodesic scale.
      EXPECT_NEAR(point.tubeWidth, m12, 1e-6 * SemiMajor);
      EXPECT_NEAR(parallel.tubeWidth, m12Scale, 1e-6);
      EXPECT_EQ(parallel.caustics, m12Scale < 0.0 ? 1 : 0);
    }
    EXPECT_LT(ray.dispersionError(), 1e-9);
  }
}

TEST(EllipsoidRays, ErrorsFollowTheTolerance)
{
  const GeographicLib::Geodesic judge(SemiMajor, Flattening);
  const Shot& shot = Shots[2];
  const Ocean ocean(shot);
  double lat = 0.0;
  double lon = 0.0;
  judge.Direct(shot.latitude, shot.longitude, shot.azimuth, shot.length, lat, lon);
  double before = std::numeric_limits<double>::infinity();
  for (const double tolerance : { 1e-5, 1e-7, 1e-9 })
  {
    HamiltonianRay ray(ocean.Medium, fanStart(ocean, shot), tolerance);
    RayPoint point;
    ASSERT_TRUE(ray.advance(FrontMeasure::Length, shot.length, point));
    const glm::dvec2 place = ocean.Map.toLonLat(point.position);
    double distance = 0.0;
    judge.Inverse(lat, lon, place.y, place.x, distance);
    EXPECT_LT(distance, 0.1 * before);
    before = distance;
  }
}

TEST(EllipsoidRays, KeepTheInvariantOverAZonalDepth)
{
  struct Profile
  {
    double h0, h1, waves, period, latitude, north, azimuth;
  };
  // That of the reference table, a steep one felt by a swell, and one that falls towards the pole.
  for (const Profile& p : { Profile{ 4000.0, 1500.0, 3.0, 1200.0, -45.0, 10.0, 20.0 },
         Profile{ 4000.0, 1500.0, 3.0, 1200.0, -45.0, 0.0, 60.0 }, Profile{ 150.0, 60.0, 7.0, 18.0, 5.0, 55.0, 30.0 },
         Profile{ 3000.0, -1200.0, 1.0, 600.0, -60.0, 20.0, -25.0 } })
  {
    const auto depth = [&](reference::Real phi) -> reference::Real { return p.h0 + p.h1 * std::sin(p.waves * phi); };
    const double longitude = 175.0;
    const EllipsoidMercator map(SemiMajor, Flattening, longitude, 10.0);
    const reference::ZonalSeafloor floor(
      [&](double phi, double& h, double& h1, double& h2)
      {
        h = p.h0 + p.h1 * std::sin(p.waves * phi);
        h1 = p.h1 * p.waves * std::cos(p.waves * phi);
        h2 = -p.h1 * p.waves * p.waves * std::sin(p.waves * phi);
      },
      map, { map.toMap({ longitude - 360.0, -84.0 }), map.toMap({ longitude + 360.0, 84.0 }) });
    RayMedium medium;
    medium.seafloor = &floor;
    medium.map = &map;
    medium.angularFrequency = 2.0 * Pi / p.period;
    const reference::Real degree = reference::Pi / 180.0L;
    const reference::ZonalRay exact(depth, p.period, p.latitude * degree, longitude * degree, p.azimuth * degree);
    const glm::dvec2 from = map.toMap({ longitude, p.latitude });
    // A row along the parallel, as wide as one metre across the ray.
    const glm::dvec2 row(-map.scale(from) / std::cos(radians(p.azimuth)), 0.0);
    HamiltonianRay ray(medium, reference::startAzimuth(medium, from, radians(p.azimuth), row), 1e-12);
    for (int i = 1; i <= 15; ++i)
    {
      const double latitude = p.latitude + (p.north - p.latitude) * i / 15.0;
      const reference::ZonalPlace place = exact.at(latitude * degree);
      RayPoint point;
      ASSERT_TRUE(ray.advance(FrontMeasure::Length, place.length, point)) << p.period << " at " << latitude;
      const glm::dvec2 wanted = map.toMap({ degrees(place.longitude), latitude });
      constexpr double relative = 1e-11;
      EXPECT_LT(glm::length(point.position - wanted), relative * place.length) << p.period << " at " << latitude;
      EXPECT_NEAR(std::atan2(point.wavenumber.x, point.wavenumber.y), place.azimuth, 1e-10);
      EXPECT_NEAR(point.phase, place.phase, relative * place.phase);
      EXPECT_NEAR(point.travelTime, place.time, relative * place.time);
      EXPECT_NEAR(point.tubeWidth, place.width, 1e-8 * place.width);
    }
  }
}
