// Rays inserted between those that were launched: on the water, and into the lee.
#include "PaperScenes.h"

#include "sim/BuiltinSeafloor.h"
#include "sim/HamiltonianRay.h"
#include "sim/LaunchLine.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace swellray;
using namespace swellray::test;

TEST(InsertedRays, InsertsWhereRaysDiverge)
{
  const auto seafloor = makeBuiltinSeafloor("bay");
  const IncidentWave wave = smallWave(90.0);
  TraceOptions options = paperOptions();
  const RayField dense = traceWaves(*seafloor, wave, options);
  options.insertion = InsertionRule::None;
  const RayField plain = traceWaves(*seafloor, wave, options);
  EXPECT_EQ(plain.rays.size(), 100u);
  EXPECT_EQ(countRays(plain, isInserted), 0u);
  EXPECT_GT(countRays(dense, isInserted), 50u);

  // With insertion no two neighbours on the water stand further apart than asked.
  const auto widest = [](const RayField& field)
  {
    double gap = 0.0;
    for (const auto& [front, places] : frontsOf(field))
    {
      for (std::size_t i = 1; i < places.size(); ++i)
      {
        if (isOnWater(places[i - 1].second->state) && isOnWater(places[i].second->state))
        {
          gap = std::max(gap, glm::length(places[i].second->position - places[i - 1].second->position));
        }
      }
    }
    return gap;
  };
  EXPECT_LE(widest(dense), 1.2);
  EXPECT_GT(widest(plain), 1.5);
}

TEST(InsertedRays, RetracedRaysAreExact)
{
  const auto seafloor = makeBuiltinSeafloor("headland");
  const IncidentWave wave = smallWave(80.0);
  TraceOptions options = paperOptions();
  options.step.reset();
  const RayField field = traceWaves(*seafloor, wave, options);
  const LaunchLine line(*seafloor, 0.0, wave, 0.05 * wave.height, { EdgeRule::Contours });
  RayMedium medium;
  medium.seafloor = seafloor.get();
  medium.angularFrequency = wave.angularFrequency();
  medium.agroundDepth = 0.05 * wave.height;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    if (!isInserted(field.rays[i]) || field.rays[i].lee)
    {
      continue;
    }
    const LaunchPoint launch = line.at(field.rays[i].launchParameter);
    RayStart start;
    start.position = launch.position;
    start.wavenumber = launch.wavenumber;
    start.dPosition = launch.dPosition;
    start.dWavenumber = launch.dWavenumber;
    start.phase = launch.phase;
    HamiltonianRay ray(medium, start, options.tolerance);
    for (std::size_t j = field.offsets[i]; j < field.offsets[i + 1]; ++j)
    {
      const RayPoint& point = field.points[j];
      RayPoint own;
      if (point.front == BetweenFronts || !isOnWater(point.state))
      {
        break;
      }
      ASSERT_TRUE(ray.advance(FrontMeasure::Phase, point.phase, own));
      // The same code from the same start: only the phase asked for may differ, by rounding.
      EXPECT_NEAR(glm::length(own.position - point.position), 0.0, 1e-9);
      EXPECT_NEAR(own.tubeWidth, point.tubeWidth, 1e-9 * std::max(1.0, std::abs(own.tubeWidth)));
      ++compared;
    }
  }
  EXPECT_GT(compared, 100u);
}

TEST(InsertedRays, InterpolatedRaysStartBetweenTheirNeighbours)
{
  const auto seafloor = makeBuiltinSeafloor("bay");
  TraceOptions options = paperOptions();
  options.insertion = InsertionRule::Interpolate;
  const RayField field = traceWaves(*seafloor, smallWave(90.0), options);
  const auto fronts = frontsOf(field);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    if (!isInserted(field.rays[i]) || field.rays[i].lee)
    {
      continue;
    }
    const RayPoint& begin = field.points[field.offsets[i]];
    const auto& places = fronts.at(begin.front);
    const auto self = std::find_if(places.begin(), places.end(), [&](const auto& p) { return p.second == &begin; });
    ASSERT_NE(self, places.end());
    if (self == places.begin() || std::next(self) == places.end())
    {
      continue;
    }
    const glm::dvec2 middle = 0.5 * (std::prev(self)->second->position + std::next(self)->second->position);
    EXPECT_NEAR(glm::length(middle - begin.position), 0.0, 1e-9);
    ++checked;
  }
  EXPECT_GT(checked, 20u);
}

TEST(InsertedRays, LeeRaysFillTheShadowAndCanBeSwitchedOff)
{
  const auto seafloor = makeBuiltinSeafloor(SteepIsland);
  TraceOptions options = paperOptions();
  const RayField with = traceWaves(*seafloor, smallWave(270.0), options);
  options.leeRays = false;
  const RayField without = traceWaves(*seafloor, smallWave(270.0), options);
  EXPECT_EQ(countRays(without, isLee), 0u);
  EXPECT_GT(countRays(with, isLee), 20u);

  // Count squares of the lee that a ray passes through.
  const auto covered = [](const RayField& field)
  {
    std::map<std::pair<int, int>, bool> squares;
    for (const RayPoint& point : field.points)
    {
      if (point.position.x > 10.0 && std::abs(point.position.y) < 12.0)
      {
        squares[{ static_cast<int>(point.position.x / 4.0), static_cast<int>(std::floor(point.position.y / 4.0)) }] =
          true;
      }
    }
    return squares.size();
  };
  EXPECT_LT(covered(without), 5u);
  EXPECT_GT(covered(with), 50u);

  for (std::size_t i = 0; i < with.rays.size(); ++i)
  {
    if (with.rays[i].lee)
    {
      // It begins in the water, with the width of a tube spread wider than at launch.
      const RayPoint& begin = with.points[with.offsets[i]];
      EXPECT_GT(begin.depth, 0.0);
      EXPECT_GT(begin.spacingWidth, 1.0);
    }
  }
}

TEST(InsertedRays, FlatRaysAreNotRefined)
{
  const auto seafloor = makeBuiltinSeafloor("bay");
  TraceOptions options = paperOptions();
  options.flatHeight = 10.0;
  const RayField field = traceWaves(*seafloor, smallWave(90.0), options);
  EXPECT_EQ(countRays(field, isInserted), 0u);
  std::size_t flat = 0;
  for (const RayPoint& point : field.points)
  {
    flat += point.state == RayState::Flat ? 1 : 0;
  }
  EXPECT_GT(flat, field.points.size() / 2);

  options.flatHeight = 0.0;
  const RayField none = traceWaves(*seafloor, smallWave(90.0), options);
  EXPECT_TRUE(
    std::none_of(none.points.begin(), none.points.end(), [](const RayPoint& p) { return p.state == RayState::Flat; }));
}
