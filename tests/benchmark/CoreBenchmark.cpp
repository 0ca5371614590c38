// What a ray is made of, and a whole scene.
#include "GaussShoal.h"

#include "sim/RayEquations.h"
#include "sim/WaveTracer.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

using namespace swellray;

namespace
{

const GaussShoal& scene()
{
  static const GaussShoal shoal;
  return shoal;
}

/** Places along a slanting line over the grid, as a ray would visit them. */
glm::dvec2 place(std::size_t i)
{
  const double way = static_cast<double>(i % 1024);
  return { 100.0 + 9.0 * way, 1500.0 + 5.3 * way };
}

void splineEvaluate(benchmark::State& state)
{
  const Seafloor& grid = scene().grid();
  std::size_t i = 0;
  for (auto _ : state)
  {
    BedSample bed;
    grid.evaluate(place(++i), 0, bed);
    benchmark::DoNotOptimize(bed);
  }
}

void frequency(benchmark::State& state)
{
  std::size_t i = 0;
  for (auto _ : state)
  {
    Frequency f;
    evaluateFrequency(0.05, 5.0 + 0.05 * static_cast<double>(++i % 1024), StandardGravity, f);
    benchmark::DoNotOptimize(f);
  }
}

void solveDispersion(benchmark::State& state)
{
  std::size_t i = 0;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(solveWavenumber(0.6, 5.0 + 0.05 * static_cast<double>(++i % 1024)));
  }
}

void rayEquations(benchmark::State& state)
{
  const RayMedium medium = GaussShoal::medium(scene().grid());
  rayequations::State y{ 0.0, 0.0, 0.045, 0.012, 0.3, 0.9, 1e-5, -2e-5, 0.0, 0.0 };
  rayequations::State rate{};
  rayequations::Local local;
  std::size_t i = 0;
  for (auto _ : state)
  {
    const glm::dvec2 p = place(++i);
    y[rayequations::X] = p.x;
    y[rayequations::Y] = p.y;
    benchmark::DoNotOptimize(rayequations::evaluate(medium, 0, 0.01, y, rate, local));
    benchmark::DoNotOptimize(rate);
  }
}

void buildSpline(benchmark::State& state)
{
  const auto nodes = static_cast<std::size_t>(state.range(0));
  ElevationGrid grid;
  grid.columns = grid.rows = nodes;
  grid.elevation.resize(nodes * nodes);
  for (std::size_t i = 0; i < grid.elevation.size(); ++i)
  {
    grid.elevation[i] = -20.0 + std::sin(0.01 * static_cast<double>(i));
  }
  for (auto _ : state)
  {
    const SplineSeafloor seafloor(grid);
    benchmark::DoNotOptimize(&seafloor);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(grid.elevation.size()));
}

void traceBabbage(benchmark::State& state)
{
  const auto seafloor = makeBuiltinSeafloor("babbage");
  IncidentWave wave;
  wave.period = 6.0;
  wave.directionFrom = 15.0;
  TraceOptions options;
  options.scheme = state.range(0) == 0 ? TraceScheme::Ode : TraceScheme::Snell;
  RayField field;
  for (auto _ : state)
  {
    field = traceWaves(*seafloor, wave, options);
    benchmark::DoNotOptimize(field.points.data());
  }
  using benchmark::Counter;
  const auto runs = static_cast<double>(state.iterations());
  state.counters["rays"] = static_cast<double>(field.rays.size());
  state.counters["rays_per_second"] = Counter(runs * static_cast<double>(field.rays.size()), Counter::kIsRate);
  state.counters["points_per_second"] = Counter(runs * static_cast<double>(field.points.size()), Counter::kIsRate);
}

BENCHMARK(splineEvaluate)->Name("Core/spline_evaluate");
BENCHMARK(frequency)->Name("Core/frequency");
BENCHMARK(solveDispersion)->Name("Core/solve_wavenumber");
BENCHMARK(rayEquations)->Name("Core/ray_equations");
BENCHMARK(buildSpline)->Name("Core/build_spline")->Arg(500)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(traceBabbage)->Name("TraceWaves/babbage")->ArgName("snell")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}
