// The tabulated profile against Gerstner's curve itself.
#include "sim/Angles.h"
#include "sim/TrochoidTable.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace swellray;

namespace
{

// Of a table of 32 steepnesses between which it is linear: a step squared over 8 times the second derivative, about 5.
constexpr double Table = 1e-3;

const TrochoidTable Profile;

}

TEST(TrochoidTable, isACosineWithoutSteepness)
{
  for (double phase = -7.0; phase < 7.0; phase += 0.1)
  {
    EXPECT_NEAR(Profile.value(phase, 0.0), std::cos(phase), 1e-8) << phase; // (2 pi/256)^4/384
  }
}

TEST(TrochoidTable, followsTheCurveOfGerstner)
{
  for (const double steepness : { 0.1, 0.33, 0.6, 0.9 })
  {
    const double scale = std::sqrt(0.5 / (0.5 - 0.25 * steepness * steepness));
    for (double u = -3.0; u < 3.1; u += 0.05)
    {
      EXPECT_NEAR(Profile.value(u - steepness * std::sin(u), steepness), scale * (std::cos(u) + 0.5 * steepness), Table)
        << steepness << ' ' << u;
    }
  }
}

TEST(TrochoidTable, hasNoMeanAndTheMeanSquareOfACosine)
{
  for (const double steepness : { 0.0, 0.4, 0.8, 1.5 })
  {
    double sum = 0.0;
    double square = 0.0;
    constexpr int Count = 20000;
    for (int i = 0; i < Count; ++i)
    {
      const double value = Profile.value(2.0 * Pi * i / Count, steepness);
      sum += value;
      square += value * value;
    }
    EXPECT_NEAR(sum / Count, 0.0, Table);
    EXPECT_NEAR(square / Count, 0.5, Table);
  }
  // Crests are sharper than troughs.
  EXPECT_GT(Profile.value(0.0, 0.8), -Profile.value(Pi, 0.8));
  EXPECT_LT(Profile.value(0.5 * Pi, 0.8), 0.0);
}
