#include "WorkPlan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swellray::cli
{

namespace
{

// Between such numbers there is none that would be worth to be told beside them.
constexpr double AboutTheSame = 1.25;

// Rays in the lee grow no faster with those launched: on a coast with bays in its bays by some 1.3.
constexpr double LargestPower = 1.5;

std::string range(const Estimate& estimate, double unit, const char* name)
{
  const double low = estimate.low / unit;
  const double high = estimate.high / unit;
  const std::string space = *name ? " " : "";
  return high < AboutTheSame * low || high == low
    ? fmt::format("about {}{}{}", roughly(std::sqrt(low * high)), space, name)
    : fmt::format("about {} to {}{}{}", roughly(low), roughly(high), space, name);
}

}

void Estimate::limit(double most)
{
  this->low = std::min(this->low, most);
  this->high = std::min(this->high, most);
}

std::string Estimate::text() const
{
  return range(*this, 1.0, "");
}

Estimate operator*(double factor, const Estimate& estimate)
{
  return { factor * estimate.low, factor * estimate.high };
}

std::string roughly(double value)
{
  if (value < 10.0)
  {
    return fmt::format("{:.2g}", value);
  }
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  std::string digits = fmt::format("{:.0f}", unit * std::round(value / unit));
  for (std::size_t at = digits.size(); at > 3; at -= 3)
  {
    digits.insert(at - 3, ",");
  }
  return digits;
}

std::string memoryText(const Estimate& bytes)
{
  constexpr double Gigabyte = 1e9;
  return range(bytes, Gigabyte, "GB");
}

std::string timeText(const Estimate& seconds)
{
  constexpr double Minute = 60.0;
  constexpr double Hour = 3600.0;
  const double typical = std::sqrt(seconds.low * seconds.high);
  return typical < 2.0 * Minute ? range(seconds, 1.0, "s")
    : typical < 2.0 * Hour      ? range(seconds, Minute, "minutes")
                                : range(seconds, Hour, "hours");
}

Estimate extrapolate(double value, double before, double growth, double times)
{
  const double shown = before > 0.0 && value > 0.0 ? std::log(value / before) / std::log(growth) : 1.0;
  const double power = std::clamp(shown, 1.0, LargestPower);
  return { value * times, value * std::pow(times, power) };
}

}
