#include "apps/view/WaveControls.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace swellray::view;

namespace
{

// Rounding of a handful of operations.
constexpr double Rounding = 1e-12;

}

TEST(WaveControls, RangeTakesSharesToValuesAndBack)
{
  const ControlRange straight{ -2.0, 6.0, 0.5, false };
  EXPECT_NEAR(straight.share(2.0), 0.5, Rounding);
  EXPECT_NEAR(straight.value(0.5), 2.0, Rounding);
  EXPECT_NEAR(straight.value(0.53), 2.0, Rounding); // to the step
  EXPECT_EQ(straight.value(-3.0), -2.0);
  EXPECT_EQ(straight.value(1.7), 6.0);

  const ControlRange logarithmic{ 2.0, 32.0, 0.1, true };
  EXPECT_NEAR(logarithmic.share(8.0), 0.5, Rounding);
  EXPECT_NEAR(logarithmic.value(0.25), 4.0, Rounding);
}

TEST(WaveControls, ValuesAreTheNumbersThatAreTyped)
{
  const ControlRange range{ 0.1, 10.0, 0.1, false };
  for (int i = 1; i <= 100; ++i)
  {
    EXPECT_EQ(range.value(range.share(i / 10.0)), i / 10.0);
  }
  EXPECT_EQ(range.next(0.2, 1), 0.3);
  EXPECT_EQ(range.next(0.1, -1), 0.1);
  EXPECT_EQ(range.next(10.0, 1), 10.0);
}

TEST(WaveControls, FitTheScene)
{
  // Deep-water waves of a 25th of 1 km: T^2 = 2 pi 40 m/g.
  const WaveControls controls = controlsForScene(1000.0, -90.4, 0.5);
  EXPECT_NEAR(controls.period, std::sqrt(2.0 * 3.14159265358979 * 40.0 / 9.81), 0.1);
  EXPECT_EQ(controls.directionFrom, 270.0);
  EXPECT_EQ(controls.waterLevel, 0.5);
  EXPECT_LT(controls.height, 40.0 / 7.0); // no wave is steeper
  EXPECT_GT(controls.height, 0.0);
  // No swell is longer than this on an ocean.
  EXPECT_LE(controlsForScene(1e7, 270.0, 0.0).period, 12.0);

  const ControlRanges ranges = rangesAround(controls, 30.0);
  EXPECT_LT(ranges.period.low, controls.period);
  EXPECT_GT(ranges.period.high, controls.period);
  EXPECT_GT(ranges.period.low, 0.0);
  EXPECT_GT(ranges.height.low, 0.0);
  EXPECT_NEAR(ranges.waterLevel.share(0.5), 0.5, Rounding);
}
