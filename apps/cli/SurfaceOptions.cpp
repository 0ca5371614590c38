#include "SurfaceOptions.h"

#include "Failure.h"
#include "OptionKinds.h"

#include "sim/sections/WaveSection.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

OptionSpec componentOption(SurfaceRequest& surface)
{
  OptionSpec spec{ "--component", "T,DIR,H", "another wave of the sea, traced on its own and added", "", "Surface",
    false, {} };
  spec.repeatable = true;
  spec.set = [&surface](const std::string& typed)
  {
    const auto values = parseNumbers("--component", typed, {});
    constexpr double turn = 360.0;
    if (values.size() != 3 || !(values[0] > 0.0) || !(std::abs(values[1]) <= turn) || !(values[2] > 0.0))
    {
      throw UsageError(
        fmt::format("--component needs T,DIR,H with a period and a height above 0 and a direction of -360 to "
                    "360 degrees, not '{}'",
          typed));
    }
    IncidentWave wave;
    wave.period = values[0];
    wave.directionFrom = values[1];
    wave.height = values[2];
    surface.components.push_back(wave);
  };
  return spec;
}

}

OptionSpec profileOption(SurfaceRequest& surface)
{
  std::string names;
  for (const FormDescription& section : waveSections())
  {
    names += (names.empty() ? "" : ", ") + section.name;
  }
  OptionSpec spec = text("--profile", "NAME:key=value,...", ("vertical section of the waves: " + names).c_str(),
    surface.profile.c_str(), "Surface", surface.profile);
  const auto setName = spec.set;
  spec.set = [setName](const std::string& typed)
  {
    setName(typed);
    try
    {
      makeWaveSection(typed);
    }
    catch (const std::invalid_argument& error)
    {
      throw UsageError(fmt::format("--profile: {}", error.what()));
    }
  };
  return spec;
}

std::vector<OptionSpec> surfaceOptions(SurfaceRequest& surface)
{
  OptionSpec seed{ "--seed", "N", "what varies from wave to wave is drawn from this", "1", "Surface", false, {} };
  seed.set = [&surface](const std::string& typed)
  { surface.seed = static_cast<int>(parseWhole("--seed", typed, 0, 2'000'000'000)); };
  return { componentOption(surface),
    number("--group-waves", "N", "waves a group: high ones in its middle, low ones between two", "all alike", "Surface",
      surface.groupWaves, { "", 2.0, 1e6 }),
    number("--group-lull", "SHARE", "height of the lowest waves of a group over that of the highest", "0.3", "Surface",
      surface.groupLull, Share),
    number("--foam-life", "S", "time until foam is gone, s", "8", "Surface", surface.foamLife, PositiveSeconds), seed };
}

void checkSurfaceOptions(const SurfaceRequest& surface)
{
  if (surface.groupLull && !surface.groupWaves)
  {
    throw UsageError("--group-lull needs --group-waves N");
  }
}

}
