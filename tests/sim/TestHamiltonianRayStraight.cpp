// Rays over straight contours against Snell's law: plane, Dean and barred beaches, edge-trapped rays, fans.
#include "RayComparison.h"
#include "StraightForms.h"
#include "TrappedRay.h"

#include "sim/BuiltinSeafloor.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

using namespace swellray;
using namespace swellray::reference;

namespace
{

constexpr double Tolerance = 1e-12;

// Asked for: 1e-6 m a km. Some thousand steps, each right to 1e-12 wavelengths of 100 m, add up to less than this.
constexpr double PositionTolerance = 3e-9;
// Asked for: 1e-6. The same steps, relative.
constexpr double RelativeTolerance = 2e-10;
// Asked for: 1e-6. The tube is held to fewer digits than the ray.
constexpr double WidthTolerance = 1e-9;

struct BeachCase
{
  const char* name;
  const char* spec;
  std::function<Real(Real)> depth;
  double period;
  double x0;
  double theta0;  // degrees from the shore normal
  double nearest; // x of the last place
};

#define SCENE ",x0=-100,x1=12100,y0=-40000,y1=40000"

const BeachCase Cases[] = {
  { "PlaneA", "plane:s=0.02" SCENE, planeDepth(0.02L), 10.0, 2000.0, 45.0, 5.0 },
  { "PlaneB", "plane:s=0.05" SCENE, planeDepth(0.05L), 7.0, 1500.0, 30.0, 2.0 },
  { "PlaneC", "plane:s=0.01" SCENE, planeDepth(0.01L), 12.0, 12000.0, 70.0, 10.0 },
  { "PlaneSteep", "plane:s=0.2" SCENE, planeDepth(0.2L), 6.0, 300.0, -55.0, 1.0 },
  { "PlaneLong", "plane:s=0.004" SCENE, planeDepth(0.004L), 18.0, 9000.0, 15.0, 25.0 },
  { "PlaneNormal", "plane:s=0.03" SCENE, planeDepth(0.03L), 9.0, 1000.0, 0.0, 4.0 },
  { "DeanA", "dean:A=0.12" SCENE, deanDepth(0.12L), 9.0, 3000.0, 40.0, 5.0 },
  { "DeanCoarse", "dean:A=0.25" SCENE, deanDepth(0.25L), 6.0, 1500.0, -62.0, 2.0 },
  { "DeanFine", "dean:A=0.08" SCENE, deanDepth(0.08L), 14.0, 8000.0, 25.0, 8.0 },
  { "BarA", "bar:s=0.02,hb=2,xb=200,wb=40" SCENE, barDepth(0.02L, 2.0L, 200.0L, 40.0L), 9.0, 1500.0, 40.0, 10.0 },
  { "BarNarrow", "bar:s=0.025,hb=2.5,xb=160,wb=18" SCENE, barDepth(0.025L, 2.5L, 160.0L, 18.0L), 7.0, 1200.0, -50.0,
    10.0 },
  { "BarWide", "bar:s=0.01,hb=1,xb=500,wb=120" SCENE, barDepth(0.01L, 1.0L, 500.0L, 120.0L), 12.0, 4000.0, 65.0, 20.0 },
};

void PrintTo(const BeachCase& beach, std::ostream* out)
{
  *out << beach.spec << " T=" << beach.period << " theta0=" << beach.theta0;
}

std::vector<double> placesBetween(double far, double near)
{
  constexpr int count = 30;
  std::vector<double> places;
  for (int i = 1; i <= count; ++i)
  {
    places.push_back(far * std::pow(near / far, static_cast<double>(i) / count));
  }
  return places;
}

class StraightContours : public testing::TestWithParam<BeachCase>
{
};

}

TEST_P(StraightContours, followSnell)
{
  const BeachCase& beach = GetParam();
  const auto seafloor = makeBuiltinSeafloor(beach.spec);
  const RayMedium medium = mediumOf(*seafloor, beach.period, 0.01);
  const double theta0 = radians(beach.theta0);
  const StraightRay exact(beach.depth, medium.angularFrequency, beach.x0, theta0);

  // Parallel rays, a unit apart across: the left of them is -y.
  const RayStart start =
    startHeading(medium, { beach.x0, 0.0 }, swellray::Pi - theta0, { 0.0, -1.0 / std::cos(theta0) });
  HamiltonianRay ray(medium, start, Tolerance);
  RayErrors errors;
  RayPoint point;
  for (const double x : placesBetween(beach.x0, beach.nearest))
  {
    const Place place = exact.at(x);
    ASSERT_TRUE(ray.advance(FrontMeasure::Length, place.length, point)) << "x = " << x;
    errors.add(point, place);
  }
  EXPECT_LT(errors.position, PositionTolerance) << errors;
  EXPECT_LT(errors.theta, RelativeTolerance) << errors;
  EXPECT_LT(errors.phase, RelativeTolerance) << errors;
  EXPECT_LT(errors.time, RelativeTolerance) << errors;
  EXPECT_LT(errors.width, WidthTolerance) << errors;
  EXPECT_EQ(errors.caustics, 0) << errors;
  EXPECT_LT(ray.dispersionError(), RelativeTolerance);
}

TEST_P(StraightContours, widenAFan)
{
  const BeachCase& beach = GetParam();
  const auto seafloor = makeBuiltinSeafloor(beach.spec);
  const RayMedium medium = mediumOf(*seafloor, beach.period, 0.01);
  const double theta0 = radians(beach.theta0);
  const StraightRay exact(beach.depth, medium.angularFrequency, beach.x0, theta0);

  RayStart start;
  start.position = { beach.x0, 0.0 };
  start.wavenumber = wavenumberAt(medium, start.position, swellray::Pi - theta0);
  // All start here, lambda is the heading.
  start.dWavenumber = { -start.wavenumber.y, start.wavenumber.x };
  HamiltonianRay ray(medium, start, Tolerance);
  RayPoint point;
  for (const double x : placesBetween(beach.x0, beach.nearest))
  {
    ASSERT_TRUE(ray.advance(FrontMeasure::Length, exact.at(x).length, point)) << "x = " << x;
    const double width = exact.fanWidth(x);
    EXPECT_NEAR(point.tubeWidth / width, 1.0, WidthTolerance) << "x = " << x;
    EXPECT_EQ(point.caustics, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(HamiltonianRay, StraightContours, testing::ValuesIn(Cases),
  [](const testing::TestParamInfo<BeachCase>& beach) { return beach.param.name; });

TEST(HamiltonianRay, turnsBackToTheShoreWhenTrapped)
{
  for (const TrappedRay& c : { TrappedRay{ 0.02, 10.0, 100.0, 50.0 }, TrappedRay{ 0.01, 60.0, 300.0, 30.0 },
         TrappedRay{ 0.05, 8.0, 60.0, 70.0 }, TrappedRay{ 0.015, 20.0, 150.0, 40.0 } })
  {
    const auto seafloor =
      makeBuiltinSeafloor("plane:s=" + std::to_string(c.slope) + ",x0=-1000,x1=20000,y0=-50000,y1=50000");
    const RayMedium medium = mediumOf(*seafloor, c.period, 0.01);
    const double theta0 = radians(c.theta0);
    HamiltonianRay ray(medium, startHeading(medium, { c.x0, 0.0 }, theta0, { 0.0, 1.0 / std::cos(theta0) }), Tolerance);
    RayErrors errors;
    RayPoint point;
    const double step = 0.02 * (swellray::Pi - 2.0 * theta0);
    for (int i = 1; i <= 50; ++i)
    {
      // No place is the turning point itself, where the width has no sign.
      const Place place = c.at(theta0 + (i < 50 ? i + 0.37 : i) * step);
      ASSERT_TRUE(ray.advance(FrontMeasure::Length, place.length, point));
      errors.add(point, place);
    }
    EXPECT_LT(errors.position, PositionTolerance) << errors;
    EXPECT_LT(errors.theta, RelativeTolerance) << errors;
    EXPECT_LT(errors.phase, RelativeTolerance) << errors;
    EXPECT_LT(errors.time, RelativeTolerance) << errors;
    EXPECT_LT(errors.width, WidthTolerance) << errors;
    EXPECT_EQ(errors.caustics, 0) << errors;
    // It comes back at the angle at which it left.
    EXPECT_NEAR(point.position.x, c.x0, PositionTolerance);
  }
}
