// Swell from a storm far away: on the edges of a scene, and on as geodesics through the storm (GeographicLib).
#include "bathymetry/GeodesicSource.h"

#include "sim/Angles.h"
#include "sim/EllipsoidMercator.h"
#include "sim/WaveTracer.h"

#include "MapOfEarth.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

using namespace swellray;
using testing::HasSubstr;

namespace
{

const glm::dvec2 Storm(170.0, -50.0); // in the Southern Ocean

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
  return "(nothing was thrown)";
}

SourceSample sampleOf(const WaveSource& source, const glm::dvec2& place)
{
  SourceSample sample;
  source.evaluate(place, sample);
  return sample;
}

void expectTurnsAsItsHeadings(const WaveSource& source, const glm::dvec2& place, double relative)
{
  const SourceSample sample = sampleOf(source, place);
  // Third derivatives over the square of thousands of kilometres: 1e-6 of the turn over 2 km.
  constexpr double step = 2000.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    glm::dvec2 way(0.0);
    way[axis] = step;
    const double turn =
      std::remainder(sampleOf(source, place + way).heading - sampleOf(source, place - way).heading, 2.0 * Pi) /
      (2.0 * step);
    EXPECT_NEAR(sample.turn[axis], turn, relative * glm::length(sample.turn));
  }
}

}

TEST(GeodesicSource, IsTheGeodesicFromTheStormOnTheEllipsoid)
{
  const Georeference scene = Georeference::onEllipsoid("EPSG:4326", 200.0, 20.0);
  const GeodesicSource source(Storm, scene);
  const Geodesics earth;
  for (const glm::dvec2 lonLat : { glm::dvec2(202.1, 21.3), glm::dvec2(190.0, -20.0), glm::dvec2(240.0, 50.0) })
  {
    const Geodesic way = earth.inverse(Storm, lonLat);
    const glm::dvec2 place = scene.mercator()->toMap(lonLat);
    const SourceSample sample = sampleOf(source, place);
    EXPECT_NEAR(sample.heading, radians(90.0 - way.azimuthTo), 1e-12);
    EXPECT_NEAR(sample.distance, way.length, 1e-6);
    EXPECT_NEAR(sample.width, way.reducedLength, 1e-6);
    expectTurnsAsItsHeadings(source, place, 1e-5);
  }
}

TEST(GeodesicSource, IsTheSameOnAPlaneLessTheConvergenceOfItsMeridians)
{
  const Georeference utm("EPSG:32604", glm::dvec2(0.0), { 600000.0, 2350000.0 }); // Oahu
  const Georeference degrees("EPSG:4326", { -158.0, 21.3 }, glm::dvec2(0.0));
  const Geodesics earth;
  for (const Georeference& scene : { utm, degrees })
  {
    const GeodesicSource source(Storm, scene);
    for (const glm::dvec2 place : { glm::dvec2(0.0, 0.0), glm::dvec2(-30000.0, 20000.0), glm::dvec2(50000.0, 5000.0) })
    {
      const SourceSample sample = sampleOf(source, place);
      const Geodesic way = earth.inverse(Storm, *scene.toLonLat(place));
      // The direction of 100 m of the way, on the map.
      const Geodesic before = earth.direct(Storm, way.azimuthFrom, way.length - 100.0);
      glm::dvec2 file = before.to;
      const glm::dvec2 step = place -
        (scene.kind() == GeoreferenceKind::Geographic
            ? scene.fromFile(file)
            : [&]
          {
            // By the inverse of the scene's own way to degrees: Newton on a plane that is nearly true to scale.
            glm::dvec2 p = place;
            for (int i = 0; i < 20; ++i)
            {
              const glm::dvec2 here = *scene.toLonLat(p);
              const glm::dvec2 miss(std::remainder(file.x - here.x, 360.0), file.y - here.y);
              const double gamma = radians(scene.convergence(p));
              const glm::dvec2 en(miss.x * 111320.0 * std::cos(radians(here.y)), miss.y * 110600.0);
              p += glm::dvec2(en.x * std::cos(gamma) - en.y * std::sin(gamma), en.x * std::sin(gamma) + en.y * std::cos(gamma));
            }
            return p;
          }());
      EXPECT_NEAR(std::remainder(sample.heading - std::atan2(step.y, step.x), 2.0 * Pi), 0.0, 1e-6);
      expectTurnsAsItsHeadings(source, place, 1e-4);
    }
  }
}

TEST(GeodesicSource, SendsRaysOnAlongTheGeodesicsThroughTheStorm)
{
  // Position: 1e-8 of a wavelength of 400 m a step; asked for is 1 m.
  constexpr double position = 1e-3;
  constexpr double relative = 1e-9;
  constexpr double deep = 1e5; // m: no swell feels it
  const Georeference scene = Georeference::onEllipsoid("EPSG:4326", 200.0, 0.0);
  const EllipsoidMercator& map = *scene.mercator();
  const Geodesics earth;
  const reference::ZonalSeafloor ocean([](double, double& h, double& h1, double& h2) { h = deep, h1 = h2 = 0.0; }, map,
    { map.toMap({ 175.0, -35.0 }), map.toMap({ 235.0, 45.0 }) });
  IncidentWave wave;
  wave.period = 16.0;
  const GeodesicSource source(Storm, scene);
  TraceOptions options;
  options.source = &source;
  options.map = &map;
  options.spacing = 60000.0;
  options.step = 400000.0;
  options.insertion = InsertionRule::None;
  const RayField field = traceWaves(ocean, wave, options);
  ASSERT_GT(field.rays.size(), 40u);
  const double k = wave.wavenumber();

  // The wave comes first to the place of the edge that is nearest to the storm.
  Geodesic nearest = earth.inverse(Storm, { 175.0, -35.0 });
  for (int i = 1; i <= 6000; ++i)
  {
    const Geodesic way = earth.inverse(Storm, { 175.0 + 0.01 * i, -35.0 });
    nearest = way.length < nearest.length ? way : nearest;
  }
  ASSERT_TRUE(field.sourceDistance);
  EXPECT_NEAR(*field.sourceDistance, nearest.length, 100.0); // the edge is looked at in parts of 10 km
  const double width = earth.direct(Storm, nearest.azimuthFrom, *field.sourceDistance).reducedLength;

  double previous = 0.0;
  double longest = 0.0;
  for (std::size_t ray = 0; ray < field.rays.size(); ++ray)
  {
    const glm::dvec2 first = map.toLonLat(field.points[field.offsets[ray]].position);
    const Geodesic way = earth.inverse(Storm, first);
    if (ray > 0)
    {
      // Equal shares of what the storm sends out: equal angles there. The reference width is right to 1e-6 above.
      EXPECT_NEAR(radians(previous - way.azimuthFrom) * width, 60000.0, 1.0);
    }
    previous = way.azimuthFrom;
    for (std::size_t i = field.offsets[ray]; i < field.offsets[ray + 1]; ++i)
    {
      const RayPoint& point = field.points[i];
      const glm::dvec2 place = map.toLonLat(point.position);
      const double length = way.length + point.travelTime * wave.groupSpeed();
      longest = std::max(longest, length);
      const Geodesic exact = earth.direct(Storm, way.azimuthFrom, length);
      EXPECT_LT(earth.inverse(exact.to, place).length, position) << "ray " << ray;
      EXPECT_NEAR(degrees(std::atan2(point.wavenumber.x, point.wavenumber.y)), exact.azimuthTo, 1e-8);
      EXPECT_NEAR(point.phase, k * (length - *field.sourceDistance), relative * k * length);
      EXPECT_NEAR(point.tubeWidth, exact.reducedLength / width, 1e-6);
    }
  }
  EXPECT_GT(longest, 10e6);
}

TEST(GeodesicSource, SaysWhatItCannotDo)
{
  const Georeference scene = Georeference::onEllipsoid("EPSG:4326", 200.0, 20.0);
  EXPECT_THAT(messageOf(
                [&] {
                  GeodesicSource({ 170.0, -91.0 }, scene);
                }),
    HasSubstr("latitude within -90 to 90 degrees"));
  EXPECT_THAT(messageOf([] { GeodesicSource(Storm, Georeference()); }), HasSubstr("give its CRS"));
  // Opposite the scene waves meet again.
  const EllipsoidMercator& map = *scene.mercator();
  const reference::ZonalSeafloor ocean([](double, double& h, double& h1, double& h2) { h = 5000.0, h1 = h2 = 0.0; },
    map, { map.toMap({ 195.0, 15.0 }), map.toMap({ 205.0, 25.0 }) });
  const GeodesicSource opposite({ 20.0, -20.0 }, scene);
  TraceOptions options;
  options.source = &opposite;
  options.map = &map;
  EXPECT_THAT(messageOf([&] { traceWaves(ocean, IncidentWave(), options); }), HasSubstr("nearly opposite the scene"));
}
