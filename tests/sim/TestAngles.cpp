#include "sim/Angles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace swellray;

// Rounding of angles up to 360 degrees.
constexpr double Rounding = 1e-13;

TEST(Angles, NauticalDirectionsComeFromTheCompass)
{
  // From the west: goes to +x. From the north: goes to -y. From the north-east: goes to the south-west.
  EXPECT_NEAR(headingFromNautical(270.0), 0.0, Rounding);
  EXPECT_NEAR(headingFromNautical(0.0), 1.5 * Pi, Rounding);
  EXPECT_NEAR(std::cos(headingFromNautical(45.0)), -std::sqrt(0.5), Rounding);
  EXPECT_NEAR(std::sin(headingFromNautical(45.0)), -std::sqrt(0.5), Rounding);
  EXPECT_DOUBLE_EQ(nauticalFromVector({ 1.0, 0.0 }), 270.0);
  EXPECT_DOUBLE_EQ(nauticalFromVector({ -2.0, 0.0 }), 90.0);
  EXPECT_DOUBLE_EQ(nauticalFromVector({ 0.0, 3.0 }), 180.0);
  EXPECT_DOUBLE_EQ(nauticalFromVector({ 0.0, -3.0 }), 0.0);
}

TEST(Angles, ThereAndBack)
{
  for (double nautical = -360.0; nautical <= 360.0; nautical += 7.5)
  {
    const double theta = headingFromNautical(nautical);
    const double back = nauticalFromVector({ std::cos(theta), std::sin(theta) });
    EXPECT_NEAR(std::remainder(back - nautical, 360.0), 0.0, Rounding) << nautical;
    EXPECT_GE(back, 0.0);
    EXPECT_LT(back, 360.0);
  }
}

TEST(Angles, WrappingStaysBelowAFullTurn)
{
  EXPECT_DOUBLE_EQ(wrapDegrees(-90.0), 270.0);
  EXPECT_DOUBLE_EQ(wrapDegrees(360.0), 0.0);
  EXPECT_DOUBLE_EQ(wrapDegrees(-720.0), 0.0);
  EXPECT_DOUBLE_EQ(wrapDegrees(725.0), 5.0);
  // 360 less a little rounds to 360, which must become 0.
  EXPECT_DOUBLE_EQ(wrapDegrees(-1e-20), 0.0);
}

}
