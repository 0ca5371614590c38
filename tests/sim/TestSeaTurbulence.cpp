// Turbulence: the spectrum of its noise, and what is asked of the sum.
#include "sim/Angles.h"
#include "sim/SeaTurbulence.h"

#include <glm/gtc/noise.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace swellray;

namespace
{

// Means of 300,000 pairs: 1/500; gradients of neighbouring corners are taken to have nothing in common, which the hash of the
// noise keeps to some percent.
constexpr double Correlation = 0.03;

// The relaxation is exact; the slope is a difference over 4 % of the wavenumber, the table has steps of 1 %.
constexpr double Slope = 0.1;
constexpr double Level = 0.01;

TurbulenceTarget target(double slope)
{
  TurbulenceTarget wanted;
  wanted.wavenumber = 0.3;
  wanted.level = 0.2;
  wanted.slope = slope;
  return wanted;
}

}

TEST(SeaTurbulence, noiseHasTheSpectrumOfItsConstruction)
{
  const NoiseSpectrum spectrum;
  EXPECT_NEAR(spectrum.shareBelow(100.0), 1.0, 1e-12);
  EXPECT_EQ(spectrum.shareBelow(0.0), 0.0);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(0.0, 289.0);
  for (const double lag : { 0.0, 0.3, 0.6, 0.9, 1.5 })
  {
    // The mean product of values so far apart, over all directions in the plane, is that of the spectrum times J0.
    double wanted = 0.0;
    constexpr double Step = 0.01;
    for (double k = 0.5 * Step; k < 16.0; k += Step)
    {
      wanted += spectrum.density(k) * std::cyl_bessel_j(0.0, k * lag) * Step;
    }
    double sum = 0.0;
    constexpr int Count = 300000;
    for (int i = 0; i < Count; ++i)
    {
      const glm::dvec3 p(any(random), any(random), any(random));
      const double angle = any(random);
      sum += glm::perlin(p) * glm::perlin(p + lag * glm::dvec3(0.0, std::cos(angle), std::sin(angle)));
    }
    EXPECT_NEAR(sum / Count / NoiseSpectrum::Variance, wanted, Correlation) << lag;
  }
}

TEST(SeaTurbulence, hasTheLevelAndTheSlopeAskedFor)
{
  for (const double slope : { -0.5, -1.5, -2.5, -3.0, -3.5, -4.5 })
  {
    const SeaTurbulence turbulence(target(slope));
    EXPECT_NEAR(turbulence.density(0.3), 0.2, Level * 0.2) << slope;
    const double here =
      std::log(turbulence.density(0.3 * 1.02) / turbulence.density(0.3 * 0.98)) / std::log(1.02 / 0.98);
    EXPECT_NEAR(here, slope, Slope) << slope;
    EXPECT_GE(turbulence.multiplier(), 1.5);
    EXPECT_LE(turbulence.multiplier(), 3.0);
  }
}

TEST(SeaTurbulence, fallsOnAsAPowerOfThree)
{
  const SeaTurbulence turbulence(target(-3.0));
  // Beyond kmax by the cube, but for the ripple of its octaves, some ten percent of the exponent over four of them.
  const double m = turbulence.multiplier();
  const double fall =
    std::log(turbulence.density(0.3 * m * m * m * m) / turbulence.density(0.3)) / std::log(m * m * m * m);
  EXPECT_NEAR(fall, -3.0, 0.3);
}

TEST(SeaTurbulence, hasTheVarianceItTells)
{
  const SeaTurbulence turbulence(target(-3.0));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-2000.0, 2000.0);
  double square = 0.0;
  double coarse = 0.0;
  constexpr int Count = 100000;
  for (int i = 0; i < Count; ++i)
  {
    const glm::dvec2 p(any(random), any(random));
    const double time = any(random);
    square += std::pow(turbulence.height(p, time, 0.0), 2.0) / Count;
    coarse += i % 10 ? 0.0 : std::pow(turbulence.height(p, time, 4.0), 2.0) * 10.0 / Count;
  }
  // The noise repeats after 289 cells, so that there are some 80,000 different ones at most: a percent or two.
  EXPECT_NEAR(square, turbulence.variance(), 0.05 * turbulence.variance());
  EXPECT_LT(coarse, 0.9 * square);
  EXPECT_EQ(turbulence.height({ 3.0, 4.0 }, 5.0, 1e4), 0.0);
  EXPECT_NEAR(turbulence.varianceAbove(0.0), turbulence.variance(), 1e-12);
  EXPECT_LT(turbulence.varianceAbove(0.3), 0.5 * turbulence.variance());
}

TEST(SeaTurbulence, repeatsOverATile)
{
  TurbulenceTarget wanted = target(-3.0);
  wanted.tile = 150.0;
  wanted.heading = 1.2;
  const SeaTurbulence turbulence(wanted);
  for (const glm::dvec2 p : { glm::dvec2(1.0, 2.0), glm::dvec2(77.7, -30.3) })
  {
    const double here = turbulence.height(p, 13.0, 0.0);
    EXPECT_NE(here, 0.0);
    EXPECT_NEAR(turbulence.height(p + glm::dvec2(150.0, 0.0), 13.0, 0.0), here, 1e-9);
    EXPECT_NEAR(turbulence.height(p + glm::dvec2(-300.0, 150.0), 13.0, 0.0), here, 1e-9);
    EXPECT_NE(turbulence.height(p, 14.0, 0.0), here);
  }
}

TEST(SeaTurbulence, refusesWhatMakesNone)
{
  TurbulenceTarget wanted = target(-3.0);
  wanted.wavenumber = 0.0;
  EXPECT_THROW(SeaTurbulence{ wanted }, std::invalid_argument);
  wanted = target(std::nan(""));
  EXPECT_THROW(SeaTurbulence{ wanted }, std::invalid_argument);
}
