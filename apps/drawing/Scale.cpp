#include "Scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace swellray::drawing
{

double roundNumber(double value)
{
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double digit = value / power;
  return (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0) * power;
}

std::string Ticks::label(double value) const
{
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(this->step) + 1e-9)));
  // No minus sign before a zero.
  const double shown = std::abs(value) < 1e-6 * this->step ? 0.0 : value;
  return fmt::format("{:.{}f}", shown, decimals);
}

Ticks ticksWithin(double low, double high, int count)
{
  Ticks ticks;
  if (!(high > low))
  {
    ticks.values = { low };
    return ticks;
  }
  // The round number nearest to the step wanted, by ratio.
  ticks.step = roundNumber(1.45 * (high - low) / count);
  const double slack = 1e-9 * (high - low);
  for (double n = std::ceil((low - slack) / ticks.step); n * ticks.step <= high + slack; n += 1.0)
  {
    ticks.values.push_back(n * ticks.step);
  }
  return ticks;
}

Range roundRange(double low, double high)
{
  const double width = high > low ? high - low : std::max(1e-3, 0.1 * std::abs(low));
  const double step = roundNumber(width / 5.0);
  return { step * std::floor(low / step + 1e-9), step * std::ceil((low + width) / step - 1e-9) };
}

std::string shortNumber(double value)
{
  return fmt::format("{:.6g}", value);
}

std::string compassPoint(double degrees)
{
  constexpr std::array<const char*, 16> Points{ "N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE", "S", "SSW", "SW",
    "WSW", "W", "WNW", "NW", "NNW" };
  const double turn = degrees / 360.0 - std::floor(degrees / 360.0);
  return Points[static_cast<std::size_t>(std::lround(16.0 * turn)) % 16];
}

}
