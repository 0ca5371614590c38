// Seas on the ellipsoid: where their waves come from, against geodesics (GeographicLib) and the invariant of a zonal depth; the
// shadow of an island along a geodesic.
#include "sim/Angles.h"
#include "sim/BackwardTracer.h"
#include "sim/EllipsoidMercator.h"
#include "sim/GeographicSeafloor.h"
#include "sim/SpectralSea.h"

#include "MapOfEarth.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace swellray;

namespace
{

const double SemiMajor = GeographicLib::Constants::WGS84_a();
const double Flattening = GeographicLib::Constants::WGS84_f();

// Of rays of a tolerance of 1e-11 a step, over 3,000 km: those of TestEllipsoidRays.cpp.
constexpr double TightHeading = 1e-9;   // rad
constexpr double TightTime = 1e-9;      // relative
constexpr double TightInvariant = 1e-9; // relative

double headingOf(double azimuth)
{
  return radians(90.0 - azimuth);
}

double turn(double a, double b)
{
  return std::remainder(a - b, 2.0 * Pi);
}

struct Geodesic
{
  double length = 0.0;
  double azimuthFrom = 0.0; // at the first point, degrees
  double azimuthTo = 0.0;   // at the second
};

Geodesic geodesic(const glm::dvec2& from, const glm::dvec2& to)
{
  Geodesic line;
  GeographicLib::Geodesic::WGS84().Inverse(from.y, from.x, to.y, to.x, line.length, line.azimuthFrom, line.azimuthTo);
  return line;
}

}

TEST(EllipsoidSpectra, wavesOfTheDeepSeaComeAlongGeodesics)
{
  const EllipsoidMercator map(SemiMajor, Flattening, -150.0, 30.0);
  const reference::ZonalSeafloor ocean([](double, double& h, double& h1, double& h2) { h = 1e5, h1 = h2 = 0.0; }, map,
    { map.toMap({ -180.0, 20.0 }), map.toMap({ -120.0, 60.0 }) });
  BackwardOptions options;
  options.map = &map;
  options.tolerance = 1e-11;
  options.edge = EdgeRule::None;
  const BackwardTracer tracer(ocean, options);
  const glm::dvec2 place(-155.0, 48.0);
  const double period = 16.0;
  const double groupSpeed = StandardGravity * period / (4.0 * Pi);
  double mostBent = 0.0;
  for (int azimuth = 5; azimuth < 360; azimuth += 25)
  {
    const WaveOrigin origin = tracer.trace(map.toMap(place), 1.0 / period, headingOf(azimuth));
    ASSERT_EQ(origin.reason, EndReason::LeftScene) << azimuth;
    const Geodesic line = geodesic(map.toLonLat(origin.edge), place);
    EXPECT_NEAR(turn(headingOf(line.azimuthTo), headingOf(azimuth)), 0.0, TightHeading) << azimuth;
    EXPECT_NEAR(turn(headingOf(line.azimuthFrom), origin.heading), 0.0, TightHeading) << azimuth;
    EXPECT_NEAR(origin.travelTime, line.length / groupSpeed, TightTime * origin.travelTime) << azimuth;
    EXPECT_NEAR(origin.gain, 1.0, TightInvariant) << azimuth;
    mostBent = std::max(mostBent, std::abs(degrees(turn(origin.heading, headingOf(azimuth)))));
  }
  EXPECT_GT(mostBent, 10.0); // on a plane no ray of the deep sea turns
}

TEST(EllipsoidSpectra, zonalDepthKeepsTheInvariantAndTheAction)
{
  // h = 150 + 60 sin 7 phi
  const EllipsoidMercator map(SemiMajor, Flattening, 0.0, 40.0);
  const auto profile = [](double latitude, double& h, double& h1, double& h2)
  {
    h = 150.0 + 60.0 * std::sin(7.0 * latitude);
    h1 = 420.0 * std::cos(7.0 * latitude);
    h2 = -2940.0 * std::sin(7.0 * latitude);
  };
  const reference::ZonalSeafloor shelf(profile, map, { map.toMap({ -10.0, 20.0 }), map.toMap({ 10.0, 60.0 }) });
  BackwardOptions options;
  options.map = &map;
  options.tolerance = 1e-11;
  options.edge = EdgeRule::None;
  const BackwardTracer tracer(shelf, options);
  const glm::dvec2 place = map.toMap({ 1.0, 44.0 });
  const double omega = 2.0 * Pi / 18.0;
  const auto depthAt = [&](const glm::dvec2& p)
  {
    double h = 0.0;
    double h1 = 0.0;
    double h2 = 0.0;
    profile(map.parallel(p.y).latitude, h, h1, h2);
    return h;
  };
  const auto invariant = [&](const glm::dvec2& p, double heading)
  { return solveWavenumber(omega, depthAt(p)) / map.scale(p) * std::cos(heading); }; // k N cos(phi) sin(az)/(c a)
  const WaveSpeeds here = waveSpeeds(solveWavenumber(omega, depthAt(place)), depthAt(place));
  const double deep = StandardGravity / omega;
  for (int azimuth = 10; azimuth < 360; azimuth += 30)
  {
    // With the rule none the heading at the edge is that offshore.
    const WaveOrigin origin = tracer.trace(place, 1.0 / 18.0, headingOf(azimuth));
    ASSERT_EQ(origin.reason, EndReason::LeftScene) << azimuth;
    const double expected = invariant(place, headingOf(azimuth));
    EXPECT_NEAR(invariant(origin.edge, origin.heading), expected, TightInvariant * std::abs(expected)) << azimuth;
    EXPECT_NEAR(origin.gain, 0.5 * deep * deep / (here.phaseSpeed * here.groupSpeed), TightInvariant) << azimuth;
  }
}

TEST(EllipsoidSpectra, anIslandShadesWhatLiesBehindItOnTheGeodesic)
{
  // A steep island in the deep sea, 1,500 km to the west of the place on 50 degrees north: rhumb line and geodesic differ by 8 degrees.
  const glm::dvec2 island(-160.0, 50.0);
  const glm::dvec2 place(-139.0, 50.0);
  constexpr double Radius = 60e3;
  constexpr double Ramp = 5e3; // of the flank, m
  ElevationGrid grid;
  grid.columns = 471;
  grid.rows = 241;
  grid.origin = { -161.0, 46.0 };
  grid.spacing = { 0.05, 0.03 };
  grid.elevation.resize(grid.columns * grid.rows);
  for (std::size_t i = 0; i < grid.elevation.size(); ++i)
  {
    const glm::dvec2 node = grid.node(i % grid.columns, i / grid.columns);
    const double away =
      std::hypot((node.x - island.x) * 71.7e3, (node.y - island.y) * 111.2e3); // m a degree at 50 north
    grid.elevation[i] = -2000.0 - 2200.0 * std::tanh((away - Radius) / Ramp);
  }
  const auto map = std::make_shared<const EllipsoidMercator>(SemiMajor, Flattening, -150.0, 50.0);
  const GeographicSeafloor seafloor(grid, map);
  BackwardOptions options;
  options.map = map.get();
  options.tolerance = 1e-8;
  options.edge = EdgeRule::None;
  const BackwardTracer tracer(seafloor, options);

  const Geodesic line = geodesic(island, place);
  const double half = degrees(Radius / line.length);
  ASSERT_GT(90.0 - line.azimuthFrom, 3.0 * half); // the rhumb line would miss the island
  // The shore lies 7.6 km within Radius, waves feel the ground from 0.8 km off it, and a cell is 3.6 km: as angles.
  const double slack = degrees((7.6e3 + 3.6e3) / line.length);
  double from = 360.0;
  double to = 0.0;
  for (double azimuth = 80.0; azimuth < 120.0; azimuth += 0.04)
  {
    const WaveOrigin origin = tracer.trace(map->toMap(place), 1.0 / 15.0, headingOf(azimuth));
    if (origin.reason == EndReason::Aground)
    {
      EXPECT_TRUE(std::isnan(origin.heading));
      from = std::min(from, azimuth);
      to = std::max(to, azimuth);
    }
  }
  EXPECT_NEAR(from, line.azimuthTo - half, slack);
  EXPECT_NEAR(to, line.azimuthTo + half, slack);

  // A narrow sea from behind the island does not get there, and one from beside it does.
  SpectralSeaOptions sea;
  sea.rays.grid = SpectralGrid::logarithmic(0.06, 0.08, 2, 720);
  const auto heightOf = [&](double azimuthAtEdge)
  {
    const auto offshore =
      DirectionalSpectrum::sample(SpectralGrid::logarithmic(0.02, 1.0, 60, 720), FrequencySpectrum::jonswap(1.0, 15.0),
        DirectionalSpreading::wrappedNormal(radians(1.2)), headingOf(azimuthAtEdge));
    DirectionalSpectrum sampled;
    sampled.grid = sea.rays.grid;
    for (const double f : sampled.grid.frequencies)
    {
      for (const double h : sampled.grid.headings)
      {
        sampled.density.push_back(offshore.interpolate(f, h));
      }
    }
    const double open = seaParameters(sampled).significantHeight;
    return transformSea(tracer, sea, sampled, { map->toMap(place) }).front().parameters.significantHeight / open;
  };
  // Of 1.2 degrees, half of the shadow less the slack and half a bin, 1.6 degrees, leave 18 % of the energy: 0.43 of the height.
  EXPECT_LT(heightOf(line.azimuthFrom), 0.45);
  EXPECT_GT(heightOf(line.azimuthFrom - 8.0), 0.9);
  EXPECT_GT(heightOf(line.azimuthFrom + 8.0), 0.9);
}
