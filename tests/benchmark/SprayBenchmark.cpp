// A frame of spray: a hundred thousand particles in the air.
#include "SurfScene.h"

#include "sim/Spray.h"

#include <benchmark/benchmark.h>

using namespace swellray;

namespace
{

void hundredThousand(benchmark::State& state)
{
  static SurfScene scene(2000.0, 4.0, 32.0);
  SprayOptions options;
  options.rate = 40.0;
  const Spray spray(scene.surface(), scene.bed(), nullptr, options);
  const auto section = makeWaveSection("gonzato-lesaec");
  double time = 0.0;
  double particles = 0.0;
  for (auto _ : state)
  {
    particles += static_cast<double>(spray.at(time += 0.04, *section).size());
  }
  using benchmark::Counter;
  state.counters["particles"] = particles / static_cast<double>(state.iterations());
  state.counters["seconds_per_100000"] = Counter(particles / 1e5, Counter::kIsRate | Counter::kInvert);
}

BENCHMARK(hundredThousand)->Name("Spray/hundred_thousand")->Unit(benchmark::kMillisecond);

}
