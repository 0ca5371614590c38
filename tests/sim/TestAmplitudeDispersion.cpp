#include "sim/AmplitudeDispersion.h"

#include "sim/Angles.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace swellray;

namespace
{

TEST(AmplitudeDispersion, SolvesItsEquation)
{
  constexpr double g = StandardGravity;
  for (const double depth : { 0.5, 2.0, 10.0, 60.0 })
  {
    for (const double steepness : { 0.0, 0.01, 0.1, 0.3 })
    {
      const double omega = 2.0 * Pi / 8.0;
      const double amplitude = steepness * std::min(depth, 10.0);
      const double k = finiteAmplitudeWavenumber(omega, depth, amplitude);
      const double q = k * depth;
      const double e = k * amplitude;
      const double t = std::tanh(q);
      const double s = std::sinh(q);
      const double d = (std::cosh(4.0 * q) + 8.0 - 2.0 * t * t) / (8.0 * std::pow(s, 4));
      const double right = g * k * (1.0 + std::pow(t, 5) * e * e * d) * std::tanh(q + std::pow(q / s, 4) * e);
      EXPECT_NEAR(right / (omega * omega), 1.0, 1e-12) << depth << " m, " << steepness;
      EXPECT_LE(k, solveWavenumber(omega, depth) * (1.0 + 1e-14));
    }
  }
}

TEST(AmplitudeDispersion, HasTheLimitsOfLinearStokesAndHedgesWaves)
{
  const double omega = 2.0 * Pi / 5.0;
  EXPECT_EQ(finiteAmplitudeWavenumber(omega, 7.0, 0.0), solveWavenumber(omega, 7.0));
  // Deep: omega^2 = g k (1 + (k a)^2).
  const double deep = finiteAmplitudeWavenumber(omega, 500.0, 0.5);
  EXPECT_NEAR(StandardGravity * deep * (1.0 + deep * deep * 0.25), omega * omega, 1e-11);
  // Shallow: omega^2 = g k tanh k (h + a), to the order of (kh)^2.
  const double slow = 2.0 * Pi / 600.0;
  const double shallow = finiteAmplitudeWavenumber(slow, 2.0, 0.4);
  EXPECT_NEAR(shallow / solveWavenumber(slow, 2.4), 1.0, 1e-4);
}

}
