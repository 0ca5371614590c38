// Rays from lines and points within a scene, and followed back from a site, against Snell's law on a plane beach.
#include "sim/Angles.h"
#include "sim/BackwardFan.h"
#include "sim/BuiltinCurrent.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"
#include "sim/WaveTracer.h"

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

// A beach that faces east, h = 0.02 x, in a scene of 2.5 km.
constexpr double Slope = 0.02;

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

/** The wave from offshore where it is x from the shore. */
struct Snell
{
  Snell(const IncidentWave& wave, double x)
    : k(solveWavenumber(wave.angularFrequency(), Slope * x))
    , along(wave.wavenumber() * wave.direction().y)
    , cosine0(-wave.direction().x)
    , cosine(std::sqrt(1.0 - along * along / (k * k)))
  {
  }

  double k;
  double along;
  double cosine0;
  double cosine;
};

}

TEST(LaunchLines, BeginWhereTheyAreGivenWithTheWaveFromOffshore)
{
  const auto beach = makeBuiltinSeafloor("plane");
  IncidentWave wave;
  wave.directionFrom = 60.0;
  TraceOptions options;
  options.spacing = 20.0;
  options.insertion = InsertionRule::None;
  const std::vector<glm::dvec2> line{ { 1200.0, -600.0 }, { 900.0, 0.0 }, { 1000.0, 400.0 } };
  const std::vector<glm::dvec2> back(line.rbegin(), line.rend());
  options.launchLines = { line };
  const RayField field = traceWaves(*beach, wave, options);
  options.launchLines = { back };
  const RayField other = traceWaves(*beach, wave, options);
  ASSERT_GT(field.rays.size(), 20u);
  ASSERT_EQ(field.points.size(), other.points.size()); // whichever way the line is drawn
  double least = 1e9;
  for (std::size_t ray = 0; ray < field.rays.size(); ++ray)
  {
    const RayPoint& first = field.points[field.offsets[ray]];
    // It stands on the line.
    const glm::dvec2 p = first.position;
    const double x = p.y < 0.0 ? 900.0 - 0.5 * p.y : 900.0 + 0.25 * p.y;
    EXPECT_NEAR(p.x, x, 1e-9);
    const Snell snell(wave, p.x);
    constexpr double rounding = 1e-11;
    EXPECT_NEAR(first.wavenumber.y, snell.along, rounding);
    EXPECT_NEAR(glm::length(first.wavenumber), snell.k, rounding);
    EXPECT_NEAR(first.tubeWidth, snell.cosine / snell.cosine0, 1e-9);
    // And so further on: the front's curvature was right. The tube's tolerance is a thousand times that of the ray.
    const RayPoint& later = field.points[field.offsets[ray] + field.pointCount(ray) / 3];
    const Snell there(wave, later.position.x);
    EXPECT_NEAR(later.tubeWidth, there.cosine / there.cosine0, 1e-6);
    least = std::min(least, first.phase);
  }
  EXPECT_GE(least, 0.0);
  EXPECT_LT(least, 2.0 * Pi);
  // From one line to the next no ray is a neighbour; and one of them on land brings nothing.
  options.launchLines = { { { 900.0, -600.0 }, { 900.0, -100.0 } }, { { 900.0, 100.0 }, { 900.0, 600.0 } },
    { { -50.0, -100.0 }, { -50.0, 100.0 } } };
  const RayField two = traceWaves(*beach, wave, options);
  EXPECT_EQ(two.rays.front().launchSegment, 0);
  EXPECT_EQ(two.rays.back().launchSegment, 1);

  options.launchLines = { { { 900.0, 0.0 }, { 900.0, 2000.0 } } };
  EXPECT_THAT(messageOf([&] { traceWaves(*beach, wave, options); }), HasSubstr("a launch line leaves the scene"));
}

TEST(LaunchPlaces, SendOneRayEach)
{
  const auto beach = makeBuiltinSeafloor("plane");
  IncidentWave wave;
  wave.directionFrom = 60.0;
  TraceOptions options;
  const glm::dvec2 place(500.0, 100.0);
  const double heading = headingFromNautical(120.0);
  options.launchPlaces = { { place, heading }, { place, {} }, { { 800.0, -50.0 }, heading } };
  const RayField field = traceWaves(*beach, wave, options);
  ASSERT_EQ(field.rays.size(), 3u);
  const Snell snell(wave, place.x);
  const RayPoint& given = field.points[field.offsets[0]];
  const RayPoint& refracted = field.points[field.offsets[1]];
  constexpr double rounding = 1e-11;
  EXPECT_NEAR(
    glm::length(given.wavenumber - snell.k * glm::dvec2(std::cos(heading), std::sin(heading))), 0.0, rounding);
  EXPECT_NEAR(given.tubeWidth, 1.0, rounding);
  EXPECT_NEAR(refracted.wavenumber.y, snell.along, rounding);
  EXPECT_NEAR(refracted.tubeWidth, snell.cosine / snell.cosine0, 1e-9);
  for (std::size_t ray = 0; ray < 3; ++ray)
  {
    const RayPoint& first = field.points[field.offsets[ray]];
    EXPECT_EQ(first.phase, 0.0);
    for (std::size_t i = field.offsets[ray]; i < field.offsets[ray + 1]; ++i)
    {
      const RayPoint& point = field.points[i];
      if (isOnWater(point.state))
      {
        EXPECT_NEAR(point.wavenumber.y, first.wavenumber.y, 1e-8 * snell.k);
      }
      EXPECT_TRUE(std::isnan(point.spacingWidth) || i == field.offsets[ray]); // no neighbours
    }
  }
  options.launchPlaces = { { place, heading }, { { -20.0, 0.0 }, heading } };
  EXPECT_THAT(messageOf([&] { traceWaves(*beach, wave, options); }), HasSubstr("launch point 2, at x -20, y 0 m"));
  options.launchLines = { { place, { 700.0, 0.0 } } };
  EXPECT_THAT(messageOf([&] { traceWaves(*beach, wave, options); }), HasSubstr("not from both"));
}

TEST(BackwardFan, FollowsSnellBackToOffshore)
{
  const auto beach = makeBuiltinSeafloor("plane");
  BackwardOptions options;
  options.tolerance = 1e-10;
  const BackwardTracer tracer(*beach, options);
  constexpr double period = 9.0;
  const glm::dvec2 site(300.0, -40.0);
  const BackwardFan fan = traceFan(tracer, site, period, 90, 8.0);
  ASSERT_EQ(fan.field.rays.size(), 90u);
  IncidentWave wave;
  wave.period = period;
  const double omega = wave.angularFrequency();
  const double k = solveWavenumber(omega, Slope * site.x);
  int come = 0;
  for (std::size_t i = 0; i < 90; ++i)
  {
    EXPECT_DOUBLE_EQ(fan.headings[i], headingFromNautical(4.0 * static_cast<double>(i)));
    const std::size_t begin = fan.field.offsets[i];
    const std::size_t end = fan.field.offsets[i + 1];
    ASSERT_GT(end, begin);
    const RayPoint& last = fan.field.points[end - 1];
    EXPECT_LT(glm::length(last.position - site), 1e-9);
    EXPECT_NEAR(
      glm::length(last.wavenumber - k * glm::dvec2(std::cos(fan.headings[i]), std::sin(fan.headings[i]))), 0.0, 1e-12);
    EXPECT_EQ(fan.field.points[begin].travelTime, 0.0);
    for (std::size_t j = begin + 1; j < end; ++j)
    {
      EXPECT_GT(fan.field.points[j].travelTime, fan.field.points[j - 1].travelTime);
      EXPECT_GT(fan.field.points[j].phase, fan.field.points[j - 1].phase);
    }
    EXPECT_NEAR(last.travelTime, fan.origins[i].travelTime, 1e-9 * last.travelTime);
    const double along = k * std::sin(fan.headings[i]);
    const bool fromOffshore = std::cos(fan.headings[i]) < 0.0 && std::abs(along) < wave.wavenumber();
    const WaveOrigin& origin = fan.origins[i];
    if (std::isnan(origin.heading))
    {
      continue;
    }
    ++come;
    EXPECT_TRUE(fromOffshore);
    EXPECT_NEAR(wave.wavenumber() * std::sin(origin.heading), along, 1e-8 * k);
    // E C Cg is the same at both ends (Longuet-Higgins 1957); offshore C = 2 Cg = omega/k0.
    const WaveSpeeds here = waveSpeeds(k, Slope * site.x);
    const double speed0 = omega / wave.wavenumber();
    EXPECT_NEAR(origin.gain, 0.5 * speed0 * speed0 / (here.phaseSpeed * here.groupSpeed), 1e-9 * origin.gain);
  }
  EXPECT_GT(come, 12); // sin theta < C/C0: 33 degrees to either side
  EXPECT_THAT(messageOf([&] { traceFan(tracer, { -30.0, 0.0 }, period, 10, 8.0); }), HasSubstr("in water"));
  EXPECT_THAT(messageOf([&] { traceFan(tracer, site, 0.0, 10, 8.0); }), HasSubstr("period must be above 0"));
  EXPECT_THAT(messageOf([&] { traceFan(tracer, site, period, 0, 8.0); }), HasSubstr("must be above 0"));
}

TEST(BackwardFan, EndsAtObstaclesAndKnowsTheExtentOfItsCurrent)
{
  const auto beach = makeBuiltinSeafloor("plane");
  const Obstacles wall({ { { { 400.0, -20.0 }, { 400.0, 20.0 } }, false, 0.0 } });
  BackwardOptions options;
  options.obstacles = &wall;
  const BackwardTracer tracer(*beach, options);
  const BackwardFan fan = traceFan(tracer, { 300.0, 0.0 }, 9.0, 36, 8.0);
  EXPECT_EQ(fan.origins[9].reason, EndReason::StoppedByObstacle); // from the east
  EXPECT_TRUE(std::isnan(fan.origins[9].heading));
  EXPECT_NEAR(fan.field.points[fan.field.offsets[9]].position.x, 400.0, 1e-6);
  EXPECT_TRUE(std::isfinite(fan.origins[7].heading)); // from 70 degrees, past the wall's end

  class Patch final : public Current
  {
  public:
    Rectangle bounds() const override { return { glm::dvec2(0.0), glm::dvec2(100.0) }; }
    void evaluate(const glm::dvec2&, CurrentSample& sample) const override { sample = CurrentSample(); }
    double featureLength() const override { return 100.0; }
  };
  const Patch patch;
  options.current = &patch;
  EXPECT_THAT(messageOf([&] { BackwardTracer(*beach, options); }), HasSubstr("it must cover all of the scene"));
}
