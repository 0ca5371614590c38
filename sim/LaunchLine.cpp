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
#include <sstream>
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

  if (!options.places.empty())
  {
    this->standPlaces();
    return;
  }
  const std::vector<std::vector<glm::dvec2>> chains = this->chains();
  for (const std::vector<glm::dvec2>& chain : chains)
  {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    {
      this->Perimeter += glm::length(chain[i + 1] - chain[i]);
    }
  }
  int segment = -1;
  for (std::size_t chain = 0; chain < chains.size(); ++chain)
  {
    bool open = false;
    for (std::size_t i = 0; i + 1 < chains[chain].size(); ++i)
    {
      const glm::dvec2 from = chains[chain][i];
      const glm::dvec2 way = chains[chain][i + 1] - from;
      Side side;
      side.corner = from;
      side.length = glm::length(way);
      side.chain = static_cast<int>(chain);
      if (!(side.length > 0.0))
      {
        continue;
      }
      side.along = way / side.length;
      side.inward = -leftOf(side.along);
      this->Sides.push_back(side);
      this->walk(side, static_cast<int>(this->Sides.size()) - 1, open, segment);
    }
  }
  this->Stretches.erase(
    std::remove_if(this->Stretches.begin(), this->Stretches.end(), [](const Stretch& s) { return !(s.width > 0.0); }),
    this->Stretches.end());
  this->findReferences();
}

std::vector<std::vector<glm::dvec2>> LaunchLine::chains() const
{
  const auto sampleAt = [&](const glm::dvec2& place)
  {
    SourceSample sample;
    this->Options.source->evaluate(place, sample);
    requireSource(sample);
    return sample;
  };
  if (this->Options.lines.empty())
  {
    // Begin at the corner that the wave leaves the scene by, so that the edges it comes in by follow each other.
    std::vector<glm::dvec2> outline = this->Floor->outline();
    const auto further = [&](const glm::dvec2& a, const glm::dvec2& b)
    {
      return this->Options.source ? sampleAt(a).distance > sampleAt(b).distance
                                  : glm::dot(a - b, this->Wave.direction()) > 0.0;
    };
    auto first = outline.begin();
    for (auto corner = outline.begin() + 1; corner != outline.end(); ++corner)
    {
      first = further(*corner, *first) ? corner : first;
    }
    std::rotate(outline.begin(), first, outline.end());
    outline.push_back(outline.front());
    return { outline };
  }
  std::vector<std::vector<glm::dvec2>> chains = this->Options.lines;
  for (std::vector<glm::dvec2>& chain : chains)
  {
    double rightward = 0.0;
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
      if (!this->Floor->bounds().contains(chain[i]))
      {
        throw std::runtime_error("a launch line leaves the scene: it must lie within");
      }
      if (i > 0)
      {
        const glm::dvec2 middle = 0.5 * (chain[i - 1] + chain[i]);
        const double heading =
          this->Options.source ? sampleAt(middle).heading : headingFromNautical(this->Wave.directionFrom);
        const glm::dvec2 way = chain[i] - chain[i - 1];
        rightward += way.y * std::cos(heading) - way.x * std::sin(heading);
      }
    }
    if (rightward < 0.0)
    {
      std::reverse(chain.begin(), chain.end());
    }
  }
  return chains;
}

void LaunchLine::takeReference(const SourceSample& sample)
{
  this->ReferenceWidth = sample.width;
  this->SourceDistance = sample.distance;
  this->DirectionFrom = nauticalFromVector({ std::cos(sample.heading), std::sin(sample.heading) });
}

void LaunchLine::findReferences()
{
  const auto ends = [](const Stretch& stretch) { return std::min(stretch.phase, stretch.phase + stretch.rise); };
  for (auto begin = this->Stretches.begin(); begin != this->Stretches.end();)
  {
    const int chain = this->Sides[begin->side].chain;
    const auto end = std::find_if(
      begin, this->Stretches.end(), [&](const Stretch& stretch) { return this->Sides[stretch.side].chain != chain; });
    const auto earliest =
      std::min_element(begin, end, [&](const Stretch& a, const Stretch& b) { return ends(a) < ends(b); });
    if (this->Options.source)
    {
      const Side& side = this->Sides[earliest->side];
      SourceSample sample;
      this->Options.source->evaluate(
        side.corner + (earliest->rise < 0.0 ? earliest->to : earliest->from) * side.along, sample);
      if (!this->SourceDistance || sample.distance < *this->SourceDistance)
      {
        this->takeReference(sample);
      }
    }
    const double first = ends(*earliest);
    for (; begin != end; ++begin)
    {
      begin->phase -= first;
    }
  }
  for (Stretch& stretch : this->Stretches)
  {
    stretch.lambda *= this->ReferenceWidth;
    stretch.width *= this->ReferenceWidth;
  }
  this->Length *= this->ReferenceWidth;
}

void LaunchLine::standPlaces()
{
  for (const LaunchPlace& place : this->Options.places)
  {
    if (this->Options.source)
    {
      SourceSample sample;
      this->Options.source->evaluate(place.position, sample);
      requireSource(sample);
      if (!this->SourceDistance || sample.distance < *this->SourceDistance)
      {
        this->takeReference(sample);
      }
    }
  }
  for (const LaunchPlace& place : this->Options.places)
  {
    Side side;
    side.corner = place.position;
    side.heading = place.heading;
    const Offshore offshore = this->offshoreAt(side, 0.0);
    side.inward = offshore.direction;
    side.along = leftOf(side.inward);
    if (this->Floor->bounds().contains(place.position))
    {
      const glm::dvec2 k = this->edgeWave(side, 0.0).wavenumber;
      side.inward = glm::length(k) > 0.0 ? glm::normalize(k) : side.inward;
      side.along = leftOf(side.inward);
    }
    this->Sides.push_back(side);
    if (!this->Floor->bounds().contains(place.position) || !this->edgeWave(side, 0.0).enters)
    {
      std::ostringstream message;
      message << "no wave can start from launch point " << this->Sides.size() << ", at x " << place.position.x << ", y "
              << place.position.y << " m: it must lie within the scene, in water deeper than " << this->Aground
              << " m, where the wave can come to";
      throw std::runtime_error(message.str());
    }
  }
  this->Length = static_cast<double>(this->Sides.size());
}

std::optional<double> LaunchLine::raySpacing() const
{
  return this->Options.places.empty() ? std::nullopt : std::optional<double>(1.0);
}

LaunchLine::Offshore LaunchLine::offshoreAt(const Side& side, double l) const
{
  Offshore wave;
  if (side.heading)
  {
    wave.direction = { std::cos(*side.heading), std::sin(*side.heading) };
    return wave;
  }
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
  const std::optional<glm::dvec2> normal = side.heading ? std::nullopt
    : this->Options.rule == EdgeRule::Edge              ? std::optional<glm::dvec2>(side.inward)
                                                        : this->ContourNormal;
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
  Side side;
  side.corner = place;
  side.along = leftOf(inward);
  side.inward = inward;
  return this->edgeWave(side, 0.0).wavenumber;
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

LaunchPoint LaunchLine::pointOf(const Side& side, double l) const
{
  const EdgeWave wave = this->edgeWave(side, l);
  LaunchPoint point;
  point.position = side.corner + l * side.along;
  point.wavenumber = wave.wavenumber;
  point.dPosition = side.along / wave.density;
  point.dWavenumber = wave.dWavenumber / wave.density;
  return point;
}

LaunchPoint LaunchLine::at(double lambda) const
{
  if (!this->Options.places.empty())
  {
    const auto index = std::min(static_cast<std::size_t>(std::max(lambda, 0.0)), this->Sides.size() - 1);
    LaunchPoint point = this->pointOf(this->Sides[index], 0.0);
    point.segment = static_cast<int>(index);
    return point;
  }
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
  LaunchPoint point = this->pointOf(side, l);
  point.phase = stretch.phase + this->integrate(side, stretch.from, l).y;
  point.segment = stretch.segment;
  return point;
}

}
