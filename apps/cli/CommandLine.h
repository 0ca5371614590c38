#pragma once

#include "Request.h"

#include <optional>

namespace swellray::cli
{

/**
 * Read the command line and the configuration file it names.
 * @return the request; none where help or the version was asked for and has been printed
 * @throws UsageError where the call is wrong, WorkError where the configuration file cannot be read
 */
std::optional<Request> readCommandLine(int argc, char** argv);

}
