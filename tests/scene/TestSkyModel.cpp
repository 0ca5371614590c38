#include "apps/scene/SkyModel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace swellray::scene;

namespace
{

constexpr double Degree = 3.14159265358979323846 / 180.0;

std::array<double, 3> direction(double azimuth, double elevation)
{
  const double level = std::cos(elevation * Degree);
  return { level * std::sin(azimuth * Degree), level * std::cos(azimuth * Degree), std::sin(elevation * Degree) };
}

double luminance(const Light& light)
{
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

}

TEST(SkyModel, ZenithHasTheLuminanceOfThePaper)
{
  // Preetham, Shirley and Smits 1999, appendix A.2: Yz = (4.0453 T - 4.9710) tan chi - 0.2155 T + 2.4192 with
  // chi = (4/9 - T/120)(pi - 2 theta_s), kcd/m2. The weights of luminance above are rounded to four digits.
  constexpr double Rounding = 2e-4;
  for (const double turbidity : { 2.0, 3.0, 6.0 })
  {
    for (const double elevation : { 15.0, 40.0, 70.0 })
    {
      const SkyModel sky(120.0, elevation, turbidity);
      const double chi = (4.0 / 9.0 - turbidity / 120.0) * 2.0 * elevation * Degree;
      const double expected = (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
      EXPECT_NEAR(luminance(sky.light({ 0.0, 0.0, 1.0 })) / expected, 1.0, Rounding) << turbidity << " " << elevation;
    }
  }
}

TEST(SkyModel, SunStandsWhereItIsSaid)
{
  const SkyModel sky(90.0, 30.0);
  EXPECT_NEAR(sky.sun()[0], std::cos(30.0 * Degree), 1e-12);
  EXPECT_NEAR(sky.sun()[1], 0.0, 1e-12);
  EXPECT_NEAR(sky.sun()[2], 0.5, 1e-12);
  // Brightest at the sun, and the same on both sides of it.
  const double there = luminance(sky.light(sky.sun()));
  for (const double aside : { 10.0, 30.0, 60.0, 120.0 })
  {
    const double right = luminance(sky.light(direction(90.0 + aside, 30.0)));
    const double left = luminance(sky.light(direction(90.0 - aside, 30.0)));
    EXPECT_NEAR(right, left, 1e-9 * there);
    EXPECT_LT(right, there);
  }
}

TEST(SkyModel, IsBlueOverheadAndPaleAtTheHorizon)
{
  const SkyModel sky(180.0, 45.0);
  const Light above = sky.light(direction(0.0, 80.0));
  const Light horizon = sky.light(direction(0.0, 3.0));
  EXPECT_GT(above[2], 1.5 * above[0]);
  EXPECT_LT(horizon[2] / horizon[0], above[2] / above[0]);
  EXPECT_GT(luminance(horizon), luminance(above));
  // Below the horizon the sky goes on as at it.
  EXPECT_EQ(sky.light({ 0.0, 1.0, 0.0 }), sky.light({ 0.0, 1.0, -0.0 }));
  EXPECT_GT(sky.middleLuminance(), 0.0);
}

TEST(SkyModel, RefusesWhatIsOutOfRange)
{
  EXPECT_THROW(SkyModel(0.0, 1.0), std::invalid_argument);
  EXPECT_THROW(SkyModel(0.0, 91.0), std::invalid_argument);
  EXPECT_THROW(SkyModel(400.0, 45.0), std::invalid_argument);
  EXPECT_THROW(SkyModel(0.0, 45.0, 1.0), std::invalid_argument);
  EXPECT_THROW(SkyModel(std::nan(""), 45.0), std::invalid_argument);
}
