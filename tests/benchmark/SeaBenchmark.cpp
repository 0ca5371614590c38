// Seas of many times at many places, from rays that have been traced.
#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/SeaTransfer.h"

#include <benchmark/benchmark.h>

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

BENCHMARK(hindcast)->Name("SeaTransfer/100_stations")->Unit(benchmark::kMillisecond);

}
