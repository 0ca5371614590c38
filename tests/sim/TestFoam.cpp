#include "sim/Foam.h"

#include "sim/Angles.h"
#include "sim/SurfHistory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace swellray;

namespace
{

// Foam is a float.
constexpr double FloatTolerance = 1e-6;

constexpr double NotBroken = std::numeric_limits<double>::quiet_NaN();

FoamOptions options(double life = 8.0)
{
  FoamOptions result;
  result.period = 10.0;
  result.life = life;
  result.wavelength = 100.0;
  return result;
}

float foamAt(double phase, double breakingPhase, double time, const FoamOptions& with, double parameter = 0.0)
{
  float foam = -1.0f;
  computeFoam({ 1, &phase, &breakingPhase, &parameter }, time, with, &foam);
  return foam;
}

}

TEST(Foam, fadesLinearlyFromThePassageOfTheWave)
{
  // The crest of wave 0 is at a phase of 20 at omega t = 20.
  const double passage = 20.0 / (2.0 * Pi) * 10.0;
  EXPECT_NEAR(foamAt(20.0, 5.0, passage + 1e-9, options()), 1.0, FloatTolerance);
  EXPECT_NEAR(foamAt(20.0, 5.0, passage + 2.0, options()), 0.75, FloatTolerance);
  EXPECT_NEAR(foamAt(20.0, 5.0, passage + 6.0, options()), 0.25, FloatTolerance);
  EXPECT_EQ(foamAt(20.0, 5.0, passage + 9.0, options()), 0.0f);
  // The next wave renews it.
  EXPECT_NEAR(foamAt(20.0, 5.0, passage + 10.5, options()), 1.0 - 0.5 / 8.0, FloatTolerance);
}

TEST(Foam, isThatOfTheLatestWaveWhereSeveralLast)
{
  const double passage = 20.0 / (2.0 * Pi) * 10.0;
  EXPECT_NEAR(foamAt(20.0, 5.0, passage + 3.0, options(25.0)), 1.0 - 3.0 / 25.0, FloatTolerance);
}

TEST(Foam, beginsWhereTheTraceSaysThatBreakingBegins)
{
  const double time = 20.0 / (2.0 * Pi) * 10.0 + 0.001;
  EXPECT_EQ(foamAt(20.0, NotBroken, time, options()), 0.0f);
  EXPECT_EQ(foamAt(20.0, 20.1, time, options()), 0.0f);
  EXPECT_GT(foamAt(20.0, 19.9, time, options()), 0.0f);
  // Whole a sixteenth of a wave behind.
  EXPECT_NEAR(foamAt(20.0, 20.0 - Pi / 8.0, time, options()), 1.0, 1e-3);
}

TEST(Foam, coversTheFrontOfAWaveWhoseCrestHasComeDown)
{
  FoamOptions with = options();
  with.front = 1.0;
  // A place that no wave has passed for longer than foam lives: the crest of wave 0 is `ahead` of it.
  const auto at = [&](double broken, double ahead, double plunge)
  {
    const double phase = 20.0;
    const double breakingPhase = phase - broken;
    const double time = (phase - ahead) / (2.0 * Pi) * 10.0;
    float foam = -1.0f;
    FoamPlaces places{ 1, &phase, &breakingPhase };
    places.plungePhase = &plunge;
    computeFoam(places, time, with, &foam);
    return foam;
  };
  // 1.2 rad ahead of the next crest the foam of the last is (2 pi - 1.2)/(2 pi) 10 s = 8.09 s old.
  EXPECT_EQ(at(9.0, 1.2, 2.0), 0.0f);
  EXPECT_NEAR(at(9.0, 0.5, 2.0), 1.0, FloatTolerance);
  EXPECT_NEAR(at(9.0, 0.9, 2.0), 0.5, FloatTolerance);
  EXPECT_NEAR(at(9.0, 1e-6, 2.0), 1.0, FloatTolerance);
  // A lip that falls is clear: only what earlier waves have left is there.
  const double old = 1.0 - (2.0 * Pi - 0.5) / (2.0 * Pi) * 10.0 / 8.0;
  EXPECT_NEAR(at(2.4, 0.5, 2.0), std::max(0.0, old), FloatTolerance);
  EXPECT_GT(at(2.7, 0.5, 2.0), 0.4);
  // It thins out within the front, without a step.
  for (double ahead = 0.0; ahead < 1.2; ahead += 0.001)
  {
    EXPECT_LT(std::abs(at(9.0, ahead + 0.001, 2.0) - at(9.0, ahead, 2.0)), 0.0051) << ahead;
  }
  with.front = 7.0;
  EXPECT_THROW(with.validate(), std::invalid_argument);
}

TEST(Foam, countsEarlierWavesWhereTheLatestHasNotBrokenYet)
{
  FoamOptions varied = options(40.0);
  varied.variation = 0.5;
  // A place short of the largest delay, and waves enough to have some of either kind.
  const double broken = 0.4 * Pi;
  int fromEarlier = 0;
  for (int wave = -20; wave < 0; ++wave)
  {
    const double phase = 2.0 * Pi * wave + 2.0 * Pi * 30.0;
    const double time = 10.0 * 30.0 + 0.5; // wave `wave` has just passed
    double expected = 0.0;
    for (int n = wave; n < wave + 5; ++n)
    {
      const double age = 0.5 + 10.0 * (n - wave);
      const double delay = Pi * breakingDelay(1, n, 0.0, 100.0);
      const double share = std::clamp((broken - delay) / (Pi / 8.0), 0.0, 1.0);
      expected = std::max(expected, age < 40.0 ? share * (1.0 - age / 40.0) : 0.0);
    }
    const float foam = foamAt(phase, phase - broken, time, varied);
    EXPECT_NEAR(foam, expected, FloatTolerance) << wave;
    fromEarlier += foam > 0.0f && foam < 1.0 - 0.6 / 40.0 ? 1 : 0;
  }
  EXPECT_GT(fromEarlier, 0);
}

TEST(Foam, dependsOnNothingButItsTime)
{
  const std::vector<double> phase{ 1.0, 9.0, 27.0 };
  const std::vector<double> breaking{ 0.5, NotBroken, 3.0 };
  const std::vector<double> parameter{ 0.0, 10.0, 20.0 };
  std::vector<float> first(3);
  std::vector<float> again(3);
  computeFoam({ 3, phase.data(), breaking.data(), parameter.data() }, 7.0, options(), first.data());
  computeFoam({ 3, phase.data(), breaking.data(), parameter.data() }, 123.0, options(), again.data());
  computeFoam({ 3, phase.data(), breaking.data(), parameter.data() }, 7.0, options(), again.data());
  EXPECT_EQ(first, again);
}

TEST(Foam, refusesWhatMakesNoSense)
{
  EXPECT_THROW(foamAt(1.0, 0.5, 0.0, options(0.0)), std::invalid_argument);
  FoamOptions without = options();
  without.period = -1.0;
  EXPECT_THROW(foamAt(1.0, 0.5, 0.0, without), std::invalid_argument);
}
