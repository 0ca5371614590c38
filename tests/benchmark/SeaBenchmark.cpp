// Seas of many times at many places, from rays that have been traced, and the rays of a map.
#include "bathymetry/SeafloorReader.h"
#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/SeaTransfer.h"
#include "sim/SplineSeafloor.h"

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>

using namespace swellray;

namespace
{

// 100 stations, 20 frequencies, 72 directions offshore; seas in turn out of a few, so that none is made in the loop.
void hindcast(benchmark::State& state)
{
  const auto seafloor = makeBuiltinSeafloor("plane:slope=0.02,x0=-100,x1=2000,y0=-3000,y1=3000");
  const BackwardTracer tracer(*seafloor, BackwardOptions());
  SpectralRays rays;
  rays.grid = SpectralGrid::logarithmic(0.06, 0.4, 20, 36);
  const SpectralGrid offshore{ rays.grid.frequencies, SpectralGrid::logarithmic(0.1, 1.0, 2, 72).headings };
  std::vector<glm::dvec2> places;
  for (int i = 0; i < 100; ++i)
  {
    places.emplace_back(20.0 + 9.0 * i, 2.0 * i);
  }
  const SeaTransfer transfer(rays, offshore, traceOrigins(tracer, rays, places), 0.6);
  constexpr std::size_t Hours = 512;
  std::vector<double> seas;
  for (std::size_t i = 0; i < Hours; ++i)
  {
    const auto sea = DirectionalSpectrum::sample(offshore, FrequencySpectrum::jonswap(2.0, 9.0),
      DirectionalSpreading::cosinePower(radians(20.0)), headingFromNautical(60.0 + static_cast<double>(i % 60)));
    seas.insert(seas.end(), sea.density.begin(), sea.density.end());
  }
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(transfer.apply(seas, Hours));
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["seas_per_second"] =
    benchmark::Counter(runs * static_cast<double>(Hours * places.size()), benchmark::Counter::kIsRate);
}

/**
 * Rays back from 10 x 10 of the 100 x 100 points over the mouth of the Hudson (SWELLRAY_DATA), 20 frequencies times 36 directions
 * each, on one thread: what a map of 7.2 million rays takes is a hundred times that, over the number of cores.
 */
void hudsonMap(benchmark::State& state)
{
  const char* folder = std::getenv("SWELLRAY_DATA");
  const std::string file =
    std::string(folder ? folder : SWELLRAY_DATA_DEFAULT) + "/sites/long_island_ny/hudson_canyon_long_branch_3s.tif";
  if (!std::filesystem::exists(file))
  {
    state.SkipWithError(("no grid " + file + "; set SWELLRAY_DATA").c_str());
    return;
  }
  const SplineSeafloor seafloor(readSeafloor(file).grid);
  const BackwardTracer tracer(seafloor, BackwardOptions());
  SpectralRays rays;
  rays.grid = SpectralGrid::logarithmic(0.06, 0.3, 20, 36);
  const Rectangle bounds = seafloor.bounds();
  constexpr int Side = 10;
  std::size_t traced = 0;
  std::size_t steps = 0;
  for (auto _ : state)
  {
    for (int i = 0; i < Side * Side; ++i)
    {
      const glm::dvec2 share((i % Side + 0.5) / Side, (i / Side + 0.5) / Side);
      const glm::dvec2 place = bounds.low + share * bounds.size();
      for (std::size_t ray = 0; ray < rays.grid.size() && tracer.depth(place) > 0.0; ++ray)
      {
        steps += tracer.trace(place, rays.grid.frequencies[ray / 36], rays.heading(ray % 36)).steps;
        ++traced;
      }
    }
  }
  const auto rate = [](std::size_t n)
  { return benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsRate); };
  state.counters["rays_per_second"] = rate(traced);
  state.counters["steps_per_second"] = rate(steps);
}

BENCHMARK(hudsonMap)->Name("SpectralMap/hudson")->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK(hindcast)->Name("SeaTransfer/100_stations")->Unit(benchmark::kMillisecond);

}
