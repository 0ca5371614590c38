#include "bathymetry/FillGaps.h"
#include "bathymetry/InscribedRectangle.h"
#include "bathymetry/SmoothGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace swellray;

namespace
{

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

// Planes pass through filling and smoothing but for rounding and the solver's reduction.
constexpr double PlaneError = 1e-6;

double plane(std::size_t column, std::size_t row)
{
  return -12.0 + 0.3 * static_cast<double>(column) - 0.1 * static_cast<double>(row);
}

ElevationGrid planeGrid(std::size_t columns, std::size_t rows)
{
  ElevationGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.elevation.resize(columns * rows);
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (std::size_t column = 0; column < columns; ++column)
    {
      grid.at(column, row) = plane(column, row);
    }
  }
  return grid;
}

void clear(ElevationGrid& grid, std::size_t left, std::size_t bottom, std::size_t columns, std::size_t rows)
{
  for (std::size_t row = bottom; row < bottom + rows; ++row)
  {
    for (std::size_t column = left; column < left + columns; ++column)
    {
      grid.at(column, row) = Nan;
    }
  }
}

double largestDeparture(const ElevationGrid& grid)
{
  double largest = 0.0;
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    for (std::size_t column = 0; column < grid.columns; ++column)
    {
      const double z = grid.at(column, row);
      largest = std::isnan(z) ? largest : std::max(largest, std::abs(z - plane(column, row)));
    }
  }
  return largest;
}

}

TEST(FillGaps, EnclosedGapsOfAnySizeAndNarrowOnesAtTheBorder)
{
  ElevationGrid grid = planeGrid(60, 50);
  clear(grid, 10, 10, 30, 25); // enclosed
  clear(grid, 0, 40, 5, 10);   // at the border, 5 wide
  clear(grid, 54, 20, 6, 6);   // at the border, 6 wide
  const GapCount count = fillGaps(grid, { 10.0, 20.0 }, {});
  EXPECT_EQ(count.filled, 750u + 50u);
  EXPECT_EQ(count.left, 36u);
  EXPECT_TRUE(std::isnan(grid.at(57, 22)));
  EXPECT_LT(largestDeparture(grid), PlaneError);
}

TEST(FillGaps, WidthIsInMetres)
{
  const auto leftWith = [](double maxGap)
  {
    ElevationGrid grid = planeGrid(30, 30);
    clear(grid, 0, 10, 4, 12); // 40 m x 240 m
    return fillGaps(grid, { 10.0, 20.0 }, maxGap).left;
  };
  EXPECT_EQ(leftWith(39.0), 48u);
  EXPECT_EQ(leftWith(40.0), 0u);
  EXPECT_EQ(leftWith(0.0), 48u);
}

TEST(FillGaps, DiagonalNeighboursAreTwoGaps)
{
  ElevationGrid grid = planeGrid(30, 30);
  clear(grid, 0, 0, 10, 10);
  clear(grid, 10, 10, 3, 3);
  const GapCount count = fillGaps(grid, glm::dvec2(1.0), {});
  EXPECT_EQ(count.filled, 9u);
  EXPECT_EQ(count.left, 100u);
}

TEST(FillGaps, NothingToFill)
{
  ElevationGrid grid = planeGrid(5, 5);
  EXPECT_EQ(fillGaps(grid, glm::dvec2(1.0), {}).filled, 0u);
  grid.elevation.assign(25, Nan);
  EXPECT_EQ(fillGaps(grid, glm::dvec2(1.0), {}).left, 25u);
}

TEST(SmoothGrid, PlanesStayBesideEdgesAndHoles)
{
  ElevationGrid grid = planeGrid(40, 30);
  grid.spacing = { 10.0, 5.0 };
  clear(grid, 20, 10, 6, 6);
  smoothGrid(grid, 25.0);
  EXPECT_LT(largestDeparture(grid), PlaneError);
  EXPECT_TRUE(std::isnan(grid.at(22, 12)));
  EXPECT_FALSE(std::isnan(grid.at(19, 12)));
}

TEST(SmoothGrid, SpikeBecomesAGaussianOfEqualVolume)
{
  // Wide enough for the smoothing not to fade where the spike reaches.
  constexpr std::size_t nodes = 81;
  ElevationGrid grid;
  grid.columns = grid.rows = nodes;
  grid.spacing = { 10.0, 20.0 };
  grid.elevation.assign(nodes * nodes, 0.0);
  grid.at(nodes / 2, nodes / 2) = 1.0;
  const double sigma = 40.0;
  smoothGrid(grid, sigma);
  double sum = 0.0;
  double xx = 0.0;
  double yy = 0.0;
  for (std::size_t row = 0; row < nodes; ++row)
  {
    for (std::size_t column = 0; column < nodes; ++column)
    {
      const double z = grid.at(column, row);
      const double x = 10.0 * (static_cast<double>(column) - 40.0);
      const double y = 20.0 * (static_cast<double>(row) - 40.0);
      sum += z;
      xx += z * x * x;
      yy += z * y * y;
    }
  }
  // Cut off at 4 standard deviations: 0.1 % of the variance.
  EXPECT_NEAR(sum, 1.0, 1e-9);
  EXPECT_NEAR(xx, sigma * sigma, 2e-3 * sigma * sigma);
  EXPECT_NEAR(yy, sigma * sigma, 2e-3 * sigma * sigma);
}

TEST(InscribedRectangle, OfARectangleIsItself)
{
  const Rectangle box = inscribedRectangle({ { 1.0, 2.0 }, { 5.0, 2.0 }, { 5.0, 9.0 }, { 1.0, 9.0 } });
  EXPECT_EQ(box.low, glm::dvec2(1.0, 2.0));
  EXPECT_EQ(box.high, glm::dvec2(5.0, 9.0));
}

TEST(InscribedRectangle, OfASquareOnItsCornerIsHalfOfIt)
{
  std::vector<glm::dvec2> outline;
  const glm::dvec2 corners[] = { { 1.0, 0.0 }, { 0.0, 1.0 }, { -1.0, 0.0 }, { 0.0, -1.0 }, { 1.0, 0.0 } };
  constexpr int parts = 100;
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < parts; ++i)
    {
      outline.push_back(corners[side] + (i / double(parts)) * (corners[side + 1] - corners[side]));
    }
  }
  const Rectangle box = inscribedRectangle(outline);
  EXPECT_NEAR(box.size().x * box.size().y, 1.0, 1e-3); // of the square's 2
  EXPECT_NEAR(box.size().x, 1.0, 0.03);
  for (const glm::dvec2& corner : { box.low, box.high, glm::dvec2(box.low.x, box.high.y) })
  {
    EXPECT_LE(std::abs(corner.x) + std::abs(corner.y), 1.0 + 1e-12);
  }
}

TEST(InscribedRectangle, OfNothing)
{
  const Rectangle box = inscribedRectangle({ { 1.0, 0.0 }, { 1.0, 1.0 }, { 1.0, 2.0 } });
  EXPECT_EQ(box.size(), glm::dvec2(0.0));
}
