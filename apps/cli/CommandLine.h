#pragma once

#include "Console.h"
#include "Request.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace swellray::cli
{

/** What was asked for, and what does it. */
struct Call
{
  Request request;
  std::vector<Request> cases;                        ///< of a sweep; empty: there is none
  std::function<void(const Request&, Console&)> run; ///< throws UsageError and WorkError
};

/**
 * Read the command line and the configuration file it names.
 * @param words of the call, the program's name first
 * @return none where help or the version was asked for and has been printed
 * @throws UsageError where the call is wrong, WorkError where the configuration file cannot be read
 */
std::optional<Call> readCommandLine(const std::vector<std::string>& words);

}
