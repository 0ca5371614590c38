#include "sim/FoldsBeside.h"

#include "sim/RayField.h"
#include "sim/RayFolds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace swellray
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

// Where the ray itself touches the caustic half the phase is 0 over 0.
constexpr double LeastHalf = 1e-4;

// Beyond it nothing is left to do: the modulus is 1 to 2e-6.
constexpr double LargestHalf = 100.0;

double square(double x)
{
  return x * x;
}

std::size_t touchedCount(const TouchingRays& rays, std::size_t ray)
{
  return rays.causticOffsets[ray + 1] - rays.causticOffsets[ray];
}

double tubeWidth(const TouchingRays& rays, std::size_t point)
{
  return 1.0 / square(rays.krTube[point]);
}

// Rays in the order of their launch, those in the lee left out.
std::vector<std::size_t> inOrder(const TouchingRays& rays)
{
  std::vector<std::size_t> row;
  for (std::size_t ray = 0; ray < rays.rays; ++ray)
  {
    if (!rays.lee[ray])
    {
      row.push_back(ray);
    }
  }
  std::sort(row.begin(), row.end(),
    [&](std::size_t a, std::size_t b)
    {
      return std::make_tuple(rays.launchSegment[a], rays.launchParameter[a], a) <
        std::make_tuple(rays.launchSegment[b], rays.launchParameter[b], b);
    });
  return row;
}

// Width of the tube of a ray at a phase; NaN beyond its ends and where it is not known.
double widthAt(const TouchingRays& rays, std::size_t ray, double phase)
{
  const double* const first = rays.phase + rays.offsets[ray];
  const double* const last = rays.phase + rays.offsets[ray + 1];
  const double* const next = std::upper_bound(first, last, phase);
  if (next == first || next == last)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double way = (phase - next[-1]) / (next[0] - next[-1]);
  const auto point = static_cast<std::size_t>(next - rays.phase);
  return (1.0 - way) * tubeWidth(rays, point - 1) + way * tubeWidth(rays, point);
}

// Values along a ray between its points.
double between(const std::vector<double>& phases, const std::vector<double>& values, double phase)
{
  const auto next = static_cast<std::size_t>(std::upper_bound(phases.begin(), phases.end(), phase) - phases.begin());
  if (next == 0 || next == phases.size())
  {
    return next == 0 ? values.front() : values.back();
  }
  const double way = (phase - phases[next - 1]) / (phases[next] - phases[next - 1]);
  return values[next - 1] + way * (values[next] - values[next - 1]);
}

// A fold along its way between the ray that touches it and the next, by phase.
struct FoldWay
{
  std::vector<double> ratePhase;
  std::vector<double> rate; // A, rad
  std::vector<double> phase;
  std::vector<double> growth; // d beta/d lambda where the sheet folds, 1/m; 0 where it does not
  std::vector<double> place;  // lambda there, m

  bool empty() const { return this->rate.empty() || this->phase.empty(); }

  double half(double where, double width, double parameter) const
  {
    const double grown = between(this->phase, this->growth, where);
    if (grown == 0.0)
    {
      return Infinity;
    }
    const double linear = grown * (parameter - between(this->phase, this->place, where));
    return between(this->ratePhase, this->rate, where) * width * square(linear);
  }
};

FoldWay wayOf(const TouchingRays& rays, std::size_t ray, std::size_t next, std::size_t number)
{
  const auto points = [&](std::size_t of)
  { return std::pair(static_cast<std::size_t>(rays.offsets[of]), static_cast<std::size_t>(rays.offsets[of + 1])); };
  const auto [first, last] = points(ray);
  const RayCaustic& caustic = rays.caustics[rays.causticOffsets[ray] + number];
  const RayFolds fold(&caustic, 1, rays.phase + first, rays.wavenumber + first, last - first);
  FoldWay way;
  std::vector<double> phases, widths;
  for (auto [i, end] = points(next); i < end; ++i)
  {
    if (std::isfinite(tubeWidth(rays, i)))
    {
      phases.push_back(rays.phase[i]);
      widths.push_back(tubeWidth(rays, i));
    }
  }
  const double apart = rays.launchParameter[next] - rays.launchParameter[ray];
  for (std::size_t i = first; i < last && !fold.empty() && !phases.empty() && apart != 0.0; ++i)
  {
    const double width = tubeWidth(rays, i);
    const bool inside = rays.phase[i] >= phases.front() && rays.phase[i] <= phases.back();
    if (!inside || !std::isfinite(width) || !isOnWater(static_cast<RayState>(rays.state[i])))
    {
      continue;
    }
    if (fold.half(i - first) > LeastHalf && width > 0.0)
    {
      way.ratePhase.push_back(rays.phase[i]);
      way.rate.push_back(fold.half(i - first) / (width * square(width)));
    }
    // Once the ray has touched it the fold is between the two.
    const double beyond = between(phases, widths, rays.phase[i]);
    const double growth = (beyond + (rays.phase[i] < caustic.phase ? -width : width)) / apart;
    const bool grows = growth * apart > 0.0;
    way.phase.push_back(rays.phase[i]);
    way.growth.push_back(grows ? growth : 0.0);
    way.place.push_back(grows ? rays.launchParameter[next] - beyond / growth : rays.launchParameter[ray]);
  }
  return way;
}

}

std::vector<RayCaustic> loneCausticRates(const TouchingRays& rays)
{
  const std::size_t count = rays.rays > 0 ? rays.causticOffsets[rays.rays] : 0;
  std::vector<RayCaustic> caustics(rays.caustics, rays.caustics + count);
  if (std::none_of(caustics.begin(), caustics.end(), [](const RayCaustic& c) { return std::isnan(c.alongRate); }))
  {
    return caustics;
  }
  const std::vector<std::size_t> row = inOrder(rays);
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    const std::size_t ray = row[i];
    for (std::size_t c = rays.causticOffsets[ray]; c < rays.causticOffsets[ray + 1]; ++c)
    {
      double growth = 0.0;
      int sides = 0;
      for (const std::size_t next : { i > 0 ? row[i - 1] : ray, i + 1 < row.size() ? row[i + 1] : ray })
      {
        const double apart = std::abs(rays.launchParameter[next] - rays.launchParameter[ray]);
        const double width = widthAt(rays, next, caustics[c].phase);
        if (rays.launchSegment[next] == rays.launchSegment[ray] && apart > 0.0 && std::isfinite(width))
        {
          growth += width / apart;
          ++sides;
        }
      }
      if (std::isnan(caustics[c].alongRate) && sides > 0)
      {
        caustics[c].alongRate = growth / sides / std::abs(caustics[c].widthRate);
        caustics[c].alongChange = 0.0;
      }
    }
  }
  return caustics;
}

std::vector<double> foldsBeside(const TouchingRays& rays, const Execution& execution)
{
  const auto points = static_cast<std::size_t>(rays.rays > 0 ? rays.offsets[rays.rays] : 0);
  std::vector<double> half(points, Infinity);
  std::size_t most = 0;
  for (std::size_t ray = 0; ray < rays.rays; ++ray)
  {
    most = std::max(most, touchedCount(rays, ray));
  }
  if (most == 0)
  {
    return half;
  }
  const std::vector<std::size_t> row = inOrder(rays);

  // The nearest ray before and after each that touches one caustic more, those between them touching as many as it does, and
  // the one next to it.
  constexpr auto none = std::numeric_limits<std::size_t>::max();
  struct Beside
  {
    std::size_t ray = none;
    std::size_t next = none;
  };
  std::vector<std::array<Beside, 2>> beside(rays.rays);
  for (const std::size_t side : { 0u, 1u })
  {
    std::vector<Beside> nearest(most + 1); // by the number of the caustic, from 0
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const std::size_t ray = side == 0 ? row[i] : row[row.size() - 1 - i];
      const std::size_t before = i == 0 ? ray : side == 0 ? row[i - 1] : row[row.size() - i];
      if (rays.launchSegment[ray] != rays.launchSegment[before])
      {
        std::fill(nearest.begin(), nearest.end(), Beside{});
      }
      const std::size_t touched = touchedCount(rays, ray);
      for (std::size_t number = 0; number <= most; ++number)
      {
        Beside& of = nearest[number];
        of = number < touched ? Beside{ ray, none } : number == touched ? of : Beside{};
        of.next = number == touched && of.ray != none && of.next == none ? ray : of.next;
      }
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
        for (const Beside& other : beside[ray])
        {
          if (other.ray == none)
          {
            continue;
          }
          const FoldWay fold = wayOf(rays, other.ray, other.next, touched);
          if (fold.empty())
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
              const double here = fold.half(rays.phase[first + i], width, rays.launchParameter[ray]) / (1.0 - share);
              half[first + i] = here < LargestHalf ? std::min(half[first + i], here) : half[first + i];
            }
          }
        }
      }
    });
  return half;
}

}
