#include "PaperScenes.h"

#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <thread>

using namespace swellray;
using namespace swellray::test;

namespace
{

bool sameBits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}

void expectSame(const RayField& a, const RayField& b)
{
  ASSERT_EQ(a.offsets, b.offsets);
  ASSERT_EQ(a.rays.size(), b.rays.size());
  for (std::size_t i = 0; i < a.rays.size(); ++i)
  {
    EXPECT_TRUE(sameBits(a.rays[i].launchParameter, b.rays[i].launchParameter));
    EXPECT_EQ(a.rays[i].parent, b.rays[i].parent);
    EXPECT_EQ(a.rays[i].endReason, b.rays[i].endReason);
    EXPECT_EQ(a.rays[i].finalState, b.rays[i].finalState);
  }
  for (std::size_t i = 0; i < a.points.size(); ++i)
  {
    const RayPoint& p = a.points[i];
    const RayPoint& q = b.points[i];
    ASSERT_TRUE(sameBits(p.position.x, q.position.x) && sameBits(p.position.y, q.position.y) &&
      sameBits(p.wavenumber.x, q.wavenumber.x) && sameBits(p.tubeWidth, q.tubeWidth) &&
      sameBits(p.spacingWidth, q.spacingWidth) && sameBits(p.phase, q.phase) && p.front == q.front &&
      p.caustics == q.caustics && p.state == q.state)
      << "point " << i;
  }
}

}

TEST(WaveTracer, FrontsAreCrests)
{
  const auto seafloor = makeBuiltinSeafloor("plane:slope=0.02");
  IncidentWave wave;
  wave.directionFrom = 60.0;
  TraceOptions options;
  options.stepsPerWave = 4.0;
  const RayField field = traceWaves(*seafloor, wave, options);
  ASSERT_GE(field.rays.size(), 100u);
  // Phases are read from the dense output by Newton to rounding.
  constexpr double PhaseTolerance = 1e-9;
  std::size_t seen = 0;
  for (const RayPoint& point : field.points)
  {
    if (point.front != BetweenFronts && isOnWater(point.state))
    {
      EXPECT_NEAR(point.phase, point.front * 2.0 * Pi / 4.0, PhaseTolerance * std::max(1.0, point.phase));
      ++seen;
    }
  }
  EXPECT_GT(seen, 5000u);
  // The wave meets the scene at phase 0.
  double earliest = 1e9;
  for (const RayPoint& point : field.points)
  {
    earliest = std::min(earliest, point.phase);
  }
  EXPECT_GE(earliest, 0.0);
  // The first ray starts half a spacing from there, where the phase is below k0 times that.
  EXPECT_LT(earliest, wave.wavenumber() * field.spacing);
}

TEST(WaveTracer, FrontsOfEqualLength)
{
  const auto seafloor = makeBuiltinSeafloor("bay");
  const RayField field = traceWaves(*seafloor, smallWave(90.0), paperOptions());
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    for (std::size_t j = field.offsets[i] + 1; j < field.offsets[i + 1]; ++j)
    {
      const RayPoint& a = field.points[j - 1];
      const RayPoint& b = field.points[j];
      if (a.front != BetweenFronts && b.front != BetweenFronts && isOnWater(b.state))
      {
        ASSERT_EQ(b.front, a.front + 1);
        // The length is integrated along with the ray, to its tolerance; a chord is shorter than its arc by
        // step^3/(24 R^2), 1e-3 m where a ray bends over R = 1.6 m.
        const double chord = glm::length(b.position - a.position);
        EXPECT_LE(chord, 0.4 + 1e-7);
        EXPECT_GE(chord, 0.4 - 1e-3);
      }
    }
  }
}

TEST(WaveTracer, RunsAgroundAtTheAgroundDepthAndFollowsTheShore)
{
  const auto seafloor = makeBuiltinSeafloor("bay");
  const IncidentWave wave = smallWave(90.0);
  const RayField field = traceWaves(*seafloor, wave, paperOptions());
  const double depth = 0.05 * wave.height;
  // The ground point is located by bisection, the walk by Newton on the contour.
  constexpr double DepthTolerance = 1e-9;
  std::size_t grounded = 0;
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    EXPECT_EQ(field.rays[i].endReason, EndReason::Aground);
    bool aground = false;
    for (std::size_t j = field.offsets[i]; j < field.offsets[i + 1]; ++j)
    {
      const RayPoint& point = field.points[j];
      if (point.state == RayState::Aground)
      {
        aground = true;
        EXPECT_NEAR(-seafloor->elevation(point.position), depth, DepthTolerance);
      }
      else if (point.state != RayState::Dead)
      {
        EXPECT_FALSE(aground) << "an aground ray went back to the water";
        EXPECT_GT(point.depth, depth);
      }
    }
    grounded += aground ? 1 : 0;
  }
  EXPECT_EQ(grounded, field.rays.size());
  // Between two aground rays a ray is dead: at the end none but the outermost are left.
  EXPECT_LE(countRays(field, [](const RayInfo& ray) { return ray.finalState == RayState::Aground; }), 2u);
}

TEST(WaveTracer, CapsEndAnySceneAndSaySo)
{
  const auto seafloor = makeBuiltinSeafloor("bay");
  TraceOptions options = paperOptions();
  options.maxFronts = 20;
  const RayField fronts = traceWaves(*seafloor, smallWave(90.0), options);
  EXPECT_TRUE(fronts.stepCapReached);
  EXPECT_GT(countRays(fronts, [](const RayInfo& ray) { return ray.endReason == EndReason::StepCap; }), 90u);

  options = paperOptions();
  options.maxRays = 110;
  const RayField rays = traceWaves(*seafloor, smallWave(90.0), options);
  EXPECT_TRUE(rays.rayCapReached);
  EXPECT_EQ(rays.rays.size(), 110u);

  options = paperOptions();
  options.maxPoints = 5000;
  const RayField points = traceWaves(*seafloor, smallWave(90.0), options);
  EXPECT_TRUE(points.stepCapReached);
  EXPECT_LT(points.points.size(), 5500u);

  options = paperOptions();
  options.maxRays = 10;
  EXPECT_EQ(traceWaves(*seafloor, smallWave(90.0), options).rays.size(), 10u);
}

TEST(WaveTracer, CancelsWhenAsked)
{
  const auto seafloor = makeBuiltinSeafloor("bay");
  Execution execution;
  int calls = 0;
  execution.progress = [&calls](double share)
  {
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0);
    return ++calls < 10;
  };
  const RayField field = traceWaves(*seafloor, smallWave(90.0), paperOptions(), execution);
  EXPECT_TRUE(field.cancelled);
  EXPECT_EQ(calls, 10);
  EXPECT_EQ(countRays(field, [](const RayInfo& ray) { return ray.endReason == EndReason::Cancelled; }), 100u);
}

TEST(WaveTracer, TheSameForAnyLoop)
{
  for (const char* form : { SteepIsland, "bay" })
  {
    const auto seafloor = makeBuiltinSeafloor(form);
    const IncidentWave wave = smallWave(form == std::string("bay") ? 75.0 : 250.0);
    const RayField one = traceWaves(*seafloor, wave, paperOptions());
    Execution execution;
    execution.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
    {
      // Odd chunks, taken by three threads as they come.
      constexpr std::size_t Chunk = 7;
      std::atomic<std::size_t> next{ 0 };
      std::vector<std::thread> threads;
      for (int t = 0; t < 3; ++t)
      {
        threads.emplace_back(
          [&]
          {
            for (std::size_t begin = next.fetch_add(Chunk); begin < n; begin = next.fetch_add(Chunk))
            {
              body(begin, std::min(n, begin + Chunk));
            }
          });
      }
      for (std::thread& thread : threads)
      {
        thread.join();
      }
    };
    TraceOptions options = paperOptions();
    const RayField many = traceWaves(*seafloor, wave, options, execution);
    expectSame(one, many);
  }
}

TEST(WaveTracer, SpacingAndTubeAgreeToSecondOrder)
{
  // Over a shoal, before the rays focus.
  const auto seafloor = makeBuiltinSeafloor("shoal:kind=gauss,h0=20,a=8,sg=300,x0=-1800,y0=-1200,x1=150,y1=1200");
  IncidentWave wave;
  wave.period = 10.0;
  wave.directionFrom = 270.0;
  const auto worst = [&](double spacing)
  {
    TraceOptions options;
    options.spacing = spacing;
    options.insertion = InsertionRule::None;
    options.tolerance = 1e-11;
    const RayField field = traceWaves(*seafloor, wave, options);
    double error = 0.0;
    for (const RayPoint& point : field.points)
    {
      if (point.front != BetweenFronts && point.position.x > -600.0 && std::abs(point.position.y) < 900.0)
      {
        error = std::max(error, std::abs(point.spacingWidth / point.tubeWidth - 1.0));
      }
    }
    return error;
  };
  const double coarse = worst(40.0);
  const double medium = worst(20.0);
  const double fine = worst(10.0);
  EXPECT_GT(coarse, 1e-3); // there is something to measure
  EXPECT_NEAR(std::log2(coarse / medium), 2.0, 0.5);
  EXPECT_NEAR(std::log2(medium / fine), 2.0, 0.3);
}

TEST(WaveTracer, SpacingAndTubeAgreeToSecondOrderUpToACaustic)
{
  // Behind a shoal, where tubes have narrowed down to a fifth, before they have no width.
  const auto seafloor = makeBuiltinSeafloor("shoal:kind=gauss,h0=20,a=12,sg=300,x0=-1300,y0=-600,x1=1800,y1=600");
  IncidentWave wave;
  wave.period = 10.0;
  wave.directionFrom = 270.0;
  std::size_t compared = 0;
  const auto worst = [&](double spacing)
  {
    TraceOptions options;
    options.spacing = spacing;
    options.insertion = InsertionRule::None;
    options.tolerance = 1e-11;
    const RayField field = traceWaves(*seafloor, wave, options);
    double error = 0.0;
    compared = 0;
    for (const RayPoint& point : field.points)
    {
      if (point.front != BetweenFronts && point.caustics == 0 && point.tubeWidth > 0.2 && point.tubeWidth < 0.5)
      {
        error = std::max(error, std::abs(point.spacingWidth / point.tubeWidth - 1.0));
        ++compared;
      }
    }
    return error;
  };
  const double coarse = worst(2.0);
  const double medium = worst(1.0);
  const double fine = worst(0.5);
  EXPECT_GT(compared, 1000u);
  EXPECT_GT(fine, 1e-6); // there is something to measure
  EXPECT_NEAR(std::log2(coarse / medium), 2.0, 0.5);
  EXPECT_NEAR(std::log2(medium / fine), 2.0, 0.3);
}

TEST(WaveTracer, UnequalSpacingIsOfSecondOrderToo)
{
  // Inserted rays make neighbours stand at unequal distances; the widths must not show it.
  const auto seafloor = makeBuiltinSeafloor("headland");
  TraceOptions options = paperOptions();
  options.spacing = 0.5;
  options.maxSpacing = 0.55;
  options.leeRays = false;
  const RayField field = traceWaves(*seafloor, smallWave(90.0), options);
  EXPECT_GT(countRays(field, isInserted), 20u);
  double error = 0.0;
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    for (std::size_t j = field.offsets[i]; j < field.offsets[i + 1]; ++j)
    {
      const RayPoint& point = field.points[j];
      if (point.front != BetweenFronts && isOnWater(point.state) && std::isfinite(point.spacingWidth) &&
        point.depth > 0.2)
      {
        error = std::max(error, std::abs(point.spacingWidth - std::abs(point.tubeWidth)));
      }
    }
  }
  // One-sided differences beside the shore are the worst of them: a few per cent at this spacing.
  EXPECT_LT(error, 0.1);
}

TEST(WaveTracer, HeightsOnAStraightBeachAreExactAtSideEdgesToo)
{
  // Kr = sqrt(cos theta0 / cos theta) holds along every ray, wherever it came in (Snell's law).
  const auto seafloor = makeBuiltinSeafloor("plane:slope=0.02,x0=-50,x1=1500,y0=-1000,y1=1000");
  IncidentWave wave;
  wave.period = 9.0;
  wave.directionFrom = 50.0; // 40 degrees from the shore normal
  TraceOptions options;
  options.tolerance = 1e-10;
  const RayField field = traceWaves(*seafloor, wave, options);
  const double sine0 = std::sin(radians(40.0));
  const double cosine0 = std::cos(radians(40.0));
  const double k0 = wave.wavenumber();
  std::size_t fromSide = 0;
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    fromSide += std::abs(field.points[field.offsets[i]].position.x - 1500.0) > 1.0 ? 1 : 0;
    for (std::size_t j = field.offsets[i]; j < field.offsets[i + 1]; ++j)
    {
      const RayPoint& point = field.points[j];
      if (!isOnWater(point.state))
      {
        continue;
      }
      const double k = solveWavenumber(wave.angularFrequency(), point.depth);
      const double sine = sine0 * k0 / k;
      EXPECT_NEAR(point.tubeWidth, std::sqrt(1.0 - sine * sine) / cosine0, 1e-7);
      EXPECT_NEAR(std::abs(point.wavenumber.y), k0 * sine0, 1e-9 * k0);
    }
  }
  EXPECT_GT(fromSide, 20u);
}

TEST(WaveTracer, CrossingRaysKeepBothSheets)
{
  const auto seafloor = makeBuiltinSeafloor("shoal:kind=gauss,h0=20,a=14,sg=300,x0=-1800,y0=-1800,x1=3000,y1=1800");
  IncidentWave wave;
  wave.period = 10.0;
  wave.directionFrom = 270.0;
  TraceOptions options;
  options.spacing = 30.0;
  const RayField field = traceWaves(*seafloor, wave, options);
  std::size_t crossed = 0;
  for (const auto& [front, places] : frontsOf(field))
  {
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      // Lambda grows with y: a neighbour further south has crossed over.
      crossed += places[i].second->position.y < places[i - 1].second->position.y ? 1 : 0;
    }
  }
  EXPECT_GT(crossed, 1000u);
  EXPECT_TRUE(std::any_of(
    field.points.begin(), field.points.end(), [](const RayPoint& p) { return p.caustics == 1 && p.tubeWidth < 0.0; }));
}

TEST(WaveTracer, MonitorsTheDispersionRelation)
{
  const auto seafloor = makeBuiltinSeafloor("bay");
  TraceOptions options = paperOptions();
  for (const double tolerance : { 1e-6, 1e-9 })
  {
    options.tolerance = tolerance;
    const RayField field = traceWaves(*seafloor, smallWave(90.0), options);
    for (const RayInfo& ray : field.rays)
    {
      // Some tens of steps, each within the tolerance.
      EXPECT_LT(ray.dispersionError, 100.0 * tolerance);
    }
  }
}

TEST(WaveTracer, WrongCalls)
{
  const auto seafloor = makeBuiltinSeafloor("bay");
  const IncidentWave wave = smallWave(90.0);
  const auto refused = [&](auto&& change)
  {
    TraceOptions options;
    change(options);
    EXPECT_THROW(traceWaves(*seafloor, wave, options), std::invalid_argument);
  };
  refused([](TraceOptions& o) { o.spacing = 0.0; });
  refused([](TraceOptions& o) { o.maxSpacing = -1.0; });
  refused([](TraceOptions& o) { o.stepsPerWave = std::nan(""); });
  refused([](TraceOptions& o) { o.step = 0.0; });
  refused([](TraceOptions& o) { o.tolerance = 1.0; });
  refused([](TraceOptions& o) { o.flatHeight = -1.0; });
  refused([](TraceOptions& o) { o.agroundDepth = 0.0; });
  refused([](TraceOptions& o) { o.waterLevel = std::nan(""); });
  refused([](TraceOptions& o) { o.maxRays = 0; });
  IncidentWave bad = wave;
  bad.period = 0.0;
  EXPECT_THROW(traceWaves(*seafloor, bad, {}), std::invalid_argument);
  // A wave with a million crests across the bay has no phase any more.
  bad.period = 1e-4;
  EXPECT_THROW(traceWaves(*seafloor, bad, {}), std::invalid_argument);
  // From the land side nothing comes in.
  EXPECT_THROW(traceWaves(*seafloor, smallWave(270.0), {}), std::runtime_error);
}
