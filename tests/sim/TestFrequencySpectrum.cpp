// Spectra over frequency, against closed-form moments and sums by brute force.
#include "sim/Angles.h"
#include "sim/FrequencySpectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace swellray;

namespace
{

// Stated for moments.
constexpr double MomentError = 1e-8;
// Of a peak found on a flat maximum.
constexpr double PeakError = 1e-7;
// Brute force by Simpson's rule over 200,000 equal steps, cut off at 100 times the peak: tail of m0 (1/100)^4, of m1
// (1/100)^3.
constexpr double BruteForce = 3e-6;

double simpson(const FrequencySpectrum& spectrum, int order)
{
  const double from = 0.25 * spectrum.peakFrequency();
  const double to = 100.0 * spectrum.peakFrequency();
  const int n = 200000;
  const double h = (to - from) / n;
  double sum = 0.0;
  for (int i = 0; i <= n; ++i)
  {
    const double f = from + h * i;
    sum += (i == 0 || i == n ? 1.0 : (i % 2 ? 4.0 : 2.0)) * std::pow(f, order) * spectrum.density(f);
  }
  return sum * h / 3.0;
}

// Integral of A f^(n-5) exp(-b f^-4): A b^(n/4-1) Gamma(1 - n/4)/4.
double piersonMoskowitzMoment(double a, double b, int n)
{
  return 0.25 * a * std::pow(b, 0.25 * n - 1.0) * std::tgamma(1.0 - 0.25 * n);
}

}

TEST(FrequencySpectrum, piersonMoskowitzHasItsMoments)
{
  const double tp = 11.0;
  const FrequencySpectrum spectrum = FrequencySpectrum::piersonMoskowitz(2.5, tp);
  const double b = 1.25 * std::pow(tp, -4.0);
  const double a = 4.0 * b * 2.5 * 2.5 / 16.0; // m0 = a/(4 b)
  for (int n = -2; n <= 3; ++n)
  {
    const double exact = piersonMoskowitzMoment(a, b, n);
    EXPECT_NEAR(spectrum.moment(n), exact, MomentError * exact) << n;
  }
  EXPECT_NEAR(spectrum.significantHeight(), 2.5, MomentError);
  EXPECT_DOUBLE_EQ(spectrum.peakPeriod(), tp);
  // Tm01 and Tm02 of this shape: 0.7718 and 0.7104 Tp, from the same Gamma functions.
  EXPECT_NEAR(spectrum.meanPeriod01() / tp, std::pow(1.25, -0.25) / std::tgamma(0.75), MomentError);
  EXPECT_NEAR(spectrum.meanPeriod02() / tp, std::pow(1.25 * Pi, -0.25), MomentError);
  EXPECT_NEAR(spectrum.shareBelow(1.0 / tp), std::exp(-1.25), MomentError);
}

TEST(FrequencySpectrum, jonswapIsPiersonMoskowitzWithAHigherPeak)
{
  const FrequencySpectrum flat = FrequencySpectrum::jonswap(2.0, 9.0, 1.0);
  const FrequencySpectrum pm = FrequencySpectrum::piersonMoskowitz(2.0, 9.0);
  const FrequencySpectrum peaked = FrequencySpectrum::jonswap(2.0, 9.0, 3.3);
  const double fp = 1.0 / 9.0;
  EXPECT_DOUBLE_EQ(flat.density(0.13), pm.density(0.13));
  // The ratio of the two at the peak, over that far above it, is gamma.
  EXPECT_NEAR(peaked.density(fp) / pm.density(fp) / (peaked.density(4.0 * fp) / pm.density(4.0 * fp)), 3.3, 1e-12);
  // At x = 0.93 and 1.09 one standard deviation off: gamma^exp(-1/2).
  for (const double x : { 0.93, 1.09 })
  {
    EXPECT_NEAR(peaked.density(x * fp) / pm.density(x * fp) / (peaked.density(4.0 * fp) / pm.density(4.0 * fp)),
      std::pow(3.3, std::exp(-0.5)), 1e-12)
      << x;
  }
  for (const double gamma : { 1.0, 3.3, 7.0 })
  {
    const FrequencySpectrum spectrum = FrequencySpectrum::jonswap(1.7, 12.0, gamma);
    EXPECT_NEAR(spectrum.significantHeight(), 1.7, 1.7 * MomentError);
    EXPECT_NEAR(simpson(spectrum, 0) / spectrum.moment(0), 1.0, BruteForce);
    EXPECT_NEAR(simpson(spectrum, 1) / spectrum.moment(1), 1.0, BruteForce);
    EXPECT_NEAR(simpson(spectrum, -1) / spectrum.moment(-1), 1.0, BruteForce);
  }
}

TEST(FrequencySpectrum, tmaIsLimitedByTheDepthAndHasThePeakAskedFor)
{
  for (const double depth : { 4.0, 12.0, 60.0 })
  {
    const FrequencySpectrum spectrum = FrequencySpectrum::tma(1.5, 10.0, depth);
    EXPECT_NEAR(spectrum.significantHeight(), 1.5, 1.5 * MomentError);
    EXPECT_DOUBLE_EQ(spectrum.peakPeriod(), 10.0);
    const double top = spectrum.density(0.1);
    EXPECT_GT(top, spectrum.density(0.1 * (1.0 + 1e-3)));
    EXPECT_GT(top, spectrum.density(0.1 * (1.0 - 1e-3)));
    EXPECT_NEAR(simpson(spectrum, 0) / spectrum.moment(0), 1.0, BruteForce);
  }
  // Shallow water: phi = (omega^2 h/g)/2, so that the tail falls with f^-3.
  const FrequencySpectrum shallow = FrequencySpectrum::tma(1.0, 10.0, 0.05);
  EXPECT_NEAR(shallow.density(0.8) / shallow.density(0.4), std::pow(2.0, -3.0), 5e-3);
  // Deep water: JONSWAP.
  const FrequencySpectrum deep = FrequencySpectrum::tma(2.0, 9.0, 5000.0);
  const FrequencySpectrum jonswap = FrequencySpectrum::jonswap(2.0, 9.0);
  for (const double f : { 0.08, 1.0 / 9.0, 0.2, 0.5 })
  {
    EXPECT_NEAR(deep.density(f), jonswap.density(f), 1e-6 * jonswap.density(f)) << f;
  }
}

TEST(FrequencySpectrum, ochiHubbleIsTheSumOfTwoSeas)
{
  const OchiHubbleSea swell{ 1.8, 14.0, 5.0 };
  const OchiHubbleSea wind{ 1.1, 6.0, 1.0 };
  const FrequencySpectrum both = FrequencySpectrum::ochiHubble({ swell, wind });
  EXPECT_NEAR(both.significantHeight(), std::hypot(1.8, 1.1), 2.0 * MomentError);
  // Each sea: m_n = H^2/16 (a^(1/4) fp)^n Gamma(lambda - n/4)/Gamma(lambda).
  const auto moment = [](const OchiHubbleSea& sea, int n)
  {
    return sea.height * sea.height / 16.0 * std::pow(std::pow(sea.shape + 0.25, 0.25) / sea.period, n) *
      std::tgamma(sea.shape - 0.25 * n) / std::tgamma(sea.shape);
  };
  for (int n = -1; n <= 2; ++n)
  {
    const double exact = moment(swell, n) + moment(wind, n);
    EXPECT_NEAR(both.moment(n), exact, 1e-7 * exact) << n;
  }
  EXPECT_NEAR(both.peakPeriod(), 14.0, 2e-3); // the wind sea's foot moves it a little
  // With lambda 1 a sea is Pierson and Moskowitz's.
  const FrequencySpectrum one = FrequencySpectrum::ochiHubble({ wind, { 0.0, 10.0, 1.0 } });
  const FrequencySpectrum pm = FrequencySpectrum::piersonMoskowitz(1.1, 6.0);
  EXPECT_NEAR(one.peakPeriod(), 6.0, 6.0 * PeakError);
  for (const double f : { 0.1, 0.15, 0.2, 0.4 })
  {
    EXPECT_NEAR(one.density(f), pm.density(f), 1e-8 * pm.density(1.0 / 6.0)) << f;
  }
}

TEST(FrequencySpectrum, windSetsTheSea)
{
  // alpha = 0.0081 and fp = 0.13 g/U: m0 = alpha g^2 (2 pi)^-4/(5 fp^4), so Hs = 0.0216 U^2.
  const FrequencySpectrum sea = FrequencySpectrum::piersonMoskowitzOfWind(15.0);
  EXPECT_NEAR(sea.peakFrequency(), 0.13 * 9.81 / 15.0, 1e-15);
  const double g = 9.81;
  const double m0 = 0.0081 * g * g / std::pow(2.0 * Pi, 4.0) / (5.0 * std::pow(0.13 * g / 15.0, 4.0));
  EXPECT_NEAR(sea.significantHeight(), 4.0 * std::sqrt(m0), 5.0 * MomentError);
  // Hasselmann et al. 1973: alpha = 0.076 X^-0.22, which the tail shows, and fp U/g = 3.5 X^-0.33.
  const double fetch = 50e3;
  const FrequencySpectrum young = FrequencySpectrum::jonswapOfWind(15.0, fetch);
  const double x = g * fetch / (15.0 * 15.0);
  const double f = 50.0 * young.peakFrequency();
  EXPECT_NEAR(
    young.density(f) * std::pow(f, 5.0) * std::pow(2.0 * Pi, 4.0) / (g * g), 0.076 * std::pow(x, -0.22), 1e-8);
  EXPECT_NEAR(young.peakFrequency() * 15.0 / g, 3.5 * std::pow(x, -0.33), 1e-12);
}

TEST(FrequencySpectrum, refusesWhatMakesNoSea)
{
  EXPECT_THROW(FrequencySpectrum::jonswap(0.0, 10.0), std::invalid_argument);
  EXPECT_THROW(FrequencySpectrum::jonswap(1.0, -1.0), std::invalid_argument);
  EXPECT_THROW(FrequencySpectrum::jonswap(1.0, 10.0, 0.5), std::invalid_argument);
  EXPECT_THROW(FrequencySpectrum::tma(1.0, 10.0, 0.0), std::invalid_argument);
  EXPECT_THROW(FrequencySpectrum::ochiHubble({ OchiHubbleSea{ 1.0, 10.0, 0.2 }, {} }), std::invalid_argument);
  EXPECT_THROW(FrequencySpectrum::jonswap(1.0, 10.0).moment(4), std::invalid_argument);
  EXPECT_EQ(FrequencySpectrum::jonswap(1.0, 10.0).density(0.0), 0.0);
}
