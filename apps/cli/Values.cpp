#include "Values.h"

#include "Failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace swellray::cli
{

namespace
{

std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos)
  {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

template <typename Number>
bool readAll(const std::string& text, Number& value)
{
  const std::string word = trimmed(text);
  const char* begin = word.data() + (!word.empty() && word[0] == '+' ? 1 : 0);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end && begin != end;
}

std::string withUnit(double value, const char* unit)
{
  return *unit ? fmt::format("{:g} {}", value, unit) : fmt::format("{:g}", value);
}

std::string rangeWords(const NumberRule& rule)
{
  const bool low = rule.low > -1e299;
  const bool high = rule.high < 1e299;
  if (low && high)
  {
    return rule.aboveLow ? fmt::format("above {:g} and at most {}", rule.low, withUnit(rule.high, rule.unit))
                         : fmt::format("within {:g} to {}", rule.low, withUnit(rule.high, rule.unit));
  }
  if (low)
  {
    return (rule.aboveLow ? "above " : "at least ") + withUnit(rule.low, rule.unit);
  }
  return "at most " + withUnit(rule.high, rule.unit);
}

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

}

double parseNumber(const std::string& option, const std::string& text, const NumberRule& rule)
{
  double value = 0.0;
  if (!readAll(text, value))
  {
    throw UsageError(*rule.unit ? fmt::format("{} needs a number of {}, not '{}'", option, rule.unit, text)
                                : fmt::format("{} needs a number, not '{}'", option, text));
  }
  if (!std::isfinite(value))
  {
    throw UsageError(fmt::format("{} must be a finite number, not {}", option, text));
  }
  if (value < rule.low || value > rule.high || (rule.aboveLow && value == rule.low))
  {
    throw UsageError(fmt::format("{} must be {}, not {}", option, rangeWords(rule), text));
  }
  return value;
}

long long parseWhole(const std::string& option, const std::string& text, long long low, long long high)
{
  long long value = 0;
  if (!readAll(text, value))
  {
    throw UsageError(fmt::format("{} needs a whole number, not '{}'", option, text));
  }
  if (value < low || value > high)
  {
    throw UsageError(fmt::format("{} must be within {} to {}, not {}", option, low, high, text));
  }
  return value;
}

std::vector<double> parseNumbers(const std::string& option, const std::string& text, const NumberRule& rule)
{
  std::vector<double> values;
  for (const std::string& part : split(text, ','))
  {
    values.push_back(parseNumber(option, part, rule));
  }
  return values;
}

std::array<int, 2> parseSize(const std::string& option, const std::string& text)
{
  const auto parts = split(text, 'x');
  if (parts.size() != 2)
  {
    throw UsageError(fmt::format("{} needs a width and a height in pixels, as in 1600x1200, not '{}'", option, text));
  }
  constexpr int Smallest = 400;
  constexpr int Largest = 8000;
  return { static_cast<int>(parseWhole(option, parts[0], Smallest, Largest)),
    static_cast<int>(parseWhole(option, parts[1], Smallest, Largest)) };
}

std::size_t parseChoice(const std::string& option, const std::string& text, const std::vector<std::string>& words)
{
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end())
  {
    throw UsageError(fmt::format("{} must be {}, not '{}'", option, alternatives(words), text));
  }
  return static_cast<std::size_t>(found - words.begin());
}

std::string alternatives(const std::vector<std::string>& words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return text;
}

}
