#include "sim/Dispersion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

using namespace swellray;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// What solveWavenumber promises.
constexpr double SolverTolerance = 1e-14;

// A few roundings of the closed forms.
constexpr double FormulaTolerance = 1e-14;

// q of y = q tanh q by bisection in long double: slow, and nothing in common with the solver.
long double bisect(long double y)
{
  long double low = 0.0L;
  long double high = y + std::sqrt(y) + 1.0L;
  for (int i = 0; i < 20000; ++i)
  {
    const long double middle = 0.5L * (low + high);
    if (middle <= low || middle >= high)
    {
      break;
    }
    (middle * std::tanh(middle) < y ? low : high) = middle;
  }
  return 0.5L * (low + high);
}

TEST(Dispersion, SolvesForAnyRelativeDepth)
{
  const double depth = 7.0;
  for (double exponent = -8.0; exponent <= 8.0; exponent += 0.01)
  {
    const double q = std::pow(10.0, exponent);
    const double omega = std::sqrt(StandardGravity * q * std::tanh(q) / depth);
    const long double y = static_cast<long double>(omega) * omega * depth / static_cast<long double>(StandardGravity);
    const double expected = static_cast<double>(bisect(y) / depth);
    EXPECT_NEAR(solveWavenumber(omega, depth) / expected, 1.0, SolverTolerance) << "kh = " << q;
  }
}

TEST(Dispersion, ReachesItsLimits)
{
  EXPECT_DOUBLE_EQ(solveWavenumber(0.7, Infinity), 0.7 * 0.7 / StandardGravity);
  EXPECT_DOUBLE_EQ(solveWavenumber(0.7, 1e6), 0.7 * 0.7 / StandardGravity);
  // Shallow: omega/sqrt(g h), also where omega^2 underflows.
  EXPECT_DOUBLE_EQ(solveWavenumber(1e-9, 2.0, 9.0), 1e-9 / std::sqrt(18.0));
  EXPECT_DOUBLE_EQ(solveWavenumber(1e-200, 2.0, 9.0), 1e-200 / std::sqrt(18.0));
}

TEST(Dispersion, ScalesWithGravity)
{
  // Units: (omega, g) to (2 omega, 4 g) leaves k.
  EXPECT_DOUBLE_EQ(solveWavenumber(1.4, 5.0, 4.0 * 9.81), solveWavenumber(0.7, 5.0, 9.81));
}

TEST(Dispersion, RefusesWhatHasNoWave)
{
  for (const double bad : { 0.0, -1.0, NotANumber })
  {
    EXPECT_THROW(solveWavenumber(bad, 5.0), std::invalid_argument);
    EXPECT_THROW(solveWavenumber(1.0, bad), std::invalid_argument);
    EXPECT_THROW(solveWavenumber(1.0, 5.0, bad), std::invalid_argument);
  }
  EXPECT_THROW(solveWavenumber(Infinity, 5.0), std::invalid_argument);
  EXPECT_THROW(solveWavenumber(1.0, 5.0, Infinity), std::invalid_argument);
}

TEST(Dispersion, SpeedsAgreeWithTheHyperbolicSine)
{
  for (double q = 1e-3; q < 300.0; q *= 1.1)
  {
    const double depth = 12.0;
    const double k = q / depth;
    const WaveSpeeds speeds = waveSpeeds(k, depth);
    const long double twice = 2.0L * k * depth;
    const double n = static_cast<double>(0.5L * (1.0L + twice / std::sinh(twice)));
    EXPECT_NEAR(speeds.groupRatio / n, 1.0, FormulaTolerance) << q;
    EXPECT_NEAR(speeds.phaseSpeed / std::sqrt(StandardGravity / k * std::tanh(k * depth)), 1.0, FormulaTolerance);
    EXPECT_DOUBLE_EQ(speeds.groupSpeed, speeds.phaseSpeed * speeds.groupRatio);
  }
}

TEST(Dispersion, SpeedsAreFiniteInAnyDepth)
{
  const double k = 0.04;
  for (const double depth : { 1e6, 1e300, Infinity })
  {
    const WaveSpeeds deep = waveSpeeds(k, depth);
    EXPECT_DOUBLE_EQ(deep.groupRatio, 0.5) << depth;
    EXPECT_DOUBLE_EQ(deep.phaseSpeed, std::sqrt(StandardGravity / k)) << depth;
  }
  for (const double depth : { 1e-10, 1e-200 })
  {
    const WaveSpeeds shallow = waveSpeeds(k, depth);
    EXPECT_DOUBLE_EQ(shallow.groupRatio, 1.0) << depth;
    EXPECT_DOUBLE_EQ(shallow.groupSpeed, std::sqrt(StandardGravity * depth)) << depth;
  }
  EXPECT_TRUE(std::isnan(waveSpeeds(NotANumber, 3.0).groupSpeed));
}

TEST(Dispersion, ShoalingHasItsMinimumWhereItMust)
{
  // Ks = (tanh q + q sech^2 q)^(-1/2) is least where q tanh q = 1, and there Ks = q^(-1/2).
  constexpr double leastKs = 0.912993187050684;
  constexpr double leastDepth = 1.199678640257734;
  const double omega = 0.7;
  const double deepK = solveWavenumber(omega, Infinity);
  const double deepSpeed = waveSpeeds(deepK, Infinity).groupSpeed;
  const auto shoaling = [&](double depth)
  { return shoalingCoefficient(deepSpeed, waveSpeeds(solveWavenumber(omega, depth), depth).groupSpeed); };
  // q tanh q = omega^2 h/g = 1
  const double depth = StandardGravity / (omega * omega);
  EXPECT_NEAR(solveWavenumber(omega, depth) * depth, leastDepth, 1e-14);
  EXPECT_NEAR(shoaling(depth), leastKs, 1e-14);
  // A minimum: both sides are higher, by the same second order.
  EXPECT_GT(shoaling(0.99 * depth), leastKs + 1e-7);
  EXPECT_GT(shoaling(1.01 * depth), leastKs + 1e-7);
}

// sigma in long double, for differences.
long double sigmaOf(long double k, long double h)
{
  return std::sqrt(static_cast<long double>(StandardGravity) * k * std::tanh(k * h));
}

// Central differences of 4th order by a step of 2e-4: truncation 1e-15, rounding 1e-19/2e-4.
constexpr long double DifferenceStep = 2e-4L;
constexpr double DifferenceTolerance = 1e-11;

long double derivative(const std::function<long double(long double)>& f, long double x)
{
  const long double d = DifferenceStep * x;
  return (8.0L * (f(x + d) - f(x - d)) - (f(x + 2.0L * d) - f(x - 2.0L * d))) / (12.0L * d);
}

TEST(Dispersion, DerivativesAgreeWithDifferences)
{
  const double h = 9.0;
  for (double q = 1e-4; q < 20.0; q *= 1.3)
  {
    const double k = q / h;
    Frequency f;
    evaluateFrequency(k, h, StandardGravity, f);
    const auto byK = [&](long double x) { return sigmaOf(x, h); };
    const auto byH = [&](long double y) { return sigmaOf(k, y); };
    const auto slopeByK = [&](long double x, long double y)
    { return derivative([y](long double z) { return sigmaOf(z, y); }, x); };
    const auto slopeByH = [&](long double y) { return derivative([&](long double z) { return sigmaOf(k, z); }, y); };
    const double kk = static_cast<double>(derivative([&](long double x) { return slopeByK(x, h); }, k));
    const double kh = static_cast<double>(derivative([&](long double y) { return slopeByK(k, y); }, h));
    const double hh = static_cast<double>(derivative(slopeByH, h));
    // Each against its natural size, so that deep water (where the derivatives by h vanish) is no exception.
    const double sigma = static_cast<double>(sigmaOf(k, h));
    EXPECT_NEAR(f.sigma, sigma, FormulaTolerance * sigma) << q;
    EXPECT_NEAR(f.k, static_cast<double>(derivative(byK, k)), DifferenceTolerance * sigma / k) << q;
    EXPECT_NEAR(f.h, static_cast<double>(derivative(byH, h)), DifferenceTolerance * sigma / h) << q;
    EXPECT_NEAR(f.kk, kk, DifferenceTolerance * sigma / (k * k)) << q;
    EXPECT_NEAR(f.kh, kh, DifferenceTolerance * sigma / (k * h)) << q;
    EXPECT_NEAR(f.hh, hh, DifferenceTolerance * sigma / (h * h)) << q;
  }
}

TEST(Dispersion, FrequencyKeepsItsDigitsInShallowWater)
{
  // Series for q -> 0: sigma = sqrt(g h) k (1 - q^2/6 + 19 q^4/360), so sigma_kk = -sqrt(g h) h q (1 - 19 q^2/18).
  constexpr double tolerance = 1e-13;
  const double h = 3.0;
  for (const double q : { 1e-8, 1e-6, 1e-4 })
  {
    const double k = q / h;
    const double speed = std::sqrt(StandardGravity * h);
    Frequency f;
    evaluateFrequency(k, h, StandardGravity, f);
    EXPECT_NEAR(f.sigma / (speed * k * (1.0 - q * q / 6.0)), 1.0, tolerance) << q;
    EXPECT_NEAR(f.k / (speed * (1.0 - 0.5 * q * q)), 1.0, tolerance) << q;
    EXPECT_NEAR(f.kk / (-speed * h * q * (1.0 - 19.0 / 18.0 * q * q)), 1.0, tolerance) << q;
  }
}

TEST(Dispersion, FrequencyIsContinuousWhereItsFormulaChanges)
{
  // kh = 0.25: the two formulas for tanh meet.
  constexpr double step = 1e-15;
  Frequency below;
  Frequency above;
  evaluateFrequency(0.25 - step, 1.0, StandardGravity, below);
  evaluateFrequency(0.25 + step, 1.0, StandardGravity, above);
  constexpr double tolerance = 1e-13;
  EXPECT_NEAR(above.sigma / below.sigma, 1.0, tolerance);
  EXPECT_NEAR(above.k / below.k, 1.0, tolerance);
  EXPECT_NEAR(above.h / below.h, 1.0, tolerance);
  EXPECT_NEAR(above.kk / below.kk, 1.0, tolerance);
  EXPECT_NEAR(above.kh / below.kh, 1.0, tolerance);
  EXPECT_NEAR(above.hh / below.hh, 1.0, tolerance);
}

TEST(Dispersion, FrequencyIsThatOfDeepWaterInTheOcean)
{
  const double k = 0.3;
  Frequency f;
  evaluateFrequency(k, 11000.0, StandardGravity, f);
  EXPECT_DOUBLE_EQ(f.sigma, std::sqrt(StandardGravity * k));
  EXPECT_DOUBLE_EQ(f.k, 0.5 * std::sqrt(StandardGravity / k));
  EXPECT_DOUBLE_EQ(f.kk, -0.25 * std::sqrt(StandardGravity / k) / k);
  EXPECT_EQ(f.h, 0.0);
  EXPECT_EQ(f.kh, 0.0);
  EXPECT_EQ(f.hh, 0.0);
}

TEST(IncidentWave, HasTheNumbersOfDeepWater)
{
  IncidentWave wave;
  wave.period = 8.0;
  wave.directionFrom = 180.0;
  const double omega = 2.0 * Pi / 8.0;
  EXPECT_DOUBLE_EQ(wave.angularFrequency(), omega);
  EXPECT_DOUBLE_EQ(wave.wavenumber(), omega * omega / StandardGravity);
  EXPECT_DOUBLE_EQ(wave.groupSpeed(), 0.5 * StandardGravity / omega);
  EXPECT_NEAR(wave.direction().x, 0.0, FormulaTolerance);
  EXPECT_NEAR(wave.direction().y, 1.0, FormulaTolerance);
  EXPECT_NEAR(wavelengthOf(wave.wavenumber()), 2.0 * Pi * StandardGravity / (omega * omega), 1e-12);

  wave.offshoreDepth = 10.0;
  const double k = wave.wavenumber();
  EXPECT_NEAR(StandardGravity * k * std::tanh(10.0 * k), omega * omega, FormulaTolerance);
  EXPECT_GT(wave.groupSpeed(), 0.5 * omega / k);
}

std::string complaint(const IncidentWave& wave)
{
  try
  {
    wave.validate();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(IncidentWave, NamesWhatIsOutOfRange)
{
  using testing::HasSubstr;
  EXPECT_EQ(complaint(IncidentWave()), "");

  IncidentWave wave;
  wave.period = -3.0;
  EXPECT_EQ(complaint(wave), "period must be above 0 s, not -3");
  for (const double bad : { 0.0, NotANumber, Infinity })
  {
    wave = IncidentWave();
    wave.period = bad;
    EXPECT_THAT(complaint(wave), HasSubstr("period must be above 0 s")) << bad;
    wave = IncidentWave();
    wave.height = bad;
    EXPECT_THAT(complaint(wave), HasSubstr("height must be above 0 m")) << bad;
    wave = IncidentWave();
    wave.gravity = bad;
    EXPECT_THAT(complaint(wave), HasSubstr("gravity must be above 0")) << bad;
  }
  for (const double bad : { 360.5, -400.0, NotANumber, Infinity })
  {
    wave = IncidentWave();
    wave.directionFrom = bad;
    EXPECT_THAT(complaint(wave), HasSubstr("direction must be within -360 to 360 degrees")) << bad;
  }
  for (const double bad : { 0.0, -5.0, NotANumber })
  {
    wave = IncidentWave();
    wave.offshoreDepth = bad;
    EXPECT_THAT(complaint(wave), HasSubstr("offshore depth must be above 0 m")) << bad;
  }
  wave = IncidentWave();
  wave.directionFrom = -360.0;
  EXPECT_EQ(complaint(wave), "");
}

}
