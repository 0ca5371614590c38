#include "TimeSeriesOption.h"

#include "Failure.h"
#include "Values.h"

#include <fmt/format.h>

namespace swellray::cli
{

namespace
{

constexpr double MostFrames = 1e6;

}

OptionSpec timesOption(std::optional<TimeSeries>& times, const char* group)
{
  OptionSpec spec{ "--times", "T0:T1:DT", "first and last time and step of a series, s", "", group, false, {} };
  spec.set = [&times](const std::string& typed)
  {
    std::string commas = typed;
    for (char& c : commas)
    {
      c = c == ':' ? ',' : c == ',' ? ':' : c;
    }
    const auto values = parseNumbers("--times", commas, { "seconds" });
    if (values.size() != 3 || !(values[1] >= values[0]) || !(values[2] > 0.0))
    {
      throw UsageError(fmt::format("--times needs T0:T1:DT with T0 <= T1 and DT > 0, not '{}'", typed));
    }
    const TimeSeries series{ values[0], values[1], values[2] };
    if (!((series.last - series.first) / series.step < MostFrames))
    {
      throw UsageError("--times has more than a million frames; take a larger step");
    }
    times = series;
  };
  return spec;
}

}
