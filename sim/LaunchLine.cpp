#include "sim/LaunchLine.h"

#include "sim/Angles.h"
#include "sim/CurrentDispersion.h"
#include "sim/Dispersion.h"
#include "sim/GaussRule.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Slope of the fitted plane below which a scene has no shore normal.
constexpr double SmallestSlope = 1e-4;

// A wave that comes in more nearly along an edge, or along the contours, than this does not come in.
constexpr double Grazing = 1e-6;

// Parts of the whole outline in which it is looked at for land and holes.
constexpr double FewestParts = 1600.0;
constexpr double MostParts = 16000.0;

// Ratio of wavenumbers above which a part is integrated in halves, down to a share of its side: below it the formula
// of Gauss is right to 1e-12.
constexpr double LargestChange = 1.1;
constexpr double ShortestPart = 1e-9;

// And the least cosine between its directions: those to a near source change within a part.
constexpr double LeastCosine = 0.98;

// Width of a source's tube over the way from it below which its rays are about to meet again: on the Earth beyond 18,000 km.
constexpr double NarrowTube = 0.1;

// A ray starts within its stretch by this share of it.
constexpr double EndShare = 1e-12;

glm::dvec2 leftOf(const glm::dvec2& v)
{
  return { -v.y, v.x };
}

void requireSource(const SourceSample& sample)
{
  if (!(sample.distance > 0.0))
  {
    throw std::invalid_argument(
      "the point that the waves come from lies on the edge of the scene: it must lie outside");
  }
  if (!(sample.width > NarrowTube * sample.distance))
  {
    throw std::invalid_argument(
      "the point that the waves come from lies nearly opposite the scene, where they meet again: it "
      "must be less than 18,000 km away");
  }
}

}

std::optional<glm::dvec2> contourNormal(const Seafloor& seafloor, double waterLevel, std::optional<double> given)
{
  if (given)
  {
    const double heading = headingFromNautical(*given);
    return glm::dvec2(std::cos(heading), std::sin(heading));
  }
  const BedPlane plane = fitWetPlane(seafloor, waterLevel);
  const double slope = glm::length(plane.slope);
  return plane.valid && slope >= SmallestSlope ? std::optional<glm::dvec2>(plane.slope / slope) : std::nullopt;
}

LaunchLine::LaunchLine(
  const Seafloor& seafloor, double waterLevel, const IncidentWave& wave, double aground, const LaunchOptions& options)
  : Floor(&seafloor)
  , Options(options)
  , WaterLevel(waterLevel)
  , Wave(wave)
  , Aground(aground)
  , DirectionFrom(wave.directionFrom)
{
  wave.validate();
  if (!(aground > 0.0))
  {
    throw std::invalid_argument("aground depth must be above 0 m");
  }
  if (options.rule == EdgeRule::Contours)
  {
    this->ContourNormal = swellray::contourNormal(seafloor, waterLevel, options.shoreNormal);
  }

  const std::vector<glm::dvec2> corners = seafloor.outline();
  // Begin at the corner that the wave leaves the scene by, so that the edges it comes in by follow each other.
  const auto way = [&](const glm::dvec2& corner)
  {
    if (!options.source)
    {
      return glm::dot(corner, wave.direction());
    }
    SourceSample sample;
    options.source->evaluate(corner, sample);
    requireSource(sample);
    return sample.distance;
  };
  std::size_t first = 0;
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    if (way(corners[i]) > way(corners[first]))
    {
      first = i;
    }
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    this->Perimeter += glm::length(corners[(i + 1) % corners.size()] - corners[i]);
  }
  bool open = false;
  int segment = -1;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec2 from = corners[(first + i) % corners.size()];
    const glm::dvec2 to = corners[(first + i + 1) % corners.size()];
    Side side;
    side.corner = from;
    side.length = glm::length(to - from);
    if (!(side.length > 0.0))
    {
      continue;
    }
    side.along = (to - from) / side.length;
    side.inward = -leftOf(side.along);
    this->Sides.push_back(side);
    this->walk(side, static_cast<int>(this->Sides.size()) - 1, open, segment);
  }

  this->Stretches.erase(
    std::remove_if(this->Stretches.begin(), this->Stretches.end(), [](const Stretch& s) { return !(s.width > 0.0); }),
    this->Stretches.end());
  this->findReference();
}

void LaunchLine::findReference()
{
  const auto ends = [](const Stretch& stretch) { return std::min(stretch.phase, stretch.phase + stretch.rise); };
  const auto earliest = std::min_element(this->Stretches.begin(), this->Stretches.end(),
    [&](const Stretch& a, const Stretch& b) { return ends(a) < ends(b); });
  if (earliest == this->Stretches.end())
  {
    return;
  }
  const double first = ends(*earliest);
  if (this->Options.source)
  {
    const Side& side = this->Sides[earliest->side];
    const glm::dvec2 place = side.corner + (earliest->rise < 0.0 ? earliest->to : earliest->from) * side.along;
    SourceSample sample;
    this->Options.source->evaluate(place, sample);
    this->ReferenceWidth = sample.width;
    this->SourceDistance = sample.distance;
    this->DirectionFrom = nauticalFromVector({ std::cos(sample.heading), std::sin(sample.heading) });
    this->Length *= sample.width;
  }
  for (Stretch& stretch : this->Stretches)
  {
    stretch.phase -= first;
    stretch.lambda *= this->ReferenceWidth;
    stretch.width *= this->ReferenceWidth;
  }
}

LaunchLine::Offshore LaunchLine::offshoreAt(const Side& side, double l) const
{
  Offshore wave;
  if (!this->Options.source)
  {
    wave.direction = this->Wave.direction();
    return wave;
  }
  SourceSample sample;
  this->Options.source->evaluate(side.corner + l * side.along, sample);
  wave.direction = { std::cos(sample.heading), std::sin(sample.heading) };
  wave.turn = glm::dot(sample.turn, side.along);
  wave.spread = sample.width / this->ReferenceWidth;
  return wave;
}

std::optional<double> LaunchLine::solveAlong(
  double depth, const glm::dvec2& along, double across, const glm::dvec2& velocity) const
{
  const double omega = this->Wave.angularFrequency();
  const double gravity = this->Wave.gravity;
  if (this->Options.current)
  {
    return solveOnCurrent(omega, depth, gravity, along, across, velocity);
  }
  const double k = solveWavenumber(omega, depth, gravity);
  const double square = k * k - across * across;
  return square < Grazing * Grazing * k * k ? std::nullopt : std::optional<double>(std::sqrt(square));
}

LaunchLine::EdgeWave LaunchLine::edgeWave(const Side& side, double l) const
{
  const glm::dvec2 p = side.corner + l * side.along;
  const BedSample bed = this->Floor->bed(p);
  const double trueDepth = this->WaterLevel - bed.elevation;
  const bool water = trueDepth >= this->Aground && !this->Floor->isHole(p) &&
    !(this->Options.obstacles && this->Options.obstacles->inside(p));
  const double depth = std::max(trueDepth, this->Aground);
  CurrentSample current;
  if (this->Options.current)
  {
    this->Options.current->evaluate(p, current);
  }

  // Along this unit vector the wavenumber follows from the dispersion relation; across it, it is kept.
  const Offshore offshore = this->offshoreAt(side, l);
  const glm::dvec2& t0 = offshore.direction;
  glm::dvec2 along = t0;
  double across = 0.0;
  EdgeWave wave;
  const std::optional<glm::dvec2> normal =
    this->Options.rule == EdgeRule::Edge ? std::optional<glm::dvec2>(side.inward) : this->ContourNormal;
  if (normal)
  {
    const double cosine = glm::dot(t0, *normal);
    if (std::abs(cosine) < Grazing || (this->Options.rule == EdgeRule::Edge && cosine < 0.0))
    {
      return wave;
    }
    along = *normal * std::copysign(1.0, cosine);
    across = this->Wave.wavenumber() * glm::dot(t0, leftOf(along));
  }
  const std::optional<double> kAlong = this->solveAlong(depth, along, across, current.velocity);
  if (!kAlong)
  {
    return wave;
  }
  wave.wavenumber = *kAlong * along + across * leftOf(along);
  const double k = glm::length(wave.wavenumber);
  Frequency f;
  evaluateFrequency(k, depth, this->Wave.gravity, f);
  const glm::dvec2 ray = f.k / k * wave.wavenumber + current.velocity;
  const double speed = glm::length(ray);
  const double forward = glm::dot(ray, along);
  if (forward < Grazing * speed)
  {
    wave.wavenumber = glm::dvec2(0.0);
    return wave;
  }
  if (water)
  {
    // d(sigma + k.U)/dl = 0, and of the component across what the wave offshore turns.
    const glm::dvec2 slope = side.along.x * current.dx + side.along.y * current.dy;
    const double change = glm::dot(wave.wavenumber, slope) - f.h * glm::dot(bed.gradient, side.along);
    const double turn = (normal ? this->Wave.wavenumber() * glm::dot(t0, along) : k) * offshore.turn;
    const glm::dvec2 left = leftOf(along);
    wave.dWavenumber = -(change + glm::dot(ray, left) * turn) / forward * along + turn * left;
  }
  const double inward = glm::dot(ray, side.inward) / speed;
  const double crestRatio = normal ? glm::dot(t0, along) * speed / forward : 1.0;
  wave.enters = water && inward > Grazing;
  wave.density = wave.enters ? inward * crestRatio / offshore.spread : 0.0;
  if (this->Options.map)
  {
    this->bringToMap(side, l, wave);
  }
  return wave;
}

void LaunchLine::bringToMap(const Side& side, double l, EdgeWave& wave) const
{
  ScaleSample m;
  this->Options.map->evaluate(side.corner + l * side.along, m);
  wave.wavenumber /= m.scale;
  wave.dWavenumber = wave.dWavenumber / m.scale - glm::dot(m.gradient, side.along) / m.scale * wave.wavenumber;
  wave.density /= m.scale;
}

glm::dvec2 LaunchLine::wavenumberAt(const glm::dvec2& place, const glm::dvec2& inward) const
{
  return this->edgeWave({ place, leftOf(inward), inward, 0.0 }, 0.0).wavenumber;
}

glm::dvec2 LaunchLine::integrate(const Side& side, double from, double to) const
{
  const double half = 0.5 * (to - from);
  const double middle = 0.5 * (to + from);
  glm::dvec2 sum(0.0);
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  bool turned = false;
  glm::dvec2 before(0.0);
  for (std::size_t i = 0; i < GaussNode.size(); ++i)
  {
    const EdgeWave wave = this->edgeWave(side, middle + half * GaussNode[i]);
    sum += GaussWeight[i] * glm::dvec2(wave.density, glm::dot(wave.wavenumber, side.along));
    const double k = glm::length(wave.wavenumber);
    least = std::min(least, k);
    most = std::max(most, k);
    turned = turned || (i > 0 && glm::dot(wave.wavenumber, before) < LeastCosine * k * glm::length(before));
    before = wave.wavenumber;
  }
  // Near the shore k changes as the root of the distance to it.
  if (least > 0.0 && (most > LargestChange * least || turned) && half > ShortestPart * side.length)
  {
    return this->integrate(side, from, middle) + this->integrate(side, middle, to);
  }
  return sum * half;
}

void LaunchLine::append(int index, int segment, double from, double to)
{
  Stretch stretch;
  stretch.side = index;
  stretch.segment = segment;
  stretch.from = from;
  stretch.to = to;
  if (!this->Stretches.empty())
  {
    stretch.phase = this->Stretches.back().phase + this->Stretches.back().rise;
  }
  const glm::dvec2 integral = this->integrate(this->Sides[index], from, to);
  stretch.rise = integral.y;
  stretch.lambda = this->Length;
  if (segment >= 0)
  {
    stretch.width = integral.x;
    this->Length += stretch.width;
  }
  this->Stretches.push_back(stretch);
}

void LaunchLine::walk(const Side& side, int index, bool& open, int& segment)
{
  const double part = std::clamp(this->Floor->resolution(), this->Perimeter / MostParts, this->Perimeter / FewestParts);
  const auto parts = static_cast<std::size_t>(std::ceil(side.length / part));
  double from = 0.0;
  bool entersFrom = this->edgeWave(side, 0.0).enters;
  for (std::size_t i = 1; i <= parts; ++i)
  {
    const double to = side.length * static_cast<double>(i) / static_cast<double>(parts);
    const bool entersTo = this->edgeWave(side, to).enters;
    std::array<double, 3> ends{ from, to, to };
    std::size_t pieces = 1;
    if (entersTo != entersFrom)
    {
      double low = from;
      double high = to;
      for (int halving = 0; halving < 60; ++halving)
      {
        const double middle = 0.5 * (low + high);
        (this->edgeWave(side, middle).enters == entersFrom ? low : high) = middle;
      }
      ends = { from, 0.5 * (low + high), to };
      pieces = 2;
    }
    for (std::size_t piece = 0; piece < pieces; ++piece)
    {
      const bool enters = piece == 0 ? entersFrom : entersTo;
      if (enters && !open)
      {
        ++segment;
      }
      open = enters;
      this->append(index, enters ? segment : -1, ends[piece], ends[piece + 1]);
    }
    from = to;
    entersFrom = entersTo;
  }
}

LaunchPoint LaunchLine::at(double lambda) const
{
  if (this->Stretches.empty())
  {
    throw std::logic_error("the wave comes in nowhere: there is no launch line");
  }
  auto next = std::upper_bound(this->Stretches.begin(), this->Stretches.end(), lambda,
    [](double value, const Stretch& stretch) { return value < stretch.lambda; });
  const Stretch& stretch = next == this->Stretches.begin() ? *next : *std::prev(next);
  const Side& side = this->Sides[stretch.side];

  // Newton on lambda(l), kept in its bracket: where the wave grazes the edge its density falls to nothing at the end.
  const double end = EndShare * stretch.width;
  const double wanted = std::clamp(lambda - stretch.lambda, end, stretch.width - end);
  double low = stretch.from;
  double high = stretch.to;
  double l = low + (high - low) * (wanted / stretch.width);
  for (int i = 0; i < 60; ++i)
  {
    const double miss = this->integrate(side, stretch.from, l).x - wanted;
    const double newton = l - miss / this->edgeWave(side, l).density;
    if (std::abs(newton - l) <= 1e-15 * side.length)
    {
      break;
    }
    (miss > 0.0 ? high : low) = l;
    l = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  const EdgeWave wave = this->edgeWave(side, l);
  LaunchPoint point;
  point.position = side.corner + l * side.along;
  point.wavenumber = wave.wavenumber;
  point.dPosition = side.along / wave.density;
  point.dWavenumber = wave.dWavenumber / wave.density;
  point.phase = stretch.phase + this->integrate(side, stretch.from, l).y;
  point.segment = stretch.segment;
  return point;
}

}
