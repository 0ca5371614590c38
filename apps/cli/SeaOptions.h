#pragma once

#include "Options.h"

namespace swellray::cli
{

/** Options of a sea by height and period or by a wind, but for its directions. */
std::vector<OptionSpec> seaStateOptions(SpectrumRequest& sea, const char* group);

OptionSpec spreadOption(std::optional<double>& spread, const char* group);
OptionSpec spreadOption(double& spread, const char* group);

/** Height and period go together, and not with a wind; a fetch goes with a wind. @throws UsageError */
void checkSeaState(const SpectrumRequest& sea);

}
