#include "sim/StraightPhase.h"

#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace swellray;

namespace
{

// Trapezoids of 2 m over a k that changes by a tenth in 20 m.
constexpr double IntegralTolerance = 1e-3;

IncidentWave waveOf(double period, double directionFrom, double height = 1.0)
{
  IncidentWave wave;
  wave.period = period;
  wave.directionFrom = directionFrom;
  wave.height = height;
  return wave;
}

glm::dvec2 gradientOf(const StraightPhase& phase, const glm::dvec2& at)
{
  constexpr double step = 10.0;
  return { (phase.at({ at.x + step, at.y }) - phase.at({ at.x - step, at.y })) / (2.0 * step),
    (phase.at({ at.x, at.y + step }) - phase.at({ at.x, at.y - step })) / (2.0 * step) };
}

}

TEST(StraightPhase, overALevelBedIsThatOfAPlaneWave)
{
  const auto bed = makeBuiltinSeafloor("plane:slope=1,offshore-depth=8,x0=100,x1=500,y0=0,y1=300");
  const IncidentWave wave = waveOf(7.0, 60.0);
  const StraightPhase phase(*bed, wave, 0.0, 5.0);
  const double k = solveWavenumber(wave.angularFrequency(), 8.0);
  const glm::dvec2 gradient = gradientOf(phase, { 300.0, 150.0 });
  EXPECT_NEAR(gradient.x, k * wave.direction().x, 1e-9);
  EXPECT_NEAR(gradient.y, k * wave.direction().y, 1e-9);
}

TEST(StraightPhase, straightOntoABeachIsTheIntegralOfK)
{
  const auto bed = makeBuiltinSeafloor("plane:slope=0.05,x0=20,x1=400,y0=0,y1=100");
  const IncidentWave wave = waveOf(7.0, 90.0);
  const StraightPhase phase(*bed, wave, 0.0, 2.0);
  for (const double x : { 300.0, 150.0, 60.0 })
  {
    double integral = 0.0;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i)
    {
      const double u = x + (400.0 - x) * (i + 0.5) / steps;
      integral += solveWavenumber(wave.angularFrequency(), 0.05 * u) * (400.0 - x) / steps;
    }
    EXPECT_NEAR(phase.at({ x, 50.0 }), integral, IntegralTolerance * integral);
  }
}

TEST(StraightPhase, bendsCrestsTowardsTheShoreButItsGradientIsNotK)
{
  const auto bed = makeBuiltinSeafloor("plane:slope=0.02,x0=0,x1=2000,y0=-1000,y1=1000");
  const IncidentWave wave = waveOf(10.0, 50.0); // 40 degrees off the normal of the beach
  const StraightPhase phase(*bed, wave, 0.0, 2.0);
  const glm::dvec2 place(250.0, 0.0);
  const glm::dvec2 gradient = gradientOf(phase, place);
  const double k = solveWavenumber(wave.angularFrequency(), 5.0);
  const double turned = std::atan2(std::abs(gradient.y), std::abs(gradient.x)) * 180.0 / Pi;
  EXPECT_LT(turned, 35.0);
  const double off = std::hypot(gradient.x, gradient.y) / k - 1.0;
  EXPECT_GT(std::abs(off), 0.02);
  EXPECT_LT(std::abs(off), 0.3);
}

TEST(PeacheySea, isTheSumOfItsWaves)
{
  const auto bed = makeBuiltinSeafloor("plane:slope=1,offshore-depth=30,x0=100,x1=500,y0=0,y1=300");
  const PeacheyWave a{ waveOf(6.0, 90.0, 1.0), 0.3 };
  const PeacheyWave b{ waveOf(2.5, 60.0, 0.3), 1.7 };
  const PeacheySea first(*bed, { a }, 0.0, 1.0);
  const PeacheySea second(*bed, { b }, 0.0, 1.0);
  const PeacheySea both(*bed, { a, b }, 0.0, 1.0);
  for (double x = 150.0; x < 400.0; x += 17.0)
  {
    const glm::dvec2 place(x, 0.5 * x);
    EXPECT_NEAR(both.height(place, 3.0), first.height(place, 3.0) + second.height(place, 3.0), 1e-12);
  }
}

TEST(PeacheySea, crestsMoveInTheDirectionOfTheWave)
{
  const auto bed = makeBuiltinSeafloor("plane:slope=1,offshore-depth=30,x0=100,x1=500,y0=0,y1=300");
  const IncidentWave wave = waveOf(6.0, 90.0, 1.0);
  const PeacheySea sea(*bed, { { wave, 0.0 } }, 0.0, 0.5);
  const double speed = wave.angularFrequency() / solveWavenumber(wave.angularFrequency(), 30.0);
  for (double x = 200.0; x < 400.0; x += 13.0)
  {
    EXPECT_NEAR(sea.height({ x, 100.0 }, 0.0), sea.height({ x - speed * 0.7, 100.0 }, 0.7), 1e-4);
  }
}

TEST(PeacheySea, neverGoesBeyondTheDepthAndIsFlatOnLand)
{
  const auto bed = makeBuiltinSeafloor("plane:slope=0.02,x0=-20,x1=200,y0=0,y1=100");
  const PeacheySea sea(*bed,
    { { waveOf(6.0, 90.0, 1.5), 0.0 }, { waveOf(2.5, 80.0, 0.8), 1.0 }, { waveOf(2.0, 100.0, 0.8), 2.0 } }, 0.0, 1.0);
  for (double x = -15.0; x < 190.0; x += 1.3)
  {
    for (double time = 0.0; time < 6.0; time += 0.5)
    {
      const double height = sea.height({ x, 40.0 }, time);
      ASSERT_LE(std::abs(height), std::max(0.0, 0.02 * x));
    }
  }
}

TEST(StraightPhase, refusesWhatMakesNoSense)
{
  const auto bed = makeBuiltinSeafloor("plane");
  EXPECT_THROW(StraightPhase(*bed, waveOf(7.0, 90.0), 0.0, 0.0), std::invalid_argument);
  EXPECT_THROW(StraightPhase(*bed, waveOf(7.0, 90.0), 0.0, 1e-6), std::invalid_argument);
  EXPECT_THROW(StraightPhase(*bed, waveOf(-7.0, 90.0), 0.0, 5.0), std::invalid_argument);
  EXPECT_THROW(PeacheySea(*bed, {}, 0.0, 5.0), std::invalid_argument);
}
