#include "sim/SurfaceFunction.h"

#include "sim/Angles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

// Samples along the wave among which the places are looked for that come to one: a wavelength, and those of a section.
constexpr double LeastSamples = 64.0;
constexpr double SamplesPerPoint = 1.5;

// Intervals in which the surface turns over are divided once more.
constexpr int Subdivision = 8;

// Places are found to this share of a wavelength.
constexpr double Closeness = 1e-10;
constexpr int MostIterations = 60;
constexpr int MostCorrections = 12;

// How far displacements at one phase may be above those found by sampling the wave.
constexpr double ReachMargin = 1.3;

double turns(double phase)
{
  return std::round(phase / (2.0 * Pi));
}

}

double resolvedShare(double wavelength, double spacing)
{
  return spacing > 0.0 ? std::clamp(wavelength / spacing - 2.0, 0.0, 1.0) : 1.0;
}

/** A place that comes to the one asked for. */
struct SurfaceFunction::Root
{
  SheetPlace still;
  MovedPlace moved;
};

struct SurfaceFunction::Scratch
{
  struct Sample
  {
    double at = 0.0;       // m along the wave from the place asked for
    double residual = 0.0; // m by which it misses that place
    double rate = 0.0;     // of the residual
    SheetPlace still;
  };

  std::vector<SheetCover> covers;
  std::vector<SheetPlace> sheets;
  std::vector<Sample> ahead;
  std::vector<Sample> behind;
};

SurfaceFunction::SurfaceFunction(const WaveSurface& surface)
  : Surface(surface)
  , Locator(surface.sheet())
{
  if (surface.hasOwnPhase())
  {
    throw std::invalid_argument(
      "the surface as a function follows the traced phase; leave out the straight one to ask for single places");
  }
  const SurfaceSheet& sheet = surface.sheet();
  this->RayOf.resize(sheet.rayPointCount());
  this->Foam.resize(sheet.rayPointCount());
  for (std::size_t ray = 0; ray < sheet.rayCount(); ++ray)
  {
    for (auto i = static_cast<std::size_t>(sheet.Offsets[ray]); i < static_cast<std::size_t>(sheet.Offsets[ray + 1]);
         ++i)
    {
      this->RayOf[i] = static_cast<std::uint32_t>(ray);
      this->Foam[i] = surface.foamOrigin(i);
    }
  }
}

SheetPlace SurfaceFunction::placeOn(const SheetCover& cover, const glm::dvec2& place) const
{
  const SurfaceSheet& sheet = this->Surface.sheet();
  SheetPlace found;
  found.still.position = place;
  found.still.wavenumber = 0.0;
  found.still.depth = 0.0;
  found.brokenShare = 0.0;
  glm::dvec2 toward(0.0);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto i = static_cast<std::size_t>(cover.corner[c]);
    const double w = cover.weight[c];
    const double k = sheet.Wavenumber[i];
    const glm::dvec2 vector = k * glm::dvec2(sheet.Direction[3 * i], sheet.Direction[3 * i + 1]);
    const glm::dvec2 offset = place - glm::dvec2(sheet.Position[3 * i], sheet.Position[3 * i + 1]);
    toward += w * vector;
    found.phase += w * (sheet.Phase[i] + 0.5 * glm::dot(vector, offset));
    found.still.height += w * sheet.Height[i];
    found.still.wavenumber += w * k;
    found.still.depth += w * sheet.Depth[i];
    found.still.slope += w * sheet.Slope[i];
    found.ripeness += w * this->Surface.ripeness(i);
    found.groupTime += w * this->Surface.groupTime(i);
    found.brokenShare += w * this->Surface.brokenShare(i);
    found.shore += sheet.Shore[i] ? w : 0.0;
    found.ray[c] = this->RayOf[i];
    found.weight[c] = w;
    found.breakingPhase[c] = this->Foam[i].begin;
    found.foamShare[c] = this->Foam[i].share;
    found.plungePhase[c] = this->Foam[i].plunge;
    found.launchParameter[c] = sheet.LaunchParameter[this->RayOf[i]];
  }
  const double size = glm::length(toward);
  const auto first = 3 * static_cast<std::size_t>(cover.corner[0]);
  found.still.direction = size > 0.0 ? toward / size : glm::dvec2(sheet.Direction[first], sheet.Direction[first + 1]);
  return found;
}

void SurfaceFunction::cover(const glm::dvec2& place, std::vector<SheetPlace>& sheets) const
{
  std::vector<SheetCover> covers;
  this->Locator.find(place, covers);
  sheets.clear();
  for (const SheetCover& cover : covers)
  {
    sheets.push_back(this->placeOn(cover, place));
  }
}

CrestState SurfaceFunction::crest(
  const SheetPlace& place, double phase, std::int64_t wave, const WaveSection& section) const
{
  CrestState sum;
  sum.wavenumber = sum.depth = sum.roller = 0.0;
  double plunging = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    // Two corners mostly lie on one ray.
    double w = place.weight[c];
    bool counted = false;
    for (std::size_t other = 0; other < 3; ++other)
    {
      counted = counted || (other < c && place.ray[other] == place.ray[c]);
      w += other > c && place.ray[other] == place.ray[c] ? place.weight[other] : 0.0;
    }
    if (counted)
    {
      continue;
    }
    const CrestState crest = this->Surface.crest(place.ray[c], phase, wave, section);
    sum.height += w * crest.height;
    sum.wavenumber += w * crest.wavenumber;
    sum.depth += w * crest.depth;
    sum.ripeness += w * crest.ripeness;
    sum.slope += w * crest.slope;
    // The less of a broken wave is left, the less its plunge matters.
    const double left = w * crest.roller;
    sum.roller += left;
    sum.plunge += left * crest.plunge;
    if (crest.plungeHeight > 0.0)
    {
      sum.plungeHeight += left * crest.plungeHeight;
      plunging += left;
    }
  }
  sum.plunge = sum.roller > 0.0 ? sum.plunge / sum.roller : 0.0;
  sum.plungeHeight = plunging > 0.0 ? sum.plungeHeight / plunging : 0.0;
  return sum;
}

MovedPlace SurfaceFunction::move(
  const SheetPlace& traced, double time, const WaveSection& section, bool* breaking) const
{
  SheetPlace place = traced;
  const WaveGroups& groups = this->Surface.options().groups;
  if (groups.any())
  {
    const double share =
      heldShare(groups.share(time - place.groupTime, this->Surface.options().period), place.brokenShare);
    place.still.height *= share;
    place.ripeness *= share;
  }
  const double passed = 2.0 * Pi / this->Surface.options().period * time;
  const double wave = turns(place.phase - passed);
  const double crestPhase = passed + 2.0 * Pi * wave;
  const double phase = std::clamp(place.phase - crestPhase, -Pi, Pi);
  SectionPoint moved;
  bool broken = place.shore > 0.5;
  if (place.shore < 1.0)
  {
    const CrestState crest = this->crest(place, crestPhase, static_cast<std::int64_t>(wave), section);
    moved = section.at(crest,
      { phase, place.still.height, place.still.wavenumber, place.still.depth, place.still.slope, place.ripeness });
    broken = broken || crest.isBroken();
  }
  if (place.shore > 0.0)
  {
    const double half = 0.5 * place.still.height;
    const double water = 1.0 - place.shore;
    moved.along *= water;
    moved.alongRate *= water;
    moved.up = water * moved.up + place.shore * half * std::cos(phase);
    moved.upRate = water * moved.upRate - place.shore * half * std::sin(phase);
  }
  if (breaking)
  {
    *breaking = broken;
  }
  return this->Surface.move(traced.still, moved);
}

double SurfaceFunction::foam(const SheetPlace& place, double time, const SurfaceMotion& motion) const
{
  const SurfaceOptions& options = this->Surface.options();
  FoamOptions foam = motion.foam;
  foam.period = options.period;
  foam.wavelength = options.wavelength;
  foam.seed = options.seed;
  foam.variation = motion.section->variation();
  foam.front = motion.section->frontPhase();
  foam.groups = options.groups;
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    sum += place.weight[c] * place.foamShare[c] *
      foamAt(place.phase, place.breakingPhase[c], place.launchParameter[c], time, foam, place.groupTime,
        place.brokenShare, place.plungePhase[c]);
  }
  return sum;
}

bool SurfaceFunction::follow(const SheetPlace& from, const glm::dvec2& place, Scratch& scratch, SheetPlace& found) const
{
  this->Locator.find(place, scratch.covers);
  const double expected =
    from.phase + from.still.wavenumber * glm::dot(from.still.direction, place - from.still.position);
  double least = Pi;
  bool any = false;
  for (const SheetCover& cover : scratch.covers)
  {
    const SheetPlace candidate = this->placeOn(cover, place);
    const double apart =
      std::abs(candidate.phase - expected) + Pi * glm::distance(candidate.still.direction, from.still.direction);
    if (apart < least)
    {
      least = apart;
      found = candidate;
      any = true;
    }
  }
  return any;
}

double SurfaceFunction::reach(const SheetPlace& place, double time, const WaveSection& section) const
{
  // Every phase of the waves around, at the place as it is.
  const double passed = 2.0 * Pi / this->Surface.options().period * time;
  constexpr int samples = 24;
  double most = 0.0;
  for (int i = -samples; i <= samples; ++i)
  {
    SheetPlace at = place;
    at.phase += Pi * i / samples;
    const double wave = turns(at.phase - passed);
    const double crestPhase = passed + 2.0 * Pi * wave;
    const SectionPoint moved = section.at(this->crest(at, crestPhase, static_cast<std::int64_t>(wave), section),
      { at.phase - crestPhase, at.still.height, at.still.wavenumber, at.still.depth, at.still.slope, at.ripeness });
    most = std::max(most, std::abs(moved.along));
  }
  return ReachMargin * most;
}

void SurfaceFunction::settle(
  Root& root, const glm::dvec2& place, double time, const WaveSection& section, Scratch& scratch) const
{
  // Directions turn along the wave: what the search along a straight line has left is taken off.
  const double close = Closeness * 2.0 * Pi / root.still.still.wavenumber;
  glm::dvec2 miss = glm::dvec2(root.moved.position) - place;
  for (int i = 0; i < MostCorrections && glm::length(miss) > close; ++i)
  {
    const glm::dvec2 direction = root.still.still.direction;
    const double along = glm::dot(miss, direction);
    const double rate = std::abs(root.moved.normal.z) > 0.05 ? root.moved.normal.z : 1.0;
    Root next;
    if (!this->follow(root.still, root.still.still.position - (miss - along * direction) - along / rate * direction,
          scratch, next.still))
    {
      return;
    }
    next.moved = this->move(next.still, time, section);
    const glm::dvec2 left = glm::dvec2(next.moved.position) - place;
    if (!(glm::length(left) < glm::length(miss)))
    {
      return;
    }
    root = next;
    miss = left;
  }
}

bool SurfaceFunction::highest(
  const SheetPlace& start, double time, const WaveSection& section, Scratch& scratch, Root& top) const
{
  using Sample = Scratch::Sample;
  const glm::dvec2 place = start.still.position;
  const glm::dvec2 direction = start.still.direction;
  const double reach = this->reach(start, time, section);
  const double wavelength = 2.0 * Pi / start.still.wavenumber;
  const double step = wavelength / std::max(LeastSamples, SamplesPerPoint * section.pointsPerWave());
  const auto sampleAt = [&](const SheetPlace& from, double at, Sample& sample)
  {
    if (!this->follow(from, place + at * direction, scratch, sample.still))
    {
      return false;
    }
    const MovedPlace moved = this->move(sample.still, time, section);
    sample.at = at;
    sample.residual = glm::dot(glm::dvec2(moved.position) - place, direction);
    sample.rate = moved.normal.z;
    return true;
  };
  bool any = false;
  const auto consider = [&](const Sample& sample)
  {
    Root root{ sample.still, this->move(sample.still, time, section) };
    this->settle(root, place, time, section, scratch);
    if (!any || root.moved.position.z > top.moved.position.z)
    {
      top = root;
      any = true;
    }
  };
  // A root between two samples of different sign: regula falsi with the Illinois rule.
  const auto bracket = [&](Sample low, Sample high)
  {
    double weightLow = low.residual;
    double weightHigh = high.residual;
    Sample best = std::abs(low.residual) < std::abs(high.residual) ? low : high;
    for (int i = 0; i < MostIterations && std::abs(best.residual) > Closeness * wavelength; ++i)
    {
      const double at = (low.at * weightHigh - high.at * weightLow) / (weightHigh - weightLow);
      Sample next;
      if (!(at > low.at && at < high.at) || !sampleAt(best.still, at, next))
      {
        break;
      }
      best = std::abs(next.residual) < std::abs(best.residual) ? next : best;
      if ((next.residual > 0.0) == (high.residual > 0.0))
      {
        high = next;
        weightHigh = next.residual;
        weightLow *= 0.5;
      }
      else
      {
        low = next;
        weightLow = next.residual;
        weightHigh *= 0.5;
      }
    }
    consider(best);
  };
  const auto between = [&](const Sample& low, const Sample& high)
  {
    if ((low.residual > 0.0) != (high.residual > 0.0))
    {
      bracket(low, high);
      return;
    }
    // The residual may turn back to 0 in between.
    if ((low.rate > 0.0) != (high.rate > 0.0) && (low.rate > 0.0) == (low.residual < 0.0))
    {
      Sample before = low;
      for (int i = 1; i <= Subdivision; ++i)
      {
        Sample next = high;
        if (i < Subdivision && !sampleAt(before.still, low.at + (high.at - low.at) * i / Subdivision, next))
        {
          return;
        }
        if ((before.residual > 0.0) != (next.residual > 0.0))
        {
          bracket(before, next);
        }
        before = next;
      }
    }
  };

  Sample middle;
  sampleAt(start, 0.0, middle);
  if (middle.residual == 0.0)
  {
    consider(middle);
  }
  for (const double side : { 1.0, -1.0 })
  {
    Sample before = middle;
    for (int i = 1; (i - 1) * step < reach; ++i)
    {
      Sample next;
      if (!sampleAt(before.still, side * i * step, next))
      {
        break;
      }
      if (side > 0.0)
      {
        between(before, next);
      }
      else
      {
        between(next, before);
      }
      before = next;
    }
  }
  return any;
}

SurfaceValue SurfaceFunction::at(
  const glm::dvec2& place, double time, const SurfaceMotion& motion, Scratch& scratch) const
{
  SurfaceValue value;
  const WaveSection& section = *motion.section;
  const double level = this->Surface.options().waterLevel;
  this->Locator.find(place, scratch.covers);
  scratch.sheets.clear();
  for (const SheetCover& cover : scratch.covers)
  {
    scratch.sheets.push_back(this->placeOn(cover, place));
  }
  glm::dvec2 slope(0.0);
  double up = 0.0;
  glm::dvec3 overhanging(0.0);
  bool whole = true;
  for (const SheetPlace& sheet : scratch.sheets)
  {
    const double share = resolvedShare(2.0 * Pi / sheet.still.wavenumber, motion.spacing);
    whole = whole && share == 1.0;
    if (share == 0.0)
    {
      value.depth = sheet.still.depth;
      ++value.sheets;
      continue;
    }
    Root root{ sheet, {} };
    if (!section.movesAlong() || sheet.shore >= 1.0)
    {
      root.moved = this->move(sheet, time, section);
    }
    else if (!this->highest(sheet, time, section, scratch, root))
    {
      continue;
    }
    bool broken = false;
    this->move(root.still, time, section, &broken);
    const glm::dvec3& normal = root.moved.normal;
    up += share * (root.moved.position.z - level);
    // A top sheet looks up; a vertical face has no slope.
    slope -= share / std::max(normal.z, 1e-9) * glm::dvec2(normal);
    overhanging = normal;
    value.velocity += share * root.moved.velocity;
    value.depth = root.moved.depth;
    value.foam = std::max(value.foam, this->foam(root.still, time, motion));
    value.breaking = value.breaking || broken;
    ++value.sheets;
  }
  if (value.sheets == 0)
  {
    return value;
  }
  value.covered = true;
  value.elevation = level + std::max(up, -value.depth);
  value.normal = whole && value.sheets == 1 && glm::length(overhanging) > 0.0 ? glm::normalize(overhanging)
                                                                              : glm::normalize(glm::dvec3(-slope, 1.0));
  return value;
}

SurfaceValue SurfaceFunction::at(const glm::dvec2& place, double time, const SurfaceMotion& motion) const
{
  Scratch scratch;
  return this->at(place, time, motion, scratch);
}

std::vector<SurfaceValue> SurfaceFunction::at(const std::vector<glm::dvec2>& places, const std::vector<double>& times,
  const SurfaceMotion& motion, const Execution& execution) const
{
  if (times.size() != 1 && times.size() != places.size())
  {
    throw std::invalid_argument("the surface at " + std::to_string(places.size()) +
      " places needs as many times, or one, not " + std::to_string(times.size()));
  }
  std::vector<SurfaceValue> values(places.size());
  execution.forRange(places.size(),
    [&](std::size_t begin, std::size_t end)
    {
      Scratch scratch;
      for (std::size_t i = begin; i < end; ++i)
      {
        values[i] = this->at(places[i], times[times.size() == 1 ? 0 : i], motion, scratch);
      }
    });
  return values;
}

}
