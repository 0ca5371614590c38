// Directions by maximum entropy have the moments they are made of.
#include "sim/Angles.h"
#include "sim/MaximumEntropySpreading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

using namespace swellray;

namespace
{

// The trapezoidal rule over the circle converges faster than any power.
constexpr double Rounding = 1e-9;

}

TEST(MaximumEntropySpreading, hasItsMoments)
{
  const double cases[][4] = { { 0.0, 0.0, 0.0, 0.0 }, { 0.8, 1.0, 0.5, 1.0 }, { 0.6, -2.0, 0.4, -1.7 },
    { 0.3, 0.5, 0.6, 0.4 }, { 0.9, 3.0, 0.7, 3.02 } };
  for (const auto& moments : cases)
  {
    const MaximumEntropySpreading spreading(moments[0], moments[1], moments[2], moments[3]);
    double sums[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
    constexpr int Count = 20000;
    for (int i = 0; i < Count; ++i)
    {
      const double angle = 2.0 * Pi * i / Count;
      const double density = spreading.density(angle);
      EXPECT_GT(density, 0.0);
      const double part = density * 2.0 * Pi / Count;
      sums[0] += part;
      sums[1] += part * std::cos(angle);
      sums[2] += part * std::sin(angle);
      sums[3] += part * std::cos(2.0 * angle);
      sums[4] += part * std::sin(2.0 * angle);
    }
    EXPECT_NEAR(sums[0], 1.0, Rounding);
    EXPECT_NEAR(sums[1], moments[0] * std::cos(moments[1]), Rounding);
    EXPECT_NEAR(sums[2], moments[0] * std::sin(moments[1]), Rounding);
    EXPECT_NEAR(sums[3], moments[2] * std::cos(2.0 * moments[3]), Rounding);
    EXPECT_NEAR(sums[4], moments[2] * std::sin(2.0 * moments[3]), Rounding);
  }
}

TEST(MaximumEntropySpreading, sharesMakeAWhole)
{
  std::vector<double> middles;
  for (int j = 0; j < 36; ++j)
  {
    middles.push_back(2.0 * Pi * j / 36.0);
  }
  const std::vector<double> shares = MaximumEntropySpreading(0.8, 1.0, 0.5, 1.0).shares(middles);
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
  EXPECT_GT(shares[6], shares[20]);
}

TEST(MaximumEntropySpreading, refusesMomentsOfNoDistribution)
{
  EXPECT_THROW(MaximumEntropySpreading(1.0, 0.0, 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(MaximumEntropySpreading(0.9, 0.0, 0.1, 0.0), std::invalid_argument); // narrow and wide at once
  EXPECT_THROW(MaximumEntropySpreading(-0.1, 0.0, 0.0, 0.0), std::invalid_argument);
  EXPECT_THROW(MaximumEntropySpreading(std::nan(""), 0.0, 0.0, 0.0), std::invalid_argument);
}
