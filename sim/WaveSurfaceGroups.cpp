#include "sim/WaveSurface.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"
#include "sim/WaveHeight.h"

#include <algorithm>
#include <cmath>

namespace swellray
{

namespace
{

// Waves are not traced to lower shares of what they would be.
constexpr double LeastShare = 1e-6;

// How fast the group's time grows with the phase: 1/(k Cg + omega - sigma), s/rad.
double groupRate(double wavenumber, double depth, double omega, double gravity)
{
  const WaveSpeeds speeds = waveSpeeds(wavenumber, depth, gravity);
  const double sigma = wavenumber * speeds.phaseSpeed;
  return 1.0 / std::max(wavenumber * speeds.groupSpeed + omega - sigma, LeastShare * omega);
}

}

WaveSurface::RayPlace WaveSurface::placeAt(std::size_t ray, double phase) const
{
  // Before an inserted ray began its waves were those of the ray beside it.
  while (this->Sheet.Parent[ray] >= 0 && phase < this->Histories[ray].firstPhase())
  {
    ray = static_cast<std::size_t>(this->Sheet.Parent[ray]);
  }
  RayPlace place;
  place.ray = ray;
  const auto first = static_cast<std::size_t>(this->Sheet.Offsets[ray]);
  const auto last = static_cast<std::size_t>(this->Sheet.Offsets[ray + 1]);
  const double* const begin = this->Sheet.Phase.data();
  const auto next = static_cast<std::size_t>(std::upper_bound(begin + first, begin + last, phase) - begin);
  place.before = next > first ? next - 1 : first;
  place.after = std::min(next, last > first ? last - 1 : first);
  const double span = begin[place.after] - begin[place.before];
  place.weight = span > 0.0 ? std::clamp((phase - begin[place.before]) / span, 0.0, 1.0) : 0.0;
  return place;
}

void WaveSurface::findGroups(std::size_t ray)
{
  const SurfaceSheet& sheet = this->Sheet;
  const auto first = static_cast<std::size_t>(sheet.Offsets[ray]);
  const auto last = static_cast<std::size_t>(sheet.Offsets[ray + 1]);
  if (first == last)
  {
    return;
  }
  const double omega = 2.0 * Pi / this->Options.period;
  const double g = this->Options.gravity;
  const auto rate = [&](std::size_t i) { return groupRate(sheet.Wavenumber[i], sheet.Depth[i], omega, g); };
  double time = rate(first) * sheet.Phase[first];
  double kept = 1.0; // what earlier breaking has left
  if (sheet.Parent[ray] >= 0)
  {
    const RayPlace beside = this->placeAt(static_cast<std::size_t>(sheet.Parent[ray]), sheet.Phase[first]);
    const auto linear = [&](const std::vector<double>& values)
    { return values[beside.before] + beside.weight * (values[beside.after] - values[beside.before]); };
    time = linear(this->GroupTime);
    kept = linear(this->BrokenShare);
  }
  const BreakingStretch* stretch = nullptr;
  double share = kept;
  double startHeight = 0.0;
  double startSpeed = 0.0;
  for (std::size_t i = first; i < last; ++i)
  {
    if (i > first)
    {
      time += 0.5 * (rate(i) + rate(i - 1)) * (sheet.Phase[i] - sheet.Phase[i - 1]);
    }
    this->GroupTime[i] = time;
    const BreakingStretch* here = sheet.Breaking[i] ? this->Histories[ray].stretchAt(sheet.Phase[i]) : nullptr;
    const double speed = waveSpeeds(sheet.Wavenumber[i], sheet.Depth[i], g).groupSpeed;
    if (here && here != stretch)
    {
      kept = share;
      // An inserted ray that begins in the surf has come to what the one beside it has.
      const CrestState start =
        here->begin >= sheet.Phase[first] ? this->Histories[ray].crest(here->begin, 0.0) : CrestState{};
      startHeight = here->begin >= sheet.Phase[first] ? start.height : sheet.Height[i];
      startSpeed = here->begin >= sheet.Phase[first] ? waveSpeeds(start.wavenumber, start.depth, g).groupSpeed : speed;
    }
    stretch = here;
    if (here)
    {
      const double whole = startHeight * shoalingCoefficient(startSpeed, speed);
      const double left = whole > 0.0 ? kept * sheet.Height[i] / whole : kept;
      share = std::clamp(left, LeastShare, share);
    }
    this->BrokenShare[i] = share;
  }
}

double WaveSurface::groupShare(std::size_t ray, double phase, std::int64_t wave) const
{
  if (!this->Options.groups.any())
  {
    return 1.0;
  }
  const RayPlace place = this->placeAt(ray, phase);
  const double arrival =
    this->GroupTime[place.before] + place.weight * (this->GroupTime[place.after] - this->GroupTime[place.before]);
  const double passage = (phase / (2.0 * Pi) - static_cast<double>(wave)) * this->Options.period;
  return this->Options.groups.share(passage - arrival, this->Options.period);
}

double WaveSurface::heightShare(std::size_t ray, double phase, std::int64_t wave) const
{
  if (!this->Options.groups.any())
  {
    return 1.0;
  }
  const RayPlace place = this->placeAt(ray, phase);
  const double broken =
    this->BrokenShare[place.before] + place.weight * (this->BrokenShare[place.after] - this->BrokenShare[place.before]);
  return heldShare(this->groupShare(ray, phase, wave), broken);
}

double WaveSurface::brokenSince(const RayPlace& place, double phase, double from, double share) const
{
  // Along a ray the shares of broken waves fall.
  const auto first = static_cast<std::size_t>(this->Sheet.Offsets[place.ray]);
  const auto shares = this->BrokenShare.begin();
  const auto found = static_cast<std::size_t>(
    std::partition_point(shares + static_cast<std::ptrdiff_t>(first),
      shares + static_cast<std::ptrdiff_t>(place.after) + 1, [&](double left) { return left > share; }) -
    shares);
  if (found == first || found > place.after)
  {
    return found == first ? from : phase;
  }
  const double before = this->BrokenShare[found - 1];
  const double fall = before - this->BrokenShare[found];
  const double weight = fall > 0.0 ? (before - share) / fall : 1.0;
  const double start = this->Sheet.Phase[found - 1];
  return std::clamp(start + weight * (this->Sheet.Phase[found] - start), from, phase);
}

void WaveSurface::lowerBy(CrestState& crest, const RayPlace& place, double phase, double delay, double share) const
{
  const double broken =
    this->BrokenShare[place.before] + place.weight * (this->BrokenShare[place.after] - this->BrokenShare[place.before]);
  const double held = heldShare(share, broken);
  crest.height *= held;
  const SurfHistory& history = this->Histories[place.ray];
  crest.ripeness = history.ripeness(crest.height, crest.depth, phase);
  crest.plunge = 0.0;
  if (held == 1.0)
  {
    history.setProgress(crest, phase,
      history.progress(phase, delay,
        [&](const BreakingStretch& stretch) { return this->brokenSince(place, phase, stretch.begin, share); }));
  }
}

}
