// Spreading and directional spectra, against closed forms and sums over the circle.
#include "sim/Angles.h"
#include "sim/DirectionalSpectrum.h"
#include "sim/SeaState.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace swellray;

namespace
{

constexpr double Rounding = 1e-12;
// Sums over 3600 equal angles: exact for such smooth periodic functions but for the corner of cos^2s at pi.
constexpr double CircleSum = 1e-9;
// Stated for shares.
constexpr double Share = 1e-6;
// What is asked of heights, periods, directions and spreads of a sampled sea.
constexpr double Sampled = 1e-4;

struct Circle
{
  double whole = 0.0;
  double east = 0.0;
};

Circle around(const DirectionalSpreading& spreading, double f)
{
  Circle sum;
  const int n = 3600;
  for (int i = 0; i < n; ++i)
  {
    const double a = -Pi + 2.0 * Pi * (i + 0.5) / n;
    const double d = spreading.density(f, a) * 2.0 * Pi / n;
    sum.whole += d;
    sum.east += d * std::cos(a);
  }
  return sum;
}

}

TEST(DirectionalSpreading, isADistributionWithTheSpreadAskedFor)
{
  for (const double degree : { 2.0, 10.0, 30.0, 60.0 })
  {
    for (const auto& spreading :
      { DirectionalSpreading::cosinePower(radians(degree)), DirectionalSpreading::wrappedNormal(radians(degree)) })
    {
      const Circle sum = around(spreading, 0.1);
      EXPECT_NEAR(sum.whole, 1.0, CircleSum) << degree;
      EXPECT_NEAR(degrees(std::sqrt(2.0 * (1.0 - sum.east))), degree, 1e-5 * degree);
      EXPECT_NEAR(spreading.spread(0.1), radians(degree), Rounding);
      EXPECT_NEAR(spreading.share(0.1, -Pi, Pi), 1.0, Share);
      EXPECT_NEAR(spreading.share(0.1, 0.0, Pi), 0.5, Share);
      EXPECT_NEAR(spreading.density(0.1, 0.3 + 2.0 * Pi) / spreading.density(0.1, 0.3), 1.0, Rounding);
    }
  }
}

TEST(DirectionalSpreading, hasselmannIsNarrowestAtThePeak)
{
  const double fp = 0.1;
  const auto measured = DirectionalSpreading::hasselmann(fp);
  const auto paper = DirectionalSpreading::hasselmann(fp, HasselmannExponent::Thon2000);
  for (const double f : { 0.06, 0.09, 0.1, 0.13, 0.3 })
  {
    EXPECT_NEAR(around(measured, f).whole, 1.0, 1e-7) << f; // the corner at pi is sharp where p is small
    EXPECT_GE(measured.spread(f), measured.spread(fp)) << f;
  }
  // r = p/(p + 1): p = 9.77 at the peak and 6.97 just below it.
  EXPECT_NEAR(measured.spread(fp), std::sqrt(2.0 / 10.77), Rounding);
  EXPECT_NEAR(measured.spread(fp * (1.0 - 1e-12)), std::sqrt(2.0 / 7.97), 1e-9);
  EXPECT_NEAR(paper.spread(fp * (1.0 - 1e-12)), std::sqrt(2.0 / 10.77), 1e-9);
  EXPECT_NEAR(measured.spread(2.0 * fp), std::sqrt(2.0 / (1.0 + 9.77 * std::pow(2.0, -2.34))), Rounding);
  // Normalisation of the paper, N = 2^(1-2p) pi Gamma(2p+1)/Gamma(p+1)^2, in closed form where p is whole.
  const double f = fp * std::pow(4.0 / 9.77, -1.0 / 2.34); // p = 4
  EXPECT_NEAR(measured.density(f, 0.0), 1.0 / (std::pow(2.0, -7.0) * Pi * 40320.0 / (24.0 * 24.0)), 1e-12);
}

TEST(DirectionalSpectrum, sampledSeasHaveTheirHeightPeriodsAndDirections)
{
  const double tp = 12.0;
  for (const double from : { 0.0, 200.0, 350.0 })
  {
    const auto spectrum = FrequencySpectrum::jonswap(2.2, tp);
    const auto spreading = DirectionalSpreading::cosinePower(radians(25.0));
    const auto grid = SpectralGrid::logarithmic(0.4 / tp, 12.0 / tp, 80, 72);
    const auto sea = DirectionalSpectrum::sample(grid, spectrum, spreading, headingFromNautical(from));
    const SeaParameters found = seaParameters(sea);
    EXPECT_NEAR(found.significantHeight, 2.2, 2.2 * Sampled);
    EXPECT_NEAR(std::remainder(found.meanDirectionFrom - from, 360.0), 0.0, 0.01);
    // Bins of 5 degrees widen a distribution by 5^2/12 degrees squared: 0.04 degrees at 25, less where hats are used.
    EXPECT_NEAR(found.spread, 25.0, 0.05);
    // Nodes 4.4 % apart; the peak is a parabola through three of them.
    EXPECT_NEAR(found.peakPeriod, tp, 0.01 * tp);
    // First moments are kept by the hats but for what lies beyond 12 fp: share (1/12)^3 of the tail.
    EXPECT_NEAR(found.meanPeriod01 / spectrum.meanPeriod01(), 1.0, 2e-3);
    EXPECT_NEAR(found.energyPeriod / spectrum.energyPeriod(), 1.0, 2e-3);
  }
}

TEST(DirectionalSpectrum, momentsComeToThoseOfTheSpectrumAsTheGridGetsFiner)
{
  const auto spectrum = FrequencySpectrum::piersonMoskowitz(1.0, 8.0);
  const auto spreading = DirectionalSpreading::wrappedNormal(radians(20.0));
  double before = 0.0;
  for (const std::size_t n : { 100u, 200u, 400u })
  {
    const auto grid = SpectralGrid::logarithmic(0.3 / 8.0, 60.0 / 8.0, n, 36);
    const SeaParameters found = seaParameters(DirectionalSpectrum::sample(grid, spectrum, spreading, 0.0));
    const double error = std::abs(found.energyPeriod / spectrum.energyPeriod() - 1.0);
    if (before > 0.0)
    {
      EXPECT_GT(before / error, 3.0) << n; // second order: 4
    }
    before = error;
  }
  EXPECT_LT(before, Sampled);
}

TEST(DirectionalSpectrum, interpolatesAndGoesRoundTheCircle)
{
  DirectionalSpectrum spectrum;
  spectrum.grid = SpectralGrid::logarithmic(0.1, 0.2, 2, 4);
  spectrum.density = { 1.0, 2.0, 3.0, 4.0, 3.0, 6.0, 9.0, 12.0 };
  EXPECT_DOUBLE_EQ(spectrum.interpolate(0.1, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(spectrum.interpolate(0.2, radians(90.0)), 6.0);
  EXPECT_NEAR(spectrum.interpolate(0.15, radians(45.0)), 3.0, Rounding);
  EXPECT_NEAR(spectrum.interpolate(0.1, radians(-45.0)), 2.5, Rounding); // between the last and the first
  EXPECT_NEAR(spectrum.interpolate(0.1, radians(675.0)), 2.5, Rounding);
  EXPECT_EQ(spectrum.interpolate(0.0999, 0.0), 0.0);
  EXPECT_EQ(spectrum.interpolate(0.21, 0.0), 0.0);
  // A sector ends where it ends.
  spectrum.grid.headings = { 0.0, 0.2, 0.4, 0.6 };
  EXPECT_FALSE(spectrum.grid.isCircle());
  EXPECT_EQ(spectrum.interpolate(0.1, 0.7), 0.0);
  EXPECT_EQ(spectrum.interpolate(0.1, -0.1), 0.0);
  EXPECT_DOUBLE_EQ(spectrum.interpolate(0.1, 0.6), 4.0);
}

TEST(DirectionalSpectrum, refusesGridsThatMakeNoSense)
{
  const auto spectrum = FrequencySpectrum::jonswap(1.0, 10.0);
  const auto spreading = DirectionalSpreading::cosinePower(0.4);
  SpectralGrid grid = SpectralGrid::logarithmic(0.03, 1.0, 20, 36);
  EXPECT_NO_THROW(DirectionalSpectrum::sample(grid, spectrum, spreading, 0.0));
  grid.frequencies[3] = grid.frequencies[2];
  EXPECT_THROW(DirectionalSpectrum::sample(grid, spectrum, spreading, 0.0), std::invalid_argument);
  EXPECT_THROW(DirectionalSpectrum::sample(SpectralGrid::logarithmic(0.2, 1.0, 20, 36), spectrum, spreading, 0.0),
    std::invalid_argument);
  EXPECT_THROW(DirectionalSpreading::cosinePower(0.0), std::invalid_argument);
  EXPECT_THROW(DirectionalSpreading::wrappedNormal(radians(90.0)), std::invalid_argument);
  EXPECT_THROW(DirectionalSpreading::hasselmann(0.0), std::invalid_argument);
  // Nothing at all: no periods, no direction, no height.
  DirectionalSpectrum none;
  none.grid = SpectralGrid::logarithmic(0.1, 0.2, 3, 4);
  none.density.assign(12, 0.0);
  EXPECT_EQ(seaParameters(none).significantHeight, 0.0);
  EXPECT_TRUE(std::isnan(seaParameters(none).meanDirectionFrom));
}

TEST(DirectionalSpectrum, resamplingKeepsHeightPeriodAndDirection)
{
  const auto sea = DirectionalSpectrum::sample(SpectralGrid::logarithmic(0.03, 0.6, 60, 72),
    FrequencySpectrum::jonswap(2.0, 11.0), DirectionalSpreading::cosinePower(radians(20.0)), 6.2);
  const SeaParameters before = seaParameters(sea);
  for (const std::size_t count : { 20u, 90u })
  {
    const SpectralGrid grid = SpectralGrid::logarithmic(0.03, 0.6, count, 60);
    const SeaParameters after = seaParameters(resample(sea, grid));
    EXPECT_NEAR(after.significantHeight, before.significantHeight, 1e-9);
    // m1 is a trapezoidal sum, which is not the integral of a linear density times f: (5 %)^2 of it.
    EXPECT_NEAR(after.meanPeriod01 / before.meanPeriod01, 1.0, 2.5e-3);
    EXPECT_NEAR(std::remainder(after.meanDirectionFrom - before.meanDirectionFrom, 360.0), 0.0, 0.01);
    // Dealing to nodes 6 degrees apart widens by at most (3 degrees)^2.
    EXPECT_NEAR(after.spread, before.spread, 0.25);
  }
  // A share outside of the grid is not lost, but the grid must hold most of it.
  const SpectralGrid narrow = SpectralGrid::logarithmic(0.05, 0.3, 20, 36);
  EXPECT_NEAR(seaParameters(resample(sea, narrow)).significantHeight, 2.0, 1e-9);
  EXPECT_THROW(resample(sea, SpectralGrid::logarithmic(0.12, 0.3, 20, 36)), std::invalid_argument);
}

TEST(DirectionalSpectrum, bandHoldsTheShareAskedFor)
{
  const auto sea = DirectionalSpectrum::sample(SpectralGrid::logarithmic(0.03, 0.8, 200, 36),
    FrequencySpectrum::piersonMoskowitz(1.0, 10.0), DirectionalSpreading::cosinePower(0.4), 0.0);
  const auto band = energyBand(sea, 0.9);
  // exp(-5/4 x^-4) = 0.05 and 0.95
  EXPECT_NEAR(band[0], 0.1 * std::pow(1.25 / std::log(20.0), 0.25), 0.002);
  EXPECT_NEAR(band[1], 0.1 * std::pow(1.25 / -std::log(0.95), 0.25), 0.01);
}

TEST(SeaState, makesTheSpectrumThatIsNamed)
{
  SeaState sea;
  EXPECT_EQ(sea.spectrum().shape(), SpectrumShape::Jonswap);
  EXPECT_NEAR(sea.spectrum().significantHeight(), 2.0, 1e-7);
  sea.shape = SpectrumShape::Tma;
  EXPECT_THROW(sea.spectrum(), std::invalid_argument);
  sea.depth = 10.0;
  EXPECT_EQ(sea.spectrum().shape(), SpectrumShape::Tma);
  sea.wind = 12.0;
  EXPECT_NEAR(sea.spectrum().peakFrequency(), 0.13 * 9.81 / 12.0, 1e-12);
  sea.fetch = 1e5;
  EXPECT_GT(sea.spectrum().peakFrequency(), 0.13 * 9.81 / 12.0); // young seas are shorter
  const SpectralGrid grid = spectralGridOf(sea.spectrum(), 20, 36);
  EXPECT_NEAR(sea.spectrum().shareBelow(grid.frequencies.back()) - sea.spectrum().shareBelow(grid.frequencies.front()),
    0.995, 1e-6);
}
