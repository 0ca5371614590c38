#include "sim/WaveSurface.h"

#include "sim/Angles.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

// Points that are displaced at once.
constexpr std::size_t RunSize = 64;

// The bed is looked up under points in less water than this many heights; in deeper water its slope does.
constexpr double ShallowDepths = 3.0;

// The way into a cliff is found to a ten-thousandth of it.
constexpr int CliffHalvings = 14;

// What lies on the bed is so thin that it is not seen but drawn above it, m.
constexpr double Film = 0.01;

}

void SurfaceOptions::validate() const
{
  const auto require = [](const char* name, double value, bool good)
  {
    if (!good)
    {
      std::ostringstream message;
      message << "surface: " << name << " must be above 0 and finite, not " << value;
      throw std::invalid_argument(message.str());
    }
  };
  for (const auto& [name, value] : { std::pair<const char*, double>{ "the period", this->period },
         { "the wavelength", this->wavelength }, { "the breaker index", this->breakerIndex } })
  {
    require(name, value, value > 0.0 && std::isfinite(value));
  }
  require("gravity", this->gravity, this->gravity > 0.0 && std::isfinite(this->gravity));
  this->groups.validate();
}

/** Neighbouring points of a ray that belong to one wave, and where they go. */
struct WaveSurface::Run
{
  std::size_t first = 0;
  std::size_t count = 0;
  bool broken = false;
  std::array<double, RunSize> phase;
  std::array<double, RunSize> along;
  std::array<double, RunSize> up;
  std::array<double, RunSize> alongRate;
  std::array<double, RunSize> upRate;
  std::array<double, RunSize> height; // these two are used where waves come in groups
  std::array<double, RunSize> ripeness;
};

WaveSurface::WaveSurface(
  const SurfaceSheet& sheet, const Seafloor& seafloor, const SurfaceOptions& options, const Execution& execution)
  : Sheet(sheet)
  , Bed(seafloor)
  , Options(options)
  , Histories(sheet.rayCount())
  , Ripeness(sheet.rayPointCount())
{
  options.validate();
  execution.forRange(sheet.rayCount(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t ray = begin; ray < end; ++ray)
      {
        const std::int64_t first = sheet.Offsets[ray];
        HistoryRay arrays;
        arrays.count = static_cast<std::size_t>(sheet.Offsets[ray + 1] - first);
        arrays.phase = sheet.Phase.data() + first;
        arrays.height = sheet.Height.data() + first;
        arrays.wavenumber = sheet.Wavenumber.data() + first;
        arrays.depth = sheet.Depth.data() + first;
        arrays.slope = sheet.Slope.data() + first;
        arrays.breakingDistance = sheet.BreakingDistance.data() + first;
        arrays.breaking = sheet.Breaking.data() + first;
        this->Histories[ray] = SurfHistory(arrays, options.breakerIndex);
      }
    });
  for (std::size_t i = 0; i < sheet.rayPointCount(); ++i)
  {
    this->ShoreDepth = sheet.Shore[i] ? std::max(this->ShoreDepth, sheet.Depth[i]) : this->ShoreDepth;
  }
  // Parents come before those inserted beside them.
  for (std::size_t ray = 0; ray < sheet.rayCount(); ++ray)
  {
    if (sheet.Parent[ray] >= 0)
    {
      this->Histories[ray].continueFrom(this->Histories[static_cast<std::size_t>(sheet.Parent[ray])]);
    }
  }
  execution.forRange(sheet.rayCount(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t ray = begin; ray < end; ++ray)
      {
        for (auto i = static_cast<std::size_t>(sheet.Offsets[ray]);
             i < static_cast<std::size_t>(sheet.Offsets[ray + 1]); ++i)
        {
          this->Ripeness[i] = this->Histories[ray].ripeness(sheet.Height[i], sheet.Depth[i], sheet.Phase[i]);
        }
      }
    });
  if (options.groups.any())
  {
    this->GroupTime.assign(sheet.rayPointCount(), 0.0);
    this->BrokenShare.assign(sheet.rayPointCount(), 1.0);
    for (std::size_t ray = 0; ray < sheet.rayCount(); ++ray)
    {
      this->findGroups(ray);
    }
  }
}

void WaveSurface::setPhase(const StraightPhase& phase)
{
  this->OwnPhase.resize(this->Sheet.pointCount());
  for (std::size_t i = 0; i < this->OwnPhase.size(); ++i)
  {
    this->OwnPhase[i] = phase.at({ this->Sheet.Position[3 * i], this->Sheet.Position[3 * i + 1] });
  }
}

double WaveSurface::phase(std::size_t point) const
{
  return this->OwnPhase.empty() ? this->Sheet.Phase[point] : this->OwnPhase[point];
}

FoamOrigin WaveSurface::foamOrigin(std::size_t point) const
{
  if (point >= this->Sheet.rayPointCount())
  {
    return this->foamOrigin(static_cast<std::size_t>(this->Sheet.BeachBase[point - this->Sheet.rayPointCount()]));
  }
  const auto after =
    std::upper_bound(this->Sheet.Offsets.begin(), this->Sheet.Offsets.end(), static_cast<std::int64_t>(point));
  const auto ray = static_cast<std::size_t>(after - this->Sheet.Offsets.begin()) - 1;
  FoamOrigin origin = this->Histories[ray].foam(this->Sheet.Phase[point]);
  origin.begin += this->phase(point) - this->Sheet.Phase[point];
  return origin;
}

CrestState WaveSurface::crest(std::size_t ray, double phase, std::int64_t wave, const WaveSection& section) const
{
  const double largestDelay = 2.0 * Pi * section.variation();
  const double delay = largestDelay > 0.0
    ? largestDelay * breakingDelay(this->Options.seed, wave, this->Sheet.LaunchParameter[ray], this->Options.wavelength)
    : 0.0;
  const RayPlace place = this->placeAt(ray, phase);
  CrestState crest = this->Histories[place.ray].crest(phase, delay);
  if (this->Options.groups.any())
  {
    this->lowerBy(crest, place, phase, delay, this->groupShare(ray, phase, wave));
  }
  return crest;
}

void WaveSurface::displace(
  double time, const WaveSection& section, const SurfaceArrays& arrays, const Execution& execution) const
{
  execution.forRange(this->Sheet.rayCount(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t ray = begin; ray < end; ++ray)
      {
        if (this->OwnPhase.empty())
        {
          this->displaceRay(ray, time, section, arrays);
        }
        else
        {
          this->displaceByOwnPhase(ray, time, section, arrays);
        }
      }
    });
  // What lies on the beach stays there.
  const double omega = 2.0 * Pi / this->Options.period;
  Run still;
  still.count = 1;
  still.along[0] = still.alongRate[0] = still.upRate[0] = 0.0;
  for (std::size_t i = this->Sheet.rayPointCount(); i < this->Sheet.pointCount(); ++i)
  {
    still.first = i;
    still.up[0] = this->Sheet.Position[3 * i + 2] - this->Options.waterLevel;
    still.broken = this->Sheet.Breaking[i] != 0;
    this->place(still, arrays);
    if (arrays.phase)
    {
      arrays.phase[i] = this->phase(i) - omega * time;
    }
  }
}

void WaveSurface::displaceByOwnPhase(
  std::size_t ray, double time, const WaveSection& section, const SurfaceArrays& arrays) const
{
  const SurfaceSheet& sheet = this->Sheet;
  Run run;
  const double omega = 2.0 * Pi / this->Options.period;
  run.count = 1;
  const auto last = static_cast<std::size_t>(sheet.Offsets[ray + 1]);
  for (std::size_t i = static_cast<std::size_t>(sheet.Offsets[ray]); i < last; ++i)
  {
    const double phase = this->OwnPhase[i] - omega * time;
    run.first = i;
    run.phase[0] = phase - 2.0 * Pi * std::round(phase / (2.0 * Pi));
    const double share = this->Options.groups.any()
      ? heldShare(this->Options.groups.share(time - this->GroupTime[i], this->Options.period), this->BrokenShare[i])
      : 1.0;
    const double height = share * sheet.Height[i];
    const double ripeness = share * this->Ripeness[i];
    CrestState crest;
    crest.height = height;
    crest.wavenumber = sheet.Wavenumber[i];
    crest.depth = sheet.Depth[i];
    crest.slope = sheet.Slope[i];
    crest.ripeness = ripeness;
    section.displace(crest,
      { 1, run.phase.data(), &height, &sheet.Wavenumber[i], &sheet.Depth[i], &sheet.Slope[i], &ripeness },
      { run.along.data(), run.up.data(), run.alongRate.data(), run.upRate.data() });
    run.broken = sheet.Breaking[i] != 0;
    if (arrays.phase)
    {
      arrays.phase[i] = phase;
    }
    this->place(run, arrays);
  }
}

void WaveSurface::displaceRay(
  std::size_t ray, double time, const WaveSection& section, const SurfaceArrays& arrays) const
{
  const SurfaceSheet& sheet = this->Sheet;
  const double omega = 2.0 * Pi / this->Options.period;
  const double passed = omega * time;
  const WaveGroups& groups = this->Options.groups;
  const auto last = static_cast<std::size_t>(sheet.Offsets[ray + 1]);
  Run run;
  for (run.first = static_cast<std::size_t>(sheet.Offsets[ray]); run.first < last; run.first += run.count)
  {
    const double wave = std::round((sheet.Phase[run.first] - passed) / (2.0 * Pi));
    const double crestPhase = passed + 2.0 * Pi * wave;
    const double lowest = crestPhase - Pi;
    const bool shore = sheet.Shore[run.first] != 0;
    run.count = 0;
    while (run.count < RunSize && run.first + run.count < last)
    {
      const std::size_t i = run.first + run.count;
      if (run.count > 0 && (sheet.Phase[i] > lowest + 2.0 * Pi || (sheet.Shore[i] != 0) != shore))
      {
        break;
      }
      run.phase[run.count++] = std::clamp(sheet.Phase[i] - crestPhase, -Pi, Pi);
    }
    if (arrays.phase)
    {
      for (std::size_t i = 0; i < run.count; ++i)
      {
        arrays.phase[run.first + i] = sheet.Phase[run.first + i] - passed;
      }
    }
    const double* height = sheet.Height.data() + run.first;
    const double* ripeness = this->Ripeness.data() + run.first;
    if (groups.any())
    {
      for (std::size_t i = 0; i < run.count; ++i)
      {
        const std::size_t at = run.first + i;
        const double share =
          heldShare(groups.share(time - this->GroupTime[at], this->Options.period), this->BrokenShare[at]);
        run.height[i] = share * height[i];
        run.ripeness[i] = share * ripeness[i];
      }
      height = run.height.data();
      ripeness = run.ripeness.data();
    }
    if (shore)
    {
      for (std::size_t i = 0; i < run.count; ++i)
      {
        const double half = 0.5 * height[i];
        run.along[i] = run.alongRate[i] = 0.0;
        run.up[i] = half * std::cos(run.phase[i]);
        run.upRate[i] = -half * std::sin(run.phase[i]);
      }
      run.broken = true;
    }
    else
    {
      const CrestState crest = this->crest(ray, crestPhase, static_cast<std::int64_t>(wave), section);
      run.broken = crest.isBroken();
      section.displace(crest,
        { run.count, run.phase.data(), height, sheet.Wavenumber.data() + run.first, sheet.Depth.data() + run.first,
          sheet.Slope.data() + run.first, ripeness },
        { run.along.data(), run.up.data(), run.alongRate.data(), run.upRate.data() });
    }
    this->place(run, arrays);
  }
}

MovedPlace WaveSurface::move(const StillPlace& still, const SectionPoint& moved) const
{
  double along = moved.along;
  double alongRate = moved.alongRate;
  if (still.slope > 0.0 && along > 0.0 && still.depth - still.slope * along < this->ShoreDepth)
  {
    along = std::min(along, std::max(0.0, (still.depth - this->ShoreDepth) / still.slope));
    alongRate = 0.0;
  }
  double depth = still.depth - still.slope * along;
  if (depth < ShallowDepths * still.height)
  {
    const auto depthAt = [&](double way)
    { return this->Options.waterLevel - this->Bed.elevation(still.position + way * still.direction); };
    depth = depthAt(along);
    const double highest = std::max(moved.up, still.height);
    if (depth < -highest)
    {
      // Into a cliff: lifted onto it the lip would be a spike.
      double inside = 0.0;
      for (int halving = 0; halving < CliffHalvings; ++halving)
      {
        const double middle = 0.5 * (inside + along);
        (depthAt(middle) < -highest ? along : inside) = middle;
      }
      along = inside;
      alongRate = 0.0;
      depth = depthAt(along);
    }
  }
  const glm::dvec2 at = still.position + along * still.direction;
  const double k = still.wavenumber;
  const double omega = 2.0 * Pi / this->Options.period;
  double up = moved.up;
  MovedPlace place;
  place.normal = { -k * moved.upRate * still.direction, 1.0 + k * alongRate };
  place.velocity = { -omega * alongRate * still.direction, -omega * moved.upRate };
  if (up < Film - depth)
  {
    up = Film - depth;
    place.normal = { still.slope * -still.direction, 1.0 };
    place.velocity = glm::dvec3(0.0);
  }
  place.position = { at, this->Options.waterLevel + up };
  place.depth = depth;
  return place;
}

void WaveSurface::place(const Run& run, const SurfaceArrays& arrays) const
{
  const SurfaceSheet& sheet = this->Sheet;
  for (std::size_t j = 0; j < run.count; ++j)
  {
    const std::size_t i = run.first + j;
    const StillPlace still{ { sheet.Position[3 * i], sheet.Position[3 * i + 1] },
      { sheet.Direction[3 * i], sheet.Direction[3 * i + 1] }, sheet.Height[i], sheet.Wavenumber[i], sheet.Depth[i],
      sheet.Slope[i] };
    const MovedPlace moved = this->move(still, { run.along[j], run.up[j], run.alongRate[j], run.upRate[j] });
    if (arrays.position)
    {
      for (int c = 0; c < 3; ++c)
      {
        arrays.position[3 * i + static_cast<std::size_t>(c)] = moved.position[c];
      }
    }
    if (arrays.normal)
    {
      const glm::dvec3& normal = moved.normal;
      const double size = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
      for (int c = 0; c < 3; ++c)
      {
        arrays.normal[3 * i + static_cast<std::size_t>(c)] =
          static_cast<float>(size > 0.0 ? normal[c] / size : (c == 2 ? 1.0 : 0.0));
      }
    }
    if (arrays.velocity)
    {
      for (int c = 0; c < 3; ++c)
      {
        arrays.velocity[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(moved.velocity[c]);
      }
    }
    if (arrays.depth)
    {
      arrays.depth[i] = moved.depth;
    }
    if (arrays.breaking)
    {
      arrays.breaking[i] = run.broken ? 1 : 0;
    }
  }
}

}
