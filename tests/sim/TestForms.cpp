// The built-in forms as functions: derivatives, kinks and bounds, whatever their shape.
#include "sim/BuiltinSeafloor.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace swellray;

namespace
{

struct FormCase
{
  const char* name;
  const char* spec;
  double step; // m, of central differences: about a thousandth of the finest shape of the form
  unsigned kinkCount;
  bool gradientJumps; // at its kinks
};

void PrintTo(const FormCase& form, std::ostream* out)
{
  *out << form.spec;
}

const FormCase Cases[] = {
  { "Plane", "plane", 0.1, 0, false },
  { "PlaneFloor", "plane:facing=0,offshore-depth=15", 0.1, 1, true },
  { "PlaneTurned", "plane:facing=217,s=0.05,offshore-depth=15", 0.1, 1, true },
  { "Dean", "dean", 3e-4, 0, false },
  { "DeanFloor", "dean:facing=120,A=0.2,min-depth=0.1,offshore-depth=9", 3e-4, 1, true },
  { "Bar", "bar", 0.02, 0, false },
  { "BarFloor", "bar:facing=-60,hb=1.5,xb=150,wb=25,offshore-depth=7", 0.02, 1, true },
  { "Bay", "bay", 0.01, 0, false },
  { "BayTurned", "bay:facing=310,indent=30,fade=35", 0.01, 0, false },
  { "Headland", "headland", 0.01, 0, false },
  { "HeadlandTurned", "headland:facing=200,reach=40,sigma=12,fade=20", 0.01, 0, false },
  { "Cone", "island", 0.05, 1, true },
  { "ConeOff", "island:xc=300,yc=-200,s=0.1,rs=100,rt=500", 0.05, 1, true },
  { "Parabola", "island:kind=parabolic,xc=-100,yc=50", 0.1, 1, true },
  { "Gauss", "shoal:xc=100,yc=-50", 0.1, 0, false },
  { "Poly3", "shoal:kind=poly3,h0=15,a=10.5,R=250", 0.05, 1, false },
  { "Berkhoff", "berkhoff", 5e-4, 3, true },
  { "BerkhoffToShore", "berkhoff:rotation=-35,toe=4,min-depth=0,slope=0.05", 5e-4, 2, true },
  { "VincentBriggs", "vincent-briggs", 5e-4, 1, true },
  { "Babbage", "babbage", 0.02, 0, false },
  { "BabbageDeep", "babbage:offshore-depth=22,x0=200,x1=900,y1=750", 0.02, 0, false },
};

// Central differences with the steps above are as good as 1e-6 of the largest derivative in the scene; ten times that.
constexpr double DerivativeTolerance = 1e-5;
// Rounding of elevations of some 10 m, divided by a step.
constexpr double Rounding = 1e-14;
// Two formulas that meet on a kink found by bisection to rounding of positions of some km.
constexpr double MeetTolerance = 1e-11;

class Forms : public testing::TestWithParam<FormCase>
{
protected:
  void SetUp() override { this->Bed = makeBuiltinSeafloor(GetParam().spec); }

  // Points all over the bounds and 5 % beyond, on no line of symmetry.
  std::vector<glm::dvec2> samples(int count) const
  {
    const Rectangle box = this->Bed->bounds();
    std::vector<glm::dvec2> points;
    for (int j = 0; j < count; ++j)
    {
      for (int i = 0; i < count; ++i)
      {
        const glm::dvec2 share((i + 0.137) / (count - 0.6), (j + 0.291) / (count - 0.6));
        points.push_back(box.low + box.size() * (1.1 * share - 0.05));
      }
    }
    return points;
  }

  BedSample at(const glm::dvec2& p, unsigned region) const
  {
    BedSample sample;
    this->Bed->evaluate(p, region, sample);
    return sample;
  }

  // Points on kink i, by bisection between neighbouring samples.
  std::vector<glm::dvec2> kinkPoints(unsigned i) const
  {
    const std::vector<glm::dvec2> points = samples(45);
    std::vector<glm::dvec2> found;
    glm::dvec2 gradient;
    for (std::size_t n = 1; n < points.size(); ++n)
    {
      glm::dvec2 inside = points[n - 1];
      glm::dvec2 outside = points[n];
      const bool positive = this->Bed->kinkLevel(i, inside, gradient) > 0.0;
      if ((this->Bed->kinkLevel(i, outside, gradient) > 0.0) == positive)
      {
        continue;
      }
      for (int halving = 0; halving < 60; ++halving)
      {
        const glm::dvec2 middle = 0.5 * (inside + outside);
        ((this->Bed->kinkLevel(i, middle, gradient) > 0.0) == positive ? inside : outside) = middle;
      }
      found.push_back(0.5 * (inside + outside));
    }
    return found;
  }

  // Gradient and second derivatives of `region` at these points against differences.
  void checkDerivatives(const std::vector<glm::dvec2>& points, const std::vector<unsigned>& regions) const
  {
    double steepest = 0.0;
    double sharpest = 0.0;
    for (const glm::dvec2& p : samples(41))
    {
      const BedSample bed = this->Bed->bed(p);
      steepest = std::max(steepest, glm::length(bed.gradient));
      sharpest = std::max({ sharpest, std::abs(bed.xx), std::abs(bed.xy), std::abs(bed.yy) });
    }
    const double step = GetParam().step;
    const double first = DerivativeTolerance * steepest + Rounding / step;
    const double second = DerivativeTolerance * sharpest + Rounding / step;
    const glm::dvec2 dx(step, 0.0);
    const glm::dvec2 dy(0.0, step);
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      const glm::dvec2 p = points[n];
      const BedSample bed = at(p, regions[n]);
      const BedSample east = at(p + dx, regions[n]);
      const BedSample west = at(p - dx, regions[n]);
      const BedSample north = at(p + dy, regions[n]);
      const BedSample south = at(p - dy, regions[n]);
      SCOPED_TRACE(testing::Message() << "at " << p.x << ", " << p.y << " region " << regions[n]);
      ASSERT_NEAR(bed.gradient.x, (east.elevation - west.elevation) / (2.0 * step), first);
      ASSERT_NEAR(bed.gradient.y, (north.elevation - south.elevation) / (2.0 * step), first);
      ASSERT_NEAR(bed.xx, (east.gradient.x - west.gradient.x) / (2.0 * step), second);
      ASSERT_NEAR(bed.xy, (east.gradient.y - west.gradient.y) / (2.0 * step), second);
      ASSERT_NEAR(bed.xy, (north.gradient.x - south.gradient.x) / (2.0 * step), second);
      ASSERT_NEAR(bed.yy, (north.gradient.y - south.gradient.y) / (2.0 * step), second);
    }
  }

  std::unique_ptr<Seafloor> Bed;
};

TEST_P(Forms, areFiniteAndSmoothAllOver)
{
  std::vector<glm::dvec2> points = samples(41);
  std::vector<unsigned> regions;
  for (const glm::dvec2& p : points)
  {
    const BedSample bed = this->Bed->bed(p);
    ASSERT_TRUE(std::isfinite(bed.elevation) && std::isfinite(bed.gradient.x) && std::isfinite(bed.gradient.y) &&
      std::isfinite(bed.xx) && std::isfinite(bed.xy) && std::isfinite(bed.yy))
      << "at " << p.x << ", " << p.y;
    regions.push_back(this->Bed->region(p));
  }
  checkDerivatives(points, regions);
}

TEST_P(Forms, goOnSmoothlyAcrossTheirKinks)
{
  ASSERT_EQ(this->Bed->kinkCount(), GetParam().kinkCount);
  for (unsigned i = 0; i < this->Bed->kinkCount(); ++i)
  {
    std::vector<glm::dvec2> points = kinkPoints(i);
    ASSERT_FALSE(points.empty()) << "kink " << i << " lies outside the scene";
    std::vector<unsigned> regions;
    const std::size_t count = points.size();
    for (std::size_t n = 0; n < count; ++n)
    {
      regions.push_back(this->Bed->region(points[n]) | (1u << i));
    }
    for (std::size_t n = 0; n < count; ++n)
    {
      points.push_back(points[n]);
      regions.push_back(regions[n] & ~(1u << i));
    }
    checkDerivatives(points, regions);
  }
}

TEST_P(Forms, areContinuousAcrossTheirKinks)
{
  for (unsigned i = 0; i < this->Bed->kinkCount(); ++i)
  {
    const double step = GetParam().step;
    double largestJump = 0.0;
    for (const glm::dvec2& p : kinkPoints(i))
    {
      SCOPED_TRACE(testing::Message() << "kink " << i << " at " << p.x << ", " << p.y);
      const unsigned region = this->Bed->region(p);
      const BedSample positive = at(p, region | (1u << i));
      const BedSample negative = at(p, region & ~(1u << i));
      ASSERT_NEAR(positive.elevation, negative.elevation, MeetTolerance);

      glm::dvec2 normal;
      glm::dvec2 unused;
      this->Bed->kinkLevel(i, p, normal);
      const double length = glm::length(normal);
      ASSERT_GT(length, 0.0);
      const glm::dvec2 byDifference(this->Bed->kinkLevel(i, p + glm::dvec2(step, 0.0), unused) -
          this->Bed->kinkLevel(i, p - glm::dvec2(step, 0.0), unused),
        this->Bed->kinkLevel(i, p + glm::dvec2(0.0, step), unused) -
          this->Bed->kinkLevel(i, p - glm::dvec2(0.0, step), unused));
      ASSERT_LT(glm::distance(normal, byDifference / (2.0 * step)), DerivativeTolerance * length);

      // Continuity along the curve leaves only a jump across it.
      const glm::dvec2 jump = positive.gradient - negative.gradient;
      ASSERT_NEAR((jump.x * normal.y - jump.y * normal.x) / length, 0.0, MeetTolerance);
      largestJump = std::max(largestJump, glm::length(jump));
      if (!GetParam().gradientJumps)
      {
        ASSERT_NEAR(positive.xx, negative.xx, MeetTolerance);
        ASSERT_NEAR(positive.xy, negative.xy, MeetTolerance);
        ASSERT_NEAR(positive.yy, negative.yy, MeetTolerance);
      }
    }
    if (GetParam().gradientJumps)
    {
      EXPECT_GT(largestJump, 1e-3);
    }
    else
    {
      EXPECT_LT(largestJump, MeetTolerance);
    }
  }
}

TEST_P(Forms, boundTheirElevationInABox)
{
  constexpr int Boxes = 9;
  constexpr int Points = 13;
  const Rectangle all = this->Bed->bounds();
  for (const double share : { 1.0, 0.31, 0.05 })
  {
    for (int n = 0; n < Boxes * Boxes; ++n)
    {
      const glm::dvec2 corner(n % Boxes / double(Boxes - 1), n / Boxes / double(Boxes - 1));
      const glm::dvec2 low = all.low + (1.0 - share) * all.size() * corner;
      const Rectangle box{ low, low + share * all.size() };
      const double highest = this->Bed->highestElevation(box);
      const double lowest = this->Bed->lowestElevation(box);
      ASSERT_TRUE(std::isfinite(highest) && std::isfinite(lowest));
      for (int k = 0; k < Points * Points; ++k)
      {
        const glm::dvec2 p =
          box.low + box.size() * glm::dvec2(k % Points / double(Points - 1), k / Points / double(Points - 1));
        const double elevation = this->Bed->elevation(p);
        ASSERT_LE(elevation, highest + MeetTolerance) << "at " << p.x << ", " << p.y;
        ASSERT_GE(elevation, lowest - MeetTolerance) << "at " << p.x << ", " << p.y;
      }
    }
  }
}

TEST_P(Forms, stateLengthsWithinTheScene)
{
  const glm::dvec2 size = this->Bed->bounds().size();
  EXPECT_GT(this->Bed->resolution(), 0.0);
  EXPECT_LE(this->Bed->resolution(), this->Bed->featureLength());
  EXPECT_LE(this->Bed->featureLength(), std::min(size.x, size.y));
  EXPECT_FALSE(this->Bed->hasHoles());
}

INSTANTIATE_TEST_SUITE_P(Builtin, Forms, testing::ValuesIn(Cases),
  [](const testing::TestParamInfo<FormCase>& form) { return std::string(form.param.name); });

}
