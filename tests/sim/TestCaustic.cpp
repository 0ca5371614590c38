#include "sim/Caustic.h"

#include "sim/Angles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace swellray;

// Ai(-z) (Abramowitz and Stegun 1964, table 10.11).
struct AiryValue
{
  double z;
  double airy;
};
constexpr AiryValue AiryTable[] = { { 0.1, 0.38084867 }, { 0.5, 0.47572809 }, { 1.0, 0.53556088 } };

// The digits of the table.
constexpr double TableRounding = 1e-8;

// A plane fold: rays of equal amplitude (z0/z)^(1/4), whose exact sum is 2 sqrt(pi) z0^(1/4) Ai(-z).
std::complex<double> planeFold(double z, double z0, double ratio = 1.0)
{
  const double half = 2.0 / 3.0 * std::pow(z, 1.5);
  const double amplitude = std::pow(z0 / z, 0.25);
  return foldWave({ amplitude, 40.0 - half }, { ratio * amplitude, 40.0 + half });
}

TEST(Caustic, FoldIsTheAiryFunction)
{
  constexpr double z0 = 7.5;
  for (const AiryValue& value : AiryTable)
  {
    const double expected = 2.0 * std::sqrt(Pi) * std::pow(z0, 0.25) * value.airy;
    const std::complex<double> wave = planeFold(value.z, z0) * std::polar(1.0, 0.25 * Pi - 40.0);
    EXPECT_NEAR(wave.real(), expected, 6.0 * TableRounding) << value.z;
    EXPECT_NEAR(wave.imag(), 0.0, 1e-12) << value.z;
  }
}

TEST(Caustic, FoldIsTheSumOfRaysFarFromIt)
{
  // The rest falls with the phase between the branches, 5/36 of the inverse of its half at most in either part.
  for (const double half : { 10.0, 100.0, 900.0 })
  {
    const FoldBranch before{ 1.3, 40.0 - half };
    const FoldBranch behind{ 0.7, 40.0 + half };
    const std::complex<double> rays =
      std::polar(before.amplitude, before.phase) + std::polar(behind.amplitude, behind.phase - 0.5 * Pi);
    EXPECT_LT(std::abs(foldWave(before, behind) - rays), 2.0 * 7.0 / 72.0 / half * 2.0) << half;
    EXPECT_GT(std::abs(foldWave(before, behind) - rays), 0.0) << half;
  }
}

TEST(Caustic, FoldIsFiniteOnIt)
{
  constexpr double z0 = 7.5;
  const double expected = 2.0 * std::sqrt(Pi) * std::pow(z0, 0.25) * 0.355028053887817; // Ai(0)
  EXPECT_NEAR(std::abs(planeFold(1e-7, z0)), expected, 1e-5);
}

TEST(Caustic, BranchesOutOfOrderAreRays)
{
  const std::complex<double> wave = foldWave({ 1.0, 2.0 }, { 1.0, 2.0 });
  EXPECT_NEAR(std::abs(wave), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(std::abs(foldWave({ 1.0, 3.0 }, { 0.0, 2.0 })), 1.0, 1e-12);
}

TEST(Caustic, ModulusIsThatOfBothAiryFunctions)
{
  // Ai(-z), Bi(-z) (Abramowitz and Stegun 1964, table 10.11).
  const double table[][3] = { { 0.1, 0.38084867, 0.56999904 }, { 0.5, 0.47572809, 0.38035266 },
    { 1.0, 0.53556088, 0.10399739 } };
  for (const auto& [z, airy, other] : table)
  {
    const double expected = std::sqrt(Pi) * std::pow(z, 0.25) * std::hypot(airy, other);
    EXPECT_NEAR(foldModulus(2.0 / 3.0 * std::pow(z, 1.5)), expected, 4.0 * TableRounding) << z;
  }
  EXPECT_EQ(foldModulus(0.0), 0.0);
}

TEST(Caustic, ModulusGrowsToOne)
{
  double before = 0.0;
  for (double half = 1e-6; half < 1e5; half *= 1.1)
  {
    const double now = foldModulus(half);
    EXPECT_GT(now, before) << half;
    before = now;
  }
  EXPECT_NEAR(before, 1.0, 1e-10);
  // Where the series begins.
  EXPECT_NEAR(foldModulus(20.0 * (1.0 + 1e-12)) - foldModulus(20.0), 0.0, 1e-8);
}

TEST(Caustic, PeakIsTheLimitOnTheCaustic)
{
  RayCaustic caustic;
  caustic.fanWavenumber = 0.07;
  caustic.widthRate = -2e-3;
  caustic.alongRate = 1.5;
  caustic.alongChange = 0.0;
  const double curvature = roundedCurvature(caustic);
  EXPECT_NEAR(curvature, 2e-3 / 1.5, 1e-12);
  // The rest falls as z, the square of the way.
  const double way = 1e-3;
  const double half = caustic.fanWavenumber * curvature * curvature * way * way * way / 3.0;
  EXPECT_NEAR(foldModulus(half) / std::sqrt(2e-3 * way), foldPeak(caustic, curvature), 1e-6);
}

TEST(Caustic, PeakOfACuspIsPearceysIntegral)
{
  // |integral of exp(i u^4)| = 2 Gamma(5/4); by stationary phase next to the cusp (Caustic.h).
  RayCaustic caustic;
  caustic.fanWavenumber = 0.07;
  caustic.alongRate = 0.0;
  caustic.alongChange = -0.02;
  for (const double rate : { 1e-3, -4e-3 })
  {
    caustic.widthRate = rate;
    const double fourth = caustic.fanWavenumber * rate * rate * 0.02; // derivative of the phase by lambda
    const double expected = std::sqrt(caustic.fanWavenumber * std::abs(rate) / (2.0 * Pi)) *
      std::pow(24.0 / fourth, 0.25) * 2.0 * std::tgamma(1.25);
    EXPECT_NEAR(foldPeak(caustic, roundedCurvature(caustic)), expected, 1e-9 * expected) << rate;
  }
}

TEST(Caustic, IsTheSameOnAnyMap)
{
  RayCaustic plane;
  plane.fanWavenumber = 0.07;
  plane.widthRate = -2e-3;
  plane.alongRate = 0.4;
  plane.alongChange = 0.01;
  RayCaustic map = plane;
  map.scale = 1.6;
  map.fanWavenumber /= map.scale;
  map.alongRate *= map.scale;
  map.alongChange *= map.scale;
  EXPECT_NEAR(roundedCurvature(map) * map.scale, roundedCurvature(plane), 1e-15);
  EXPECT_NEAR(foldPeak(map, roundedCurvature(map)), foldPeak(plane, roundedCurvature(plane)), 1e-12);
}

}
