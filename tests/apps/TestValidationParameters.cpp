// The problems behind the cases of `swellray validate` for other parameters than those of the cases.
#include "apps/validation/Problems.h"

#include <gtest/gtest.h>

namespace
{

using namespace swellray::validation;
using namespace swellray;

Setting quick()
{
  Setting setting;
  setting.quick = true;
  return setting;
}

void expectPassed(const Outcome& outcome, const std::string& what)
{
  EXPECT_FALSE(outcome.checks.empty()) << what;
  for (const Check& check : outcome.checks)
  {
    EXPECT_TRUE(check.passed()) << what << ": " << check.quantity << " is " << check.value << ", limit " << check.limit;
  }
}

Beach beach(const std::string& spec, const reference::Depth& depth, double period, double x0, double theta0)
{
  Beach b;
  b.spec = spec;
  b.depth = depth;
  b.period = period;
  b.x0 = x0;
  b.theta0 = theta0;
  b.nearest = 4e-3 * x0;
  b.plane = true;
  b.coarsest = 0.05 * x0;
  return b;
}

TEST(ValidationParameters, Dispersion)
{
  expectPassed(runDispersion({ 0.7, 1.3, 3.3, 6.7, 11.0, 17.0, 31.0, 240.0, 1800.0 }, quick()), "other periods");
}

TEST(ValidationParameters, FromDeepWater)
{
  expectPassed(runDeepToDepth({ 0.05, { 6.5, 14.0 }, { 10.0, 33.0, 60.0 } }, quick()), "s = 0.05");
  expectPassed(runDeepToDepth({ 0.008, { 10.0 }, { 0.0, 55.0, 75.0 } }, quick()), "s = 0.008");
}

TEST(ValidationParameters, LongWaves)
{
  // Curves at the design's default period and depth: only their shape is used.
  const auto design = [](double length, double angle)
  {
    reference::Design d;
    d.length = length;
    d.angle = angle;
    return d;
  };
  expectPassed(runShallow({ cycloidRay(design(700.0, 55.0)), 1.0, 9.0, false }, quick()), "cycloid");
  expectPassed(runShallow({ circleRay(design(1300.0, 20.0)), 2.0, 30.0, false }, quick()), "circle");
  expectPassed(runShallow({ islandParabolaRay(design(1500.0, 45.0)), 1.0, 15.0, true }, quick()), "parabola");
  expectPassed(runShallow({ spiralRay(design(1200.0, 40.0)), 2.0, 25.0, true }, quick()), "spiral");
}

TEST(ValidationParameters, FirstBreaking)
{
  expectPassed(runBreaking({ { 7.0, 0.8, 25.0, 0.04, 0.7 }, { 10.0, 2.5, 50.0, 0.015, 0.85 },
                             { 5.0, 0.2, 10.0, 0.12, 0.78 }, { 18.0, 1.0, 65.0, 0.06, 1.1 } },
                 quick()),
    "four waves");
}

TEST(ValidationParameters, PlaneBeaches)
{
  for (const Beach& b : { beach("plane:s=0.013", reference::planeDepth(0.013L), 7.0, 2500.0, 63.0),
         beach("plane:s=0.03", reference::planeDepth(0.03L), 14.0, 4000.0, -35.0),
         beach("plane:s=0.1", reference::planeDepth(0.1L), 5.0, 400.0, 12.0),
         beach("plane:s=0.004", reference::planeDepth(0.004L), 18.0, 9000.0, 50.0) })
  {
    expectPassed(runBeach(b, quick()), b.spec);
  }
}

TEST(ValidationParameters, DeanAndBarredBeaches)
{
  Beach dean = beach("dean:A=0.2", reference::deanDepth(0.2L), 14.0, 5000.0, 55.0);
  dean.plane = false;
  dean.nearestOnGrid = 600.0;
  dean.gridFrom = 80.0;
  dean.coarsest = 100.0;
  expectPassed(runBeach(dean, quick()), dean.spec);
  Beach bar =
    beach("bar:s=0.03,hb=1.5,xb=120,wb=30", reference::barDepth(0.03L, 1.5L, 120.0L, 30.0L), 7.0, 1200.0, -50.0);
  bar.plane = false;
  bar.nearest = bar.nearestOnGrid = 12.0;
  bar.coarsest = 7.5;
  expectPassed(runBeach(bar, quick()), bar.spec);
}

TEST(ValidationParameters, TrappedRays)
{
  expectPassed(runTrapped({ 0.05, 7.0, 40.0, 35.0 }, quick()), "s = 0.05");
  expectPassed(runTrapped({ 0.015, 14.0, 150.0, 60.0 }, quick()), "s = 0.015");
}

TEST(ValidationParameters, ShoalsAndIslands)
{
  const auto run = [](const reference::CircularForm& form, double period, double x0, const std::vector<double>& b)
  {
    Circular c;
    c.form = form;
    c.period = period;
    c.x0 = x0;
    c.b = b;
    expectPassed(runCircular(c, quick()), form.spec);
    return c;
  };
  const Circular gauss = run(reference::gaussianShoal(30.0, 18.0, 400.0), 14.0, -2400.0, { -350.0, 70.0, 500.0 });
  const Circular poly = run(reference::polynomialShoal(12.0, 7.0, 400.0), 7.0, -600.0, { -310.0, 20.0, 160.0 });
  run(reference::conicalIsland(0.08, 150.0, 700.0), 7.0, -1000.0, { 30.0, -320.0, 600.0 });
  run(reference::parabolicIsland(20.0, 900.0), 10.0, -1400.0, { -40.0, 350.0, 800.0 });
  expectPassed(runCircularCaustic(gauss, quick()), "caustic of the Gaussian shoal");
  expectPassed(runCircularCaustic(poly, quick()), "caustic of the polynomial shoal");
}

TEST(ValidationParameters, EllipticShoals)
{
  reference::EllipticShoal shoal;
  shoal.rotation = -15.0;
  shoal.slope = 0.015;
  shoal.toe = 4.5;
  shoal.h0 = 0.5;
  expectPassed(
    runElliptic(
      { "berkhoff:rotation=-15,slope=0.015,toe=4.5,h0=0.5,", shoal, 1.3, -10.0, { -3.1, -0.9, 0.7, 2.2 } }, quick()),
    "berkhoff");
}

TEST(ValidationParameters, DesignedSeafloors)
{
  using reference::Design;
  const DesignGrid straight{ GridOrder::Straight, { 40.0, 20.0, 10.0 } };
  const DesignGrid turning{ GridOrder::Turning, { 40.0, 20.0, 10.0 } };
  const DesignGrid curved{ GridOrder::Curved, { 40.0, 20.0, 10.0 } };
  const Design d{ 14.0, 20.0, 1200.0, 60.0 };
  expectPassed(runDesign({ circleRay(d) }, straight, quick()), "circle");
  expectPassed(runDesign({ cycloidRay(d) }, straight, quick()), "cycloid");
  const Design island{ 7.0, 9.0, 1100.0, 55.0 };
  expectPassed(runDesign({ spiralRay(island) }, curved, quick()), "spiral");
  expectPassed(runDesign({ islandParabolaRay(island) }, curved, quick()), "parabola");
  const Design fold{ 7.0, 4.0, 400.0, 55.0 };
  expectPassed(runDesign({ foldParabolaRay(fold, reference::Neighbours::Parallel) }, turning, quick()), "fold");
  const Design lens{ 8.0, 11.0, 600.0, 0.0 };
  const DesignGrid kinked{ GridOrder::Kinked, { 40.0, 20.0, 10.0, 5.0 } };
  expectPassed(
    runDesign({ luneburgRay(lens, -0.7), luneburgRay(lens, 0.2), luneburgRay(lens, 0.6) }, kinked, quick()), "lens");
}

TEST(ValidationParameters, Currents)
{
  const reference::CurrentScene deep;
  expectPassed(runJet({ 1.2, 300.0, { 7.0, 4000.0 }, -1500.0, -35.0 }, quick()), "jet, deep");
  expectPassed(runJet({ -1.0, 120.0, { 6.0, 8.0 }, -700.0, 50.0 }, quick()), "jet, 8 m deep");
  expectPassed(runJet({ 2.5, 220.0, { 8.0, 4000.0 }, -1200.0, 65.0 }, quick()), "jet, turning");
  expectPassed(runEddy({ -1.0, 400.0, { 14.0, 4000.0 }, -2400.0, { -500.0, 100.0, 350.0 } }, quick()), "eddy");
  expectPassed(runEddy({ 0.8, 250.0, { 8.0, 10.0 }, -1600.0, { -200.0, 150.0 } }, quick()), "eddy, 10 m deep");
  expectPassed(runCollinear({ { 14.0, 4000.0 }, { -4.5, 3.0 }, 300.0 }, quick()), "collinear, deep");
  expectPassed(runCollinear({ { 8.0, 6.0 }, { -1.5, 1.0 }, 150.0 }, quick()), "collinear, 6 m deep");
}

}
