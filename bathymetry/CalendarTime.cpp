#include "bathymetry/CalendarTime.h"

#include "bathymetry/Text.h"

#include <cmath>
#include <cstdio>

namespace swellray
{

namespace
{

constexpr double Day = 86400.0;

// Days since 1970-01-01 in the Gregorian calendar, years beginning in March.
long long dayNumber(long long year, int month, int day)
{
  year -= month <= 2 ? 1 : 0;
  const long long era = (year >= 0 ? year : year - 399) / 400;
  const long long yearOfEra = year - era * 400;
  const long long dayOfYear = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return era * 146097 + yearOfEra * 365 + yearOfEra / 4 - yearOfEra / 100 + dayOfYear - 719468;
}

}

std::optional<double> secondsOfTime(const std::string& text)
{
  int year = 0;
  int month = 0;
  int day = 0;
  int hour = 0;
  int minute = 0;
  double second = 0.0;
  char mark = 0;
  const bool iso =
    std::sscanf(text.c_str(), "%4d-%2d-%2d%c%2d:%2d:%lf", &year, &month, &day, &mark, &hour, &minute, &second) >= 3;
  if (!iso)
  {
    int whole = 0;
    if (std::sscanf(text.c_str(), "%4d%2d%2d.%2d%2d%2d", &year, &month, &day, &hour, &minute, &whole) < 3)
    {
      return {};
    }
    second = whole;
  }
  if (month < 1 || month > 12 || day < 1 || day > 31 || hour < 0 || hour > 24 || minute < 0 || minute > 59 ||
    !(second >= 0.0 && second < 61.0))
  {
    return {};
  }
  return Day * static_cast<double>(dayNumber(year, month, day)) + 3600.0 * hour + 60.0 * minute + second;
}

std::string timeOfSeconds(double seconds)
{
  const auto whole = static_cast<long long>(std::llround(seconds));
  const long long days = whole >= 0 ? whole / 86400 : -((86399 - whole) / 86400);
  const long long rest = whole - days * 86400;
  const long long shifted = days + 719468;
  const long long era = (shifted >= 0 ? shifted : shifted - 146096) / 146097;
  const long long dayOfEra = shifted - era * 146097;
  const long long yearOfEra = (dayOfEra - dayOfEra / 1460 + dayOfEra / 36524 - dayOfEra / 146096) / 365;
  const long long dayOfYear = dayOfEra - (365 * yearOfEra + yearOfEra / 4 - yearOfEra / 100);
  const long long marchMonth = (5 * dayOfYear + 2) / 153;
  const long long day = dayOfYear - (153 * marchMonth + 2) / 5 + 1;
  const long long month = marchMonth < 10 ? marchMonth + 3 : marchMonth - 9;
  const long long year = yearOfEra + era * 400 + (month <= 2 ? 1 : 0);
  char text[128];
  std::snprintf(text, sizeof text, "%04lld-%02lld-%02lldT%02lld:%02lld:%02lld", year, month, day, rest / 3600,
    rest / 60 % 60, rest % 60);
  return text;
}

std::optional<double> secondsOfUnits(double value, const std::string& units)
{
  const std::string words = plain(units);
  const std::size_t since = words.find(" since ");
  if (since == std::string::npos || !std::isfinite(value))
  {
    return {};
  }
  std::string epoch = words.substr(since + 7);
  const std::optional<double> start = secondsOfTime(epoch);
  const std::string unit = words.substr(0, since);
  const double step = unit == "days" || unit == "day" || unit == "d" ? Day
    : unit == "hours" || unit == "hour" || unit == "h"               ? 3600.0
    : unit == "minutes" || unit == "minute" || unit == "min"         ? 60.0
    : unit == "seconds" || unit == "second" || unit == "s"           ? 1.0
                                                                     : 0.0;
  if (!start || step == 0.0)
  {
    return {};
  }
  return *start + value * step;
}

}
