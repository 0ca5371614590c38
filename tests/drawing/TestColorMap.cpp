#include "apps/drawing/ColorMap.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace swellray::drawing;

namespace
{

constexpr int Steps = 64;

// Steps of a scale are even where none is half as large again as the mean; viridis and cividis themselves, whose ends
// are measured in another colour space, are so within this.
constexpr double Even = 0.5;

double distance(const Lab& a, const Lab& b)
{
  return std::hypot(a.lightness - b.lightness, std::hypot(a.a - b.a, a.b - b.b));
}

double linear(double channel)
{
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

// Luminance of a colour as protanopes and deuteranopes see it: Vienot, Brettel and Mollon 1999, on linear sRGB.
double luminance(const Rgb& color, const std::array<std::array<double, 3>, 3>& eye)
{
  const std::array<double, 3> weight{ 0.2126, 0.7152, 0.0722 };
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      sum += weight[i] * eye[i][j] * linear(color[j]);
    }
  }
  return sum;
}

}

TEST(ColorMap, TurnsLabIntoScreenColours)
{
  // Known pairs: white, black, and sRGB red (CIE L*a*b* 53.24, 80.09, 67.20 under D65).
  constexpr double Rounding = 2e-3;
  const Rgb white = toRgb({ 100.0, 0.0, 0.0 });
  const Rgb black = toRgb({ 0.0, 0.0, 0.0 });
  const Rgb red = toRgb({ 53.24, 80.09, 67.20 });
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(white[i], 1.0, Rounding);
    EXPECT_NEAR(black[i], 0.0, Rounding);
    EXPECT_NEAR(red[i], i == 0 ? 1.0 : 0.0, 10 * Rounding); // steep where a channel is dark
  }
}

TEST(ColorMap, ScalesAreEven)
{
  for (const auto& [name, map] : quantityMaps())
  {
    const double mean = [&]
    {
      double sum = 0.0;
      for (int i = 0; i < Steps; ++i)
      {
        sum += distance(map->lab(static_cast<double>(i) / Steps), map->lab((i + 1.0) / Steps));
      }
      return sum / Steps;
    }();
    for (int i = 0; i < Steps; ++i)
    {
      const double step = distance(map->lab(static_cast<double>(i) / Steps), map->lab((i + 1.0) / Steps));
      EXPECT_NEAR(step / mean, 1.0, Even) << name << " at " << i;
    }
  }
}

TEST(ColorMap, ScalesReadTheSameToAnyEye)
{
  const std::array<std::array<double, 3>, 3> usual{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  const std::array<std::array<double, 3>, 3> protan{ { { 0.11238, 0.88762, 0 }, { 0.11238, 0.88762, 0 },
    { 0.00401, -0.00401, 1 } } };
  const std::array<std::array<double, 3>, 3> deutan{ { { 0.29275, 0.70725, 0 }, { 0.29275, 0.70725, 0 },
    { -0.02234, 0.02234, 1 } } };
  auto maps = quantityMaps();
  maps.emplace_back("water", &waterMap());
  for (const auto& [name, map] : maps)
  {
    for (const auto& eye : { usual, protan, deutan })
    {
      const double way = luminance(map->rgb(1.0), eye) - luminance(map->rgb(0.0), eye);
      for (int i = 0; i < Steps; ++i)
      {
        const double step =
          luminance(map->rgb((i + 1.0) / Steps), eye) - luminance(map->rgb(static_cast<double>(i) / Steps), eye);
        EXPECT_GT(step * way, 0.0) << name << " at " << i;
      }
    }
  }
}

TEST(ColorMap, StaysAtItsEndsBeyondThem)
{
  for (const auto& [name, map] : quantityMaps())
  {
    EXPECT_EQ(map->rgb(-1.0), map->rgb(0.0)) << name;
    EXPECT_EQ(map->rgb(7.0), map->rgb(1.0)) << name;
  }
}
