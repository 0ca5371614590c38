#include "ColorMap.h"

#include <algorithm>
#include <cmath>

namespace swellray::drawing
{

Rgb toRgb(const Lab& lab)
{
  // CIE 15: L*a*b* to XYZ for the white of D65; IEC 61966-2-1: XYZ to sRGB.
  const double fy = (lab.lightness + 16.0) / 116.0;
  const auto inverse = [](double f)
  { return f > 6.0 / 29.0 ? f * f * f : 3.0 * (6.0 / 29.0) * (6.0 / 29.0) * (f - 4.0 / 29.0); };
  const double x = 0.95047 * inverse(fy + lab.a / 500.0);
  const double y = inverse(fy);
  const double z = 1.08883 * inverse(fy - lab.b / 200.0);
  const auto encode = [](double linear)
  {
    const double c = std::clamp(linear, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
  };
  return { encode(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
    encode(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z), encode(0.0556434 * x - 0.2040259 * y + 1.0572252 * z) };
}

Lab ColorMap::lab(double t) const
{
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(this->Anchors.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), this->Anchors.size() - 2);
  const double w = place - static_cast<double>(i);
  const Lab& p = this->Anchors[i];
  const Lab& q = this->Anchors[i + 1];
  return { p.lightness + w * (q.lightness - p.lightness), p.a + w * (q.a - p.a), p.b + w * (q.b - p.b) };
}

const ColorMap& waterMap()
{
  static const ColorMap map(
    { { 90, -13, -4 }, { 81, -17, -12 }, { 72, -17, -20 }, { 63, -14, -26 }, { 54, -9, -31 }, { 45, -4, -33 } });
  return map;
}

const ColorMap& landMap()
{
  static const ColorMap map({ { 89, 0, 10 }, { 84, 2, 15 }, { 77, 4, 18 }, { 70, 6, 19 } });
  return map;
}

const ColorMap& rayMap()
{
  static const ColorMap map({ { 95, -8, 52 }, { 83, 12, 62 }, { 70, 36, 55 }, { 57, 55, 42 }, { 43, 58, 18 },
    { 30, 48, -10 }, { 18, 34, -28 } });
  return map;
}

const std::vector<std::pair<std::string, const ColorMap*>>& quantityMaps()
{
  static const ColorMap viridis({ { 15, 41, -32 }, { 22, 36, -39 }, { 29, 25, -40 }, { 36, 9, -34 }, { 42, -6, -26 },
    { 48, -18, -17 }, { 54, -31, -7 }, { 60, -41, 6 }, { 67, -50, 22 }, { 73, -52, 42 }, { 79, -45, 63 },
    { 85, -29, 80 }, { 91, -10, 85 } });
  static const ColorMap cividis({ { 14, 8, -30 }, { 22, 12, -39 }, { 30, 5, -25 }, { 37, 2, -13 }, { 44, 1, -4 },
    { 52, 0, 2 }, { 59, -2, 13 }, { 67, -3, 27 }, { 74, -5, 43 }, { 83, -7, 63 }, { 91, -10, 81 } });
  static const std::vector<std::pair<std::string, const ColorMap*>> maps{ { "warm", &rayMap() },
    { "viridis", &viridis }, { "cividis", &cividis } };
  return maps;
}

}
