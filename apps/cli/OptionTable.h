#pragma once

#include "Options.h"

#include <string>
#include <vector>

namespace swellray::cli
{

// What help, completion and manual say of the program beside its options.

extern const char* const ProgramHelp;
extern const char* const SeafloorHelp; ///< of the argument that commands on a seafloor take
extern const char* const ExitCodes;

/** The option that names a configuration file, written to target. */
OptionSpec configurationOption(std::string& target);

/** All commands with the options that every command has: the configuration file, then commonOptions(). */
std::vector<CommandSpec> completeSpecs(Request& request, std::string& configuration);

/** The words that stand for the value of an option, those between bars as in "ode|snell"; none for any other value. */
std::vector<std::string> wordsOf(const OptionSpec& option);

/** Its name of one letter with the hyphen, as "-o"; empty: it has none. */
std::string shortName(const OptionSpec& option);

/** Whether the value is a file, or may be one; of a folder the second. */
bool takesFile(const OptionSpec& option);
bool takesFolder(const OptionSpec& option);

}
