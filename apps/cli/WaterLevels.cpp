#include "WaterLevels.h"

#include "Csv.h"
#include "Failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace swellray::cli
{

namespace
{

// Days since 1970-01-01 of a date of the Gregorian calendar (Fliegel and Van Flandern 1968).
long long dayNumber(int year, int month, int day)
{
  const int shift = (month - 14) / 12;
  return (1461LL * (year + 4800 + shift)) / 4 + (367LL * (month - 2 - 12 * shift)) / 12 -
    (3LL * ((year + 4900 + shift) / 100)) / 4 + day - 32075 - 2440588;
}

bool isLeap(int year)
{
  return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

// Seconds since 1970 of a time in ISO 8601; a time without a zone is taken as UTC.
std::optional<double> isoSeconds(const std::string& text)
{
  int year = 0;
  int month = 0;
  int day = 0;
  int hour = 0;
  int minute = 0;
  double second = 0.0;
  char mark = 0;
  int used = 0;
  if (std::sscanf(text.c_str(), "%4d-%2d-%2d%c%2d:%2d%n", &year, &month, &day, &mark, &hour, &minute, &used) != 6 ||
    (mark != 'T' && mark != ' '))
  {
    return {};
  }
  std::string rest = text.substr(static_cast<std::size_t>(used));
  if (!rest.empty() && rest[0] == ':')
  {
    const std::size_t end = std::min(rest.find_first_not_of("0123456789.", 1), rest.size());
    if (!parseField(rest.substr(1, end - 1), second))
    {
      return {};
    }
    rest = rest.substr(end);
  }
  double zone = 0.0;
  if (!rest.empty() && rest != "Z")
  {
    int hours = 0;
    int minutes = 0;
    used = 0;
    if ((rest[0] != '+' && rest[0] != '-') ||
      std::sscanf(rest.c_str() + 1, "%2d:%2d%n", &hours, &minutes, &used) != 2 ||
      static_cast<std::size_t>(used) + 1 != rest.size() || hours > 18 || minutes > 59)
    {
      return {};
    }
    zone = (rest[0] == '+' ? 1.0 : -1.0) * (3600.0 * hours + 60.0 * minutes);
  }
  constexpr int Days[] = { 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31 };
  if (month < 1 || month > 12 || day < 1 || day > Days[month - 1] + (month == 2 && isLeap(year) ? 1 : 0) || hour < 0 ||
    hour > 24 || minute < 0 || minute > 59 || !(second >= 0.0 && second < 61.0))
  {
    return {};
  }
  return 86400.0 * static_cast<double>(dayNumber(year, month, day)) + 3600.0 * hour + 60.0 * minute + second - zone;
}

}

std::vector<TimedLevel> readWaterLevels(const std::string& path)
{
  std::vector<TimedLevel> series;
  std::size_t timeColumn = 0;
  std::size_t levelColumn = 1;
  bool first = true;
  bool numbers = false;
  double last = 0.0;
  for (const CsvLine& line : readCsv(path))
  {
    double level = 0.0;
    if (first && (line.fields.size() < 2 || !parseField(line.fields[1], level)) && line.fields.size() >= 2)
    {
      timeColumn = columnOf(line.fields, { "time", "date", "datetime", "t" }).value_or(0);
      levelColumn = columnOf(line.fields, { "level", "water", "waterlevel", "height", "tide", "eta" }).value_or(1);
      first = false;
      continue;
    }
    first = false;
    if (line.fields.size() <= std::max(timeColumn, levelColumn) || !parseField(line.fields[levelColumn], level))
    {
      throw WorkError(fmt::format("'{}' line {}: '{}' is no water level; it needs time,level with the level in metres",
        path, line.number, line.text));
    }
    const std::string& time = line.fields[timeColumn];
    double value = 0.0;
    const bool isNumber = parseField(time, value);
    if (!isNumber)
    {
      const std::optional<double> seconds = isoSeconds(time);
      if (!seconds)
      {
        throw WorkError(fmt::format(
          "'{}' line {}: '{}' is no time; times are ISO 8601 (2024-05-01T06:00) or numbers", path, line.number, time));
      }
      value = *seconds;
    }
    if (!series.empty() && isNumber != numbers)
    {
      throw WorkError(
        fmt::format("'{}' line {}: times are either all numbers or all of the calendar, not both", path, line.number));
    }
    if (!series.empty() && !(value > last))
    {
      throw WorkError(
        fmt::format("'{}' line {}: time {} does not come after {}", path, line.number, time, series.back().time));
    }
    numbers = isNumber;
    last = value;
    series.push_back({ time, level });
  }
  if (series.empty())
  {
    throw WorkError(fmt::format("'{}' has no water levels", path));
  }
  return series;
}

}
