// A million soundings onto 500 x 500 nodes by natural neighbours, as `swellray grid` does it, and from their text.
#include "bathymetry/GridSoundings.h"
#include "bathymetry/TextSoundings.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

using namespace swellray;

namespace
{

constexpr double Size = 5000.0; // m

const Soundings& million()
{
  static const Soundings soundings = []
  {
    Soundings made;
    std::mt19937 chance(1);
    const auto draw = [&chance] { return Size * static_cast<double>(chance()) / 4294967296.0; };
    for (int i = 0; i < 1000000; ++i)
    {
      const double x = draw();
      const double y = draw();
      made.add(x, y, -20.0 + 5.0 * std::sin(x / 200.0) * std::cos(y / 150.0));
    }
    return made;
  }();
  return soundings;
}

// Of the process so far.
double peakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void grid(benchmark::State& state)
{
  SeafloorOptions options;
  options.crs = "local";
  options.resample = Size / 499.0;
  for (auto _ : state)
  {
    const GriddedSoundings made = gridSoundings(million(), options);
    state.counters["nodes"] = static_cast<double>(made.grid.elevation.size());
    state.counters["left_out_rms_m"] = made.report.single.rms;
  }
  state.counters["peak_MB"] = peakMegabytes();
}
BENCHMARK(grid)->Name("Gridding/million")->Unit(benchmark::kSecond)->Iterations(1);

void read(benchmark::State& state)
{
  const std::string path =
    (std::filesystem::temp_directory_path() / ("swellray-million-" + std::to_string(getpid()) + ".xyz")).string();
  {
    std::FILE* file = std::fopen(path.c_str(), "w");
    for (std::size_t i = 0; file && i < million().size(); ++i)
    {
      std::fprintf(file, "%.2f %.2f %.3f\n", million().x[i], million().y[i], million().z[i]);
    }
    if (!file || std::fclose(file) != 0)
    {
      state.SkipWithError("the file of soundings cannot be written");
    }
  }
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(readTextSoundings(path, ""));
  }
  std::filesystem::remove(path);
}
BENCHMARK(read)->Name("Gridding/million_lines")->Unit(benchmark::kSecond)->Iterations(1);

}
