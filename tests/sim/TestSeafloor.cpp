#include "sim/Seafloor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace swellray;

// A plane z = -10 + 0.02 x - 0.01 y on 1 km x 2 km.
class Plane : public Seafloor
{
public:
  Rectangle bounds() const override { return { { -500.0, 100.0 }, { 500.0, 2100.0 } }; }
  void evaluate(const glm::dvec2& p, unsigned, BedSample& bed) const override
  {
    bed = BedSample();
    bed.elevation = -10.0 + 0.02 * p.x - 0.01 * p.y;
    bed.gradient = glm::dvec2(0.02, -0.01);
  }
  double featureLength() const override { return 100.0; }
  double resolution() const override { return 10.0; }
};

// Flat, with a ridge whose sides meet in a kink at x = 0 and a second kink at y = 0.
class Roof : public Plane
{
public:
  Rectangle bounds() const override { return { { -1.0, -1.0 }, { 1.0, 1.0 } }; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override
  {
    bed = BedSample();
    bed.gradient = glm::dvec2(region & 1u ? -1.0 : 1.0, region & 2u ? 2.0 : 0.0);
    bed.elevation = bed.gradient.x * p.x + bed.gradient.y * p.y;
  }
  unsigned kinkCount() const override { return 2; }
  double kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const override
  {
    gradient = i == 0 ? glm::dvec2(1.0, 0.0) : glm::dvec2(0.0, 1.0);
    return i == 0 ? p.x : p.y;
  }
};

// Land in the east, a hole in the middle of the sea.
class Shore : public Plane
{
public:
  void evaluate(const glm::dvec2& p, unsigned, BedSample& bed) const override
  {
    bed = BedSample();
    bed.elevation = p.x > 0.0 ? 50.0 : (isHole(p) ? -1e6 : -5.0 + 0.01 * p.x);
  }
  bool hasHoles() const override { return true; }
  bool isHole(const glm::dvec2& p) const override { return std::fabs(p.x + 200.0) < 50.0; }
};

TEST(Seafloor, RegionsChooseTheFormula)
{
  const Roof roof;
  EXPECT_EQ(roof.region({ -0.5, -0.5 }), 0u);
  EXPECT_EQ(roof.region({ 0.5, -0.5 }), 1u);
  EXPECT_EQ(roof.region({ -0.5, 0.5 }), 2u);
  EXPECT_EQ(roof.region({ 0.5, 0.5 }), 3u);
  EXPECT_DOUBLE_EQ(roof.elevation({ 0.5, -0.5 }), -0.5);
  EXPECT_DOUBLE_EQ(roof.elevation({ -0.5, 0.25 }), 0.0);
  EXPECT_EQ(roof.bed({ 0.5, 0.5 }).gradient, glm::dvec2(-1.0, 2.0));
}

TEST(Seafloor, WithoutKinksThereIsOneRegion)
{
  const Plane plane;
  glm::dvec2 gradient(7.0);
  EXPECT_EQ(plane.region({ 3.0, 4.0 }), 0u);
  EXPECT_LT(plane.kinkLevel(0, { 3.0, 4.0 }, gradient), 0.0);
  EXPECT_EQ(gradient, glm::dvec2(0.0));
}

TEST(Seafloor, KnowsNoBoundsUnlessItSays)
{
  const Plane plane;
  const Rectangle box = plane.bounds();
  EXPECT_EQ(plane.highestElevation(box), std::numeric_limits<double>::infinity());
  EXPECT_EQ(plane.lowestElevation(box), -std::numeric_limits<double>::infinity());
}

TEST(Seafloor, FittedPlaneIsThePlane)
{
  // Least squares of exact data: rounding.
  constexpr double tolerance = 1e-14;
  const BedPlane fit = fitWetPlane(Plane(), 100.0);
  ASSERT_TRUE(fit.valid);
  EXPECT_NEAR(fit.slope.x, 0.02, tolerance);
  EXPECT_NEAR(fit.slope.y, -0.01, tolerance);
}

TEST(Seafloor, FitLooksAtTheWetPartOnly)
{
  constexpr double tolerance = 1e-14;
  const BedPlane fit = fitWetPlane(Shore(), 0.0);
  ASSERT_TRUE(fit.valid);
  EXPECT_NEAR(fit.slope.x, 0.01, tolerance);
  EXPECT_NEAR(fit.slope.y, 0.0, tolerance);
}

TEST(Seafloor, FitOfADrySceneIsNone)
{
  const BedPlane fit = fitWetPlane(Plane(), -1000.0);
  EXPECT_FALSE(fit.valid);
  EXPECT_EQ(fit.slope, glm::dvec2(0.0));
}

TEST(Rectangle, ContainsItsEdges)
{
  const Rectangle box{ { 1.0, 2.0 }, { 3.0, 5.0 } };
  EXPECT_TRUE(box.contains({ 1.0, 2.0 }));
  EXPECT_TRUE(box.contains({ 3.0, 5.0 }));
  EXPECT_FALSE(box.contains({ 3.1, 4.0 }));
  EXPECT_FALSE(box.contains({ 2.0, 1.9 }));
  EXPECT_FALSE(box.contains({ std::numeric_limits<double>::quiet_NaN(), 3.0 }));
  EXPECT_EQ(box.size(), glm::dvec2(2.0, 3.0));
}

}
