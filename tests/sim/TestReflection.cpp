// Rays that meet obstacles: where they end, how they are reflected, and the tubes and fronts that follow.
#include "Currents.h"
#include "RayComparison.h"

#include "sim/BuiltinCurrent.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/CurrentDispersion.h"
#include "sim/SnellRay.h"
#include "sim/WaveTracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace swellray;
using swellray::reference::mediumOf;
using swellray::reference::startHeading;
using swellray::testing::FlatBed;

namespace
{

constexpr double Tolerance = 1e-12;

// Asked for. The mirror itself is exact to rounding.
constexpr double LawOfReflection = 1e-10;

// m: hits are roots of the dense output to rounding, of coordinates of some thousand metres.
constexpr double OnTheWall = 1e-9;

// Central differences over a hundredth of a metre of rays held to 1e-12: their error over that step.
constexpr double TubeByDifferences = 1e-6;

Obstacle wall(const glm::dvec2& from, const glm::dvec2& to, double reflection = 1.0)
{
  return { { from, to }, false, reflection };
}

double distanceToWall(const Obstacle& obstacle, const glm::dvec2& p)
{
  const glm::dvec2 along = glm::normalize(obstacle.points[1] - obstacle.points[0]);
  return along.x * (p.y - obstacle.points[0].y) - along.y * (p.x - obstacle.points[0].x);
}

// Trace to the end, or to this time, through as many reflections as there are.
struct Traced
{
  RayPoint point;
  int reflections = 0;
  EndReason reason = EndReason::StepCap;
};

Traced traceTo(const RayMedium& medium, RayStart start, double time)
{
  Traced traced;
  for (;;)
  {
    HamiltonianRay ray(medium, start, Tolerance);
    const bool reached = ray.advance(FrontMeasure::Time, time, traced.point);
    traced.reason = ray.endReason();
    if (reached || !ray.reflection())
    {
      return traced;
    }
    start = *ray.reflection();
    ++traced.reflections;
  }
}

struct Mirror
{
  const char* name;
  const char* seafloor;
  const char* current;
  Obstacle wall;
};

void PrintTo(const Mirror& mirror, std::ostream* out)
{
  *out << mirror.name;
}

const Mirror Mirrors[] = {
  { "Beach", "plane:s=0.02", "", wall({ 300.0, -900.0 }, { 360.0, 900.0 }) },
  { "BeachFromBehind", "plane:s=0.02", "", wall({ 360.0, 900.0 }, { 300.0, -900.0 }) },
  { "Shoal", "plane:s=0.01", "", wall({ 900.0, -900.0 }, { 200.0, 900.0 }) },
  { "Bar", "bar", "", wall({ 350.0, -900.0 }, { 420.0, 900.0 }) },
  { "AlongAShear", "plane:s=0.02", "shear:S=0.0005,heading=0", wall({ 400.0, -900.0 }, { 400.0, 900.0 }) },
  { "AcrossAJet", "plane:s=0.02", "jet:V0=0.8,w=400", wall({ 320.0, -900.0 }, { 420.0, 900.0 }) },
};

class Reflection : public ::testing::TestWithParam<Mirror>
{
protected:
  Reflection()
    : Seafloor(makeBuiltinSeafloor(GetParam().seafloor))
    , Walls({ GetParam().wall })
    , Medium(mediumOf(*this->Seafloor, 9.0, 0.05))
  {
    this->Medium.obstacles = &this->Walls;
    if (*GetParam().current)
    {
      this->Current = makeBuiltinCurrent(GetParam().current);
      this->Medium.current = this->Current.get();
    }
  }

  // Towards the shore, from x = 1500 m; neighbours along y, of one frequency.
  RayStart startAt(double y) const
  {
    const glm::dvec2 place(1500.0, y);
    RayStart start = startHeading(this->Medium, place, Pi - 0.4, { 0.0, 1.0 });
    if (this->Current)
    {
      const glm::dvec2 along = glm::normalize(start.wavenumber);
      const auto size = [&](const glm::dvec2& at)
      {
        return *solveOnCurrent(this->Medium.angularFrequency, this->Medium.depth(at), this->Medium.gravity, along, 0.0,
          this->Current->velocity(at));
      };
      start.wavenumber = size(place) * along;
      const glm::dvec2 step(0.0, 0.01);
      start.dWavenumber = (size(place + step) - size(place - step)) / 0.02 * along;
    }
    return start;
  }

  std::unique_ptr<swellray::Seafloor> Seafloor;
  std::unique_ptr<swellray::Current> Current;
  Obstacles Walls;
  RayMedium Medium;
};

}

TEST_P(Reflection, obeysItsLaw)
{
  HamiltonianRay ray(this->Medium, this->startAt(0.0), Tolerance);
  RayPoint end;
  ASSERT_FALSE(ray.advance(FrontMeasure::Time, 1e6, end));
  ASSERT_EQ(ray.endReason(), EndReason::StoppedByObstacle);
  const Obstacle& obstacle = GetParam().wall;
  EXPECT_NEAR(distanceToWall(obstacle, end.position), 0.0, OnTheWall);
  ASSERT_TRUE(ray.reflection());
  const RayStart& start = *ray.reflection();
  EXPECT_EQ(start.position, end.position);
  EXPECT_EQ(start.phase, end.phase);
  EXPECT_EQ(start.travelTime, end.travelTime);

  const glm::dvec2 along = glm::normalize(obstacle.points[1] - obstacle.points[0]);
  const glm::dvec2 normal(-along.y, along.x);
  const double k = glm::length(end.wavenumber);
  EXPECT_NEAR(glm::dot(start.wavenumber, along) / k, glm::dot(end.wavenumber, along) / k, LawOfReflection);
  if (!this->Current)
  {
    EXPECT_NEAR(glm::dot(start.wavenumber, normal) / k, -glm::dot(end.wavenumber, normal) / k, LawOfReflection);
  }
  else
  {
    // The period is kept: sigma + k.U.
    const double size = glm::length(start.wavenumber);
    const double sigma = std::sqrt(StandardGravity * size * std::tanh(size * end.depth));
    EXPECT_NEAR(
      (sigma + glm::dot(start.wavenumber, end.current)) / this->Medium.angularFrequency, 1.0, LawOfReflection);
    EXPECT_LT(glm::dot(start.wavenumber, normal) * glm::dot(end.wavenumber, normal), 0.0);
  }
  HamiltonianRay onward(this->Medium, start, Tolerance);
  RayPoint point;
  onward.advance(FrontMeasure::Phase, start.phase, point);
  EXPECT_NEAR(point.tubeWidth / end.tubeWidth, 1.0, this->Current ? 10.0 : LawOfReflection) << "beta goes on";
  EXPECT_GT(point.tubeWidth * end.tubeWidth, 0.0) << "and keeps its sign";
}

TEST_P(Reflection, carriesTheTubeThatNeighboursSpan)
{
  constexpr double apart = 0.005; // m
  const RayStart start = this->startAt(0.0);
  int compared = 0;
  for (double time = 10.0; time < 400.0; time += 7.0)
  {
    const Traced ray = traceTo(this->Medium, start, time);
    const Traced left = traceTo(this->Medium, this->startAt(apart), time);
    const Traced right = traceTo(this->Medium, this->startAt(-apart), time);
    if (ray.reason != EndReason::StepCap)
    {
      break; // out of the scene
    }
    if (left.reflections != ray.reflections || right.reflections != ray.reflections)
    {
      continue;
    }
    const glm::dvec2 across = (left.point.position - right.point.position) / (2.0 * apart);
    const glm::dvec2 d = ray.point.rayDirection;
    const double width = (d.x * across.y - d.y * across.x) * (ray.reflections % 2 == 0 ? 1.0 : -1.0);
    EXPECT_NEAR(ray.point.tubeWidth, width, TubeByDifferences * std::max(1.0, std::abs(width)))
      << "after " << time << " s, " << ray.reflections << " reflections";
    compared += ray.reflections > 0 ? 1 : 0;
  }
  EXPECT_GT(compared, 5);
}

INSTANTIATE_TEST_SUITE_P(Obstacles, Reflection, ::testing::ValuesIn(Mirrors),
  [](const auto& tested) { return std::string(tested.param.name); });

TEST(ObstacleRays, aSnellRayIsReflectedToo)
{
  const auto seafloor = makeBuiltinSeafloor("plane:s=0.02");
  const Obstacle obstacle = wall({ 300.0, -900.0 }, { 360.0, 900.0 });
  const Obstacles walls({ obstacle });
  RayMedium medium = mediumOf(*seafloor, 9.0, 0.05);
  medium.obstacles = &walls;
  SnellRay ray(medium, startHeading(medium, { 1500.0, 0.0 }, Pi - 0.4, { 0.0, 1.0 }), 7.0);
  RayPoint end;
  ASSERT_FALSE(ray.advance(FrontMeasure::Length, 1e6, end));
  EXPECT_EQ(ray.endReason(), EndReason::StoppedByObstacle);
  EXPECT_NEAR(distanceToWall(obstacle, end.position), 0.0, OnTheWall);
  ASSERT_TRUE(ray.reflection());
  const glm::dvec2 along = glm::normalize(obstacle.points[1] - obstacle.points[0]);
  const glm::dvec2 onward = glm::normalize(ray.reflection()->wavenumber);
  EXPECT_NEAR(glm::dot(onward, along), glm::dot(end.rayDirection, along), LawOfReflection);
  EXPECT_GT(onward.x, 0.0);
}

TEST(ObstacleRays, aCornerEndsARay)
{
  const FlatBed floor({ { -1000.0, -1000.0 }, { 1000.0, 1000.0 } }, 20.0);
  const Obstacles walls({ { { { 0.0, -100.0 }, { 50.0, 0.0 }, { 0.0, 100.0 } }, false, 1.0 } });
  RayMedium medium = mediumOf(floor, 9.0, 0.05);
  medium.obstacles = &walls;
  HamiltonianRay ray(medium, startHeading(medium, { -500.0, 0.0 }, 0.0, { 0.0, 1.0 }), Tolerance);
  RayPoint end;
  ASSERT_FALSE(ray.advance(FrontMeasure::Time, 1e6, end));
  EXPECT_EQ(ray.endReason(), EndReason::StoppedByObstacle);
  EXPECT_NEAR(end.position.x, 50.0, OnTheWall);
  EXPECT_FALSE(ray.reflection());
}

namespace
{

const Rectangle Basin{ { 0.0, 0.0 }, { 2000.0, 1000.0 } };
constexpr double BasinDepth = 15.0;

IncidentWave fromWest(double directionFrom = 270.0)
{
  IncidentWave wave;
  wave.period = 8.0;
  wave.height = 1.0;
  wave.directionFrom = directionFrom;
  wave.offshoreDepth = BasinDepth;
  return wave;
}

RayField traceBasin(const std::vector<Obstacle>& obstacles, double directionFrom = 270.0, TraceOptions options = {})
{
  const FlatBed floor(Basin, BasinDepth);
  const Obstacles walls(obstacles);
  options.obstacles = &walls;
  options.spacing = options.spacing.value_or(10.0);
  options.stepsPerWave = options.stepsPerWave.value_or(4.0);
  options.edge = EdgeRule::None;
  return traceWaves(floor, fromWest(directionFrom), options);
}

std::size_t countRays(const RayField& field, int reflections)
{
  return static_cast<std::size_t>(std::count_if(
    field.rays.begin(), field.rays.end(), [=](const RayInfo& ray) { return ray.reflections == reflections; }));
}

}

TEST(ObstacleFronts, allRaysOfAPlaneWaveAreReflectedOnce)
{
  const RayField field = traceBasin({ wall({ 1500.0, -10.0 }, { 1500.0, 1010.0 }, 0.5) });
  EXPECT_EQ(countRays(field, 0), 100u);
  ASSERT_EQ(countRays(field, 1), 100u);
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    const RayInfo& ray = field.rays[i];
    const RayPoint& first = field.points[field.offsets[i]];
    const RayPoint& last = field.points[field.offsets[i + 1] - 1];
    EXPECT_EQ(ray.endReason, ray.reflections == 0 ? EndReason::StoppedByObstacle : EndReason::LeftScene);
    if (ray.reflections == 1)
    {
      const auto parent = static_cast<std::size_t>(ray.parent);
      const RayPoint& stopped = field.points[field.offsets[parent + 1] - 1];
      EXPECT_EQ(field.rays[parent].launchParameter, ray.launchParameter);
      EXPECT_EQ(ray.reflection, 0.5);
      EXPECT_EQ(first.position, stopped.position);
      EXPECT_EQ(first.phase, stopped.phase);
      EXPECT_NEAR(last.position.x, 0.0, OnTheWall);
      EXPECT_NEAR(last.tubeWidth, 1.0, 1e-9);
      EXPECT_NEAR(last.spacingWidth, 1.0, 1e-9);
    }
  }
  // One wave comes in, one goes back.
  EXPECT_EQ(std::max_element(field.rays.begin(), field.rays.end(),
              [](const RayInfo& a, const RayInfo& b) { return a.launchSegment < b.launchSegment; })
              ->launchSegment,
    1);
}

TEST(ObstacleFronts, aWallWithoutReflectionOnlyStops)
{
  const RayField field = traceBasin({ wall({ 1500.0, -10.0 }, { 1500.0, 1010.0 }, 0.0) });
  EXPECT_EQ(field.rays.size(), 100u);
  for (const RayInfo& ray : field.rays)
  {
    EXPECT_EQ(ray.endReason, EndReason::StoppedByObstacle);
  }
}

TEST(ObstacleFronts, wavesBetweenTwoWallsAreReflectedAsOftenAsAllowed)
{
  TraceOptions options;
  options.maxReflections = 4;
  // The second wall stands behind the launch line: only what has been reflected meets it.
  const std::vector<Obstacle> walls{ wall({ 1500.0, -10.0 }, { 1500.0, 1010.0 }, 0.9),
    wall({ 500.0, -10.0 }, { 500.0, 1010.0 }, 0.9) };
  const FlatBed floor(Basin, BasinDepth);
  const RayField field = traceBasin(walls, 270.0, options);
  // The first wall to meet is that at x = 500: nothing comes in between the two.
  EXPECT_EQ(countRays(field, 1), 100u);
  EXPECT_EQ(countRays(field, 2), 0u);

  // A wave that comes in above the end of the first wall is caught between the two, until it is too low or too old.
  const RayField caught = traceBasin(
    { wall({ 200.0, 0.0 }, { 1990.0, 0.0 }, 0.9), wall({ 200.0, 300.0 }, { 1990.0, 300.0 }, 0.9) }, 300.0, options);
  EXPECT_GT(countRays(caught, 4), 0u);
  EXPECT_EQ(countRays(caught, 5), 0u);
  // 0.05 of the height, then 0.0025 of it: too low.
  const RayField low = traceBasin(
    { wall({ 200.0, 0.0 }, { 1990.0, 0.0 }, 0.05), wall({ 200.0, 300.0 }, { 1990.0, 300.0 }, 0.05) }, 300.0, options);
  EXPECT_GT(countRays(low, 1), 0u);
  EXPECT_EQ(countRays(low, 2), 0u);
}

TEST(ObstacleFronts, noRayPassesAWall)
{
  const std::vector<Obstacle> obstacles{ { { { 900.0, 200.0 }, { 1100.0, 300.0 }, { 1000.0, 600.0 } }, true, 0.8 },
    wall({ 700.0, 700.0 }, { 1200.0, 900.0 }, 1.0), wall({ 1500.0, 0.0 }, { 1550.0, 1000.0 }, 0.5) };
  const Obstacles walls(obstacles);
  for (const InsertionRule insertion : { InsertionRule::Retrace, InsertionRule::Interpolate })
  {
    TraceOptions options;
    options.maxSpacing = 10.5;
    options.insertion = insertion;
    const RayField field = traceBasin(obstacles, 250.0, options);
    EXPECT_GT(countRays(field, 2), 10u);
    for (std::size_t i = 0; i < field.rays.size(); ++i)
    {
      for (std::size_t j = field.offsets[i]; j + 1 < field.offsets[i + 1]; ++j)
      {
        ASSERT_FALSE(walls.crosses(field.points[j].position, field.points[j + 1].position)) << "ray " << i;
        ASSERT_FALSE(walls.inside(field.points[j].position + 1e-6 * field.points[j].rayDirection)) << "ray " << i;
      }
    }
  }
}

TEST(ObstacleFronts, nothingIsLaunchedOnLand)
{
  // An island over the middle of the western edge, 400 m of its 1000.
  const RayField field =
    traceBasin({ { { { -50.0, 300.0 }, { 50.0, 300.0 }, { 50.0, 700.0 }, { -50.0, 700.0 } }, true, 0.0 } });
  EXPECT_NEAR(field.launchWidth, 600.0, 1e-6);
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    const double y = field.points[field.offsets[i]].position.y;
    EXPECT_TRUE(y <= 300.0 || y >= 700.0) << y;
  }
}

TEST(ObstacleFronts, aRoundPileSpreadsWavesAsACylinderDoes)
{
  // Reflected from a circle of radius R at the angle of incidence i, a tube of width b0 has b0 (1 + 2 s/(R cos i)) after s.
  constexpr double radius = 200.0;
  constexpr int sides = 200000;
  const glm::dvec2 middle(1500.0, 500.0);
  Obstacle pile;
  pile.closed = true;
  pile.reflection = 1.0;
  for (int i = 0; i < sides; ++i)
  {
    const double a = 2.0 * Pi * i / sides;
    pile.points.push_back(middle + radius * glm::dvec2(std::cos(a), std::sin(a)));
  }
  TraceOptions options;
  options.spacing = 5.0;
  const RayField field = traceBasin({ pile }, 270.0, options);
  int compared = 0;
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    const RayInfo& ray = field.rays[i];
    if (ray.reflections != 1 || field.rays[static_cast<std::size_t>(ray.parent)].reflections != 0)
    {
      continue; // an inserted ray begins far from the wall
    }
    const glm::dvec2 hit = field.points[field.offsets[i]].position;
    const double cosine = (middle.x - hit.x) / radius;
    for (std::size_t j = field.offsets[i]; j < field.offsets[i + 1] && cosine > 0.5; ++j)
    {
      const RayPoint& point = field.points[j];
      const double s = glm::distance(point.position, hit);
      if (s > 50.0 && point.front != BetweenFronts && std::isfinite(point.spacingWidth))
      {
        const double exact = 1.0 + 2.0 * s / (radius * cosine);
        // The sides turn by 0.03 mrad each, inserted neighbours by 3 mrad or more.
        EXPECT_NEAR(point.spacingWidth / exact, 1.0, 0.015) << "incidence " << std::acos(cosine) << ", " << s << " m";
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000);
  // Rays are inserted where the reflected ones spread, and traced by way of the wall.
  EXPECT_GT(std::count_if(field.rays.begin(), field.rays.end(),
              [&](const RayInfo& ray)
              { return ray.reflections == 1 && field.rays[static_cast<std::size_t>(ray.parent)].reflections == 1; }),
    20);
}

TEST(ObstacleFronts, areTheSameForAnyLoop)
{
  const FlatBed floor(Basin, BasinDepth);
  const Obstacles walls({ { { { 900.0, 200.0 }, { 1100.0, 300.0 }, { 1000.0, 600.0 } }, true, 0.8 } });
  TraceOptions options;
  options.obstacles = &walls;
  options.spacing = 10.0;
  options.edge = EdgeRule::None;
  const RayField one = traceWaves(floor, fromWest(), options);
  Execution many;
  many.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 4; ++i)
    {
      threads.emplace_back([&, i] { body(i * n / 4, (i + 1) * n / 4); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  };
  const RayField two = traceWaves(floor, fromWest(), options, many);
  ASSERT_EQ(one.offsets, two.offsets);
  EXPECT_GT(countRays(one, 1), 10u);
  for (std::size_t i = 0; i < one.points.size(); ++i)
  {
    ASSERT_EQ(one.points[i].position, two.points[i].position);
  }
  for (std::size_t i = 0; i < one.rays.size(); ++i)
  {
    EXPECT_EQ(one.rays[i].launchSegment, two.rays[i].launchSegment);
  }
}
