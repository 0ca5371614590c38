// Rays over a gridded Gaussian shoal: what a C2 spline of the depth leaves of the accuracy of the formula.
#include "RayComparison.h"

#include "sim/BuiltinSeafloor.h"
#include "sim/SplineSeafloor.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <vector>

using namespace swellray;
using namespace swellray::reference;

namespace
{

constexpr double Tolerance = 1e-12;
constexpr double Sigma = 300.0; // m
constexpr const char* Shoal = "shoal:kind=gauss,h0=20,a=14,sg=300,x0=-3600,x1=3600,y0=-3600,y1=3600";
constexpr double Period = 10.0;
constexpr double Distance = 1800.0; // m from the start to abreast of the shoal
constexpr double Inside = 2700.0;   // half width of the grid, m
constexpr double Oblique = 0.7;     // rad, heading across the grid

// Places of the rays aside from the shoal's centre, m. Those of the flank are turned by up to 0.85 rad: from the oblique
// heading to that of the grid's rows and beyond. The others stay 0.12 rad and more from rows and columns.
const std::vector<double> Others{ 0.0, 30.0, 75.0, 150.0, -180.0, 450.0, 600.0, 750.0 };
const std::vector<double> Flank{ 225.0, 300.0 };

// Where a node lies beside the shoal's centre, cells: by symmetry on a node and between nodes, and elsewhere.
const std::array<double, 4> Offsets{ 0.0, 0.5, 0.37, 0.2 };

/** Differences to the rays of the formula. */
struct GridErrors
{
  double position = 0.0;    ///< largest, m
  double theta = 0.0;       ///< largest, rad
  double width = 0.0;       ///< largest, relative where |q| > 1
  double positionSum = 0.0; ///< of squares
  double widthSum = 0.0;
};

ElevationGrid sample(const Seafloor& seafloor, double spacing, double offset)
{
  ElevationGrid grid;
  grid.origin = glm::dvec2(offset * spacing - Inside);
  grid.spacing = glm::dvec2(spacing);
  grid.columns = grid.rows = static_cast<std::size_t>(2.0 * Inside / spacing);
  grid.elevation.resize(grid.columns * grid.rows);
  for (std::size_t j = 0; j < grid.rows; ++j)
  {
    for (std::size_t i = 0; i < grid.columns; ++i)
    {
      grid.at(i, j) = seafloor.elevation(grid.node(i, j));
    }
  }
  return grid;
}

void addErrors(
  const Seafloor& exact, const Seafloor& gridded, double heading, const std::vector<double>& aside, GridErrors& errors)
{
  const RayMedium formula = mediumOf(exact, Period, 0.1);
  const RayMedium grid = mediumOf(gridded, Period, 0.1);
  const glm::dvec2 along(std::cos(heading), std::sin(heading));
  const glm::dvec2 across(-along.y, along.x);
  for (const double b : aside)
  {
    const glm::dvec2 from = b * across - Distance * along;
    HamiltonianRay a(formula, startHeading(formula, from, heading, across), Tolerance);
    HamiltonianRay c(grid, startHeading(grid, from, heading, across), Tolerance);
    RayPoint p;
    RayPoint q;
    // Through the cusp at 2021 m and beyond.
    for (int i = 1; i <= 40; ++i)
    {
      ASSERT_TRUE(a.advance(FrontMeasure::Length, 90.0 * i, p));
      ASSERT_TRUE(c.advance(FrontMeasure::Length, 90.0 * i, q));
      const double apart = glm::length(p.position - q.position);
      const double turn = p.rayDirection.x * q.rayDirection.y - p.rayDirection.y * q.rayDirection.x;
      const double width = std::abs(p.tubeWidth - q.tubeWidth) / std::max(1.0, std::abs(p.tubeWidth));
      errors.position = std::max(errors.position, apart);
      errors.theta = std::max(errors.theta, std::abs(turn));
      errors.width = std::max(errors.width, width);
      errors.positionSum += apart * apart;
      errors.widthSum += width * width;
    }
  }
}

/** Errors at sigma/spacing = 6, 12, 24 and 48. */
std::array<GridErrors, 4> refine(double heading, const std::vector<double>& aside, const std::vector<double>& offsets)
{
  const auto exact = makeBuiltinSeafloor(Shoal);
  std::array<GridErrors, 4> errors;
  double cells = 6.0;
  for (GridErrors& now : errors)
  {
    for (const double offset : offsets)
    {
      addErrors(*exact, SplineSeafloor(sample(*exact, Sigma / cells, offset)), heading, aside, now);
    }
    std::cout << "sigma/spacing " << cells << ": position " << now.position << " m, theta " << now.theta
              << " rad, width " << now.width << '\n';
    cells *= 2.0;
  }
  return errors;
}

// Slope of the straight line fitted to four errors in logarithms.
double order(const std::array<GridErrors, 4>& errors, double GridErrors::*what, double power = 1.0)
{
  const auto halvings = [&](int i) { return -power * std::log2(errors[i].*what); };
  return (3.0 * (halvings(3) - halvings(0)) + halvings(2) - halvings(1)) / 10.0;
}

}

// Errors known for this shoal at sigma/spacing = 12 and 48, other rays over another grid: 1.3e-3 and 1e-5 m, 1.5e-6 and
// 2e-8 rad, 2.6e-4 and 2e-6 of the tube. Which rays are the worst, and how the grid lies to them, makes a factor of 3.
constexpr double OtherRays = 3.0;

bool isNear(double value, double known)
{
  return value < OtherRays * known && value > known / OtherRays;
}

TEST(HamiltonianRayGrid, convergesAcrossTheGrid)
{
  // An oblique ray sees the errors of the spline's gradient (order 3) and curvature (order 2), of no mean over a cell,
  // change their sign from cell to cell. Summed along the ray, once for the heading and twice for the place, they leave an order more.
  const auto errors = refine(Oblique, Others, { Offsets.begin(), Offsets.end() });
  EXPECT_GT(order(errors, &GridErrors::positionSum, 0.5), 3.8);
  EXPECT_GT(order(errors, &GridErrors::theta), 3.8);
  EXPECT_TRUE(isNear(errors[1].position, 1.3e-3)) << errors[1].position;
  EXPECT_TRUE(isNear(errors[1].theta, 1.5e-6)) << errors[1].theta;
  EXPECT_TRUE(isNear(errors[3].position, 1e-5)) << errors[3].position;
  EXPECT_LT(errors[3].theta, OtherRays * 2e-8);
  // The tube's error is soon that of its integration: a thousand times the tolerance in each of some 300 steps, carried on
  // by tubes that grow six-fold.
  constexpr double integration = 1e3 * Tolerance * 300.0 * 6.0;
  EXPECT_GT(0.5 * std::log2(errors[0].widthSum / errors[1].widthSum), 3.5);
  EXPECT_LT(errors[2].width, integration);
  EXPECT_LT(errors[3].width, integration);
}

TEST(HamiltonianRayGrid, losesAnOrderWhereARayTurnsAlongTheRows)
{
  // Where a ray comes to run along a row of cells it meets the same error in many of them: over a stretch of the root of a cell
  // by the ray's radius, so that half of the order gained is lost, and the tube is left with its 2 and a half.
  const auto errors = refine(Oblique, Flank, { Offsets.begin(), Offsets.end() });
  EXPECT_GT(order(errors, &GridErrors::positionSum, 0.5), 3.3);
  EXPECT_GT(order(errors, &GridErrors::theta), 3.3);
  EXPECT_GT(order(errors, &GridErrors::widthSum, 0.5), 2.3);
  EXPECT_TRUE(isNear(errors[1].position, 1.3e-3)) << errors[1].position;
  EXPECT_TRUE(isNear(errors[1].theta, 1.5e-6)) << errors[1].theta;
  EXPECT_TRUE(isNear(errors[1].width, 2.6e-4)) << errors[1].width;
}

TEST(HamiltonianRayGrid, convergesAlongTheGrid)
{
  // A ray that keeps its place between two rows meets the same error in every cell: what is left are the orders of the
  // spline's gradient and curvature.
  const auto errors = refine(0.0, { 0.0, 30.0, 75.0, 150.0, -180.0, 225.0, 300.0, 450.0, 600.0, 750.0 }, { 0.37 });
  EXPECT_GT(order(errors, &GridErrors::position), 2.9);
  EXPECT_GT(order(errors, &GridErrors::theta), 2.9);
  EXPECT_GT(order(errors, &GridErrors::width), 1.9);
  EXPECT_LT(errors[1].position, 0.05); // 2 cm were seen, on cells of 25 m
}

TEST(HamiltonianRayGrid, isExactOnAGridOfAPlaneBeach)
{
  // A spline reproduces a plane: over it the grid is as good as the formula, at any spacing.
  const auto exact = makeBuiltinSeafloor("plane:s=0.02,facing=70,x0=-3000,x1=3000,y0=-3000,y1=3000");
  const SplineSeafloor grid(sample(*exact, 180.0, 0.3));
  GridErrors errors;
  const RayMedium a = mediumOf(*exact, Period, 0.1);
  const RayMedium b = mediumOf(grid, Period, 0.1);
  const glm::dvec2 from(2000.0, 500.0);
  HamiltonianRay onFormula(a, startHeading(a, from, 2.8, { 0.0, 1.0 }), Tolerance);
  HamiltonianRay onGrid(b, startHeading(b, from, 2.8, { 0.0, 1.0 }), Tolerance);
  RayPoint p;
  RayPoint q;
  for (int i = 1; i <= 18; ++i)
  {
    ASSERT_TRUE(onFormula.advance(FrontMeasure::Length, 100.0 * i, p));
    ASSERT_TRUE(onGrid.advance(FrontMeasure::Length, 100.0 * i, q));
    errors.position = std::max(errors.position, glm::length(p.position - q.position));
    errors.width = std::max(errors.width, std::abs(p.tubeWidth / q.tubeWidth - 1.0));
  }
  // Both integrate to tolerance 1e-12, with other steps.
  EXPECT_LT(errors.position, 5e-9);
  EXPECT_LT(errors.width, 1e-9);
}
