// Currents as functions, the dispersion relation on them, and whole scenes with one.
#include "Currents.h"

#include "sim/BuiltinCurrent.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/CurrentDispersion.h"
#include "sim/LaunchLine.h"
#include "sim/SplineCurrent.h"
#include "sim/WaveTracer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

using namespace swellray;
using namespace swellray::testing;

namespace
{

std::string messageOf(const std::string& spec)
{
  try
  {
    makeBuiltinCurrent(spec);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TraceOptions optionsWith(const Current& current)
{
  TraceOptions options;
  options.current = &current;
  options.spacing = 50.0;
  return options;
}

IncidentWave waveFrom(double direction, double period)
{
  IncidentWave wave;
  wave.directionFrom = direction;
  wave.period = period;
  return wave;
}

}

TEST(BuiltinCurrents, haveTheDerivativesOfTheirFormulas)
{
  constexpr double Step = 0.01;     // m
  constexpr double Relative = 1e-7; // of the largest: differences keep half of the digits
  for (const std::string& spec :
    { std::string("jet:V0=2,w=150"), std::string("jet:speed=-1.5,width=80,heading=30,xc=20,yc=-10"),
      std::string("shear:V0=0.5,S=0.002,heading=200"), std::string("eddy:U0=1.5,R=120,xc=10,yc=5") })
  {
    const auto current = makeBuiltinCurrent(spec);
    for (const glm::dvec2 p : { glm::dvec2(0.0, 0.0), glm::dvec2(70.0, 40.0), glm::dvec2(-100.0, 130.0) })
    {
      CurrentSample at;
      CurrentSample east;
      CurrentSample west;
      CurrentSample north;
      CurrentSample south;
      current->evaluate(p, at);
      current->evaluate(p + glm::dvec2(Step, 0.0), east);
      current->evaluate(p - glm::dvec2(Step, 0.0), west);
      current->evaluate(p + glm::dvec2(0.0, Step), north);
      current->evaluate(p - glm::dvec2(0.0, Step), south);
      const auto expectNear = [&](const glm::dvec2& exact, const glm::dvec2& difference)
      { EXPECT_LT(glm::length(exact - difference / (2.0 * Step)), Relative) << spec << " " << p.x; };
      expectNear(at.dx, east.velocity - west.velocity);
      expectNear(at.dy, north.velocity - south.velocity);
      expectNear(at.dxx, east.dx - west.dx);
      expectNear(at.dxy, north.dx - south.dx);
      expectNear(at.dxy, east.dy - west.dy);
      expectNear(at.dyy, north.dy - south.dy);
    }
  }
}

TEST(BuiltinCurrents, areThoseOfTheirFormulas)
{
  EXPECT_DOUBLE_EQ(makeBuiltinCurrent("jet:V0=2,w=200")->velocity({ 200.0, 77.0 }).y, 2.0 * std::exp(-1.0));
  EXPECT_EQ(makeBuiltinCurrent("jet:V0=2,w=200")->velocity({ 200.0, 77.0 }).x, 0.0);
  // Flowing east, the distance to its right counts southward.
  EXPECT_NEAR(makeBuiltinCurrent("shear:S=0.01,heading=90")->velocity({ 5.0, -30.0 }).x, 0.3, 1e-15);
  EXPECT_NEAR(makeBuiltinCurrent("eddy:U0=1.5,R=300")->velocity({ 300.0, 0.0 }).y, 1.5, 1e-15);
}

TEST(BuiltinCurrents, refuseWhatTheyDoNotKnow)
{
  EXPECT_THAT(messageOf("jett"), ::testing::HasSubstr("did you mean 'jet'"));
  EXPECT_THAT(messageOf("jet:speed=fast"), ::testing::StartsWith("built-in current 'jet'"));
  EXPECT_THAT(messageOf("jet:w=0"), ::testing::HasSubstr("width"));
  EXPECT_TRUE(isBuiltinCurrent("eddy:U0=1"));
  EXPECT_FALSE(isBuiltinCurrent("current.nc"));
  for (const char* meant : { "jet", "jett", "edy", "sheer:V0=1", "whirl:U0=1", "eddy:" })
  {
    EXPECT_TRUE(resemblesBuiltinCurrent(meant)) << meant;
  }
  for (const char* file : { "", "current.nc", "tide", "./jet", "NETCDF:\"a=b.nc\":u" })
  {
    EXPECT_FALSE(resemblesBuiltinCurrent(file)) << file;
  }
}

TEST(SplineCurrents, wantTheSameNodesForBothComponents)
{
  ElevationGrid u;
  u.columns = u.rows = 5;
  u.elevation.assign(25, 1.0);
  ElevationGrid v = u;
  EXPECT_NO_THROW(SplineCurrent(u, v));
  v.origin.x = 1.0;
  EXPECT_THROW(SplineCurrent(u, v), std::invalid_argument);
}

TEST(CurrentDispersion, solvesForTheWaveThatGoesForward)
{
  constexpr double Rounding = 1e-12;
  const double omega = 2.0 * Pi / 8.0;
  for (const double depth : { 2.0, 12.0, 4000.0 })
  {
    for (const double across : { 0.0, 0.02, -0.04 })
    {
      for (const glm::dvec2 current : { glm::dvec2(0.0), glm::dvec2(1.5, 0.4), glm::dvec2(-1.8, 0.9) })
      {
        const glm::dvec2 along(0.6, -0.8);
        const glm::dvec2 left(0.8, 0.6);
        const auto n = solveOnCurrent(omega, depth, StandardGravity, along, across, current);
        ASSERT_TRUE(n) << depth << " " << across << " " << current.x;
        const glm::dvec2 k = *n * along + across * left;
        Frequency f;
        evaluateFrequency(glm::length(k), depth, StandardGravity, f);
        EXPECT_NEAR((f.sigma + glm::dot(k, current)) / omega, 1.0, Rounding);
        EXPECT_GT(glm::dot(f.k / glm::length(k) * k + current, along), 0.0);
      }
    }
  }
}

TEST(CurrentDispersion, findsNothingBeyondTheBlockingCurrent)
{
  const double omega = 2.0 * Pi / 10.0;
  const double blocking = 0.25 * StandardGravity / omega;
  const auto solve = [&](double u) {
    return solveOnCurrent(omega, 4000.0, StandardGravity, { 1.0, 0.0 }, 0.0, { u, 0.0 });
  };
  EXPECT_TRUE(solve(-0.99 * blocking));
  EXPECT_FALSE(solve(-0.99999 * blocking)); // stopped
  EXPECT_FALSE(solve(-1.01 * blocking));
  EXPECT_FALSE(solve(-5.0 * blocking));
}

TEST(CurrentLaunch, keepsTheWavenumberAlongTheContoursAndTheAction)
{
  // A jet along the shore of a straight beach that the wave enters obliquely over its west and south edges.
  const auto bed = makeBuiltinSeafloor("plane:slope=0.02,facing=270,x0=-3000,x1=-300,y0=-1000,y1=1000");
  const auto current = makeBuiltinCurrent("jet:V0=1.5,w=400,xc=-1800");
  const IncidentWave wave = waveFrom(250.0, 9.0);
  const LaunchLine line(*bed, 0.0, wave, 0.05, { EdgeRule::Contours, 270.0, current.get() });
  const glm::dvec2 t0 = wave.direction();
  const double alongShore = wave.wavenumber() * t0.y;
  ASSERT_GT(line.length(), 0.0);
  RayMedium medium = mediumWith(*bed, *current, 9.0);
  int south = 0;
  for (double share = 0.02; share < 1.0; share += 0.04)
  {
    const LaunchPoint start = line.at(share * line.length());
    EXPECT_NEAR(start.wavenumber.y, alongShore, 1e-15);
    const double k = glm::length(start.wavenumber);
    Frequency f;
    evaluateFrequency(k, medium.depth(start.position), StandardGravity, f);
    const glm::dvec2 u = current->velocity(start.position);
    EXPECT_NEAR((f.sigma + glm::dot(start.wavenumber, u)) / medium.angularFrequency, 1.0, 1e-12);
    // Action that comes in over the shore-parallel metre: A Vx is that of offshore.
    const glm::dvec2 speed = f.k / k * start.wavenumber + u;
    const double width = std::abs(speed.x * start.dPosition.y - speed.y * start.dPosition.x) / glm::length(speed);
    EXPECT_NEAR(width, speed.x / glm::length(speed) / t0.x, 1e-9) << share;
    south += start.position.y < -999.9 ? 1 : 0;
    // The front's curvature keeps the dispersion relation along the edge.
    const double step = 1e-3;
    const LaunchPoint before = line.at(share * line.length() - step);
    const LaunchPoint after = line.at(share * line.length() + step);
    const glm::dvec2 slope = (after.wavenumber - before.wavenumber) / (2.0 * step);
    if (glm::length(after.position - before.position) < 3.0 * step * glm::length(start.dPosition))
    {
      EXPECT_NEAR(glm::length(slope - start.dWavenumber), 0.0, 1e-9) << share;
    }
  }
  EXPECT_GT(south, 3);
}

TEST(CurrentLaunch, letsNothingInWhereTheCurrentIsTooStrong)
{
  const auto bed = makeBuiltinSeafloor("plane:slope=0.02,facing=270,x0=-3000,x1=-300,y0=-1000,y1=1000");
  // A jet out to sea through the middle of the west edge.
  const auto current = makeBuiltinCurrent("jet:V0=4,w=200,heading=270");
  const LaunchLine line(*bed, 0.0, waveFrom(270.0, 6.0), 0.05, { EdgeRule::Contours, 270.0, current.get() });
  double closest = 1e9;
  for (double share = 0.0; share <= 1.0; share += 0.001)
  {
    closest = std::min(closest, std::abs(line.at(share * line.length()).position.y));
  }
  // Where 4 exp(-(y/w)^2) is below the blocking current, c0/4 of a wave of 6 s.
  const double blocking = 0.25 * StandardGravity * 6.0 / (2.0 * Pi);
  EXPECT_NEAR(closest, 200.0 * std::sqrt(std::log(4.0 / blocking)), 3.0);
}

TEST(CurrentScenes, measureTheSameTubeBetweenNeighbours)
{
  const FlatBed bed({ { -1000.0, -3000.0 }, { 1000.0, 3000.0 } }, 300.0);
  const auto current = makeBuiltinCurrent("jet:V0=2,w=200,heading=20");
  std::vector<double> largest;
  for (const double spacing : { 40.0, 20.0 })
  {
    TraceOptions options = optionsWith(*current);
    options.insertion = InsertionRule::None;
    options.edge = EdgeRule::None;
    options.spacing = spacing;
    const RayField field = traceWaves(bed, waveFrom(270.0, 10.0), options);
    double difference = 0.0;
    std::size_t compared = 0;
    for (const RayPoint& point : field.points)
    {
      EXPECT_EQ(point.current, current->velocity(point.position));
      // Away from the ends of the front, where rays have neighbours on one side only.
      if (point.front != BetweenFronts && std::abs(point.position.y) < 1500.0)
      {
        difference = std::max(difference, std::abs(point.spacingWidth - std::abs(point.tubeWidth)));
        ++compared;
      }
    }
    EXPECT_GT(compared, 1000u);
    largest.push_back(difference);
  }
  // Of second order in the spacing.
  EXPECT_GT(std::log2(largest[0] / largest[1]), 1.8) << largest[0] << " " << largest[1];
  EXPECT_LT(largest[1], 0.02);
}

TEST(CurrentScenes, endRaysThatAreBlocked)
{
  const FlatBed bed({ { -1500.0, -1500.0 }, { 1500.0, 1500.0 } }, 300.0);
  const auto current = makeBuiltinCurrent("eddy:U0=2.5,R=300");
  const RayField field = traceWaves(bed, waveFrom(270.0, 5.0), optionsWith(*current));
  const auto blocked = [](const RayInfo& ray) { return ray.endReason == EndReason::BlockedByCurrent; };
  const auto count = std::count_if(field.rays.begin(), field.rays.end(), blocked);
  EXPECT_GT(count, 3);
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    if (blocked(field.rays[i]))
    {
      const RayPoint& last = field.points[field.offsets[i + 1] - 1];
      EXPECT_EQ(last.state, RayState::Dead);
      EXPECT_LT(glm::dot(last.current, last.wavenumber), 0.0);
      EXPECT_LT(glm::length(last.wavenumber), 4.0 * waveFrom(270.0, 5.0).wavenumber());
    }
  }
  EXPECT_FALSE(field.stepCapReached);
}

TEST(CurrentScenes, areTheSameForAnyNumberOfThreads)
{
  const auto bed = makeBuiltinSeafloor("shoal:kind=gauss");
  const auto current = makeBuiltinCurrent("eddy:U0=1.5,R=400,yc=300");
  const IncidentWave wave = waveFrom(270.0, 10.0);
  const RayField one = traceWaves(*bed, wave, optionsWith(*current));
  Execution threads;
  threads.loop = [](std::size_t count, const std::function<void(std::size_t, std::size_t)>& body)
  {
    std::vector<std::thread> pool;
    for (std::size_t i = 0; i < 4; ++i)
    {
      pool.emplace_back([&body, count, i] { body(count * i / 4, count * (i + 1) / 4); });
    }
    for (std::thread& thread : pool)
    {
      thread.join();
    }
  };
  const RayField many = traceWaves(*bed, wave, optionsWith(*current), threads);
  ASSERT_EQ(one.points.size(), many.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i)
  {
    ASSERT_EQ(one.points[i].position, many.points[i].position);
    ASSERT_EQ(one.points[i].wavenumber, many.points[i].wavenumber);
    ASSERT_EQ(one.points[i].rayDirection, many.points[i].rayDirection);
  }
}

TEST(CurrentScenes, refuseWhatCannotBe)
{
  const auto bed = makeBuiltinSeafloor("plane:facing=270");
  const auto jet = makeBuiltinCurrent("jet");
  TraceOptions options = optionsWith(*jet);
  options.scheme = TraceScheme::Snell;
  EXPECT_THROW(traceWaves(*bed, waveFrom(270.0, 10.0), options), std::invalid_argument);

  ElevationGrid u;
  u.columns = u.rows = 5;
  u.spacing = glm::dvec2(100.0);
  u.elevation.assign(25, 0.5);
  const SplineCurrent small(u, u);
  try
  {
    traceWaves(*bed, waveFrom(270.0, 10.0), optionsWith(small));
    ADD_FAILURE() << "a current that does not cover the scene is taken";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("must cover all of the scene"));
  }
}
