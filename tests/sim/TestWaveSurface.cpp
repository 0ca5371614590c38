#include "sim/WaveSurface.h"

#include "RayBundle.h"

#include "sim/Angles.h"
#include "sim/RayField.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace swellray;
using namespace swellray::bundles;

namespace
{

constexpr double Rounding = 1e-9;

// Arrays for drawing are floats.
constexpr double FloatTolerance = 2e-6;

glm::dvec3 pointOf(const std::vector<double>& positions, std::size_t i)
{
  return { positions[3 * i], positions[3 * i + 1], positions[3 * i + 2] };
}

// 3 m of water up to x = 121 m, then a cliff of 5:1.
class Cliff : public Slope
{
public:
  Cliff()
    : Slope(3.0, 0.0)
  {
  }
  void evaluate(const glm::dvec2& p, unsigned derivatives, BedSample& bed) const override
  {
    this->Slope::evaluate(p, derivatives, bed);
    bed.elevation += 5.0 * std::max(0.0, p.x - 121.0);
    bed.gradient.x = p.x > 121.0 ? 5.0 : 0.0;
  }
};

double areaOf(const SurfaceSheet& sheet)
{
  double area = 0.0;
  for (const auto& triangle : sheet.Triangles)
  {
    const glm::dvec3 a = pointOf(sheet.Position, static_cast<std::size_t>(triangle[0]));
    const glm::dvec3 b = pointOf(sheet.Position, static_cast<std::size_t>(triangle[1]));
    const glm::dvec3 c = pointOf(sheet.Position, static_cast<std::size_t>(triangle[2]));
    const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    EXPECT_GE(twice, 0.0); // looks up
    area += 0.5 * twice;
  }
  return area;
}

}

TEST(SurfaceSheet, hasTheWantedPointsAWaveHoweverTheRaysWereStepped)
{
  const Slope seafloor(20.0, 0.0);
  for (const double step : { 3.0, 24.0, 60.0 })
  {
    const Bundle bundle = straight(step);
    const SurfaceSheet sheet(bundle.rays(), seafloor, 0.0, 16.0);
    for (std::size_t ray = 0; ray < sheet.rayCount(); ++ray)
    {
      for (std::int64_t i = sheet.Offsets[ray] + 1; i < sheet.Offsets[ray + 1]; ++i)
      {
        const auto at = static_cast<std::size_t>(i);
        EXPECT_LE(sheet.Phase[at] - sheet.Phase[at - 1], 2.0 * Pi / 16.0 + Rounding);
        EXPECT_GT(sheet.Phase[at], sheet.Phase[at - 1]);
        EXPECT_NEAR(sheet.Position[3 * at], sheet.Phase[at] / K, Rounding);
      }
    }
    EXPECT_NEAR(areaOf(sheet), 120.0 * 20.0, 1e-6);
  }
}

TEST(SurfaceSheet, coarseStepsOfACurvedRayMakeASmoothOne)
{
  // A quarter of a circle of 100 m in four steps. Hermite's cubic is off it by R a^4/384 = 6.2 cm/1000 at a = 22.5 degrees.
  constexpr double radius = 100.0;
  Bundle bundle;
  for (int ray = 0; ray < 2; ++ray)
  {
    bundle.begin(ray);
    for (int i = 0; i <= 4; ++i)
    {
      const double angle = i * Pi / 8.0;
      bundle.add(radius * glm::dvec2(std::sin(angle), 1.0 - std::cos(angle)) + glm::dvec2(0.0, ray), K * radius * angle,
        { std::cos(angle), std::sin(angle) });
    }
  }
  const Slope seafloor(20.0, 0.0);
  const SurfaceSheet sheet(bundle.rays(), seafloor, 0.0, 32.0);
  for (std::int64_t i = 0; i < sheet.Offsets[1]; ++i)
  {
    const glm::dvec3 point = pointOf(sheet.Position, static_cast<std::size_t>(i));
    EXPECT_NEAR(std::hypot(point.x, point.y - radius), radius, radius * std::pow(Pi / 8.0, 4) / 384.0 * 1.1);
  }
}

TEST(SurfaceSheet, raysOfDifferentDensityJoinWithoutCracks)
{
  // A ray comes in between two at x = 33.4, at no point of theirs; another ends early at the side.
  Bundle bundle = straight(7.0, 3);
  bundle.begin(2.5, 0);
  for (double x = 33.4; x < 119.0; x += 5.0)
  {
    bundle.add({ x, 2.5 }, K * x, { 1.0, 0.0 });
  }
  bundle.add({ 119.0, 2.5 }, K * 119.0, { 1.0, 0.0 });
  const Slope seafloor(20.0, 0.0);
  const SurfaceSheet sheet(bundle.rays(), seafloor, 0.0, 16.0);
  EXPECT_NEAR(areaOf(sheet), 119.0 * 10.0, 1e-6);
  // Inside, every edge belongs to two triangles: no point lies on the edge of another triangle.
  std::map<std::pair<std::int64_t, std::int64_t>, int> uses;
  for (const auto& triangle : sheet.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      ++uses[std::minmax(triangle[c], triangle[(c + 1) % 3])];
    }
  }
  for (const auto& [edge, count] : uses)
  {
    const glm::dvec3 middle = 0.5 *
      (pointOf(sheet.Position, static_cast<std::size_t>(edge.first)) +
        pointOf(sheet.Position, static_cast<std::size_t>(edge.second)));
    const bool inside = middle.x > 1e-6 && middle.x < 118.9 && middle.y > 1e-6 && middle.y < 10.0 - 1e-6;
    EXPECT_EQ(count, inside ? 2 : 1) << middle.x << " " << middle.y;
  }
}

TEST(SurfaceSheet, crossingSheetsAreKept)
{
  // Three rays that meet in one line of points and cross: both sides look up.
  Bundle bundle;
  for (int i = 0; i < 3; ++i)
  {
    bundle.begin(5.0 * i);
    const glm::dvec2 direction = glm::normalize(glm::dvec2(100.0, -10.0 * (i - 1)));
    for (double s = 0.0; s < 120.0; s += 10.0)
    {
      bundle.add(glm::dvec2(0.0, 5.0 * (i - 1)) + s * direction, K * s, direction);
    }
  }
  const Slope seafloor(20.0, 0.0);
  const SurfaceSheet sheet(bundle.rays(), seafloor, 0.0, 16.0);
  double beyond = 0.0;
  for (const auto& triangle : sheet.Triangles)
  {
    beyond = std::max(beyond, sheet.Position[3 * static_cast<std::size_t>(triangle[0])]);
  }
  EXPECT_GT(beyond, 100.0);
  EXPECT_GT(areaOf(sheet), 0.0);
}

TEST(SurfaceSheet, meetsTheBeachAboveStillWater)
{
  // Rays aground in 0.1 m of water on a slope of 1:20, walking along the shore.
  Bundle bundle;
  const Slope seafloor(2.0, 0.05);
  for (int i = 0; i < 3; ++i)
  {
    bundle.begin(5.0 * i);
    for (double x = 0.0; x < 37.0; x += 4.0)
    {
      bundle.add({ x, 5.0 * i + 0.02 * x }, K * x, { 1.0, 0.0 });
    }
    bundle.add({ 38.0, 5.0 * i + 0.76 }, K * (38.0 + 0.5 * i), { 1.0, 0.0 }, 0.08, 1.0, RayState::Aground);
    for (double y = 1.0; y < 8.0; y += 1.0)
    {
      bundle.add(
        { 38.0, 5.0 * i + 0.76 + y }, K * (38.0 + 0.5 * i + y), { 0.0, 1.0 }, 0.08, 1.0 + y, RayState::Aground);
    }
  }
  const SurfaceSheet sheet(bundle.rays(), seafloor, 0.0, 16.0);
  ASSERT_GT(sheet.pointCount(), sheet.rayPointCount());
  for (std::size_t i = sheet.rayPointCount(); i < sheet.pointCount(); ++i)
  {
    EXPECT_NEAR(sheet.Position[3 * i], 40.8, 1e-4); // 0.04 m above still water
    EXPECT_NEAR(sheet.Position[3 * i + 2], 0.04, 1e-5);
    EXPECT_NEAR(sheet.Depth[i], -0.04, 1e-5);
  }
  EXPECT_GT(areaOf(sheet), 0.0);
}

TEST(SurfaceSheet, refusesWhatMakesNoSense)
{
  const Slope seafloor(20.0, 0.0);
  const Bundle bundle = straight(5.0);
  EXPECT_THROW(SurfaceSheet(bundle.rays(), seafloor, 0.0, 0.0), std::invalid_argument);
  EXPECT_THROW(SurfaceSheet(bundle.rays(), seafloor, 0.0, 16.0, {}, 100), std::runtime_error);
  const SurfaceSheet sheet(bundle.rays(), seafloor, 0.0, 16.0);
  SurfaceOptions options;
  options.period = 0.0;
  EXPECT_THROW(WaveSurface(sheet, seafloor, options), std::invalid_argument);
}

TEST(WaveSurface, crestsStandWherePhiIsAMultipleOf2Pi)
{
  const Slope seafloor(20.0, 0.0);
  Surface surface(straight(5.0), seafloor, 16.0, 1.5);
  const double time = 3.3;
  surface.at(time, "airy");
  for (std::size_t i = 0; i < surface.Sheet.pointCount(); ++i)
  {
    const double phi = surface.Sheet.Phase[i] - 2.0 * Pi / Period * time;
    EXPECT_NEAR(surface.Phase[i], phi, Rounding);
    EXPECT_NEAR(surface.Position[3 * i + 2], 1.5 + 0.5 * std::cos(phi), Rounding);
    EXPECT_NEAR(surface.Position[3 * i], surface.Sheet.Phase[i] / K, Rounding);
    EXPECT_NEAR(surface.Depth[i], 21.5, Rounding);
  }
}

TEST(WaveSurface, anyFrameStandsAlone)
{
  const Slope seafloor(4.0, 0.0);
  Surface surface(breaking(), seafloor);
  surface.at(17.0, "jeschke");
  const auto first = surface.Position;
  surface.at(3.0, "jeschke");
  EXPECT_NE(first, surface.Position);
  surface.at(17.0, "jeschke");
  EXPECT_EQ(first, surface.Position);
}

TEST(WaveSurface, repeatsAfterAPeriodWhereWavesDoNotVary)
{
  const Slope seafloor(4.0, 0.0);
  Surface surface(breaking(), seafloor);
  surface.at(1.7, "vortex:variation=0");
  const auto first = surface.Position;
  surface.at(1.7 + Period, "vortex:variation=0");
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_NEAR(first[i], surface.Position[i], 1e-8);
  }
  surface.at(1.7, "vortex:variation=0.4");
  const auto varied = surface.Position;
  surface.at(1.7 + Period, "vortex:variation=0.4");
  EXPECT_NE(varied, surface.Position);
}

TEST(WaveSurface, isTheSameForAnyLoop)
{
  Execution backwards;
  backwards.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    for (std::size_t i = n; i > 0; --i)
    {
      body(i - 1, i);
    }
  };
  const Slope seafloor(4.0, 0.0);
  Surface surface(breaking(), seafloor);
  surface.at(5.0, "jeschke");
  const auto position = surface.Position;
  const auto normal = surface.Normal;
  surface.at(5.0, "jeschke", backwards);
  EXPECT_EQ(position, surface.Position);
  EXPECT_EQ(normal, surface.Normal);
}

TEST(WaveSurface, normalsAndVelocitiesAreThoseOfTheMovingSurface)
{
  const Slope seafloor(20.0, 0.0);
  Surface surface(straight(5.0), seafloor, 64.0);
  constexpr double step = 1e-5;
  surface.at(2.0 + step, "gerstner");
  const auto later = surface.Position;
  surface.at(2.0 - step, "gerstner");
  const auto earlier = surface.Position;
  surface.at(2.0, "gerstner");
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(surface.Sheet.Offsets[1]); ++i)
  {
    const glm::dvec3 velocity = (pointOf(later, i) - pointOf(earlier, i)) / (2.0 * step);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(surface.Velocity[3 * i + static_cast<std::size_t>(c)], velocity[c], 1e-5);
    }
    const glm::dvec3 normal(surface.Normal[3 * i], surface.Normal[3 * i + 1], surface.Normal[3 * i + 2]);
    EXPECT_NEAR(glm::length(normal), 1.0, FloatTolerance);
    EXPECT_GT(normal.z, 0.0);
    if (std::abs(surface.Sheet.Phase[i + 1] - 2.0 * surface.Sheet.Phase[i] + surface.Sheet.Phase[i - 1]) < 1e-6)
    {
      // The chord over two steps of 2 pi/64 is parallel to the tangent but for their square.
      const glm::dvec3 chord = glm::normalize(pointOf(surface.Position, i + 1) - pointOf(surface.Position, i - 1));
      EXPECT_NEAR(glm::dot(chord, normal), 0.0, 2e-4);
    }
  }
}

TEST(WaveSurface, breakersOverhangAndOnlyTheyDo)
{
  const Slope seafloor(4.0, 0.0);
  for (const char* section : { "jeschke:variation=0", "vortex:variation=0" })
  {
    Surface surface(breaking(), seafloor, 64.0);
    bool overhangs = false;
    for (double time = 0.0; time < Period; time += 0.5)
    {
      surface.at(time, section);
      for (std::size_t i = 0; i < surface.Sheet.pointCount(); ++i)
      {
        if (surface.Normal[3 * i + 2] < -0.1f)
        {
          overhangs = true;
          EXPECT_EQ(surface.Broken[i], 1) << section << " " << time;
          EXPECT_GT(surface.Sheet.Phase[i], K * 60.0 - Pi);
        }
      }
    }
    EXPECT_TRUE(overhangs) << section;
  }
}

TEST(WaveSurface, nothingGoesBelowTheBed)
{
  // Waves of 2 m that nothing lowers, over 0.3 m of water: fournier-reeves would dig far into the ground.
  const Slope seafloor(0.9, 0.005);
  for (const char* section : { "fournier-reeves", "airy", "vortex", "gonzato-lesaec" })
  {
    Surface surface(breaking(), seafloor);
    for (double time = 0.0; time < Period; time += 0.7)
    {
      surface.at(time, section);
      for (std::size_t i = 0; i < surface.Sheet.pointCount(); ++i)
      {
        const glm::dvec3 point = pointOf(surface.Position, i);
        ASSERT_GE(point.z, seafloor.elevation({ point.x, point.y }) - Rounding) << section;
        ASSERT_NEAR(surface.Depth[i], -seafloor.elevation({ point.x, point.y }), Rounding);
      }
    }
  }
}

TEST(WaveSurface, lipsThatStrikeACliffAreNotLiftedOntoIt)
{
  Bundle bundle;
  constexpr double Height = 2.0;
  for (int i = 0; i < 3; ++i)
  {
    bundle.begin(5.0 * i);
    for (double x = 0.0; x < 120.5; x += 2.0)
    {
      bundle.add({ x, 5.0 * i }, K * x, { 1.0, 0.0 }, Height, std::max(0.0, x - 110.0));
    }
  }
  const Cliff cliff;
  const Slope flat(3.0, 0.0);
  for (const char* section : { "jeschke", "gonzato-lesaec", "vortex" })
  {
    Surface beforeCliff(bundle, cliff);
    Surface free(bundle, flat);
    int struck = 0;
    for (double time = 0.0; time < Period; time += 0.2)
    {
      beforeCliff.at(time, section);
      free.at(time, section);
      for (std::size_t i = 0; i < free.Sheet.rayPointCount(); ++i)
      {
        const glm::dvec3 point = pointOf(beforeCliff.Position, i);
        const glm::dvec3 without = pointOf(free.Position, i);
        // A ten-thousandth of the way into it, on 5:1, and the film on the bed.
        EXPECT_LE(point.z, std::max(without.z, Height) + 0.02) << section;
        EXPECT_GE(point.z, cliff.elevation({ point.x, point.y }) - Rounding) << section;
        struck += point.x < without.x - 0.1 ? 1 : 0;
      }
    }
    EXPECT_GT(struck, 0) << section;
  }
}

TEST(WaveSurface, breakingPhaseIsThatOfTheTrace)
{
  const Slope seafloor(4.0, 0.0);
  Surface surface(breaking(), seafloor);
  for (std::size_t i = 0; i < surface.Sheet.rayPointCount(); ++i)
  {
    const FoamOrigin origin = surface.Moved->foamOrigin(i);
    if (surface.Sheet.Phase[i] < K * 60.0 - 1e-9)
    {
      EXPECT_TRUE(std::isnan(origin.begin)) << i;
      EXPECT_EQ(origin.share, 0.0) << i;
    }
    else
    {
      EXPECT_NEAR(origin.begin, K * 60.0, 1e-6);
      EXPECT_EQ(origin.share, 1.0);
    }
  }
}
