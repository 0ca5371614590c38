#pragma once

#include "Options.h"

#include <optional>

namespace swellray::cli
{

/** `--times T0:T1:DT`. */
OptionSpec timesOption(std::optional<TimeSeries>& times, const char* group);

}
