#include "sim/SplineSeafloor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

using namespace swellray;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Elevations of order 10 through solves and sums of some ten roundings, and derivatives of them over cells of 0.1 m.
constexpr double ValueRounding = 1e-12;
constexpr double GradientRounding = 1e-11;
constexpr double HessianRounding = 1e-9;

using Formula = std::function<BedSample(double, double)>;

ElevationGrid sample(
  std::size_t columns, std::size_t rows, const glm::dvec2& origin, const glm::dvec2& spacing, const Formula& f)
{
  ElevationGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.origin = origin;
  grid.spacing = spacing;
  grid.elevation.resize(columns * rows);
  for (std::size_t j = 0; j < rows; ++j)
  {
    for (std::size_t i = 0; i < columns; ++i)
    {
      const glm::dvec2 p = grid.node(i, j);
      grid.at(i, j) = f(p.x, p.y).elevation;
    }
  }
  return grid;
}

BedSample cubic(double x, double y)
{
  BedSample bed;
  bed.elevation = 1.0 + x - 2.0 * y + x * y - 0.3 * x * x * y + 0.2 * y * y * y + 0.1 * x * x * x * y * y * y;
  bed.gradient.x = 1.0 + y - 0.6 * x * y + 0.3 * x * x * y * y * y;
  bed.gradient.y = -2.0 + x - 0.3 * x * x + 0.6 * y * y + 0.3 * x * x * x * y * y;
  bed.xx = -0.6 * y + 0.6 * x * y * y * y;
  bed.xy = 1.0 - 0.6 * x + 0.9 * x * x * y * y;
  bed.yy = 1.2 * y + 0.6 * x * x * x * y;
  return bed;
}

BedSample wavy(double x, double y)
{
  BedSample bed;
  const double sx = std::sin(x);
  const double cx = std::cos(x);
  const double sy = std::sin(1.3 * y + 0.4);
  const double cy = std::cos(1.3 * y + 0.4);
  bed.elevation = sx * cy;
  bed.gradient = glm::dvec2(cx * cy, -1.3 * sx * sy);
  bed.xx = -sx * cy;
  bed.xy = -1.3 * cx * sy;
  bed.yy = -1.69 * sx * cy;
  return bed;
}

BedSample plane(double x, double y)
{
  BedSample bed;
  bed.elevation = -20.0 + 0.1 * x - 0.05 * y;
  bed.gradient = glm::dvec2(0.1, -0.05);
  return bed;
}

struct Errors
{
  double value = 0.0;
  double gradient = 0.0;
  double hessian = 0.0;
};

// Largest errors over points that do not repeat their place in the cells.
Errors compare(const Seafloor& seafloor, const Formula& f, const glm::dvec2& low, const glm::dvec2& high)
{
  Errors errors;
  constexpr int count = 301;
  for (int j = 0; j < count; ++j)
  {
    for (int i = 0; i < count; ++i)
    {
      const glm::dvec2 p = low + (high - low) * glm::dvec2(i, j) / (count - 1.0);
      if (seafloor.isHole(p))
      {
        continue;
      }
      const BedSample bed = seafloor.bed(p);
      const BedSample expected = f(p.x, p.y);
      errors.value = std::max(errors.value, std::fabs(bed.elevation - expected.elevation));
      errors.gradient = std::max({ errors.gradient, std::fabs(bed.gradient.x - expected.gradient.x),
        std::fabs(bed.gradient.y - expected.gradient.y) });
      errors.hessian = std::max({ errors.hessian, std::fabs(bed.xx - expected.xx), std::fabs(bed.xy - expected.xy),
        std::fabs(bed.yy - expected.yy) });
    }
  }
  return errors;
}

TEST(SplineSeafloor, IsExactOnCubics)
{
  // Unequal spacings, all parities and the smallest grids, and a little outside, where the edge polynomials go on.
  for (const std::size_t columns : { 4u, 5u, 6u, 7u, 12u })
  {
    for (const std::size_t rows : { 4u, 5u, 9u })
    {
      const glm::dvec2 spacing(2.0 / static_cast<double>(columns - 1), 3.0 / static_cast<double>(rows - 1));
      const SplineSeafloor seafloor(sample(columns, rows, { -1.0, -1.5 }, spacing, cubic));
      const Errors errors = compare(seafloor, cubic, { -1.2, -1.7 }, { 1.2, 1.7 });
      EXPECT_LT(errors.value, ValueRounding) << columns << " x " << rows;
      EXPECT_LT(errors.gradient, GradientRounding) << columns << " x " << rows;
      EXPECT_LT(errors.hessian, HessianRounding) << columns << " x " << rows;
    }
  }
}

TEST(SplineSeafloor, InterpolatesTheNodes)
{
  // A rough grid: neighbouring nodes have nothing in common.
  const Formula rough = [](double x, double y)
  {
    BedSample bed;
    bed.elevation = 10.0 * std::sin(91.0 * x * x + 17.0 * y * y * y);
    return bed;
  };
  const ElevationGrid grid = sample(23, 17, { 5.0, -3.0 }, { 0.5, 0.25 }, rough);
  const SplineSeafloor seafloor(grid);
  for (std::size_t j = 0; j < grid.rows; ++j)
  {
    for (std::size_t i = 0; i < grid.columns; ++i)
    {
      EXPECT_NEAR(seafloor.elevation(grid.node(i, j)), grid.at(i, j), ValueRounding);
    }
  }
}

TEST(SplineSeafloor, ConvergesAtItsOrders)
{
  // Orders 4, 3 and 2 also at the edges; the measured ones may fall short by this.
  constexpr double shortfall = 0.25;
  Errors coarse;
  for (const std::size_t cells : { 32u, 64u, 128u })
  {
    const double spacing = 4.0 / static_cast<double>(cells);
    const SplineSeafloor seafloor(sample(cells + 1, cells + 1, { 0.0, 0.0 }, { spacing, spacing }, wavy));
    const Errors fine = compare(seafloor, wavy, { 0.0, 0.0 }, { 4.0, 4.0 });
    if (coarse.value > 0.0)
    {
      EXPECT_GT(std::log2(coarse.value / fine.value), 4.0 - shortfall) << cells;
      EXPECT_GT(std::log2(coarse.gradient / fine.gradient), 3.0 - shortfall) << cells;
      EXPECT_GT(std::log2(coarse.hessian / fine.hessian), 2.0 - shortfall) << cells;
    }
    coarse = fine;
  }
  // cells = 128: 5/384 d^4 f'''' inside is 3e-8.
  EXPECT_LT(coarse.value, 3e-7);
}

TEST(SplineSeafloor, IsTwiceContinuouslyDifferentiable)
{
  const SplineSeafloor rough(sample(9, 9, { 0.0, 0.0 }, { 2.0, 3.0 },
    [](double x, double y)
    {
      BedSample bed;
      bed.elevation = 10.0 * std::sin(91.0 * x * x + 17.0 * y * y * y);
      return bed;
    }));
  // Both sides of every cell boundary, a step apart whose third derivatives make less than the tolerance.
  constexpr double step = 1e-11;
  constexpr double tolerance = 1e-8;
  for (int line = 1; line < 8; ++line)
  {
    for (double along = 0.3; along < 15.0; along += 0.71)
    {
      for (const bool vertical : { true, false })
      {
        const glm::dvec2 p = vertical ? glm::dvec2(2.0 * line, along) : glm::dvec2(along, 3.0 * line);
        const glm::dvec2 d = vertical ? glm::dvec2(step, 0.0) : glm::dvec2(0.0, step);
        const BedSample a = rough.bed(p - d);
        const BedSample b = rough.bed(p + d);
        EXPECT_NEAR(a.elevation, b.elevation, tolerance);
        EXPECT_NEAR(a.gradient.x, b.gradient.x, tolerance);
        EXPECT_NEAR(a.gradient.y, b.gradient.y, tolerance);
        EXPECT_NEAR(a.xx, b.xx, tolerance);
        EXPECT_NEAR(a.xy, b.xy, tolerance);
        EXPECT_NEAR(a.yy, b.yy, tolerance);
      }
    }
  }
}

TEST(SplineSeafloor, DerivativesAreThoseOfItsValues)
{
  const SplineSeafloor seafloor(sample(12, 15, { -3.0, 2.0 }, { 0.7, 1.3 }, wavy));
  // Central differences of a piecewise cubic: truncation d^2 f'''/6.
  constexpr double d = 1e-5;
  constexpr double tolerance = 1e-9;
  for (double x = -2.9; x < 4.0; x += 0.377)
  {
    for (double y = 2.1; y < 20.0; y += 0.519)
    {
      const BedSample bed = seafloor.bed({ x, y });
      const BedSample east = seafloor.bed({ x + d, y });
      const BedSample west = seafloor.bed({ x - d, y });
      const BedSample north = seafloor.bed({ x, y + d });
      const BedSample south = seafloor.bed({ x, y - d });
      EXPECT_NEAR(bed.gradient.x, (east.elevation - west.elevation) / (2.0 * d), tolerance);
      EXPECT_NEAR(bed.gradient.y, (north.elevation - south.elevation) / (2.0 * d), tolerance);
      // The second derivatives bend at the cell boundaries: first order there.
      constexpr double kink = 1e-4;
      EXPECT_NEAR(bed.xx, (east.gradient.x - west.gradient.x) / (2.0 * d), kink);
      EXPECT_NEAR(bed.xy, (east.gradient.y - west.gradient.y) / (2.0 * d), kink);
      EXPECT_NEAR(bed.yy, (north.gradient.y - south.gradient.y) / (2.0 * d), kink);
    }
  }
}

TEST(SplineSeafloor, KnowsItsLengths)
{
  const SplineSeafloor seafloor(sample(5, 4, { 10.0, 20.0 }, { 2.0, 3.0 }, plane));
  EXPECT_DOUBLE_EQ(seafloor.resolution(), 1.0);
  EXPECT_DOUBLE_EQ(seafloor.featureLength(), 16.0);
  EXPECT_EQ(seafloor.bounds().low, glm::dvec2(10.0, 20.0));
  EXPECT_EQ(seafloor.bounds().high, glm::dvec2(18.0, 29.0));
  EXPECT_EQ(seafloor.kinkCount(), 0u);
  EXPECT_FALSE(seafloor.hasHoles());
  EXPECT_FALSE(seafloor.isHole({ 12.0, 25.0 }));
}

TEST(SplineSeafloor, BoundsItsElevations)
{
  const Formula rough = [](double x, double y)
  {
    BedSample bed;
    bed.elevation = 10.0 * std::sin(0.3 * x * x + 0.2 * y * y);
    return bed;
  };
  const SplineSeafloor seafloor(sample(43, 31, { 0.0, 0.0 }, { 0.5, 0.25 }, rough));
  const Rectangle box = seafloor.bounds();
  for (double x = -2.0; x < 20.0; x += 1.7)
  {
    for (double y = -1.0; y < 7.0; y += 0.9)
    {
      const Rectangle part{ { x, y }, { x + 2.3, y + 1.1 } };
      const double highest = seafloor.highestElevation(part);
      const double lowest = seafloor.lowestElevation(part);
      for (double a = part.low.x; a <= part.high.x; a += 0.1)
      {
        for (double b = part.low.y; b <= part.high.y; b += 0.1)
        {
          if (box.contains({ a, b }))
          {
            EXPECT_LE(seafloor.elevation({ a, b }), highest + ValueRounding);
            EXPECT_GE(seafloor.elevation({ a, b }), lowest - ValueRounding);
          }
        }
      }
    }
  }
  // Tight enough to be of use: over a plane they exceed it by no more than a block and one cell around.
  const SplineSeafloor slope(sample(101, 101, { 0.0, 0.0 }, { 1.0, 1.0 },
    [](double x, double)
    {
      BedSample bed;
      bed.elevation = x;
      return bed;
    }));
  EXPECT_LE(slope.highestElevation({ { 40.0, 40.0 }, { 41.0, 41.0 } }), 49.0 + ValueRounding);
  EXPECT_GE(slope.lowestElevation({ { 40.0, 40.0 }, { 41.0, 41.0 } }), 39.0 - ValueRounding);
  EXPECT_GE(slope.highestElevation({ { -1e9, -1e9 }, { 1e9, 1e9 } }), 100.0);
  EXPECT_LE(slope.lowestElevation({ { -1e9, -1e9 }, { 1e9, 1e9 } }), 0.0);
}

ElevationGrid withHoles(ElevationGrid grid)
{
  for (std::size_t j = 0; j < grid.rows; ++j)
  {
    for (std::size_t i = 0; i < grid.columns; ++i)
    {
      const bool inside = i >= 40 && i < 46 && j >= 30 && j < 35;
      const bool wide = i >= 20 && i < 60 && j >= 60 && j < 80;
      const bool corner = i + j < 25;
      const bool edge = i >= 95 && j >= 40 && j < 50;
      if (inside || wide || corner || edge)
      {
        grid.at(i, j) = NotANumber;
      }
    }
  }
  return grid;
}

TEST(SplineSeafloor, HolesAreTheCellsThatTouchThem)
{
  ElevationGrid grid = sample(10, 8, { 100.0, 200.0 }, { 2.0, 4.0 }, plane);
  grid.at(4, 3) = NotANumber;
  grid.at(9, 7) = std::numeric_limits<double>::infinity();
  const SplineSeafloor seafloor(grid);
  EXPECT_TRUE(seafloor.hasHoles());
  for (std::size_t j = 0; j < 7; ++j)
  {
    for (std::size_t i = 0; i < 9; ++i)
    {
      const bool expected = ((i == 3 || i == 4) && (j == 2 || j == 3)) || (i == 8 && j == 6);
      const glm::dvec2 middle = grid.node(i, j) + 0.5 * grid.spacing;
      EXPECT_EQ(seafloor.isHole(middle), expected) << i << ", " << j;
    }
  }
  EXPECT_TRUE(seafloor.isHole(grid.bounds().high));
  EXPECT_FALSE(seafloor.isHole(grid.bounds().high + 1.0));
  EXPECT_FALSE(seafloor.isHole(grid.bounds().low - 1.0));
  EXPECT_FALSE(seafloor.isHole({ NotANumber, NotANumber }));
}

TEST(SplineSeafloor, APlaneWithHolesStaysAPlane)
{
  const ElevationGrid grid = withHoles(sample(100, 100, { 0.0, 0.0 }, { 0.1, 0.1 }, plane));
  const SplineSeafloor seafloor(grid);
  ASSERT_TRUE(seafloor.isHole({ 4.3, 3.2 }));
  // Rounding, not an approximation: the continuation of a plane is exact.
  const Errors errors = compare(seafloor, plane, { 0.0, 0.0 }, { 9.9, 9.9 });
  EXPECT_LT(errors.value, ValueRounding);
  EXPECT_LT(errors.gradient, GradientRounding);
  EXPECT_LT(errors.hessian, HessianRounding);
}

TEST(SplineSeafloor, HolesLeaveTheGoodCellsAlone)
{
  const ElevationGrid whole = sample(100, 100, { 0.0, 0.0 }, { 0.1, 0.1 }, wavy);
  const SplineSeafloor seafloor(withHoles(whole));
  const SplineSeafloor reference(whole);
  const Formula intact = [&](double x, double y) { return reference.bed({ x, y }); };
  // Beside a hole of half a wavelength of the bed no continuation knows it: some 1e-3 of its height in the first cell.
  const Errors beside = compare(seafloor, intact, { 0.0, 0.0 }, { 9.9, 9.9 });
  EXPECT_LT(beside.value, 3e-3);
  // Around a small hole the curvature goes on, and that is nearly all.
  const Errors small = compare(seafloor, intact, { 3.6, 2.7 }, { 4.9, 3.7 });
  EXPECT_LT(small.value, 1e-5);
  EXPECT_LT(small.gradient, 1e-3);
  EXPECT_LT(small.hessian, 2e-2);
  // The spline forgets by 0.268 a cell: 20 cells away it is the same.
  const Errors far = compare(seafloor, intact, { 7.0, 1.0 }, { 7.4, 9.0 });
  EXPECT_LT(far.value, 1e-8);
}

TEST(SplineSeafloor, HolesAreFilledWithinReason)
{
  // Two basins of different depth on both sides of a wide hole: no value far outside their range.
  ElevationGrid grid = sample(80, 40, { 0.0, 0.0 }, { 1.0, 1.0 },
    [](double x, double)
    {
      BedSample bed;
      bed.elevation = x < 40.0 ? -100.0 : -10.0;
      return bed;
    });
  for (std::size_t j = 0; j < grid.rows; ++j)
  {
    for (std::size_t i = 15; i < 65; ++i)
    {
      grid.at(i, j) = NotANumber;
    }
  }
  const SplineSeafloor seafloor(grid);
  EXPECT_LT(seafloor.highestElevation(seafloor.bounds()), 20.0);
  EXPECT_GT(seafloor.lowestElevation(seafloor.bounds()), -130.0);
}

TEST(SplineSeafloor, OneNodeOfDataIsEnoughToStandOn)
{
  ElevationGrid grid = sample(6, 6, { 0.0, 0.0 }, { 1.0, 1.0 }, plane);
  for (double& z : grid.elevation)
  {
    z = NotANumber;
  }
  grid.at(3, 2) = -7.0;
  const SplineSeafloor seafloor(grid);
  EXPECT_NEAR(seafloor.elevation({ 1.5, 4.5 }), -7.0, ValueRounding);
  EXPECT_TRUE(seafloor.isHole({ 3.0, 2.0 }));
}

TEST(SplineSeafloor, SurvivesAPositionThatIsNoNumber)
{
  const SplineSeafloor seafloor(sample(5, 5, { 0.0, 0.0 }, { 1.0, 1.0 }, plane));
  EXPECT_TRUE(std::isnan(seafloor.elevation({ NotANumber, 1.0 })));
  EXPECT_TRUE(std::isnan(seafloor.elevation({ 1.0, NotANumber })));
}

std::string complaint(const ElevationGrid& grid)
{
  try
  {
    const SplineSeafloor seafloor(grid);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(SplineSeafloor, RefusesWhatIsNoGrid)
{
  using testing::HasSubstr;
  EXPECT_THAT(complaint({}), HasSubstr("at least 4 x 4 nodes"));
  EXPECT_THAT(complaint(sample(3, 9, { 0.0, 0.0 }, { 1.0, 1.0 }, plane)), HasSubstr("not 3 x 9"));
  EXPECT_THAT(complaint(sample(9, 9, { 0.0, 0.0 }, { 0.0, 1.0 }, plane)), HasSubstr("spacing must be above 0"));
  EXPECT_THAT(complaint(sample(9, 9, { 0.0, 0.0 }, { 1.0, -1.0 }, plane)), HasSubstr("spacing must be above 0"));
  EXPECT_THAT(complaint(sample(9, 9, { NotANumber, 0.0 }, { 1.0, 1.0 }, plane)), HasSubstr("origin must be finite"));
  ElevationGrid grid = sample(5, 5, { 0.0, 0.0 }, { 1.0, 1.0 }, plane);
  grid.elevation.pop_back();
  EXPECT_THAT(complaint(grid), HasSubstr("as many elevations, not 24"));
  grid.elevation.assign(25, NotANumber);
  EXPECT_THAT(complaint(grid), HasSubstr("no node with an elevation"));
}

}
