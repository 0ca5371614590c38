// The integrator itself: error against tolerance, dense output, the measures of fronts, and what ends a ray.
#include "RayComparison.h"

#include "sim/BuiltinSeafloor.h"
#include "sim/SplineSeafloor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

using namespace swellray;
using namespace swellray::reference;

namespace
{

constexpr const char* Shoal = "shoal:kind=gauss,h0=20,a=14,sg=300,x0=-1900,x1=1900,y0=-1900,y1=1900";
constexpr double Period = 10.0;
constexpr double Aground = 0.1;

// At this tolerance a ray stands for the exact one: see the comparisons with closed forms.
constexpr double Fine = 1e-12;

RayStart launched(const RayMedium& medium, double b)
{
  return startHeading(medium, { -1800.0, b }, 0.0, { 0.0, 1.0 });
}

RayPoint pointAt(HamiltonianRay& ray, FrontMeasure measure, double target)
{
  RayPoint point;
  EXPECT_TRUE(ray.advance(measure, target, point));
  return point;
}

void expectSame(const RayPoint& a, const RayPoint& b, double tolerance)
{
  EXPECT_LT(glm::length(a.position - b.position), tolerance * 100.0); // a wavelength
  EXPECT_LT(glm::length(a.wavenumber - b.wavenumber), tolerance * glm::length(b.wavenumber));
  EXPECT_NEAR(a.phase, b.phase, tolerance * 2.0 * swellray::Pi);
  EXPECT_NEAR(a.travelTime, b.travelTime, tolerance * Period);
  EXPECT_NEAR(a.tubeWidth, b.tubeWidth, tolerance * 10.0 * std::max(1.0, std::abs(b.tubeWidth)));
  EXPECT_EQ(a.caustics, b.caustics);
}

}

TEST(HamiltonianRayIntegration, errsInProportionToTheTolerance)
{
  // Steps go as the fifth root of the tolerance and the error as their fifth power, a little better where loose
  // tolerances are bound by the shoal's size.
  const auto seafloor = makeBuiltinSeafloor(Shoal);
  const RayMedium medium = mediumOf(*seafloor, Period, Aground);
  const std::vector<double> tolerances{ 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10 };
  std::vector<double> errors;
  std::vector<std::size_t> steps;
  for (const double tolerance : tolerances)
  {
    double error = 0.0;
    std::size_t count = 0;
    for (const double b : { 40.0, 110.0, -170.0, 260.0, 420.0 })
    {
      HamiltonianRay coarse(medium, launched(medium, b), tolerance);
      HamiltonianRay fine(medium, launched(medium, b), Fine);
      const RayPoint p = pointAt(coarse, FrontMeasure::Length, 3000.0);
      const RayPoint q = pointAt(fine, FrontMeasure::Length, 3000.0);
      error = std::max(error, glm::length(p.position - q.position));
      count += coarse.steps();
    }
    // Some tens of steps, each good to the tolerance in wavelengths of 100 m: ten such errors at most.
    EXPECT_LT(error, 1e3 * tolerance) << tolerance;
    errors.push_back(error);
    steps.push_back(count);
  }
  const double power = std::log10(errors.front() / errors.back()) / 5.0;
  EXPECT_GT(power, 0.75);
  EXPECT_LT(power, 1.25);
  // Of order 5: ten times the accuracy for 10^(1/5) = 1.6 times the steps, once they are no longer bound by the shoal.
  EXPECT_NEAR(std::pow(static_cast<double>(steps[5]) / steps[3], 0.5), std::pow(10.0, 0.2), 0.25);
}

TEST(HamiltonianRayIntegration, isAsAccurateBetweenStepsAsOnThem)
{
  // Fronts are read off the dense output, of order 4: a little behind the steps themselves.
  constexpr double tolerance = 1e-8;
  constexpr double dense = 20.0 * tolerance;
  const auto seafloor = makeBuiltinSeafloor(Shoal);
  const RayMedium medium = mediumOf(*seafloor, Period, Aground);
  for (const double b : { 40.0, 150.0, 333.0 })
  {
    HamiltonianRay ray(medium, launched(medium, b), tolerance);
    HamiltonianRay fine(medium, launched(medium, b), Fine);
    const double last = 200.0;
    for (double phase = 0.0; phase <= last; phase += 0.1)
    {
      const RayPoint p = pointAt(ray, FrontMeasure::Phase, phase);
      ASSERT_NEAR(p.phase, phase, 1e-12 * (1.0 + phase));
      expectSame(p, pointAt(fine, FrontMeasure::Phase, phase), dense);
      // The wavenumber stays on the dispersion relation.
      const double k = static_cast<double>(wavenumber(medium.angularFrequency, p.depth));
      EXPECT_NEAR(glm::length(p.wavenumber) / k, 1.0, dense);
    }
    // Reading costs no step.
    HamiltonianRay straight(medium, launched(medium, b), tolerance);
    pointAt(straight, FrontMeasure::Phase, last);
    EXPECT_EQ(ray.evaluations(), straight.evaluations());
    EXPECT_EQ(ray.steps(), straight.steps());
  }
}

TEST(HamiltonianRayIntegration, comesToTheSamePlacesByAnyMeasure)
{
  const auto seafloor = makeBuiltinSeafloor("berkhoff");
  const RayMedium medium = mediumOf(*seafloor, 1.0, 0.01);
  const RayStart start = startHeading(medium, { -10.0, -1.3 }, 0.0, { 0.0, 1.0 });
  HamiltonianRay byLength(medium, start, Fine);
  HamiltonianRay byPhase(medium, start, Fine);
  HamiltonianRay byTime(medium, start, Fine);
  for (int i = 0; i <= 57; ++i)
  {
    const RayPoint p = pointAt(byLength, FrontMeasure::Length, 0.35 * i);
    const RayPoint q = pointAt(byPhase, FrontMeasure::Phase, p.phase);
    const RayPoint r = pointAt(byTime, FrontMeasure::Time, p.travelTime);
    // Rounding of the measure, magnified by the tube's rate of up to some 10/m.
    constexpr double rounding = 1e-11;
    EXPECT_LT(glm::length(q.position - p.position), rounding);
    EXPECT_LT(glm::length(r.position - p.position), rounding);
    EXPECT_NEAR(q.tubeWidth, p.tubeWidth, rounding * std::max(1.0, std::abs(p.tubeWidth)));
    EXPECT_NEAR(r.tubeWidth, p.tubeWidth, rounding * std::max(1.0, std::abs(p.tubeWidth)));
    EXPECT_NEAR(byPhase.length(), 0.35 * i, rounding);
    EXPECT_NEAR(r.travelTime, p.travelTime, rounding);
    EXPECT_EQ(q.caustics, p.caustics);
    EXPECT_EQ(r.caustics, p.caustics);
  }
}

TEST(HamiltonianRayIntegration, goesOnFromWhereAnotherStood)
{
  const auto seafloor = makeBuiltinSeafloor(Shoal);
  const RayMedium medium = mediumOf(*seafloor, Period, Aground);
  RayStart start = launched(medium, 75.0);
  start.phase = 3.0;
  start.travelTime = 50.0;
  start.length = 700.0;
  start.caustics = 2;
  HamiltonianRay ray(medium, start, Fine);
  const RayPoint begin = pointAt(ray, FrontMeasure::Length, 700.0);
  EXPECT_EQ(begin.position, start.position);
  EXPECT_DOUBLE_EQ(begin.phase, 3.0);
  EXPECT_DOUBLE_EQ(begin.travelTime, 50.0);
  EXPECT_EQ(begin.caustics, 2);
  EXPECT_DOUBLE_EQ(begin.tubeWidth, 1.0);
  HamiltonianRay plain(medium, launched(medium, 75.0), Fine);
  const RayPoint p = pointAt(ray, FrontMeasure::Length, 700.0 + 2600.0);
  const RayPoint q = pointAt(plain, FrontMeasure::Length, 2600.0);
  EXPECT_LT(glm::length(p.position - q.position), 1e-8);
  EXPECT_NEAR(p.phase - q.phase, 3.0, 1e-9);
  EXPECT_NEAR(p.travelTime - q.travelTime, 50.0, 1e-9);
  EXPECT_EQ(p.caustics, q.caustics + 2);
  EXPECT_EQ(q.caustics, 1);
}

TEST(HamiltonianRayIntegration, runsAgroundWhereTheDepthSays)
{
  const auto seafloor = makeBuiltinSeafloor("plane:s=0.02,x0=-100,x1=2400,y0=-2000,y1=2000");
  const RayMedium medium = mediumOf(*seafloor, Period, 0.5);
  HamiltonianRay ray(medium, startHeading(medium, { 2000.0, 0.0 }, radians(150.0), { 0.0, -1.0 }), Fine);
  RayPoint point;
  EXPECT_FALSE(ray.advance(FrontMeasure::Length, 1e9, point));
  EXPECT_TRUE(ray.ended());
  EXPECT_EQ(ray.endReason(), EndReason::Aground);
  EXPECT_NEAR(point.depth, 0.5, 1e-9);
  EXPECT_NEAR(point.position.x, 25.0, 1e-7);
  const StraightRay exact([](Real x) { return 0.02L * x; }, medium.angularFrequency, 2000.0, radians(30.0));
  EXPECT_NEAR(point.position.y, exact.at(25.0).y, 1e-7);
  EXPECT_NEAR(point.phase, exact.at(25.0).phase, 1e-8);
  // Once ended it stays so, and describes the same place.
  RayPoint again;
  EXPECT_FALSE(ray.advance(FrontMeasure::Length, 2e9, again));
  EXPECT_EQ(again.position, point.position);
}

TEST(HamiltonianRayIntegration, leavesTheSceneAtItsEdge)
{
  const auto seafloor = makeBuiltinSeafloor(Shoal);
  const RayMedium medium = mediumOf(*seafloor, Period, Aground);
  for (const double b : { -900.0, 0.0, 120.0 })
  {
    HamiltonianRay ray(medium, launched(medium, b), 1e-8);
    RayPoint point;
    EXPECT_FALSE(ray.advance(FrontMeasure::Phase, 1e9, point));
    EXPECT_EQ(ray.endReason(), EndReason::LeftScene);
    EXPECT_NEAR(point.position.x, 1900.0, 1e-9);
  }
}

TEST(HamiltonianRayIntegration, endsInAHole)
{
  const auto plain = makeBuiltinSeafloor("plane:s=0.02,x0=0,x1=2000,y0=0,y1=1000");
  ElevationGrid grid;
  grid.columns = 101;
  grid.rows = 51;
  grid.spacing = { 20.0, 20.0 };
  grid.elevation.resize(grid.columns * grid.rows);
  for (std::size_t j = 0; j < grid.rows; ++j)
  {
    for (std::size_t i = 0; i < grid.columns; ++i)
    {
      grid.at(i, j) = plain->elevation(grid.node(i, j));
    }
  }
  for (std::size_t j = 20; j < 30; ++j)
  {
    for (std::size_t i = 40; i < 60; ++i)
    {
      grid.at(i, j) = std::numeric_limits<double>::quiet_NaN();
    }
  }
  const SplineSeafloor seafloor(grid);
  const RayMedium medium = mediumOf(seafloor, Period, Aground);
  HamiltonianRay ray(medium, startHeading(medium, { 1900.0, 490.0 }, swellray::Pi, { 0.0, -1.0 }), 1e-8);
  RayPoint point;
  EXPECT_FALSE(ray.advance(FrontMeasure::Length, 1e9, point));
  EXPECT_EQ(ray.endReason(), EndReason::EnteredHole);
  EXPECT_NEAR(point.position.x, 60.0 * 20.0, 1e-6); // the cells that touch the last node without data
  // Started in the hole it ends at once, beside it it passes by.
  HamiltonianRay inside(medium, startHeading(medium, { 1000.0, 490.0 }, swellray::Pi, { 0.0, -1.0 }), 1e-8);
  EXPECT_TRUE(inside.ended());
  EXPECT_EQ(inside.endReason(), EndReason::EnteredHole);
  HamiltonianRay aside(medium, startHeading(medium, { 1900.0, 190.0 }, swellray::Pi, { 0.0, -1.0 }), 1e-8);
  EXPECT_FALSE(aside.advance(FrontMeasure::Length, 1e9, point));
  EXPECT_EQ(aside.endReason(), EndReason::Aground);
}

TEST(HamiltonianRayIntegration, endsAtOnceOnLand)
{
  const auto seafloor = makeBuiltinSeafloor("plane:s=0.02,x0=-100,x1=2400,y0=-2000,y1=2000");
  const RayMedium medium = mediumOf(*seafloor, Period, 0.5);
  for (const double x : { -50.0, 0.0, 10.0, 24.9 })
  {
    RayStart start;
    start.position = { x, 0.0 };
    start.wavenumber = { -0.1, 0.0 };
    HamiltonianRay ray(medium, start, 1e-8);
    EXPECT_TRUE(ray.ended());
    EXPECT_EQ(ray.endReason(), EndReason::Aground);
    RayPoint point;
    EXPECT_FALSE(ray.advance(FrontMeasure::Length, 10.0, point));
    EXPECT_EQ(point.position, start.position);
  }
}

TEST(HamiltonianRayIntegration, endsAtTheCapOnSteps)
{
  const auto seafloor = makeBuiltinSeafloor(Shoal);
  const RayMedium medium = mediumOf(*seafloor, Period, Aground);
  HamiltonianRay ray(medium, launched(medium, 100.0), 1e-10, 7);
  RayPoint point;
  EXPECT_FALSE(ray.advance(FrontMeasure::Length, 1e9, point));
  EXPECT_TRUE(ray.ended());
  EXPECT_EQ(ray.endReason(), EndReason::StepCap);
  EXPECT_EQ(ray.steps(), 7u);
}

TEST(HamiltonianRayIntegration, needsFewStepsWhereTheWaveFeelsNoBottom)
{
  // 40 km of deep water before a beach: steps grow to many grid cells there.
  ElevationGrid grid;
  grid.columns = 2001;
  grid.rows = 41;
  grid.spacing = { 20.0, 20.0 };
  grid.elevation.assign(grid.columns * grid.rows, -500.0);
  const SplineSeafloor seafloor(grid);
  const RayMedium medium = mediumOf(seafloor, 6.0, Aground);
  HamiltonianRay ray(medium, startHeading(medium, { 10.0, 400.0 }, 0.0, { 0.0, 1.0 }), 1e-8);
  const RayPoint point = pointAt(ray, FrontMeasure::Length, 39000.0);
  EXPECT_LT(ray.steps(), 20u);
  EXPECT_NEAR(point.position.x, 39010.0, 1e-6);
  EXPECT_DOUBLE_EQ(point.tubeWidth, 1.0);
}
