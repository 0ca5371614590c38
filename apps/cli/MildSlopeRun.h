#pragma once

#include "Options.h"

#include <vector>

namespace swellray::cli
{

// trace --method mild-slope: waves on a map and at stations by the mild-slope equation, in place of rays.

std::vector<OptionSpec> mildSlopeOptions(MildSlopeRequest& mildSlope);

/** Options that do not go with the method. @throws UsageError */
void checkMildSlope(const Request& request);

/** Solve and write, or only say what it will take. @throws WorkError */
void runMildSlope(const Request& request, Console& console);

}
