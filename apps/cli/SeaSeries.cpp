#include "SeaSeries.h"

#include "Console.h"
#include "Csv.h"
#include "Failure.h"
#include "OutputFile.h"
#include "StationTable.h"

#include "sim/Angles.h"
#include "sim/SeaTransfer.h"

#include <fmt/format.h>

#include <vtkSMPTools.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

constexpr double BandShare = 0.995;

// The loop of the core on VTK's threads; what a body throws comes out on the calling one.
void inParallel(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
{
  std::mutex mutex;
  std::exception_ptr failure;
  vtkSMPTools::For(0, static_cast<vtkIdType>(n),
    [&](vtkIdType begin, vtkIdType end)
    {
      try
      {
        body(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        failure = failure ? failure : std::current_exception();
      }
    });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

bool isMissing(const std::string& field)
{
  return field.empty() || field == "nan" || field == "NaN" || field == "NA";
}

double parseColumn(const std::string& path, const CsvLine& line, std::size_t column, const char* what, double low,
  double high, bool aboveLow)
{
  double value = 0.0;
  if (column >= line.fields.size() || !parseField(line.fields[column], value) || value < low || value > high ||
    (aboveLow && value == low))
  {
    throw WorkError(fmt::format("'{}' line {}: '{}' is no {}; it must be {} {:g} and at most {:g}", path, line.number,
      column < line.fields.size() ? line.fields[column] : "", what, aboveLow ? "above" : "at least", low, high));
  }
  return value;
}

}

SeaSeries::SeaSeries(const std::string& path, const SeaState& form)
  : Path(path)
{
  if (std::filesystem::path(path).extension() != ".csv")
  {
    try
    {
      SpectrumFile file = readSpectra(path);
      const auto place = file.records.front().place;
      for (SpectrumRecord& record : file.records)
      {
        if (record.place == place)
        {
          this->Times.push_back(record.time);
          this->Records.push_back(std::move(record));
        }
      }
    }
    catch (const std::exception& error)
    {
      throw WorkError(error.what());
    }
    return;
  }
  std::optional<std::size_t> time;
  std::optional<std::size_t> height;
  std::optional<std::size_t> period;
  std::optional<std::size_t> direction;
  std::optional<std::size_t> spread;
  bool first = true;
  for (const CsvLine& line : readCsv(path))
  {
    if (first)
    {
      first = false;
      time = columnOf(line.fields, { "time", "date", "datetime", "t" });
      height = columnOf(line.fields, { "hs", "hm0", "swh", "wvht", "significantwaveheight" });
      period = columnOf(line.fields, { "tp", "dpd", "peakperiod" });
      direction = columnOf(line.fields, { "direction", "dir", "mwd", "dp", "meandirectionfrom", "mdir" });
      spread = columnOf(line.fields, { "spread", "spr", "dspr", "directionalspread" });
      if (!time || !height || !period || !direction)
      {
        throw WorkError(fmt::format("'{}' line {}: the columns time, hs, tp and direction are needed (spread if it "
                                    "varies); the line has '{}'",
          path, line.number, line.text));
      }
      continue;
    }
    const auto missing = [&](std::size_t column)
    { return column < line.fields.size() && isMissing(line.fields[column]); };
    this->Times.push_back(*time < line.fields.size() ? line.fields[*time] : "");
    if (this->Times.back().empty())
    {
      throw WorkError(fmt::format("'{}' line {} has no time", path, line.number));
    }
    if (missing(*height) || missing(*period) || missing(*direction) || (spread && missing(*spread)))
    {
      this->States.emplace_back();
      continue;
    }
    SeaState state = form;
    state.wind = state.fetch = std::nullopt;
    state.height = parseColumn(path, line, *height, "significant height", 0.0, 100.0, false);
    state.peakPeriod = parseColumn(path, line, *period, "peak period", 0.0, 1000.0, true);
    state.directionFrom = parseColumn(path, line, *direction, "direction", -360.0, 360.0, false);
    if (spread)
    {
      state.spread = parseColumn(path, line, *spread, "spread", 1.0, 80.0, false);
    }
    this->States.emplace_back(state);
  }
  if (this->Times.empty())
  {
    throw WorkError(fmt::format("'{}' has no seas", path));
  }
}

std::optional<SeaState> SeaSeries::firstState() const
{
  for (const auto& state : this->States)
  {
    if (state && state->height > 0.0)
    {
      return state;
    }
  }
  if (this->Records.empty())
  {
    throw WorkError(fmt::format("'{}' has no sea that is higher than 0", this->Path));
  }
  return {};
}

std::array<double, 2> SeaSeries::band() const
{
  std::array<double, 2> whole{ 1e300, 0.0 };
  const auto widen = [&](const std::array<double, 2>& band) {
    whole = { std::min(whole[0], band[0]), std::max(whole[1], band[1]) };
  };
  for (const SpectrumRecord& record : this->Records)
  {
    if (seaParameters(record.spectrum).significantHeight > 0.0)
    {
      widen(energyBand(record.spectrum, BandShare));
    }
  }
  // The band of a shape goes with its peak: the longest and the shortest periods tell.
  std::array<const SeaState*, 2> ends{ nullptr, nullptr };
  for (const auto& state : this->States)
  {
    if (state && state->height > 0.0)
    {
      ends[0] = !ends[0] || state->peakPeriod > ends[0]->peakPeriod ? &*state : ends[0];
      ends[1] = !ends[1] || state->peakPeriod < ends[1]->peakPeriod ? &*state : ends[1];
    }
  }
  for (const SeaState* state : ends)
  {
    if (state)
    {
      const SpectralGrid grid = spectralGridOf(state->spectrum(), 2, 4);
      widen({ grid.frequencies.front(), grid.frequencies.back() });
    }
  }
  if (!(whole[1] > whole[0]))
  {
    throw WorkError(fmt::format("'{}' has no sea that is higher than 0", this->Path));
  }
  return whole;
}

bool SeaSeries::sample(std::size_t i, const SpectralGrid& grid, double* density) const
{
  try
  {
    if (!this->Records.empty())
    {
      const std::vector<double> made = resample(this->Records[i].spectrum, grid).density;
      std::copy(made.begin(), made.end(), density);
      return true;
    }
    const auto& state = this->States[i];
    if (!state)
    {
      return false;
    }
    if (state->height == 0.0)
    {
      std::fill(density, density + grid.size(), 0.0);
      return true;
    }
    const DirectionalSpectrum made = DirectionalSpectrum::sample(grid, state->spectrum(),
      DirectionalSpreading::cosinePower(radians(state->spread)), headingFromNautical(state->directionFrom));
    std::copy(made.density.begin(), made.density.end(), density);
    return true;
  }
  catch (const std::invalid_argument& error)
  {
    throw WorkError(fmt::format("'{}', time {}: {}", this->Path, this->Times[i], error.what()));
  }
}

SeriesOutcome writeSeaSeries(const SeaSeries& series, const SpectralRays& rays,
  const std::vector<SpectralOrigins>& origins, std::optional<double> gamma, const StationTable& stations,
  const OutputFile& file, Console& console)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const SpectralGrid offshore{ rays.grid.frequencies,
    SpectralGrid::logarithmic(0.1, 1.0, 2, OffshoreDirections).headings };
  Execution execution;
  execution.loop = inParallel;
  const SeaTransfer transfer(rays, offshore, origins, gamma, execution);
  std::ofstream table(file.temporary(), std::ios::trunc);
  table << "Time,"
        << stations.heading({ "Depth", "SignificantWaveHeight", "PeakPeriod", "MeanPeriod", "ZeroCrossingPeriod",
             "EnergyPeriod", "MeanDirectionFrom", "DirectionalSpread", "Breaking" })
        << '\n';
  // Times of a block and parts of it that threads take: memory does not grow with the series.
  constexpr std::size_t Block = 1024;
  constexpr std::size_t Part = 64;
  Clock::duration writing{};
  std::size_t missing = 0;
  for (std::size_t first = 0; first < series.size(); first += Block)
  {
    const std::size_t count = std::min(Block, series.size() - first);
    const std::size_t parts = (count + Part - 1) / Part;
    std::vector<std::string> texts(parts);
    std::vector<std::size_t> without(parts, 0);
    inParallel(parts,
      [&](std::size_t from, std::size_t to)
      {
        std::vector<double> densities;
        std::vector<char> there;
        for (std::size_t part = from; part < to; ++part)
        {
          const std::size_t start = first + part * Part;
          const std::size_t size = std::min(Part, first + count - start);
          densities.assign(size * offshore.size(), 0.0);
          there.assign(size, 0);
          for (std::size_t i = 0; i < size; ++i)
          {
            there[i] = series.sample(start + i, offshore, densities.data() + i * offshore.size()) ? 1 : 0;
            without[part] += there[i] ? 0 : 1;
          }
          const std::vector<PlaceSea> seas = transfer.apply(densities, size);
          const auto out = std::back_inserter(texts[part]);
          for (std::size_t i = 0; i < size * stations.size(); ++i)
          {
            const PlaceSea& sea = seas[i];
            const std::size_t hour = i / stations.size();
            fmt::format_to(out, "{},{},", series.time(start + hour), stations.line(i % stations.size()));
            const SeaParameters& p = sea.parameters;
            const bool known = there[hour] && sea.known;
            const auto put = [&](double value, const char* after) {
              std::isfinite(value) ? fmt::format_to(out, "{:.7g}{}", value, after) : fmt::format_to(out, "{}", after);
            };
            const double none = std::nan("");
            put(sea.depth, ",");
            for (const double value : { p.significantHeight, p.peakPeriod, p.meanPeriod01, p.meanPeriod02,
                   p.energyPeriod, p.meanDirectionFrom, p.spread })
            {
              put(known ? value : none, ",");
            }
            put(known ? (sea.breaking ? 1.0 : 0.0) : none, "\n");
          }
        }
      });
    const Clock::time_point before = Clock::now();
    for (std::size_t part = 0; part < parts; ++part)
    {
      table << texts[part];
      missing += without[part];
    }
    writing += Clock::now() - before;
    console.progress("series", static_cast<double>(first + count) / static_cast<double>(series.size()));
  }
  console.endProgress();
  table.close();
  if (!table)
  {
    file.fail("the disk is full, or files may not get so large");
  }
  if (missing > 0)
  {
    console.warn(fmt::format("{} of {} times have no sea: their fields are empty", missing, series.size()));
  }
  return { series.size() * stations.size(), std::chrono::duration<double>(Clock::now() - begin - writing).count() };
}

}
