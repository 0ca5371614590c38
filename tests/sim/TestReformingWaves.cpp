#include "TracedSurface.h"

#include "sim/Angles.h"
#include "sim/SurfaceFunction.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

using namespace swellray;

namespace
{

constexpr double Period = 9.0;

// Swell of 1.5 m breaks on this bar and again on the beach.
constexpr const char* Bar = "bar:y0=-60,y1=60,x1=800";

IncidentWave swell()
{
  IncidentWave wave;
  wave.period = Period;
  wave.directionFrom = 90.0;
  wave.height = 1.5;
  return wave;
}

const TracedSurface& overTheBar(BreakingRule rule)
{
  const auto make = [](BreakingRule breaking)
  {
    HeightOptions losses;
    losses.breaking = breaking;
    return TracedSurface(Bar, swell(), losses, 40.0, 48.0);
  };
  static const TracedSurface dally = make(BreakingRule::Dally);
  static const TracedSurface gamma = make(BreakingRule::Gamma);
  return rule == BreakingRule::Dally ? dally : gamma;
}

/** The way to the bar, the bar, and the water behind it as far as the beach. */
std::vector<double> phasesOf(const BreakingStretch& bar, int count)
{
  std::vector<double> phases;
  for (int i = 0; i <= count; ++i)
  {
    phases.push_back(bar.begin - Pi + (bar.end + ReformingPhase - bar.begin + 2.0 * Pi) * i / count);
  }
  return phases;
}

double apart(const CrestState& a, const CrestState& b)
{
  // Of a wave that is whole the shape is the same however much of it is left.
  const auto fallen = [](const CrestState& crest) { return std::min(crest.plunge, 1.0); };
  return std::abs(a.height - b.height) + std::abs(fallen(a) - fallen(b)) + std::abs(a.ripeness - b.ripeness) +
    std::abs(fallen(a) * a.roller - fallen(b) * b.roller) +
    std::abs(fallen(a) * a.plungeHeight - fallen(b) * b.plungeHeight);
}

}

class ReformingWaves : public ::testing::TestWithParam<std::tuple<std::string, BreakingRule>>
{
};

TEST_P(ReformingWaves, moveTheSurfaceWithoutAJump)
{
  // Where each place goes, at times ever closer: what is continuous falls with the step, a jump stays.
  const auto& [name, rule] = GetParam();
  const TracedSurface& traced = overTheBar(rule);
  const auto section = makeWaveSection(name);
  const SurfaceFunction function(traced.surface());
  const BreakingStretch bar = traced.surface().history(1).stretches().front();
  ASSERT_GE(traced.surface().history(1).stretches().size(), 2u);
  const auto first = static_cast<std::size_t>(traced.sheet().Offsets[1]);
  const auto last = static_cast<std::size_t>(traced.sheet().Offsets[2]);
  const double omega = 2.0 * Pi / Period;
  const auto largestJump = [&](int steps)
  {
    double largest = 0.0;
    for (std::size_t i = first; i < last; i += 5)
    {
      const double phase = traced.sheet().Phase[i];
      std::vector<SheetPlace> sheets;
      function.cover({ traced.sheet().Position[3 * i], traced.sheet().Position[3 * i + 1] + 1e-6 }, sheets);
      if (phase < bar.begin - Pi || phase > bar.end + ReformingPhase + Pi || sheets.size() != 1)
      {
        continue;
      }
      // The crest of wave 0 comes from half a wave before the place to half a wave beyond it.
      glm::dvec3 before(0.0);
      for (int step = 0; step <= steps; ++step)
      {
        const double crest = phase + Pi * (2.0 * step / steps - 1.0);
        const glm::dvec3 now = function.move(sheets[0], crest / omega, *section).position;
        // The two sides of a lip that has come down end apart (table 1 of the paper), at the crest.
        const bool lip = 2 * step == steps || 2 * (step - 1) == steps;
        largest = step > 0 && !lip ? std::max(largest, glm::distance(now, before)) : largest;
        before = now;
      }
    }
    return largest;
  };
  const double coarse = largestJump(400);
  const double fine = largestJump(1600);
  const double finest = largestJump(6400);
  ASSERT_GT(coarse, 0.0);
  // A lip begins to fall as t^0.85 (table 1): a quarter of the step leaves a third of the way.
  constexpr double left = 0.4;
  EXPECT_LT(fine, left * coarse);
  EXPECT_LT(finest, left * fine);
}

TEST_P(ReformingWaves, keepTheirShapeAsLongAsTheTraceSaysThatTheyBreak)
{
  const auto& [name, rule] = GetParam();
  const TracedSurface& traced = overTheBar(rule);
  const SurfHistory& history = traced.surface().history(1);
  const BreakingStretch bar = history.stretches().front();
  for (const double phase : phasesOf(bar, 200))
  {
    const CrestState crest = history.crest(phase, 0.0);
    if (phase < bar.begin)
    {
      EXPECT_EQ(crest.plunge, 0.0);
    }
    else if (phase <= bar.end)
    {
      EXPECT_NEAR(crest.plunge, (phase - bar.begin) / bar.plungePhase, 1e-12);
      EXPECT_EQ(crest.roller, 1.0);
      EXPECT_EQ(crest.ripeness, 1.0);
    }
    else if (phase < bar.end + ReformingPhase)
    {
      EXPECT_GT(crest.plunge, 0.0);
      EXPECT_LT(crest.roller, 1.0);
    }
  }
  EXPECT_EQ(history.crest(bar.end + 1.001 * ReformingPhase, 0.0).plunge, 0.0);
  // The height is the trace's all the way: the shape alone changes.
  EXPECT_NEAR(history.crest(bar.end - 1e-9, 0.0).height, history.crest(bar.end + 1e-9, 0.0).height, 1e-6);
}

TEST_P(ReformingWaves, leaveFoamThatThinsOut)
{
  const auto& [name, rule] = GetParam();
  const TracedSurface& traced = overTheBar(rule);
  const SurfHistory& history = traced.surface().history(1);
  const BreakingStretch bar = history.stretches().front();
  EXPECT_TRUE(std::isnan(history.foam(bar.begin - 1e-9).begin));
  EXPECT_EQ(history.foam(0.5 * (bar.begin + bar.end)).begin, bar.begin);
  EXPECT_EQ(history.foam(0.5 * (bar.begin + bar.end)).share, 1.0);
  EXPECT_NEAR(history.foam(bar.end + 0.5 * ReformingPhase).share, 0.5, 1e-12);
  EXPECT_TRUE(std::isnan(history.foam(bar.end + ReformingPhase + 1e-6).begin));
  constexpr int count = 2000;
  const std::vector<double> phases = phasesOf(bar, count);
  for (std::size_t i = 1; i < phases.size(); ++i)
  {
    if (phases[i - 1] >= bar.begin && phases[i] < history.stretches()[1].begin)
    {
      // Three halves is the steepest of the smooth step.
      EXPECT_LE(std::abs(history.foam(phases[i]).share - history.foam(phases[i - 1]).share),
        1.5 * (phases[i] - phases[i - 1]) / ReformingPhase + 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OverABar, ReformingWaves,
  ::testing::Combine(::testing::Values("vortex", "jeschke", "vortex:variation=0", "jeschke:variation=0"),
    ::testing::Values(BreakingRule::Dally, BreakingRule::Gamma)));

TEST(ReformingHistory, isContinuousHoweverShortTheStretchesAndTheWaysBetween)
{
  // Waves stop breaking for some way, again and again.
  for (const double length : { 0.05, 0.3, 2.0 })
  {
    for (const double gap : { 0.05, 0.5, 3.0, 6.0, 6.28, 6.3, 9.0 })
    {
      std::vector<double> phase, height, wavenumber, depth, slope, distance;
      std::vector<std::uint8_t> breaking;
      constexpr double step = 0.01;
      constexpr double first = 1.0;
      for (int i = 0; i <= 1600; ++i)
      {
        const double s = step * i;
        const double within = s < first ? -1.0 : std::fmod(s - first, length + gap);
        const bool broken = within >= 0.0 && within <= length + 1e-9;
        phase.push_back(s);
        height.push_back(1.5 - 0.01 * s);
        wavenumber.push_back(0.2);
        depth.push_back(height.back() / 0.78);
        slope.push_back(0.02);
        distance.push_back(broken ? (within + 1e-6) / 0.2 : 0.0);
        breaking.push_back(broken ? 1 : 0);
      }
      const SurfHistory history({ phase.size(), phase.data(), height.data(), wavenumber.data(), depth.data(),
                                  slope.data(), distance.data(), breaking.data() },
        0.78);
      ASSERT_GE(history.stretches().size(), 2u);
      for (const double delay : { 0.0, 0.4 })
      {
        const auto largestJump = [&](int count)
        {
          double largest = 0.0;
          CrestState before = history.crest(0.0, delay);
          for (int i = 1; i <= count; ++i)
          {
            const CrestState now = history.crest(15.0 * i / count, delay);
            largest = std::max(largest, apart(before, now));
            before = now;
          }
          return largest;
        };
        // A jump would stay; what is steepest takes a few steps of the coarser ones.
        EXPECT_LT(largestJump(150000), 0.2 * largestJump(15000) + 1e-3) << length << " " << gap << " " << delay;
      }
    }
  }
}
