#include "ElevationOutput.h"

#include "Failure.h"
#include "OptionKinds.h"
#include "OutputFile.h"

#include "sim/ElevationSeries.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

constexpr const char* Group = "Elevation in time";
constexpr double MostSamples = 1e6;

}

std::vector<OptionSpec> elevationOptions(Request& request)
{
  ElevationRequest& elevation = request.elevation;
  OptionSpec series = outputFile(
    "--elevation-series", "surface elevation at the stations in time, .csv", request.output.elevations, { ".csv" });
  OptionSpec seed{ "--seed", "N", "phases are drawn from this", "1", Group, false, {} };
  seed.set = [&elevation](const std::string& typed)
  { elevation.seed = static_cast<int>(parseWhole("--seed", typed, 0, 2'000'000'000)); };
  return { series,
    number("--duration", "S", "length of the elevation record, s", "1200", Group, elevation.duration, PositiveSeconds),
    number("--interval", "S", "time between its samples, s", "0.5", Group, elevation.interval, PositiveSeconds), seed };
}

void checkElevation(const Request& request)
{
  const double count = request.elevation.duration / request.elevation.interval;
  if (!request.output.elevations.empty() && !(count >= 2.0 && count <= MostSamples))
  {
    throw UsageError(fmt::format("--duration over --interval is {:g} samples; it must be 2 to a million", count));
  }
}

void writeElevations(const std::vector<DirectionalSpectrum>& spectra, const Request& request, const OutputFile& file,
  const Console& console)
{
  ElevationTimes times;
  times.interval = request.elevation.interval;
  times.cover(request.elevation.duration);
  times.seed = static_cast<unsigned>(request.elevation.seed);
  std::vector<std::vector<double>> records;
  std::ofstream table(file.temporary(), std::ios::trunc);
  table << "Time";
  for (std::size_t i = 0; i < spectra.size(); ++i)
  {
    table << ",Elevation" << i + 1;
    records.emplace_back();
    times.index = i;
    if (!spectra[i].density.empty())
    {
      try
      {
        records.back() = elevationSeries(spectra[i], times);
      }
      catch (const std::invalid_argument& error)
      {
        throw WorkError(fmt::format("elevation at station {}: {}", i + 1, error.what()));
      }
    }
  }
  table << '\n';
  std::string line;
  for (std::size_t n = 0; n < times.count; ++n)
  {
    line = fmt::format("{:.10g}", static_cast<double>(n) * times.interval);
    for (const std::vector<double>& record : records)
    {
      line += record.empty() ? "," : fmt::format(",{:.5f}", record[n]);
    }
    table << line << '\n';
  }
  table.close();
  if (!table)
  {
    file.fail("the disk is full, or files may not get so large");
  }
  console.say(
    fmt::format("elevation {} samples, {:g} s apart, at {} stations", times.count, times.interval, spectra.size()));
}

}
