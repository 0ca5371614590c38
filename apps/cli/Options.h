#pragma once

#include "Console.h"
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
  bool takesLists = false;                     ///< a list makes a sweep

  /** The longest of its names, as messages give it. */
  std::string longName() const;
};

/** The word that a command takes in place of a seafloor: a file in most. */
struct FileSpec
{
  std::string name; ///< what stands for it in the help; empty: the command takes none
  std::string help;
  std::string* target = nullptr;
  std::string standard{}; ///< what it is where none is given; empty: one must be given
};

/** One command: what it does, what it takes, and examples of it. */
struct CommandSpec
{
  std::string name;
  std::string help;
  bool takesSeafloor = true;
  std::vector<OptionSpec> options;
  std::string examples;
  std::function<void(Request&)> check =
    nullptr; ///< checks that span several options, and what follows; throws UsageError
  std::function<void(const Request&, Console&)> run = nullptr; ///< throws UsageError and WorkError
  FileSpec file{};
};

/** All commands, in the order of the help. The options write into request, which must outlive them. */
std::vector<CommandSpec> commandSpecs(Request& request);

}
