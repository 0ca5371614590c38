// Formulas of breaking and of the surf zone, against values worked out by hand and the equations that they solve.
#include "sim/Angles.h"
#include "sim/Breaking.h"
#include "sim/Dispersion.h"
#include "sim/SurfZone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace swellray;

namespace
{

constexpr double Rounding = 1e-13;

// Values worked out by hand are given to five digits.
constexpr double FiveDigits = 1e-5;

constexpr double g = StandardGravity;

}

TEST(Breaking, weggelFollowsSlopeAndSteepness)
{
  // m = 0: a = 0, b = 0.78.
  EXPECT_NEAR(weggelHeight(2.0, 0.0, 10.0, g), 1.56, Rounding);
  EXPECT_EQ(weggelHeight(2.0, -0.05, 10.0, g), weggelHeight(2.0, 0.0, 10.0, g));
  EXPECT_EQ(weggelHeight(2.0, 0.3, 10.0, g), weggelHeight(2.0, 0.1, 10.0, g));
  // m = 0.05: a = 43.75 (1 - exp(-0.95)) = 26.83008, b = 1.56/(1 + exp(-0.975)) = 1.132740.
  const double height = weggelHeight(2.0, 0.05, 10.0, g);
  EXPECT_NEAR(height / 2.0, 1.132740 - 26.83008 * height / (g * 100.0), FiveDigits);
  // A very long wave on a steep beach comes to 1.56/(1 + exp(-1.95)) = 1.366 times the depth.
  EXPECT_NEAR(weggelHeight(1.0, 0.1, 1e4, g), 1.56 / (1.0 + std::exp(-1.95)), FiveDigits);
}

TEST(Breaking, micheIsTheSteepnessOffshoreAndTheDepthInshore)
{
  const double deep = solveWavenumber(0.7, 500.0);
  EXPECT_NEAR(micheHeight(deep, 500.0), 0.142 * wavelengthOf(deep), Rounding * wavelengthOf(deep));
  // tanh kh = kh - (kh)^3/3: 0.142 2 pi h in shallow water.
  const double shallow = solveWavenumber(0.1, 1.0);
  EXPECT_NEAR(micheHeight(shallow, 1.0), 0.142 * 2.0 * Pi * (1.0 - 0.01 / g / 3.0), 1e-6);
}

TEST(Breaking, randomWavesHaveAShareThatSolvesItsEquation)
{
  for (double ratio = 0.21; ratio < 0.9999; ratio += 0.01)
  {
    const double q = brokenShare(ratio);
    ASSERT_GT(q, 0.0);
    ASSERT_LT(q, 1.0) << ratio;
    // Both sides to rounding of ln Qb, which is large where Qb is small and 1 - Qb where it is not.
    EXPECT_NEAR((1.0 - q) / -std::log(q), ratio * ratio, 1e-12) << ratio;
  }
  EXPECT_EQ(brokenShare(0.0), 0.0);
  EXPECT_EQ(brokenShare(0.19), 0.0);
  EXPECT_EQ(brokenShare(1.0), 1.0);
  EXPECT_EQ(brokenShare(1.7), 1.0);
  EXPECT_NEAR(brokenShare(0.999999), 1.0, 1e-5);
  EXPECT_LT(brokenShare(0.21), 1e-9);
}

TEST(Breaking, randomWavesHaveALimit)
{
  EXPECT_NEAR(randomWaveLimit(1e-6, 2.0, 0.7), 1.4, 1e-10);
  const double k = solveWavenumber(1.0, 400.0);
  EXPECT_NEAR(randomWaveLimit(k, 400.0, 0.8), 0.88 / k, Rounding);
  EXPECT_NEAR(battjesStiveGamma(0.0), 0.5, Rounding);
  EXPECT_NEAR(battjesStiveGamma(0.02), 0.5 + 0.4 * 0.578363, FiveDigits);
}

TEST(Breaking, wavesAboveAHeightLoseWhatTheirBoresDo)
{
  // Mean of g H^3/(4 T h) over the Rayleigh distributed waves above Hb, by the trapezoid rule in steps of 2e-5: its square is the error.
  const double hrms = 0.8;
  const double depth = 2.0;
  const double period = 7.0;
  constexpr double Quadrature = 1e-7;
  for (const double ratio : { 0.3, 0.5, 0.8, 1.3, 4.0 })
  {
    const double from = hrms / ratio;
    const double step = 2e-5;
    double loss = 0.0;
    for (int i = 0; from + i * step < 8.0 * hrms; ++i)
    {
      const double h = from + i * step;
      const double density = 2.0 * h / (hrms * hrms) * std::exp(-h * h / (hrms * hrms));
      loss += (i > 0 ? 1.0 : 0.5) * step * density * g * h * h * h / (4.0 * period * depth);
    }
    const double rate = baldockLossRate(ratio, hrms / depth, period);
    EXPECT_NEAR(rate / (loss / (g * hrms * hrms / 8.0)), 1.0, Quadrature) << ratio;
    EXPECT_NEAR(higherShare(ratio), std::exp(-from * from / (hrms * hrms)), Rounding);
  }
  // All of them: the third moment of the distribution.
  EXPECT_NEAR(baldockLossRate(1e9, 0.4, 7.0), 1.5 * std::sqrt(Pi) * 0.4 / 7.0, Rounding);
  EXPECT_EQ(baldockLossRate(0.0, 0.4, 7.0), 0.0);
  EXPECT_EQ(higherShare(0.0), 0.0);
  EXPECT_NEAR(ruessinkGamma(0.25, 2.0), 0.67, Rounding);
}

TEST(Breaking, breakersHaveTypes)
{
  // L0 = 156.13 m at 10 s.
  EXPECT_NEAR(iribarrenNumber(0.05, 2.0, 10.0, g), 0.05 / std::sqrt(2.0 / (g * 100.0 / (2.0 * Pi))), Rounding);
  EXPECT_LT(iribarrenNumber(-0.05, 2.0, 10.0, g), 0.0);
  EXPECT_EQ(breakerType(-0.2), BreakerType::Spilling);
  EXPECT_EQ(breakerType(0.499), BreakerType::Spilling);
  EXPECT_EQ(breakerType(0.5), BreakerType::Plunging);
  EXPECT_EQ(breakerType(3.3), BreakerType::Plunging);
  EXPECT_EQ(breakerType(3.31), BreakerType::Surging);
  EXPECT_EQ(breakerTypeAtBreaking(0.399), BreakerType::Spilling);
  EXPECT_EQ(breakerTypeAtBreaking(0.4), BreakerType::Plunging);
  EXPECT_EQ(breakerTypeAtBreaking(2.0), BreakerType::Plunging);
  EXPECT_EQ(breakerTypeAtBreaking(2.01), BreakerType::Surging);
  EXPECT_EQ(breakingRuleName(BreakingRule::BattjesJanssen), std::string("battjes-janssen"));
  EXPECT_EQ(breakingRuleName(BreakingRule::Baldock), std::string("baldock"));
  EXPECT_TRUE(ofRandomWaves(BreakingRule::Baldock));
  EXPECT_FALSE(ofRandomWaves(BreakingRule::Dally));
}

TEST(Breaking, frictionIsTheWorkOfTheBedStress)
{
  const double period = 8.0;
  const double depth = 3.0;
  const double height = 1.2;
  const double fw = 0.03;
  const double k = solveWavenumber(2.0 * Pi / period, depth);
  const double u = Pi * height / (period * std::sinh(k * depth));
  // Mean of rho fw |u|u u/2 over a period, by the trapezoid rule, exact to 1e-9 for so smooth a function.
  double work = 0.0;
  const int n = 20000;
  for (int i = 0; i < n; ++i)
  {
    const double now = u * std::cos(2.0 * Pi * i / n);
    work += 0.5 * SeaWaterDensity * fw * std::fabs(now) * now * now / n;
  }
  const double energy = SeaWaterDensity * g * height * height / 8.0;
  EXPECT_NEAR(frictionRate(fw, height, k, depth, period, g) / (work / energy), 1.0, 1e-7);
  EXPECT_EQ(frictionRate(fw, height, 0.04, 1e6, period, g), 0.0);
}

TEST(Breaking, aLaminarLayerTakesTheWorkOfItsShear)
{
  const double period = 1.0;
  const double depth = 0.3;
  const double height = 0.05;
  const double omega = 2.0 * Pi / period;
  const double k = solveWavenumber(omega, depth);
  const double u = Pi * height / (period * std::sinh(k * depth));
  // Stokes' layer u (cos wt - exp(-z/d) cos(wt - z/d)), d = sqrt(2 nu/w): mean of nu (du/dz)^2 over a period and the layer, by sums in z, the
  // trapezoid rule in t being exact.
  const double thickness = std::sqrt(2.0 * WaterViscosity / omega);
  constexpr int Steps = 4000;
  constexpr int Phases = 8;
  const double step = 20.0 * thickness / Steps;
  double work = 0.0;
  for (int i = 0; i < Steps; ++i)
  {
    const double z = (i + 0.5) * step;
    for (int j = 0; j < Phases; ++j)
    {
      const double phase = 2.0 * Pi * j / Phases - z / thickness;
      const double shear = u / thickness * std::exp(-z / thickness) * (std::cos(phase) - std::sin(phase));
      work += WaterViscosity * shear * shear * step / Phases;
    }
  }
  constexpr double Quadrature = 1e-5; // square of the step over the thickness, over 6
  const double rate = laminarFrictionRate(WaterViscosity, k, depth, period, g);
  EXPECT_NEAR(rate / (work / (g * height * height / 8.0)), 1.0, Quadrature);
  // Hunt 1952.
  const double decay =
    2.0 * k * k * std::sqrt(WaterViscosity / (2.0 * omega)) / (2.0 * k * depth + std::sinh(2.0 * k * depth));
  EXPECT_NEAR(rate / (2.0 * waveSpeeds(k, depth).groupSpeed * decay), 1.0, Rounding);
  EXPECT_EQ(laminarFrictionRate(0.0, k, depth, period, g), 0.0);
  EXPECT_EQ(laminarFrictionRate(WaterViscosity, 0.04, 1e6, period, g), 0.0);
}

TEST(SurfZone, setDownAndSetUp)
{
  // Shallow water: -H^2/(16 h).
  EXPECT_NEAR(setDown(1.0, 1.0, 1e-4), -1.0 / 16.0, 1e-9);
  // gamma = 0.8: K = 1/(1 + 8/1.92) = 0.193548; eta_b = -gamma^2 hb/16 = -0.04 hb; -0.04 + 0.193548, over 1 - K.
  const WaveSetUp rise = waveSetUp(0.8, 1.0, 1e-4);
  EXPECT_NEAR(rise.stillWaterLine, 0.153548, FiveDigits);
  EXPECT_NEAR(rise.maximum, 0.190400, FiveDigits);
  // The same by marching d eta/dx = -(3/8) gamma^2 d(h + eta)/dx up the beach: at the maximum no water is left.
  double eta = setDown(0.8, 1.0, 1e-4);
  double still = 1.0;
  const double step = 1e-6;
  while (still + eta > 0.0)
  {
    const double c = 3.0 / 8.0 * 0.64;
    eta += c / (1.0 + c) * step;
    still -= step;
  }
  EXPECT_NEAR(rise.maximum, eta, FiveDigits);
}

TEST(SurfZone, longshoreFluxAndTransport)
{
  const double flux = longshoreEnergyFlux(2.0, 5.0, radians(10.0), g);
  EXPECT_NEAR(flux, 1025.0 * g * 4.0 * 5.0 / 8.0 * std::sin(radians(10.0)) * std::cos(radians(10.0)), 1e-9 * flux);
  EXPECT_EQ(longshoreEnergyFlux(2.0, 5.0, radians(-10.0), g), -flux);
  EXPECT_NEAR(longshoreTransport(flux, g), 0.39 * flux / (1625.0 * g * 0.6), Rounding);
}

TEST(SurfZone, vortexRatioWhereReefsWereMeasured)
{
  EXPECT_NEAR(vortexRatio(0.1), 1.471, Rounding);
  EXPECT_NEAR(vortexRatio(1.0 / 40.0), 3.421, Rounding);
  EXPECT_TRUE(std::isnan(vortexRatio(0.2)));
  EXPECT_TRUE(std::isnan(vortexRatio(0.01)));
  EXPECT_TRUE(std::isnan(vortexRatio(-0.1)));
}
