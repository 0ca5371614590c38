#include "sim/SurfHistory.h"

#include "sim/Angles.h"
#include "sim/Scramble.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellray
{

namespace
{

// A crest does not come down at once, rad.
constexpr double SmallestPhase = 1e-9;

// Share of ReformingPhase from which on a lip that is hardly left is drawn back, so that the wave can break anew.
constexpr double DrawnBack = 0.8;

double smoothStep(double t)
{
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double lipShare(double reforming)
{
  return 1.0 - smoothStep((reforming - DrawnBack) / (1.0 - DrawnBack));
}

}

double rollerShare(double reforming)
{
  return 1.0 - smoothStep(reforming);
}

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
    stretch.plungePhase =
      std::max(SmallestPhase, plungeDistance(between(ray.slope, begin)) * height * between(ray.wavenumber, begin));
    this->Stretches.push_back(stretch);
  }
}

void SurfHistory::continueFrom(const SurfHistory& parent)
{
  if (this->Ray.count == 0)
  {
    return;
  }
  const double first = this->Ray.phase[0];
  this->Parent = &parent;
  const bool goesOn = this->Ray.breaking[0] && parent.stretchAt(first);
  if (goesOn)
  {
    const double end = this->Stretches.front().end;
    this->Stretches.front() = *parent.stretchAt(first);
    this->Stretches.front().end = end;
  }
  parent.forStretches(
    [&](const BreakingStretch& stretch)
    {
      const bool before = stretch.begin < first && !(goesOn && &stretch == parent.stretchAt(first));
      if (before)
      {
        this->Past.push_back(stretch);
        this->Past.back().end = std::min(stretch.end, first);
      }
      return before;
    });
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

bool SurfHistory::staysBroken(const BreakingStretch& stretch) const
{
  return !this->Stretches.empty() && &stretch == &this->Stretches.back() && this->Ray.breaking[this->Ray.count - 1];
}

double SurfHistory::heightAt(double phase) const
{
  const SurfHistory* ray = this;
  while (ray->Parent && phase < ray->firstPhase())
  {
    ray = ray->Parent;
  }
  return between(ray->Ray.height, ray->place(phase));
}

double SurfHistory::ripeness(double height, double depth, double phase) const
{
  double index = this->BreakerIndex;
  const BreakingStretch* last = nullptr;
  const BreakingStretch* next = nullptr;
  this->forStretches(
    [&](const BreakingStretch& stretch)
    {
      (phase <= stretch.end ? next : last) = &stretch;
      return !next;
    });
  index = next ? next->index : index;
  if (last && !(next && phase >= next->begin))
  {
    const double way = next ? std::min(ReformingPhase, next->begin - last->end) : ReformingPhase;
    index += rollerShare((phase - last->end) / way) * (last->index - index);
  }
  return std::clamp(height / (depth * index), 0.0, 1.0);
}

void SurfHistory::breakOn(
  BreakingProgress& progress, const BreakingStretch& stretch, double begin, double delay, double to) const
{
  const double way = (this->staysBroken(stretch) ? to : std::min(to, stretch.end)) - begin;
  const BreakingProgress old = progress;
  const double fallen = std::min(1.0, old.plunge);
  const double grown = fallen > 0.0 ? std::min(1.0, way / (fallen * stretch.plungePhase)) : 1.0;
  progress.plunge = old.plunge + std::max(0.0, way - delay) / stretch.plungePhase;
  progress.reforming = old.reforming * (1.0 - grown);
  const double down = begin + delay + (1.0 - fallen) * stretch.plungePhase;
  progress.plungeHeight = this->heightAt(down);
  if (fallen > 0.0)
  {
    const double renewed = grown * (1.0 - rollerShare(old.reforming));
    progress.plungeHeight = old.plungeHeight + renewed * (progress.plungeHeight - old.plungeHeight);
  }
}

void SurfHistory::reform(BreakingProgress& progress, const BreakingStretch& stretch, double to)
{
  const double way = to - stretch.end;
  const double before = progress.reforming;
  progress.reforming += way / ReformingPhase;
  if (progress.reforming >= 1.0)
  {
    progress = {};
  }
  else if (progress.plunge > 0.0)
  {
    const double falling = progress.plunge * (2.0 - std::exp(-way / (stretch.plungePhase * progress.plunge)));
    const double lip = lipShare(before);
    progress.plunge = lip > 0.0 ? falling * lipShare(progress.reforming) / lip : 0.0;
  }
}

void SurfHistory::setProgress(CrestState& crest, double phase, const BreakingProgress& progress) const
{
  crest.plunge = progress.plunge;
  crest.plungeHeight = progress.plungeHeight;
  crest.roller = rollerShare(progress.reforming);
  const bool breaks = this->stretchAt(phase) != nullptr;
  crest.ripeness = breaks ? 1.0 : crest.ripeness;
  if (!breaks && progress.reforming > 0.0)
  {
    crest.ripeness += crest.roller * (1.0 - crest.ripeness);
  }
}

FoamOrigin SurfHistory::foam(double phase) const
{
  const FoamOrigin none{ std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0 };
  FoamOrigin origin = none;
  double most = 0.0; // at `since`, where the breaking ended that leaves the most
  double since = 0.0;
  const auto left = [&](double at) { return most * rollerShare((at - since) / ReformingPhase); };
  this->forStretches(
    [&](const BreakingStretch& stretch)
    {
      if (phase < stretch.begin)
      {
        return false;
      }
      const bool anew = !(left(stretch.begin) > 0.0);
      origin.begin = anew ? stretch.begin : origin.begin;
      origin.plunge = anew ? stretch.plungePhase : origin.plunge;
      const double end = this->staysBroken(stretch) ? phase : std::min(phase, stretch.end);
      const double share = anew ? 1.0 : std::min(1.0, (end - stretch.begin) / FoamOnsetPhase);
      if (share >= left(end))
      {
        most = share;
        since = end;
      }
      return true;
    });
  origin.share = left(phase);
  return origin.share > 0.0 ? origin : none;
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
  this->setProgress(
    crest, phase, this->progress(phase, delay, [](const BreakingStretch& stretch) { return stretch.begin; }));
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
