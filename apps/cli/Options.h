#pragma once

#include "Request.h"

#include <functional>
#include <string>
#include <vector>

namespace swellray::cli
{

/** One option as it is typed, shown by --help and named in a configuration file. */
struct OptionSpec
{
  std::string name;  ///< as typed, several separated by commas: "-o,--output"
  std::string value; ///< what stands for its value in the help; empty: a switch
  std::string help;
  std::string standard; ///< the default, in words; empty: none
  std::string group;
  bool required = false;
  std::function<void(const std::string&)> set; ///< takes the text typed; throws UsageError
  bool repeatable = false;                     ///< may be given several times

  /** The longest of its names, as messages give it. */
  std::string longName() const;
};

/** One command: what it does, what it takes, and examples of it. */
struct CommandSpec
{
  Command command = Command::Info;
  std::string name;
  std::string help;
  bool takesSeafloor = true;
  std::vector<OptionSpec> options;
  std::string examples;
};

/**
 * All commands, in the order of the help. The options write into request, which must outlive them.
 * This is the one place where an option is described.
 */
std::vector<CommandSpec> commandSpecs(Request& request);

/** Options that come before or after any command. */
std::vector<OptionSpec> commonOptions(Request& request);

/** Checks that span several options, and what follows from them. @throws UsageError */
void checkTogether(Request& request);

}
