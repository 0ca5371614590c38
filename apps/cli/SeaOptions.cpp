#include "SeaOptions.h"

#include "Failure.h"
#include "OptionKinds.h"

namespace swellray::cli
{

namespace
{

const NumberRule Spreads{ "degrees", 1.0, 80.0 };
const NumberRule Peakednesses{ "", 1.0, 20.0 };
const NumberRule Winds{ "m/s", 0.0, 200.0, true };

constexpr const char* SpreadHelp = "circular standard deviation of the directions, degrees";

}

OptionSpec spreadOption(std::optional<double>& spread, const char* group)
{
  return number("--spread", "DEG", SpreadHelp, "", group, spread, Spreads);
}

OptionSpec spreadOption(double& spread, const char* group)
{
  return number("--spread", "DEG", SpreadHelp, "25", group, spread, Spreads);
}

std::vector<OptionSpec> seaStateOptions(SpectrumRequest& sea, const char* group)
{
  return {
    number("--hs", "M", "significant wave height, m", "", group, sea.height, PositiveMetres),
    number("--tp", "S", "peak period, s", "", group, sea.peakPeriod, PositiveSeconds),
    number("--direction", "DEG", "mean direction the sea comes from, degrees clockwise from north", "", group,
      sea.directionFrom, Degrees),
    choice("--shape", "shape of the spectrum", "jonswap", group, sea.shape,
      std::vector<std::pair<std::string, SpectrumShape>>{ { "jonswap", SpectrumShape::Jonswap },
        { "pierson-moskowitz", SpectrumShape::PiersonMoskowitz }, { "tma", SpectrumShape::Tma } }),
    number("--peakedness", "G", "peak enhancement of jonswap and tma", "3.3", group, sea.peakedness, Peakednesses),
    number("--wind", "M/S", "the sea of this wind at 10 m height, m/s", "", group, sea.wind, Winds),
    number("--fetch", "M", "fetch of the wind, m", "without end", group, sea.fetch, PositiveMetres),
  };
}

void checkSeaState(const SpectrumRequest& sea)
{
  if ((sea.height || sea.peakPeriod) && !(sea.height && sea.peakPeriod))
  {
    throw UsageError(sea.height ? "--hs needs --tp S" : "--tp needs --hs M");
  }
  if (sea.fetch && !sea.wind)
  {
    throw UsageError("--fetch needs --wind M/S");
  }
}

}
