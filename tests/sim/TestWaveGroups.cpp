#include "sim/WaveGroups.h"

#include "RayBundle.h"

#include "sim/Foam.h"
#include "sim/SurfaceFunction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

using namespace swellray;
using namespace swellray::bundles;

namespace
{

constexpr double Gravity = 9.81;
constexpr double Omega = 2.0 * Pi / Period;

// What is of one depth is interpolated exactly; phases are up to some hundreds.
constexpr double Rounding = 1e-9;

// The group's time is summed by trapezoids of a sixteenth of a wave, whose rate changes by some percent a wave.
constexpr double Trapezoids = 2e-4;

/** Where an increasing function is 0. */
double rootOf(const std::function<double(double)>& value, double low, double high)
{
  for (int i = 0; i < 200; ++i)
  {
    const double middle = 0.5 * (low + high);
    (value(middle) < 0.0 ? low : high) = middle;
  }
  return low;
}

/** k of Airy's wave of this period, by bisection. */
double wavenumberAt(double depth)
{
  return rootOf([&](double k) { return Gravity * k * std::tanh(k * depth) - Omega * Omega; }, 1e-4, 10.0);
}

/** d omega/dk at this depth, by differences. */
double groupSpeedAt(double depth)
{
  const double k = wavenumberAt(depth);
  const auto frequency = [&](double number) { return std::sqrt(Gravity * number * std::tanh(number * depth)); };
  constexpr double step = 1e-6;
  return (frequency(k + step) - frequency(k - step)) / (2.0 * step);
}

struct Groups
{
  Groups(const Bundle& bundle, const Seafloor& bed, const WaveGroups& groups)
    : Sheet(bundle.rays(), bed, 0.0, 16.0)
  {
    SurfaceOptions options;
    options.period = Period;
    options.wavelength = Wavelength;
    options.groups = groups;
    this->Moved = std::make_unique<WaveSurface>(this->Sheet, bed, options);
  }

  std::vector<double> at(double time, const std::string& section) const
  {
    std::vector<double> positions(3 * this->Sheet.pointCount());
    SurfaceArrays arrays;
    arrays.position = positions.data();
    this->Moved->displace(time, *makeWaveSection(section), arrays);
    return positions;
  }

  SurfaceSheet Sheet;
  std::unique_ptr<WaveSurface> Moved;
};

/** Straight rays toward +x over a bed, their phase as the waves have it. */
Bundle toward(const std::function<double(double)>& wavenumber, double length, double step)
{
  Bundle bundle;
  for (int i = 0; i < 3; ++i)
  {
    bundle.begin(5.0 * i);
    double phase = 0.0;
    for (double x = 0.0; x < length + 1e-9; x += step)
    {
      bundle.add({ x, 5.0 * i }, phase, { 1.0, 0.0 }, 1.0, 0.0, RayState::Alive, wavenumber(x));
      phase += step / 6.0 * (wavenumber(x) + 4.0 * wavenumber(x + 0.5 * step) + wavenumber(x + step));
    }
  }
  return bundle;
}

WaveGroups sevens(double lull = 0.25)
{
  WaveGroups groups;
  groups.waves = 7.0;
  groups.lull = lull;
  return groups;
}

}

TEST(WaveGroups, haveHighWavesInTheMiddleAndLowOnesBetween)
{
  const WaveGroups groups = sevens();
  EXPECT_NEAR(groups.share(0.0, 10.0), 1.0, Rounding);
  EXPECT_NEAR(groups.share(35.0, 10.0), 0.25, Rounding);
  EXPECT_NEAR(groups.share(-35.0, 10.0), 0.25, Rounding);
  EXPECT_NEAR(groups.share(17.5, 10.0), 0.625, Rounding);
  EXPECT_NEAR(groups.share(1.0 + 700.0, 10.0), groups.share(1.0, 10.0), Rounding);
  EXPECT_EQ(WaveGroups{}.share(12.3, 10.0), 1.0);
}

TEST(WaveGroups, goAtHalfTheSpeedOfTheWavesInDeepWater)
{
  constexpr double depth = 500.0;
  const Slope bed(depth, 0.0);
  const double k = Omega * Omega / Gravity;
  const Groups surface(toward([&](double) { return k; }, 600.0, 5.0), bed, sevens());
  const SurfaceFunction function(*surface.Moved);
  const auto airy = makeWaveSection("airy");
  SurfaceMotion motion;
  motion.section = airy.get();
  for (const double time : { 0.0, 31.7, -55.0, 1000.3 })
  {
    const auto positions = surface.at(time, "airy");
    for (std::size_t i = 0; i < surface.Sheet.pointCount(); ++i)
    {
      const double x = positions[3 * i];
      const double since = time - x / (0.5 * Omega / k);
      const double share = 0.25 + 0.75 * 0.5 * (1.0 + std::cos(2.0 * Pi * since / (7.0 * Period)));
      const double expected = 0.5 * share * std::cos(k * x - Omega * time);
      ASSERT_NEAR(positions[3 * i + 2], expected, 1e-7) << x << " at " << time;
      if (i % 17 == 0)
      {
        ASSERT_NEAR(function.at({ x, positions[3 * i + 1] }, time, motion).elevation, expected, 1e-7);
      }
    }
  }
}

TEST(WaveGroups, takeTheTimeOfTheGroupSpeedOverAnyBed)
{
  const Slope bed(30.0, 0.04);
  const auto depth = [](double x) { return 30.0 - 0.04 * x; };
  const Groups surface(toward([&](double x) { return wavenumberAt(depth(x)); }, 700.0, 5.0), bed, sevens());
  for (const std::size_t i : { std::size_t(3), std::size_t(40), std::size_t(150) })
  {
    const double x = surface.Sheet.Position[3 * i];
    double expected = 0.0;
    constexpr int steps = 4000;
    for (int j = 0; j < steps; ++j)
    {
      expected += x / steps / groupSpeedAt(depth((j + 0.5) * x / steps));
    }
    EXPECT_NEAR(surface.Moved->groupTime(i), expected, Trapezoids * expected) << x;
  }
}

TEST(WaveGroups, areCarriedByACurrent)
{
  constexpr double current = 1.5;
  const Slope bed(500.0, 0.0);
  // sigma + k U = omega
  const double k =
    rootOf([](double number) { return std::sqrt(Gravity * number) + number * current - Omega; }, 1e-4, 10.0);
  const Groups surface(toward([&](double) { return k; }, 300.0, 5.0), bed, sevens());
  const double speed = 0.5 * std::sqrt(Gravity / k) + current;
  const auto last = static_cast<std::size_t>(surface.Sheet.Offsets[1]) - 1;
  EXPECT_NEAR(surface.Moved->groupTime(last), 300.0 / speed, 1e-6);
}

TEST(WaveGroups, breakWhereTheBreakingWavesAreAsLow)
{
  // Heights fall by 0.03 from 2 m at x = 60 m on, on water of one depth, where no wave grows.
  const Slope bed(20.0, 0.0);
  const Groups surface(breaking(), bed, sevens());
  const auto section = makeWaveSection("airy");
  int whole = 0;
  int broken = 0;
  for (int wave = -20; wave <= 0; ++wave)
  {
    for (double x = 30.0; x < 110.0; x += 3.7)
    {
      const double phase = K * x;
      const double share = surface.Moved->groupShare(1, phase, wave);
      const double traced = x < 60.0 ? 2.0 : 2.0 - 0.03 * (x - 60.0);
      const CrestState crest = surface.Moved->crest(1, phase, wave, *section);
      EXPECT_NEAR(crest.height, std::min(2.0 * share, traced), 1e-6) << x << " " << share;
      EXPECT_NEAR(surface.Moved->heightShare(1, phase, wave) * traced, crest.height, 1e-6);
      const double from = 60.0 + (1.0 - share) * 2.0 / 0.03;
      if (x < from)
      {
        EXPECT_EQ(crest.plunge, 0.0) << x << " " << share;
        ++whole;
      }
      else
      {
        const BreakingStretch* stretch = surface.Moved->history(1).stretchAt(phase);
        ASSERT_NE(stretch, nullptr);
        EXPECT_NEAR(crest.plunge * stretch->plungePhase, K * (x - from), 1e-6) << x << " " << share;
        ++broken;
      }
    }
  }
  EXPECT_GT(whole, 100);
  EXPECT_GT(broken, 50);
}

TEST(WaveGroups, ofEqualWavesAreTheTracedWaves)
{
  const Slope bed(20.0, 0.0);
  const Groups alike(breaking(), bed, {});
  const Groups groups(breaking(), bed, sevens(1.0));
  for (const char* section : { "jeschke", "gonzato-lesaec", "vortex" })
  {
    EXPECT_EQ(alike.at(13.7, section), groups.at(13.7, section)) << section;
  }
}

TEST(WaveGroups, areThoseOfTheRayBesideWhichARayBegan)
{
  const Slope bed(20.0, 0.0);
  Bundle bundle = breaking();
  bundle.begin(2.5, 0);
  for (double x = 70.0; x < 120.5; x += 2.0)
  {
    bundle.add({ x, 2.5 }, K * x, { 1.0, 0.0 }, 2.0 - 0.03 * (x - 60.0), x - 60.0);
  }
  const Groups surface(bundle, bed, sevens());
  const auto section = makeWaveSection("airy");
  for (int wave = -9; wave < 0; ++wave)
  {
    for (const double x : { 40.0, 65.0, 71.0, 80.0, 95.5, 110.0 })
    {
      EXPECT_NEAR(surface.Moved->groupShare(3, K * x, wave), surface.Moved->groupShare(0, K * x, wave), 1e-9);
      // Shares left by breaking are taken as of the ray's first point.
      EXPECT_NEAR(surface.Moved->crest(3, K * x, wave, *section).height,
        surface.Moved->crest(0, K * x, wave, *section).height, 1e-6)
        << x;
    }
  }
}

TEST(WaveGroups, leaveFoamWhereTheyBreak)
{
  FoamOptions options;
  options.period = Period;
  options.life = 6.0;
  options.wavelength = Wavelength;
  options.groups = sevens(0.0);
  // A place where waves break that have more than 0.6 of the height; wave n passes it at -8 n s.
  const double phase = 0.0;
  const double began = -3.0;
  const double launch = 0.0;
  const double groupTime = 0.0;
  const double brokenShare = 0.6;
  for (int wave = -7; wave <= 0; ++wave)
  {
    const double passage = -Period * wave;
    const double high = 0.5 * (1.0 + std::cos(2.0 * Pi * wave / 7.0));
    float foam = -1.0f;
    computeFoam({ 1, &phase, &began, &launch, &groupTime, &brokenShare }, passage + 1.5, options, &foam);
    EXPECT_NEAR(foam, high >= 0.6 ? 1.0 - 1.5 / 6.0 : 0.0, 1e-6) << wave;
  }
}

TEST(WaveGroups, refuseWhatMakesNoSense)
{
  for (const WaveGroups& groups : { WaveGroups{ 1.0, 0.3 }, WaveGroups{ -3.0, 0.3 }, WaveGroups{ 7.0, -0.1 },
         WaveGroups{ 7.0, 1.1 }, WaveGroups{ std::nan(""), 0.3 } })
  {
    EXPECT_THROW(groups.validate(), std::invalid_argument);
    const Slope bed(20.0, 0.0);
    EXPECT_THROW(Groups(straight(7.0), bed, groups), std::invalid_argument);
  }
}
