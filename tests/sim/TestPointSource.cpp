// Waves from a point: circular crests over a flat bed, and what they become on the edges of a scene.
#include "sim/PointSource.h"

#include "sim/Angles.h"
#include "sim/BuiltinCurrent.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/WaveTracer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

using namespace swellray;

namespace
{

// A square of 1 km, 20 m deep everywhere, in water that is 20 m deep outside too: nothing refracts.
constexpr double FlatDepth = 20.0;

std::shared_ptr<const Seafloor> flatSquare()
{
  return makeBuiltinSeafloor("shoal:kind=poly3,depth=20,height=0,x0=-500,y0=-500,x1=500,y1=500");
}

IncidentWave flatWave()
{
  IncidentWave wave;
  wave.period = 8.0;
  wave.offshoreDepth = FlatDepth;
  return wave;
}

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

}

TEST(PointSource, IsThatOfItsFormulas)
{
  const PointSource source({ 3.0, -4.0 });
  const auto at = [&](const glm::dvec2& place)
  {
    SourceSample sample;
    source.evaluate(place, sample);
    return sample;
  };
  const glm::dvec2 place(-9.0, 12.0);
  const SourceSample sample = at(place);
  EXPECT_DOUBLE_EQ(sample.distance, 20.0);
  EXPECT_DOUBLE_EQ(sample.width, 20.0);
  EXPECT_DOUBLE_EQ(sample.heading, std::atan2(16.0, -12.0));
  constexpr double step = 1e-3; // m of 20: differences of second order, 1e-9 relative
  for (int axis = 0; axis < 2; ++axis)
  {
    glm::dvec2 way(0.0);
    way[axis] = step;
    EXPECT_NEAR(sample.turn[axis], (at(place + way).heading - at(place - way).heading) / (2.0 * step), 1e-8 / 20.0);
  }
}

TEST(PointSource, sendsStraightRaysWithCircularCrests)
{
  const auto seafloor = flatSquare();
  const IncidentWave wave = flatWave();
  const double k = wave.wavenumber();
  // Far, near a corner, and so near an edge that the directions along it turn by 170 degrees.
  for (const glm::dvec2 from : { glm::dvec2(-90000.0, 20000.0), glm::dvec2(-700.0, 650.0), glm::dvec2(30.0, -540.0) })
  {
    const PointSource source(from);
    TraceOptions options;
    options.source = &source;
    options.spacing = 5.0;
    options.insertion = InsertionRule::None;
    const RayField field = traceWaves(*seafloor, wave, options);
    ASSERT_GT(field.rays.size(), 20u);
    ASSERT_TRUE(field.sourceDistance);
    // The nearest place of the square, found to a part of its edge of 2.5 m: 2.5^2/2 over the distance.
    const glm::dvec2 nearest = glm::clamp(from, glm::dvec2(-500.0), glm::dvec2(500.0));
    const double reference = *field.sourceDistance;
    EXPECT_NEAR(reference, glm::length(nearest - from), 0.1);
    for (std::size_t ray = 0; ray < field.rays.size(); ++ray)
    {
      const glm::dvec2 first = field.points[field.offsets[ray]].position - from;
      // Equal steps of lambda are equal angles at the source, lambda growing to the left.
      const glm::dvec2 before = field.points[field.offsets[ray == 0 ? 0 : ray - 1]].position - from;
      if (ray > 0)
      {
        const double angle = std::atan2(before.x * first.y - before.y * first.x, glm::dot(before, first));
        EXPECT_NEAR(angle * reference, 5.0, 1e-7) << "ray " << ray;
      }
      for (std::size_t i = field.offsets[ray]; i < field.offsets[ray + 1]; ++i)
      {
        const RayPoint& point = field.points[i];
        const glm::dvec2 way = point.position - from;
        const double r = glm::length(way);
        EXPECT_NEAR((way.x * first.y - way.y * first.x) / glm::length(first), 0.0, 1e-9 * r);
        EXPECT_NEAR(point.phase, k * (r - reference), 1e-9 * k * r);
        EXPECT_NEAR(point.tubeWidth, r / reference, 1e-9 * r / reference);
      }
    }
  }
}

TEST(PointSource, isBroughtToTheEdgesByEveryRule)
{
  // A beach that faces east, with a current along it: everything that the edges can do with the wave.
  const auto beach = makeBuiltinSeafloor("plane:slope=0.02");
  const auto current = makeBuiltinCurrent("shear:S=0.0005");
  const Rectangle box = beach->bounds();
  const PointSource source({ box.high.x + 400.0, box.low.y + 0.2 * box.size().y });
  IncidentWave wave;
  wave.period = 9.0;
  for (const EdgeRule rule : { EdgeRule::Contours, EdgeRule::Edge, EdgeRule::None })
  {
    for (const bool flows : { false, true })
    {
      const Current* flow = flows ? current.get() : nullptr;
      const LaunchLine line(*beach, 0.0, wave, 0.05, { rule, {}, flow, nullptr, nullptr, &source });
      ASSERT_GT(line.length(), 0.0);
      for (int i = 1; i < 40; ++i)
      {
        const double lambda = line.length() * i / 40.0;
        const double step = 1e-4 * line.length() / 40.0;
        const LaunchPoint point = line.at(lambda);
        const LaunchPoint ahead = line.at(lambda + step);
        const LaunchPoint behind = line.at(lambda - step);
        if (ahead.segment != behind.segment || glm::length(ahead.position - behind.position) > 20.0)
        {
          continue; // across a corner or land
        }
        // Differences of second order over metres, in wavenumbers of 0.05 rad/m that change over hundreds of metres.
        constexpr double same = 1e-5;
        const glm::dvec2 dPosition = (ahead.position - behind.position) / (2.0 * step);
        const glm::dvec2 dWavenumber = (ahead.wavenumber - behind.wavenumber) / (2.0 * step);
        EXPECT_LT(glm::length(point.dPosition - dPosition), same * glm::length(dPosition));
        EXPECT_LT(glm::length(point.dWavenumber - dWavenumber), same * glm::length(dWavenumber))
          << static_cast<int>(rule);
        // Phase goes by k along the edge.
        EXPECT_NEAR((ahead.phase - behind.phase) / (2.0 * step), glm::dot(point.wavenumber, dPosition),
          same * glm::length(point.wavenumber) * glm::length(dPosition));
      }
    }
  }
}

TEST(PointSource, mustLieOutsideOfTheScene)
{
  const auto seafloor = flatSquare();
  TraceOptions options;
  const PointSource inside({ 10.0, 20.0 });
  options.source = &inside;
  EXPECT_THAT(messageOf([&] { traceWaves(*seafloor, flatWave(), options); }),
    testing::HasSubstr("it must lie outside of the scene"));
  const PointSource corner({ -500.0, -500.0 });
  options.source = &corner;
  EXPECT_THAT(
    messageOf([&] { traceWaves(*seafloor, flatWave(), options); }), testing::HasSubstr("on the edge of the scene"));
}
