// Frames of the breaking-wave surface with foam: a million points, and the 50,000 points and ten waves of Jeschke et al. 2003.
#include "SurfScene.h"

#include "sim/SurfaceFunction.h"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

using namespace swellray;

namespace
{

void frames(benchmark::State& state, SurfScene& scene, const std::string& name)
{
  const auto section = makeWaveSection(name);
  double time = 0.0;
  for (auto _ : state)
  {
    scene.frame(time += 0.04, *section);
  }
  using benchmark::Counter;
  state.counters["points"] = static_cast<double>(scene.points());
  state.counters["points_per_second"] =
    Counter(static_cast<double>(state.iterations()) * static_cast<double>(scene.points()), Counter::kIsRate);
  state.counters["frames_per_second"] = Counter(static_cast<double>(state.iterations()), Counter::kIsRate);
}

// A million points: ten waves of 48 points on 2,000 rays.
void million(benchmark::State& state, const std::string& name)
{
  static SurfScene scene(2000.0, 1.0, 48.0);
  frames(state, scene, name);
}

void fiftyThousand(benchmark::State& state, const std::string& name)
{
  static SurfScene scene(100.0, 1.0, 48.0);
  frames(state, scene, name);
}

// Places of one's own, without a mesh: as many as a hull has.
void places(benchmark::State& state, const std::string& name)
{
  static SurfScene scene(100.0, 1.0, 48.0);
  const SurfaceFunction function(scene.surface());
  const auto section = makeWaveSection(name);
  SurfaceMotion motion;
  motion.section = section.get();
  std::vector<glm::dvec2> where;
  for (int i = 0; i < 1000; ++i)
  {
    where.emplace_back(20.0 + 0.4 * i, 10.0 + 0.08 * i);
  }
  double time = 0.0;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(function.at(where, { time += 0.04 }, motion).data());
  }
  state.counters["places_per_second"] =
    benchmark::Counter(1000.0 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(places, airy, "airy")->Name("Surface/places/airy")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(places, jeschke, "jeschke")->Name("Surface/places/jeschke")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(million, airy, "airy")->Name("Surface/million/airy")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(million, gonzato, "gonzato-lesaec")
  ->Name("Surface/million/gonzato-lesaec")
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(million, jeschke, "jeschke")->Name("Surface/million/jeschke")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(million, vortex, "vortex")->Name("Surface/million/vortex")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(million, peachey, "peachey")->Name("Surface/million/peachey")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fiftyThousand, jeschke, "jeschke")->Name("Surface/50000/jeschke")->Unit(benchmark::kMillisecond);

}
