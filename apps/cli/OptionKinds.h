#pragma once

#include "Options.h"
#include "Values.h"

#include <string>
#include <utility>
#include <vector>

namespace swellray::cli
{

// Builders of the kinds of options that commands take.

extern const NumberRule Metres;
extern const NumberRule PositiveMetres;
extern const NumberRule NonNegativeMetres;
extern const NumberRule PositiveSeconds;
extern const NumberRule Degrees; ///< -360 to 360
extern const NumberRule PlainNumber;
extern const NumberRule PositiveNumber;
extern const NumberRule NonNegativeNumber;
extern const NumberRule Share; ///< 0 to 1

/** A number within the rule, written to target. */
template <typename Target>
OptionSpec number(const char* name, const char* value, const char* help, const char* standard, const char* group,
  Target& target, const NumberRule& rule)
{
  OptionSpec spec{ name, value, help, standard, group, false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, rule, longName](const std::string& text) { target = parseNumber(longName, text, rule); };
  return spec;
}

/** One of several words, each standing for a value. */
template <typename Target, typename Value>
OptionSpec choice(const char* name, const char* help, const char* standard, const char* group, Target& target,
  const std::vector<std::pair<std::string, Value>>& values)
{
  std::vector<std::string> words;
  std::string shown;
  for (const auto& entry : values)
  {
    words.push_back(entry.first);
    shown += (shown.empty() ? "" : "|") + entry.first;
  }
  OptionSpec spec{ name, shown, help, standard, group, false, {} };
  const std::string longName = spec.longName();
  spec.set = [&target, values, words, longName](const std::string& text)
  { target = values[parseChoice(longName, text, words)].second; };
  return spec;
}

/** A text that is not empty. */
OptionSpec text(
  const char* name, const char* value, const char* help, const char* standard, const char* group, std::string& target);

/** A switch. */
OptionSpec flag(const char* name, const char* help, const char* group, bool& target);

/** A file to write, whose name ends in one of the endings. */
OptionSpec outputFile(const char* name, const char* help, std::string& target, const std::vector<std::string>& endings);

/** Append options. */
void add(std::vector<OptionSpec>& options, std::vector<OptionSpec> more);

}
