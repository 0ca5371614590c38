// Rays over seafloors designed for their curves: k(x, y) is given, h = atanh(k_inf/k)/k, and the ray is a circle, a
// cycloid, a parabola, a logarithmic spiral or an ellipse at any period.
#include "DesignedRays.h"
#include "RayComparison.h"

#include <gtest/gtest.h>

using namespace swellray;
using namespace swellray::reference;

namespace
{

constexpr double Tolerance = 1e-12;

// Asked for: 1e-6 m a km, 1e-6 in all else. Some hundred steps, each right to 1e-12 wavelengths of 100 m.
constexpr double PositionTolerance = 3e-9;
constexpr double RelativeTolerance = 2e-10;
// The tube is held to fewer digits than the ray.
constexpr double WidthTolerance = 1e-9;

// The first of each is that of the tables, others are chosen freely.
const Design Designs[] = { { 10.0, 12.0, 1000.0, 45.0 }, { 7.0, 8.0, 400.0, 62.0 }, { 14.0, 30.0, 2500.0, 25.0 } };

// k must stay above k_inf up to the turning point: k sin theta0 tanh... holds for these.
const Design Parabolas[] = { { 10.0, 5.0, 428.654868376, 65.0 }, { 8.0, 2.0, 300.0, 50.0 },
  { 15.0, 4.0, 900.0, 35.0 } };

void follow(const DesignedRay& designed)
{
  const FormulaSeafloor bed = designed.seafloor();
  const RayMedium medium = mediumOf(bed, designed.period, 1e-3);
  HamiltonianRay ray(medium, designed.start(medium), Tolerance);
  RayErrors errors;
  RayPoint point;
  for (const Place& place : designed.places)
  {
    ASSERT_TRUE(ray.advance(FrontMeasure::Phase, place.phase, point)) << "at " << place.x << ", " << place.y;
    EXPECT_NEAR(
      ray.length() / std::max(1.0, place.length), place.length / std::max(1.0, place.length), RelativeTolerance);
    errors.add(point, place);
  }
  EXPECT_LT(errors.position, PositionTolerance) << errors;
  EXPECT_LT(errors.theta, RelativeTolerance) << errors;
  EXPECT_LT(errors.phase, RelativeTolerance) << errors;
  EXPECT_LT(errors.time, RelativeTolerance) << errors;
  EXPECT_LT(errors.width, WidthTolerance) << errors;
  EXPECT_EQ(errors.caustics, 0) << errors;
}

}

TEST(HamiltonianRayDesign, isACircleWhereTheWavelengthGrowsAsTheDistance)
{
  for (const Design& d : Designs)
  {
    follow(circleRay(d));
  }
}

TEST(HamiltonianRayDesign, isACycloidWhereTheWavelengthGrowsAsTheRootOfTheDistance)
{
  for (const Design& d : Designs)
  {
    follow(cycloidRay(d));
  }
}

TEST(HamiltonianRayDesign, isASpiralAroundAnIsland)
{
  for (const Design& d : Designs)
  {
    follow(spiralRay(d));
  }
}

TEST(HamiltonianRayDesign, isAParabolaAroundAnIsland)
{
  for (const Design& d : Designs)
  {
    follow(islandParabolaRay(d));
  }
}

TEST(HamiltonianRayDesign, foldsAtTheTurningLineOfParallelParabolas)
{
  for (const Design& d : Parabolas)
  {
    follow(foldParabolaRay(d, Neighbours::Parallel));
  }
}

TEST(HamiltonianRayDesign, touchesTheEnvelopeOfAFanOfParabolas)
{
  for (const Design& d : Parabolas)
  {
    follow(foldParabolaRay(d, Neighbours::Fan));
  }
}

TEST(HamiltonianRayDesign, meetsAllOthersAtTheFocusOfALuneburgLens)
{
  for (const Design& d : { Design{ 10.0, 15.0, 500.0, 0.0 }, Design{ 6.0, 6.0, 200.0, 0.0 } })
  {
    for (const double share : { -0.93, -0.5, -0.1, 0.0, 0.3, 0.65, 0.9 })
    {
      const DesignedRay ray = luneburgRay(d, share);
      follow(ray);
      // The first place past the focus, a tenth of R on, tells the phase in the focus: the same for all.
      const Place& past = *(ray.places.end() - 2);
      const double k0 = static_cast<double>(wavenumber(2.0 * swellray::Pi / d.period, d.depth));
      const double focus = k0 * d.length * (1.0 + 0.5 * swellray::Pi);
      EXPECT_NEAR(past.phase - 0.1 * k0 * d.length, focus, RelativeTolerance * focus);
    }
  }
}

TEST(HamiltonianRayDesign, approachesTheShallowCycloidAsTheSquareOfTheFrequency)
{
  // Over a plane beach in shallow water the ray is a cycloid; what full dispersion adds is of order omega^2 h/g.
  constexpr double slope = 0.02;
  constexpr double x0 = 1000.0;
  constexpr double theta0 = radians(40.0);
  constexpr double theta = radians(12.0);
  Formula formula;
  formula.depth = [](const Jet& x, const Jet&, unsigned) { return slope * x; };
  const FormulaSeafloor bed(formula, { { 0.0, -2000.0 }, { 1100.0, 2000.0 } }, 100.0);
  const double D = x0 / (std::sin(theta0) * std::sin(theta0));
  const double length = 2.0 * D * (std::cos(theta) - std::cos(theta0));
  const glm::dvec2 exact(D * std::sin(theta) * std::sin(theta),
    0.5 * D * (2.0 * theta0 - std::sin(2.0 * theta0) - 2.0 * theta + std::sin(2.0 * theta)));
  double before = 0.0;
  for (const double period : { 400.0, 800.0, 1600.0 })
  {
    const RayMedium medium = mediumOf(bed, period, 1e-3);
    HamiltonianRay ray(
      medium, startHeading(medium, { x0, 0.0 }, swellray::Pi - theta0, { 0.0, -1.0 / std::cos(theta0) }), Tolerance);
    RayPoint point;
    ASSERT_TRUE(ray.advance(FrontMeasure::Length, length, point));
    const double error = std::hypot(point.position.x - exact.x, point.position.y - exact.y);
    if (before > 0.0)
    {
      // The next term is omega^2 h/g smaller: 5e-4.
      EXPECT_NEAR(before / error, 4.0, 0.01);
    }
    before = error;
  }
  EXPECT_LT(before / length, 1e-5); // omega^2 h0/(6 g) = 5e-6
}
