#include "sim/SurfHistory.h"

#include "sim/Angles.h"
#include "sim/Scramble.h"

#include <algorithm>
#include <cmath>

namespace swellray
{

double plungeDistance(double slope)
{
  return std::max(1.0, 4.0 - 9.25 * std::max(0.0, slope));
}

SurfHistory::SurfHistory(const HistoryRay& ray, double breakerIndex)
  : Ray(ray)
  , BreakerIndex(breakerIndex)
{
  for (std::size_t i = 0; i < ray.count; ++i)
  {
    if (!ray.breaking[i])
    {
      continue;
    }
    const std::size_t first = i;
    while (i + 1 < ray.count && ray.breaking[i + 1])
    {
      ++i;
    }
    BreakingStretch stretch;
    stretch.begin = ray.phase[first];
    if (first > 0)
    {
      const double back = ray.breakingDistance[first] * ray.wavenumber[first];
      stretch.begin = std::max(ray.phase[first - 1], stretch.begin - back);
    }
    stretch.end = i + 1 < ray.count ? 0.5 * (ray.phase[i] + ray.phase[i + 1]) : ray.phase[i];
    const Place begin = this->place(stretch.begin);
    const double height = between(ray.height, begin);
    stretch.index = height / between(ray.depth, begin);
    stretch.plungePhase = plungeDistance(between(ray.slope, begin)) * height * between(ray.wavenumber, begin);
    stretch.plungeHeight = between(ray.height, this->place(stretch.begin + stretch.plungePhase));
    this->Stretches.push_back(stretch);
  }
}

void SurfHistory::continueFrom(const SurfHistory& parent)
{
  if (this->Ray.count == 0 || !this->Ray.breaking[0] || this->Stretches.empty())
  {
    return;
  }
  if (const BreakingStretch* before = parent.stretchAt(this->Ray.phase[0]))
  {
    const double end = this->Stretches.front().end;
    this->Stretches.front() = *before;
    this->Stretches.front().end = end;
  }
}

SurfHistory::Place SurfHistory::place(double phase) const
{
  const double* const begin = this->Ray.phase;
  const double* const end = begin + this->Ray.count;
  const double* const next = std::upper_bound(begin, end, phase);
  if (next == begin)
  {
    return {};
  }
  Place place;
  place.before = static_cast<std::size_t>(next - begin) - 1;
  place.after = next == end ? place.before : place.before + 1;
  const double rise = begin[place.after] - begin[place.before];
  place.weight = rise > 0.0 ? (phase - begin[place.before]) / rise : 0.0;
  return place;
}

double SurfHistory::between(const double* values, const Place& place)
{
  return values[place.before] + place.weight * (values[place.after] - values[place.before]);
}

const BreakingStretch* SurfHistory::stretchAt(double phase) const
{
  // The last stretch holds on beyond the end of the ray: what breaks up to the beach is broken on it.
  for (const BreakingStretch& stretch : this->Stretches)
  {
    const bool last = this->Ray.breaking[this->Ray.count - 1] && &stretch == &this->Stretches.back();
    if (phase >= stretch.begin && (phase <= stretch.end || last))
    {
      return &stretch;
    }
  }
  return nullptr;
}

double SurfHistory::ripeness(double height, double depth, double phase) const
{
  double index = this->BreakerIndex;
  for (const BreakingStretch& stretch : this->Stretches)
  {
    if (phase <= stretch.end)
    {
      index = stretch.index;
      break;
    }
  }
  return std::clamp(height / (depth * index), 0.0, 1.0);
}

CrestState SurfHistory::crest(double phase, double delay) const
{
  CrestState crest;
  if (this->Ray.count == 0)
  {
    return crest;
  }
  const Place place = this->place(phase);
  crest.height = between(this->Ray.height, place);
  crest.wavenumber = between(this->Ray.wavenumber, place);
  crest.depth = between(this->Ray.depth, place);
  crest.slope = between(this->Ray.slope, place);
  crest.ripeness = this->ripeness(crest.height, crest.depth, phase);
  if (const BreakingStretch* stretch = this->stretchAt(phase))
  {
    crest.ripeness = 1.0;
    crest.plunge = std::max(0.0, (phase - stretch->begin - delay) / stretch->plungePhase);
    crest.plungeHeight = stretch->plungeHeight;
  }
  return crest;
}

double breakingDelay(std::uint64_t seed, std::int64_t wave, double launchParameter, double wavelength)
{
  constexpr double lengths[] = { 0.9, 2.3, 5.1 };
  constexpr double weights[] = { 0.2, 0.3, 0.5 };
  double sum = 0.0;
  std::uint64_t draw = scramble(seed ^ scramble(static_cast<std::uint64_t>(wave)));
  for (int i = 0; i < 3; ++i)
  {
    draw = scramble(draw);
    const double turn = 2.0 * Pi * unitOf(draw);
    sum += weights[i] * std::sin(2.0 * Pi * launchParameter / (lengths[i] * wavelength) + turn);
  }
  return 0.5 * (1.0 + sum);
}

}
