#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace swellray::cli
{

/** Range and unit of a number that is typed; the unit is used in messages ("seconds"). */
struct NumberRule
{
  const char* unit = "";
  double low = -1e300;
  double high = 1e300;
  bool aboveLow = false; ///< low itself is out of range
};

/** A finite number within the rule. @throws UsageError naming the option, its range and the text */
double parseNumber(const std::string& option, const std::string& text, const NumberRule& rule);

/** A whole number within low to high. @throws UsageError */
long long parseWhole(const std::string& option, const std::string& text, long long low, long long high);

/** Numbers with commas between. @throws UsageError */
std::vector<double> parseNumbers(const std::string& option, const std::string& text, const NumberRule& rule);

/** A width and a height in pixels, as in 1600x1200. @throws UsageError */
std::array<int, 2> parseSize(const std::string& option, const std::string& text);

/** Place of the word in the list. @throws UsageError that lists them */
std::size_t parseChoice(const std::string& option, const std::string& text, const std::vector<std::string>& words);

/** Words as "a, b or c". */
std::string alternatives(const std::vector<std::string>& words);

}
