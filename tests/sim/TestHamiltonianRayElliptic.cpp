// Rays over elliptic shoals on a slope, with kinks at their rims, at the toe of the slope and at its end, against Munk
// and Arthur's equation.
#include "EllipticShoal.h"
#include "RayComparison.h"

#include "sim/BuiltinSeafloor.h"

#include <gtest/gtest.h>

#include <vector>

using namespace swellray;
using namespace swellray::reference;

namespace
{

constexpr double Tolerance = 1e-12;

// The scenes are some 20 m long. Steps of 5 mm leave the reference an error of order 4 below 1e-10.
constexpr double ReferenceStep = 5e-3;
constexpr double PositionTolerance = 1e-9; // m
constexpr double RelativeTolerance = 1e-9;
// Behind the shoal's focus a ray tube magnifies the errors of both some hundredfold.
constexpr double WidthTolerance = 2e-8;

struct EllipticCase
{
  const char* spec;
  EllipticShoal shoal;
  double period;
  double x0;
  double end; // x of the last place
};

const EllipticCase Cases[] = {
  { "berkhoff", { 0.45, 0.02, 5.82, 0.07, 20.0, 0.5, 0.3, 3.75, 5.0 }, 1.0, -10.0, 11.0 },
  { "berkhoff:rotation=-10,toe=7,slope=0.025,h0=0.5,min-depth=0.1,x0=-12,x1=12",
    { 0.5, 0.025, 7.0, 0.1, -10.0, 0.5, 0.3, 3.75, 5.0 }, 1.3, -11.5, 11.0 },
  { "vincent-briggs", { 0.4572, 0.0, 0.0, 0.0, 0.0, 0.762, 0.4572, 3.81, 4.95 }, 1.3, -6.0, 15.0 },
};

}

TEST(HamiltonianRayElliptic, crossesRimsToesAndEndsOfSlopes)
{
  for (const EllipticCase& c : Cases)
  {
    const auto seafloor = makeBuiltinSeafloor(c.spec);
    const RayMedium medium = mediumOf(*seafloor, c.period, 0.01);
    const Formula formula = c.shoal.formula();
    int caustics = 0;
    RayErrors errors;
    for (const double y0 : { -4.7, -2.3, -1.1, -0.35, 0.15, 0.8, 1.7, 2.9, 4.3, 6.0 })
    {
      Place begin;
      begin.x = c.x0;
      begin.y = y0;
      HamiltonianRay ray(medium, startHeading(medium, { c.x0, y0 }, 0.0, { 0.0, 1.0 }), Tolerance);
      // In the scene as long as it goes nearly straight.
      std::vector<double> lengths;
      for (int i = 1; i <= 30; ++i)
      {
        lengths.push_back((c.end - c.x0) * i / 30.0);
      }
      RayPoint point;
      for (const Place& place : traceMunkArthur(formula, medium.angularFrequency, begin, lengths, ReferenceStep))
      {
        ASSERT_TRUE(ray.advance(FrontMeasure::Length, place.length, point)) << c.spec << " y0 = " << y0;
        errors.add(point, place);
      }
      caustics += point.caustics;
    }
    EXPECT_LT(errors.position, PositionTolerance) << c.spec << ": " << errors;
    EXPECT_LT(errors.theta, RelativeTolerance) << c.spec << ": " << errors;
    EXPECT_LT(errors.phase, RelativeTolerance) << c.spec << ": " << errors;
    EXPECT_LT(errors.time, RelativeTolerance) << c.spec << ": " << errors;
    EXPECT_LT(errors.width, WidthTolerance) << c.spec << ": " << errors;
    EXPECT_EQ(errors.caustics, 0) << c.spec << ": " << errors;
    EXPECT_GT(caustics, 2) << c.spec;
  }
}

TEST(HamiltonianRayElliptic, stretchesTheTubeAsItsNeighboursSay)
{
  // A check of the jump at kinks that takes no formula for it: central differences of traced rays.
  constexpr double apart = 1e-4;     // m
  constexpr double tolerance = 2e-5; // third derivatives of some 1e2/m2 times apart^2, relative to |q| up to 10
  const auto seafloor = makeBuiltinSeafloor("berkhoff");
  const RayMedium medium = mediumOf(*seafloor, 1.0, 0.01);
  for (const double y0 : { -3.1, -1.37, 0.42, 2.03, 3.6 })
  {
    for (const double length : { 6.0, 9.0, 13.0, 17.0, 20.0 })
    {
      std::vector<RayPoint> points;
      for (const double y : { y0 - apart, y0, y0 + apart })
      {
        HamiltonianRay ray(medium, startHeading(medium, { -10.0, y }, 0.0, { 0.0, 1.0 }), Tolerance);
        points.emplace_back();
        ASSERT_TRUE(ray.advance(FrontMeasure::Length, length, points.back()));
      }
      const glm::dvec2 difference = (points[2].position - points[0].position) / (2.0 * apart);
      const glm::dvec2 t = points[1].rayDirection;
      const double width = t.x * difference.y - t.y * difference.x;
      EXPECT_NEAR(points[1].tubeWidth, width, tolerance * std::max(1.0, std::abs(width)))
        << "y0 = " << y0 << " s = " << length;
    }
  }
}
