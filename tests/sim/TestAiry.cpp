#include "sim/Airy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace swellray;

// The digits of the table.
constexpr double TableRounding = 1e-8;

TEST(Airy, IsThatOfTheTables)
{
  // Abramowitz and Stegun 1964, table 10.11: x, Ai, Ai'.
  const double table[][3] = { { 0.0, 0.35502805, -0.25881940 }, { 0.5, 0.23169361, -0.22491053 },
    { 1.0, 0.13529242, -0.15914744 }, { -0.5, 0.47572809, -0.20408167 }, { -1.0, 0.53556088, -0.01016057 },
    { -2.0, 0.22740743, 0.61825902 }, { -4.0, -0.07026553, -0.79062858 } };
  for (const auto& [x, value, slope] : table)
  {
    EXPECT_NEAR(airy(x).value, value, TableRounding) << x;
    EXPECT_NEAR(airy(x).slope, slope, TableRounding) << x;
  }
}

TEST(Airy, SolvesItsEquation)
{
  // Ai'' = x Ai, by differences of the slope; their error is h^2/6 of the fourth derivative.
  constexpr double h = 1e-4;
  for (double x = -20.05; x < 8.0; x += 0.37)
  {
    const double second = (airy(x + h).slope - airy(x - h).slope) / (2.0 * h);
    const double first = (airy(x + h).value - airy(x - h).value) / (2.0 * h);
    const double size = 1.0 + std::abs(x * x * x);
    EXPECT_NEAR(second, x * airy(x).value, 1e-8 * size) << x;
    EXPECT_NEAR(first, airy(x).slope, 1e-8 * size) << x;
  }
}

TEST(Airy, IsOneFunctionWhereTheFormulasMeet)
{
  for (const double x : { -1.0, 1.0 })
  {
    const AiryValue inside = airy(x * (1.0 - 1e-12));
    const AiryValue outside = airy(x * (1.0 + 1e-12));
    EXPECT_NEAR(inside.value, outside.value, 1e-11) << x;
    EXPECT_NEAR(inside.slope, outside.slope, 1e-11) << x;
  }
}

}
