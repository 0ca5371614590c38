#include "sim/FoldsBeside.h"

#include "sim/RayField.h"
#include "sim/RayFolds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace swellray
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// Where the ray itself touches the caustic half the phase is 0 over 0.
constexpr double LeastHalf = 1e-4;

// Beyond it nothing is left to do: the modulus is 1 to 2e-6.
constexpr double LargestHalf = 100.0;

double cube(double x)
{
  return x * x * x;
}

// A along a ray that touches a caustic, by phase.
struct FoldRate
{
  std::vector<double> phase;
  std::vector<double> rate;

  double at(double where) const
  {
    const auto next =
      static_cast<std::size_t>(std::upper_bound(this->phase.begin(), this->phase.end(), where) - this->phase.begin());
    if (next == 0 || next == this->phase.size())
    {
      return next == 0 ? this->rate.front() : this->rate.back();
    }
    const double way = (where - this->phase[next - 1]) / (this->phase[next] - this->phase[next - 1]);
    return this->rate[next - 1] + way * (this->rate[next] - this->rate[next - 1]);
  }
};

std::size_t touchedCount(const TouchingRays& rays, std::size_t ray)
{
  return rays.causticOffsets[ray + 1] - rays.causticOffsets[ray];
}

double tubeWidth(const TouchingRays& rays, std::size_t point)
{
  return 1.0 / (rays.krTube[point] * rays.krTube[point]);
}

FoldRate rateOf(const TouchingRays& rays, std::size_t ray, std::size_t number)
{
  const auto first = static_cast<std::size_t>(rays.offsets[ray]);
  const auto count = static_cast<std::size_t>(rays.offsets[ray + 1]) - first;
  const RayFolds fold(
    rays.caustics + rays.causticOffsets[ray] + number, 1, rays.phase + first, rays.wavenumber + first, count);
  FoldRate rate;
  for (std::size_t i = 0; i < count && !fold.empty(); ++i)
  {
    const double value = fold.half(i) / cube(tubeWidth(rays, first + i));
    if (fold.half(i) > LeastHalf && std::isfinite(value) && isOnWater(static_cast<RayState>(rays.state[first + i])))
    {
      rate.phase.push_back(rays.phase[first + i]);
      rate.rate.push_back(value);
    }
  }
  return rate;
}

}

std::vector<double> foldsBeside(const TouchingRays& rays, const Execution& execution)
{
  const auto points = static_cast<std::size_t>(rays.rays > 0 ? rays.offsets[rays.rays] : 0);
  std::vector<double> half(points, Infinity);
  std::vector<std::size_t> row;
  std::size_t most = 0;
  for (std::size_t ray = 0; ray < rays.rays; ++ray)
  {
    most = std::max(most, touchedCount(rays, ray));
    if (!rays.lee[ray])
    {
      row.push_back(ray);
    }
  }
  if (most == 0)
  {
    return half;
  }
  std::sort(row.begin(), row.end(),
    [&](std::size_t a, std::size_t b)
    {
      return std::make_tuple(rays.launchSegment[a], rays.launchParameter[a], a) <
        std::make_tuple(rays.launchSegment[b], rays.launchParameter[b], b);
    });

  // The nearest ray before and after each that touches one caustic more, those between them touching as many as it does.
  constexpr auto none = std::numeric_limits<std::size_t>::max();
  std::vector<std::array<std::size_t, 2>> beside(rays.rays, { none, none });
  for (const std::size_t side : { 0u, 1u })
  {
    std::vector<std::size_t> nearest(most + 1, none); // by the number of the caustic, from 0
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const std::size_t ray = side == 0 ? row[i] : row[row.size() - 1 - i];
      const std::size_t before = i == 0 ? ray : side == 0 ? row[i - 1] : row[row.size() - i];
      if (rays.launchSegment[ray] != rays.launchSegment[before])
      {
        std::fill(nearest.begin(), nearest.end(), none);
      }
      const std::size_t touched = touchedCount(rays, ray);
      std::fill_n(nearest.begin(), touched, ray);
      std::fill(nearest.begin() + static_cast<std::ptrdiff_t>(std::min(touched + 1, most)), nearest.end(), none);
      beside[ray][side] = nearest[touched];
    }
  }

  execution.forRange(rays.rays,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t ray = begin; ray < end; ++ray)
      {
        const auto first = static_cast<std::size_t>(rays.offsets[ray]);
        const auto count = static_cast<std::size_t>(rays.offsets[ray + 1]) - first;
        const std::size_t touched = touchedCount(rays, ray);
        for (const std::size_t other : beside[ray])
        {
          if (other == none)
          {
            continue;
          }
          const FoldRate rate = rateOf(rays, other, touched);
          if (rate.phase.empty())
          {
            continue;
          }
          const RayFolds own(
            rays.caustics + rays.causticOffsets[ray], touched, rays.phase + first, rays.wavenumber + first, count);
          for (std::size_t i = 0; i < count; ++i)
          {
            const double width = tubeWidth(rays, first + i);
            const double share = own.tubeShare(i);
            if (std::isfinite(width) && share < 1.0)
            {
              const double here = rate.at(rays.phase[first + i]) * cube(width) / (1.0 - share);
              half[first + i] = here < LargestHalf ? std::min(half[first + i], here) : half[first + i];
            }
          }
        }
      }
    });
  return half;
}

}
