// The papers' own scheme, of first order, beside the integrator of the ray equations.
#include "RayComparison.h"

#include "sim/BuiltinSeafloor.h"
#include "sim/SnellRay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

using namespace swellray;
using namespace swellray::reference;

namespace
{

struct PlaneCase
{
  double slope;
  double period;
  double theta0; // degrees
  double x0;
  double end; // x of the place compared
};

const PlaneCase Cases[] = { { 0.02, 10.0, 45.0, 2000.0, 200.0 }, { 0.05, 7.0, -60.0, 700.0, 60.0 },
  { 0.01, 12.0, 70.0, 6000.0, 900.0 } };

}

TEST(SnellRay, isOfFirstOrderInTheStepOnAPlaneBeach)
{
  for (const PlaneCase& c : Cases)
  {
    const auto seafloor =
      makeBuiltinSeafloor("plane:s=" + std::to_string(c.slope) + ",x0=-100,x1=12000,y0=-40000,y1=40000");
    const RayMedium medium = mediumOf(*seafloor, c.period, 0.05);
    const double theta0 = radians(c.theta0);
    const StraightRay exact([&](Real x) { return c.slope * x; }, medium.angularFrequency, c.x0, theta0);
    const Place place = exact.at(c.end);
    const RayStart start = startHeading(medium, { c.x0, 0.0 }, swellray::Pi - theta0, { 0.0, -1.0 / std::cos(theta0) });

    HamiltonianRay ode(medium, start, 1e-8);
    RayPoint point;
    ASSERT_TRUE(ode.advance(FrontMeasure::Length, place.length, point));
    const double odeError = std::hypot(point.position.x - place.x, point.position.y - place.y);
    std::cout << "ode: " << odeError << " m, " << ode.evaluations() << " evaluations\n";

    std::vector<double> positions;
    std::vector<double> phases;
    for (const double step : { 16.0, 8.0, 4.0, 2.0 })
    {
      SnellRay ray(medium, start, step);
      ASSERT_TRUE(ray.advance(FrontMeasure::Length, place.length, point));
      positions.push_back(std::hypot(point.position.x - place.x, point.position.y - place.y));
      phases.push_back(std::abs(point.phase - place.phase));
      std::cout << "snell, step " << step << " m: " << positions.back() << " m, " << phases.back() << " rad, "
                << ray.evaluations() << " evaluations\n";
      EXPECT_TRUE(std::isnan(point.tubeWidth));
    }
    for (std::size_t i = 1; i < positions.size(); ++i)
    {
      const double order = std::log2(positions[i - 1] / positions[i]);
      EXPECT_GT(order, 0.8) << "slope " << c.slope;
      EXPECT_LT(order, 1.3) << "slope " << c.slope;
      const double phaseOrder = std::log2(phases[i - 1] / phases[i]);
      EXPECT_GT(phaseOrder, 0.8) << "slope " << c.slope;
      EXPECT_LT(phaseOrder, 1.3) << "slope " << c.slope;
    }
    // Four digits and more lie between the two at a comparable cost.
    EXPECT_LT(odeError, 1e-4 * positions.back()) << "slope " << c.slope;
  }
}

TEST(SnellRay, isOfFirstOrderPastAShoal)
{
  // Past the top of a shoal every ray runs along a contour for a while, where Snell's law alone would catch it.
  const auto seafloor = makeBuiltinSeafloor("shoal:kind=gauss,h0=20,a=14,sg=300,x0=-1900,x1=1900,y0=-1900,y1=1900");
  const RayMedium medium = mediumOf(*seafloor, 10.0, 0.05);
  std::vector<double> errors;
  for (const double step : { 16.0, 8.0, 4.0, 2.0 })
  {
    double sum = 0.0;
    for (int i = -60; i <= 60; ++i)
    {
      const RayStart start = startHeading(medium, { -1800.0, 10.0 * i + 1.7 }, 0.0, { 0.0, 1.0 });
      HamiltonianRay exact(medium, start, 1e-10);
      SnellRay ray(medium, start, step);
      RayPoint p;
      RayPoint q;
      ASSERT_TRUE(exact.advance(FrontMeasure::Length, 2800.0, p));
      ASSERT_TRUE(ray.advance(FrontMeasure::Length, 2800.0, q));
      const double error = glm::length(p.position - q.position);
      EXPECT_LT(error, 10.0 * step) << "y0 = " << 10.0 * i + 1.7; // none is caught
      sum += error * error;
    }
    errors.push_back(std::sqrt(sum / 121.0));
    std::cout << "snell, step " << step << " m: " << errors.back() << " m rms\n";
  }
  const double order = std::log2(errors.front() / errors.back()) / 3.0;
  EXPECT_GT(order, 0.8);
  EXPECT_LT(order, 1.3);
}

TEST(SnellRay, goesStraightOverAFlatBed)
{
  const auto seafloor = makeBuiltinSeafloor("shoal:a=0,h0=12");
  const RayMedium medium = mediumOf(*seafloor, 8.0, 0.05);
  const double heading = radians(33.0);
  SnellRay ray(medium, startHeading(medium, { -1000.0, -1000.0 }, heading, { 0.0, 1.0 }), 7.0);
  RayPoint point;
  ASSERT_TRUE(ray.advance(FrontMeasure::Length, 1234.5, point));
  // Some hundred additions.
  constexpr double rounding = 1e-9;
  EXPECT_NEAR(point.position.x, -1000.0 + 1234.5 * std::cos(heading), rounding);
  EXPECT_NEAR(point.position.y, -1000.0 + 1234.5 * std::sin(heading), rounding);
  EXPECT_NEAR(point.phase, 1234.5 * static_cast<double>(wavenumber(medium.angularFrequency, 12.0L)), rounding);
  EXPECT_NEAR(point.travelTime, 1234.5 / static_cast<double>(groupSpeed(medium.angularFrequency, 12.0L)), rounding);
}

TEST(SnellRay, comesToTheSamePlacesByAnyMeasure)
{
  const auto seafloor = makeBuiltinSeafloor("shoal:kind=gauss");
  const RayMedium medium = mediumOf(*seafloor, 10.0, 0.05);
  const RayStart start = startHeading(medium, { -1700.0, 120.0 }, 0.0, { 0.0, 1.0 });
  SnellRay byLength(medium, start, 9.0);
  SnellRay byPhase(medium, start, 9.0);
  SnellRay byTime(medium, start, 9.0);
  for (int i = 0; i < 60; ++i)
  {
    RayPoint p;
    RayPoint q;
    RayPoint r;
    ASSERT_TRUE(byLength.advance(FrontMeasure::Length, 50.3 * i, p));
    ASSERT_TRUE(byPhase.advance(FrontMeasure::Phase, p.phase, q));
    ASSERT_TRUE(byTime.advance(FrontMeasure::Time, p.travelTime, r));
    EXPECT_LT(glm::length(p.position - q.position), 1e-9);
    EXPECT_LT(glm::length(p.position - r.position), 1e-9);
  }
}

TEST(SnellRay, turnsBackWhenTrapped)
{
  const auto seafloor = makeBuiltinSeafloor("plane:s=0.02,x0=-1000,x1=20000,y0=-50000,y1=50000");
  const RayMedium medium = mediumOf(*seafloor, 10.0, 0.5);
  SnellRay ray(medium, startHeading(medium, { 100.0, 0.0 }, radians(50.0), { 0.0, 1.0 }), 0.5);
  RayPoint point;
  EXPECT_FALSE(ray.advance(FrontMeasure::Length, 1e6, point));
  EXPECT_EQ(ray.endReason(), EndReason::Aground);
  EXPECT_NEAR(point.depth, 0.5, 1e-6);
}

TEST(SnellRay, saysWhatEndedIt)
{
  const auto shoal = makeBuiltinSeafloor("shoal:kind=gauss,x0=-1900,x1=1900,y0=-1900,y1=1900");
  const RayMedium medium = mediumOf(*shoal, 10.0, 0.05);
  RayPoint point;
  SnellRay leaving(medium, startHeading(medium, { -1800.0, 100.0 }, 0.0, { 0.0, 1.0 }), 20.0);
  EXPECT_FALSE(leaving.advance(FrontMeasure::Phase, 1e6, point));
  EXPECT_EQ(leaving.endReason(), EndReason::LeftScene);
  EXPECT_NEAR(point.position.x, 1900.0, 1e-9);
  SnellRay capped(medium, startHeading(medium, { -1800.0, 100.0 }, 0.0, { 0.0, 1.0 }), 20.0, 5);
  EXPECT_FALSE(capped.advance(FrontMeasure::Phase, 1e6, point));
  EXPECT_EQ(capped.endReason(), EndReason::StepCap);
  EXPECT_NEAR(capped.length(), 100.0, 1e-9);
  const auto plane = makeBuiltinSeafloor("plane");
  const RayMedium beach = mediumOf(*plane, 10.0, 0.5);
  RayStart ashore;
  ashore.position = { -20.0, 0.0 };
  ashore.wavenumber = { -0.1, 0.0 };
  SnellRay dry(beach, ashore, 5.0);
  EXPECT_FALSE(dry.advance(FrontMeasure::Length, 100.0, point));
  EXPECT_EQ(dry.endReason(), EndReason::Aground);
}
