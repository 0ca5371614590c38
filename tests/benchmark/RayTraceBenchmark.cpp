// How fast single rays are, at an accuracy that is measured.
#include "GaussShoal.h"

#include "sim/HamiltonianRay.h"
#include "sim/SnellRay.h"

#include <benchmark/benchmark.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace swellray;

namespace
{

constexpr double LargestError = 0.01; // m
constexpr double ReferenceTolerance = 1e-12;
constexpr double LoosestTolerance = 1.0;
constexpr double TightestTolerance = 1e-10;
const double ToleranceStep = std::pow(10.0, 0.25);

const GaussShoal& scene()
{
  static const GaussShoal shoal;
  return shoal;
}

/** Where the rays are at the end, by a fine integration on the formula. */
const std::vector<glm::dvec2>& reference()
{
  static const std::vector<glm::dvec2> places = []
  {
    std::vector<glm::dvec2> result;
    const RayMedium medium = GaussShoal::medium(scene().formula());
    for (std::size_t i = 0; i < GaussShoal::Rays; ++i)
    {
      HamiltonianRay ray(medium, GaussShoal::start(medium, i), ReferenceTolerance);
      RayPoint point;
      ray.advance(FrontMeasure::Time, GaussShoal::TravelTime, point);
      result.push_back(point.position);
    }
    return result;
  }();
  return places;
}

/** Largest error of the rays that `make` makes, m; infinite where one does not arrive. */
template <typename Make>
double largestError(const Make& make)
{
  const RayMedium medium = GaussShoal::medium(scene().grid());
  double error = 0.0;
  for (std::size_t i = 0; i < GaussShoal::Rays; ++i)
  {
    auto ray = make(medium, GaussShoal::start(medium, i));
    RayPoint point;
    if (!ray.advance(FrontMeasure::Time, GaussShoal::TravelTime, point))
    {
      return HUGE_VAL;
    }
    error = std::max(error, glm::length(point.position - reference()[i]));
  }
  return error;
}

double errorAt(double tolerance)
{
  return largestError(
    [tolerance](const RayMedium& medium, const RayStart& start) { return HamiltonianRay(medium, start, tolerance); });
}

/** The loosest tolerance that, like all tighter ones, keeps the error in bounds; 0 where none does. */
double loosestTolerance()
{
  double found = 0.0;
  for (double tolerance = TightestTolerance; tolerance <= LoosestTolerance; tolerance *= ToleranceStep)
  {
    if (!(errorAt(tolerance) < LargestError))
    {
      break;
    }
    found = tolerance;
  }
  return found;
}

template <typename Make>
void traceRays(benchmark::State& state, const Make& make)
{
  const RayMedium medium = GaussShoal::medium(scene().grid());
  std::vector<RayStart> starts;
  for (std::size_t i = 0; i < GaussShoal::Rays; ++i)
  {
    starts.push_back(GaussShoal::start(medium, i));
  }
  std::size_t evaluations = 0;
  for (auto _ : state)
  {
    for (const RayStart& start : starts)
    {
      auto ray = make(medium, start);
      RayPoint point;
      ray.advance(FrontMeasure::Time, GaussShoal::TravelTime, point);
      benchmark::DoNotOptimize(point);
      evaluations += ray.evaluations();
    }
  }
  using benchmark::Counter;
  const auto rays = static_cast<double>(state.iterations() * GaussShoal::Rays);
  state.counters["rays_per_second"] = Counter(rays, Counter::kIsRate);
  state.counters["evaluations_per_second"] = Counter(static_cast<double>(evaluations), Counter::kIsRate);
  state.counters["evaluations_per_ray"] = static_cast<double>(evaluations) / rays;
  state.counters["max_position_error"] = largestError(make);
}

void gaussShoal(benchmark::State& state)
{
  static const double tolerance = loosestTolerance();
  if (!(tolerance > 0.0))
  {
    state.SkipWithError("no tolerance keeps the error of the rays below 1 cm");
    return;
  }
  traceRays(
    state, [](const RayMedium& medium, const RayStart& start) { return HamiltonianRay(medium, start, tolerance); });
  state.counters["tolerance"] = tolerance;
}

void gaussShoalAtDefault(benchmark::State& state)
{
  constexpr double tolerance = 1e-8;
  traceRays(
    state, [](const RayMedium& medium, const RayStart& start) { return HamiltonianRay(medium, start, tolerance); });
  state.counters["tolerance"] = tolerance;
}

void gaussShoalSnell(benchmark::State& state)
{
  const auto step = static_cast<double>(state.range(0));
  traceRays(state, [step](const RayMedium& medium, const RayStart& start) { return SnellRay(medium, start, step); });
}

BENCHMARK(gaussShoal)->Name("RayTrace/gauss_shoal")->Unit(benchmark::kMicrosecond);
BENCHMARK(gaussShoalAtDefault)->Name("RayTrace/default_tolerance")->Unit(benchmark::kMicrosecond);
// An eighth of a wavelength, and finer.
BENCHMARK(gaussShoalSnell)->Name("RayTrace/snell_step")->Arg(20)->Arg(5)->Unit(benchmark::kMicrosecond);

}
