#include "sim/SurfHistory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace swellray;

namespace
{

constexpr double Rounding = 1e-12;

/** A ray with a point a metre: shoals, breaks at 10.4 m, is whole again from 16 m on and breaks again at 18.5 m. */
struct Ray
{
  Ray()
  {
    for (int i = 0; i <= 20; ++i)
    {
      const bool first = i > 10 && i < 16;
      const bool second = i > 18;
      this->Phase.push_back(0.5 * i);
      this->Height.push_back(i <= 10 ? 1.0 : 1.0 - 0.05 * (i - 10));
      this->Wavenumber.push_back(0.5);
      this->Depth.push_back(4.0 - 0.18 * i);
      this->Slope.push_back(0.18);
      this->Distance.push_back(first ? i - 10.4 : second ? i - 18.5 : 0.0);
      this->Breaking.push_back(first || second ? 1 : 0);
    }
  }

  HistoryRay arrays(std::size_t begin = 0) const
  {
    return { this->Phase.size() - begin, this->Phase.data() + begin, this->Height.data() + begin,
      this->Wavenumber.data() + begin, this->Depth.data() + begin, this->Slope.data() + begin,
      this->Distance.data() + begin, this->Breaking.data() + begin };
  }

  std::vector<double> Phase, Height, Wavenumber, Depth, Slope, Distance;
  std::vector<std::uint8_t> Breaking;
};

}

TEST(SurfHistory, breakingBeginsWhereTheTraceSays)
{
  const Ray ray;
  const SurfHistory history(ray.arrays(), 0.78);
  ASSERT_EQ(history.stretches().size(), 2u);
  EXPECT_NEAR(history.stretches()[0].begin, 5.2, Rounding);
  EXPECT_NEAR(history.stretches()[0].end, 7.75, Rounding);
  EXPECT_NEAR(history.stretches()[1].begin, 9.25, Rounding);
  EXPECT_EQ(history.stretchAt(5.1), nullptr);
  EXPECT_EQ(history.stretchAt(5.3), &history.stretches()[0]);
  EXPECT_EQ(history.stretchAt(8.5), nullptr);
  // What breaks up to the end of a ray is broken beyond it.
  EXPECT_EQ(history.stretchAt(50.0), &history.stretches()[1]);
}

TEST(SurfHistory, crestsPlungeOverGalvinsDistance)
{
  EXPECT_NEAR(plungeDistance(0.1), 4.0 - 0.925, Rounding);
  EXPECT_NEAR(plungeDistance(0.0), 4.0, Rounding);
  EXPECT_NEAR(plungeDistance(-0.1), 4.0, Rounding);
  EXPECT_NEAR(plungeDistance(1.0), 1.0, Rounding);
  const Ray ray;
  const SurfHistory history(ray.arrays(), 0.78);
  const double height = 0.98; // at 10.4 m
  const double length = (4.0 - 9.25 * 0.18) * height;
  EXPECT_NEAR(history.stretches()[0].plungePhase, 0.5 * length, Rounding);
  EXPECT_EQ(history.crest(5.0, 0.0).plunge, 0.0);
  EXPECT_NEAR(history.crest(0.5 * (10.4 + 0.5 * length), 0.0).plunge, 0.5, Rounding);
  EXPECT_NEAR(history.crest(0.5 * (10.4 + length), 0.0).plunge, 1.0, Rounding);
  EXPECT_NEAR(history.crest(6.0, 0.0).plungeHeight, 1.0 - 0.05 * (0.4 + length), Rounding);
}

TEST(SurfHistory, aDelayedWaveBreaksLaterAndNeverSooner)
{
  const Ray ray;
  const SurfHistory history(ray.arrays(), 0.78);
  EXPECT_EQ(history.crest(5.6, 0.5).plunge, 0.0);
  EXPECT_NEAR(history.crest(6.0, 0.5).plunge, history.crest(5.5, 0.0).plunge, Rounding);
}

TEST(SurfHistory, ripenessGrowsTo1WhereTheWaveBreaks)
{
  const Ray ray;
  const SurfHistory history(ray.arrays(), 0.78);
  const double index = 0.98 / (4.0 - 0.18 * 10.4);
  EXPECT_NEAR(history.crest(0.0, 0.0).ripeness, 0.25 / index, Rounding);
  EXPECT_LT(history.crest(5.0, 0.0).ripeness, 1.0);
  EXPECT_GT(history.crest(5.0, 0.0).ripeness, 0.9);
  EXPECT_EQ(history.crest(6.0, 0.0).ripeness, 1.0);
}

TEST(SurfHistory, anInsertedRayGoesOnWithTheBreakingBesideIt)
{
  const Ray ray;
  const SurfHistory parent(ray.arrays(), 0.78);
  SurfHistory child(ray.arrays(13), 0.78);
  child.continueFrom(parent);
  ASSERT_EQ(child.stretches().size(), 2u);
  EXPECT_NEAR(child.stretches()[0].begin, 5.2, Rounding);
  for (const double phase : { 6.5, 7.0, 7.5 })
  {
    EXPECT_NEAR(child.crest(phase, 0.0).plunge, parent.crest(phase, 0.0).plunge, Rounding);
    EXPECT_NEAR(child.crest(phase, 0.0).plungeHeight, parent.crest(phase, 0.0).plungeHeight, Rounding);
  }
  // One that begins whole has no past.
  SurfHistory whole(ray.arrays(17), 0.78);
  whole.continueFrom(parent);
  EXPECT_NEAR(whole.stretches()[0].begin, 9.25, Rounding);
}

TEST(SurfHistory, delaysVaryFromWaveToWaveAndSmoothlyAlongACrest)
{
  double low = 1.0;
  double high = 0.0;
  for (std::int64_t wave = -50; wave < 50; ++wave)
  {
    const double delay = breakingDelay(1, wave, 300.0, 100.0);
    low = std::min(low, delay);
    high = std::max(high, delay);
    // The steepest of the three sines: 2 pi/90 m.
    EXPECT_LT(std::abs(breakingDelay(1, wave, 301.0, 100.0) - delay), 0.035);
  }
  EXPECT_GE(low, 0.0);
  EXPECT_LE(high, 1.0);
  EXPECT_GT(high - low, 0.5);
  EXPECT_EQ(breakingDelay(1, 7, 20.0, 100.0), breakingDelay(1, 7, 20.0, 100.0));
  EXPECT_NE(breakingDelay(1, 7, 20.0, 100.0), breakingDelay(2, 7, 20.0, 100.0));
}
