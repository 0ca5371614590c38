// Rays over circular shoals and islands: Bouguer's law for the ray, Munk and Arthur's equation for its tube.
#include "CircularForms.h"
#include "RayComparison.h"

#include "sim/BuiltinSeafloor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

using namespace swellray;
using namespace swellray::reference;

namespace
{

constexpr double Tolerance = 1e-12;

// Asked for: 1e-6 m a km, 1e-6 in all else. A ray that passes a shoal's cusp magnifies its errors some tenfold.
constexpr double PositionTolerance = 5e-9;
constexpr double RelativeTolerance = 3e-10;
// The tube is held to fewer digits than the ray.
constexpr double WidthTolerance = 1e-9;
// Steps of the reference a length over which the bed changes: with order 4 its own error is below 1e-10.
constexpr double ReferenceSteps = 400.0;

struct CircularCase
{
  const char* name;
  CircularForm form;
  double period;
  double x0;
  std::vector<double> b;
};

constexpr const char* Scene = ",x0=-9000,x1=9000,y0=-9000,y1=9000";

// The first of each is that of the tables, others are chosen freely.
const CircularCase Cases[] = {
  { "GaussA", gaussianShoal(20.0, 14.0, 300.0), 10.0, -1800.0, { -180.0, 30.0, 150.0, 300.0, 600.0 } },
  { "GaussTall", gaussianShoal(12.0, 10.0, 150.0), 7.0, -1000.0, { -250.0, -40.0, 10.0, 90.0, 170.0 } },
  { "GaussBroad", gaussianShoal(60.0, 50.0, 1000.0), 14.0, -6000.0, { -1500.0, -600.0, 200.0, 2500.0 } },
  { "PolyA", polynomialShoal(15.0, 10.5, 250.0), 8.0, -300.0, { -200.0, 12.5, 100.0, 240.0 } },
  { "PolyWide", polynomialShoal(25.0, 19.0, 900.0), 12.0, -1500.0, { -700.0, -350.0, 60.0, 500.0 } },
  { "ConeA", conicalIsland(0.05, 200.0, 1000.0), 12.0, -1500.0, { 20.0, 400.0, 800.0, 970.0 } },
  { "ConeSteep", conicalIsland(0.12, 60.0, 260.0), 8.0, -500.0, { -240.0, -150.0, 40.0, 255.0 } },
  { "BowlA", parabolicIsland(30.0, 1200.0), 14.0, -1800.0, { 24.0, 400.0, 900.0, 1150.0 } },
  { "BowlSmall", parabolicIsland(12.0, 400.0), 9.0, -700.0, { -390.0, -200.0, 120.0, 330.0 } },
};

void PrintTo(const CircularCase& c, std::ostream* out)
{
  *out << c.form.spec << " T=" << c.period;
}

// Ends before the shore, where all rays of a paraboloid would wind up around the centre.
constexpr double AgroundDepth = 0.3;

class CircularContours : public testing::TestWithParam<CircularCase>
{
};

}

TEST_P(CircularContours, followBouguer)
{
  const CircularCase& c = GetParam();
  const auto seafloor = makeBuiltinSeafloor(c.form.spec + Scene);
  const RayMedium medium = mediumOf(*seafloor, c.period, AgroundDepth);
  for (const double b : c.b)
  {
    const CircularRay exact(c.form.depth, medium.angularFrequency, c.x0, b, c.form.rim);
    const double far = std::hypot(c.x0, b);
    double near = std::max(exact.nearest(), 1.0);
    // A ray that reaches the shore is followed to a little before.
    const bool ashore = c.form.depth(near) < 1.1 * AgroundDepth;
    while (c.form.depth(near) < 1.1 * AgroundDepth)
    {
      near += 1e-3 * far;
    }
    std::vector<Place> places;
    constexpr int count = 12;
    for (int i = 1; i <= count; ++i)
    {
      const double share = 1.0 - static_cast<double>(i) / count;
      places.push_back(exact.at(near + (far - near) * share * share, false));
    }
    for (int i = 1; !ashore && i <= count; ++i)
    {
      const double share = static_cast<double>(i) / count;
      places.push_back(exact.at(near + (far - near) * share * share, true));
    }
    HamiltonianRay ray(medium, startHeading(medium, { c.x0, b }, 0.0, { 0.0, 1.0 }), Tolerance);
    RayErrors errors;
    RayPoint point;
    for (Place& place : places)
    {
      ASSERT_TRUE(ray.advance(FrontMeasure::Length, place.length, point)) << "b = " << b << " s = " << place.length;
      // The tube has a test of its own.
      place.width = point.tubeWidth;
      place.caustics = point.caustics;
      errors.add(point, place);
    }
    EXPECT_LT(errors.position, PositionTolerance) << "b = " << b << ": " << errors;
    EXPECT_LT(errors.theta, RelativeTolerance) << "b = " << b << ": " << errors;
    EXPECT_LT(errors.phase, RelativeTolerance) << "b = " << b << ": " << errors;
    EXPECT_LT(errors.time, RelativeTolerance) << "b = " << b << ": " << errors;
  }
}

TEST_P(CircularContours, widenAsMunkAndArthurSay)
{
  const CircularCase& c = GetParam();
  const auto seafloor = makeBuiltinSeafloor(c.form.spec + Scene);
  const RayMedium medium = mediumOf(*seafloor, c.period, AgroundDepth);
  const Formula formula = c.form.formula();
  int caustics = 0;
  for (const double b : c.b)
  {
    const RayStart begin = startHeading(medium, { c.x0, b }, 0.0, { 0.0, 1.0 });
    HamiltonianRay ray(medium, begin, Tolerance);
    // As far as the ray goes, and no farther than to the other side.
    RayPoint point;
    HamiltonianRay scout(medium, begin, Tolerance);
    scout.advance(FrontMeasure::Length, -2.2 * c.x0, point);
    const double end = scout.ended() ? 0.995 * scout.length() : -2.2 * c.x0;
    std::vector<double> lengths;
    for (int i = 1; i <= 40; ++i)
    {
      lengths.push_back(end * i / 40.0);
    }
    Place start;
    start.x = c.x0;
    start.y = b;
    const std::vector<Place> places =
      traceMunkArthur(formula, medium.angularFrequency, start, lengths, c.form.feature / ReferenceSteps);
    RayErrors errors;
    for (const Place& place : places)
    {
      ASSERT_TRUE(ray.advance(FrontMeasure::Length, place.length, point)) << "b = " << b << " s = " << place.length;
      errors.add(point, place);
    }
    EXPECT_LT(errors.position, PositionTolerance) << "b = " << b << ": " << errors;
    EXPECT_LT(errors.width, WidthTolerance) << "b = " << b << ": " << errors;
    EXPECT_EQ(errors.caustics, 0) << "b = " << b << ": " << errors;
    caustics += point.caustics;
  }
  // Shoals focus, islands spread.
  EXPECT_EQ(caustics > 0, c.form.spec.rfind("shoal", 0) == 0);
}

INSTANTIATE_TEST_SUITE_P(HamiltonianRay, CircularContours, testing::ValuesIn(Cases),
  [](const testing::TestParamInfo<CircularCase>& c) { return c.param.name; });
