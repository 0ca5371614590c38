#include "sim/BeamBuilder.h"

#include "sim/Angles.h"
#include "sim/Caustic.h"
#include "sim/RayField.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace swellray
{

namespace
{

// M at a focus over k |d beta/ds|: least errors over round shoals.
constexpr std::complex<double> FocusSpread(0.3, 0.7);

// Where the peak of the fold would be higher than this, rays meet in a focus.
constexpr double FocusPeak = 10.0;

// On a current rays do not run along the wavenumber, and widths do not tell how it turns.
constexpr double StillWater = 1e-6;

// Phase over which an inserted ray comes in, rad.
constexpr double ComingIn = 2.0 * Pi;

// Between fronts phases are equal to the accuracy of the integration, rad.
constexpr double PhaseTolerance = 1e-6;

// Before its end a ray is counted as ended over this phase, rad: feet of a place on neighbouring rays are not on one
// front.
constexpr double Ending = Pi;

// Widest distance of rays, over the width of their beams.
constexpr double WidestGap = 1.6;

// Rays go on straight outside of the scene over this many lengths of the longest focus, in so many steps.
constexpr double ExtensionLengths = 2.0;
constexpr int ExtensionSteps = 32;

// A ray begins on the edge of the scene within this share of its size.
constexpr double OnEdge = 1e-3;

// Whether the rays about this one meet in a place, not along a line.
bool isFocus(const RayCaustic& caustic)
{
  return std::isfinite(caustic.alongRate) &&
    !(foldPeak(caustic, std::abs(caustic.widthRate / caustic.alongRate)) < FocusPeak);
}

// Whether the way along the caustic turns back between two rays.
bool isCusp(const RayCaustic& a, const RayCaustic& b)
{
  return a.alongRate * b.alongRate <= 0.0;
}

bool onStillWater(const RayCaustic& caustic)
{
  const double k = glm::length(caustic.wavenumber);
  return std::abs(caustic.fanWavenumber - k) < StillWater * k && std::abs(caustic.phaseRate - k) < StillWater * k;
}

double smoothStep(double low, double high, double x)
{
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Error of the trapezoidal rule for a Gaussian with places so many widths apart.
double errorOfSum(double spacing)
{
  return std::min(1.0, 2.0 * std::exp(-2.0 * Pi * Pi / (spacing * spacing)));
}

// Derivative by x of a function known at three places, at the middle one.
double derivative(double x0, double y0, double x1, double y1, double x2, double y2)
{
  const double before = (y1 - y0) / (x1 - x0);
  const double after = (y2 - y1) / (x2 - x1);
  return (before * (x2 - x1) + after * (x1 - x0)) / (x2 - x0);
}

}

double BeamBuilder::widthOf(const Point& point)
{
  return point.scale * std::sqrt(2.0 * LargestExponent / point.spread.imag());
}

BeamBuilder::BeamBuilder(GaussianBeams& beams)
  : Beams(beams)
  , Rays(beams.Sheets.rays())
{
}

void BeamBuilder::build(const Execution& execution)
{
  if (this->Rays.touchedCount == 0 || !this->Rays.refraction || !this->Rays.tubeWidth)
  {
    return;
  }
  this->findFoci();
  if (this->Beams.Foci.empty())
  {
    return;
  }
  this->sortRays();
  std::vector<std::vector<Point>> points(this->Sorted.size());
  execution.forRange(this->Sorted.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        points[i] = this->pointsOf(i);
      }
    });
  for (const std::vector<Point>& ofRay : points)
  {
    for (std::size_t i = 0; i < ofRay.size(); ++i)
    {
      const Point& a = ofRay[i];
      this->Beams.Points.push_back(a);
      if (i + 1 == ofRay.size() || (a.amplitude == 0.0 && ofRay[i + 1].amplitude == 0.0))
      {
        continue;
      }
      const Point& b = ofRay[i + 1];
      GaussianBeams::Segment segment;
      segment.first = this->Beams.Points.size() - 1;
      segment.length = glm::distance(a.position, b.position);
      const double width = std::max(a.width, b.width);
      const glm::dvec2 across = width * glm::max(glm::abs(a.along), glm::abs(b.along));
      segment.box.low = glm::min(a.position, b.position) - glm::dvec2(across.y, across.x);
      segment.box.high = glm::max(a.position, b.position) + glm::dvec2(across.y, across.x);
      if (segment.length > 0.0)
      {
        this->Beams.Segments.push_back(segment);
      }
    }
  }
}

void BeamBuilder::findFoci()
{
  std::vector<const RayCaustic*> sorted;
  for (std::size_t i = 0; i < this->Rays.touchedCount; ++i)
  {
    const RayCaustic& caustic = this->Rays.touched[i];
    if (onStillWater(caustic) && std::abs(caustic.widthRate) > 0.0)
    {
      sorted.push_back(&caustic);
    }
  }
  const auto key = [&](const RayCaustic* caustic)
  {
    const auto ray = static_cast<std::size_t>(caustic->ray);
    return std::make_tuple(
      this->Rays.lines.launchSegment[ray], caustic->number, this->Rays.lines.launchParameter[ray], caustic->ray);
  };
  std::sort(sorted.begin(), sorted.end(), [&](const RayCaustic* a, const RayCaustic* b) { return key(a) < key(b); });
  const auto together = [&](const RayCaustic* a, const RayCaustic* b) {
    return a->number == b->number && this->Rays.lines.launchSegment[a->ray] == this->Rays.lines.launchSegment[b->ray];
  };
  const std::size_t count = sorted.size();
  std::vector<char> special(count, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    special[i] = special[i] || isFocus(*sorted[i]) ? 1 : 0;
    if (i + 1 < count && together(sorted[i], sorted[i + 1]) && isCusp(*sorted[i], *sorted[i + 1]))
    {
      special[i] = special[i + 1] = 1;
    }
  }
  for (std::size_t begin = 0; begin < count;)
  {
    if (special[begin] == 0)
    {
      ++begin;
      continue;
    }
    std::size_t end = begin + 1;
    while (end < count && special[end] != 0 && together(sorted[end - 1], sorted[end]))
    {
      ++end;
    }
    const RayCaustic* tip = *std::min_element(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
      sorted.begin() + static_cast<std::ptrdiff_t>(end),
      [](const RayCaustic* a, const RayCaustic* b) { return std::abs(a->alongRate) < std::abs(b->alongRate); });
    std::vector<double> closing;
    for (std::size_t i = begin; i < end; ++i)
    {
      closing.push_back(std::abs(sorted[i]->widthRate));
    }
    std::nth_element(closing.begin(), closing.begin() + static_cast<std::ptrdiff_t>(closing.size() / 2), closing.end());
    const double median = closing[closing.size() / 2];
    begin = end;
    if (2.0 * Pi * median > tip->scale * glm::length(tip->wavenumber))
    {
      continue; // closer than a wavelength rays are no waves
    }
    BeamFocus focus;
    focus.position = tip->position;
    focus.along = tip->rayDirection;
    focus.phase = tip->phase;
    focus.length = tip->scale / median;
    focus.spread = FocusSpread * (tip->scale * glm::length(tip->wavenumber) * median);
    this->Beams.Foci.push_back(focus);
    this->Extension = std::max(this->Extension, ExtensionLengths / median);
  }
}

void BeamBuilder::sortRays()
{
  const RayLines& lines = this->Rays.lines;
  const Rectangle& bounds = this->Beams.Sheets.bounds();
  const double near = OnEdge * glm::length(bounds.size());
  for (std::size_t i = 0; i < lines.rays; ++i)
  {
    Ray ray;
    ray.index = i;
    ray.begin = lines.offsets[i];
    ray.end = ray.begin;
    while (ray.end < lines.offsets[i + 1] && std::isfinite(this->Rays.tubeWidth[ray.end]) &&
      this->Rays.state[ray.end] != static_cast<std::uint8_t>(RayState::Aground))
    {
      ++ray.end;
    }
    if (this->Rays.lee[i] != 0 || ray.end - ray.begin < 2)
    {
      continue;
    }
    const std::int32_t parent = this->Rays.parent[i];
    ray.launched =
      parent < 0 || (this->Rays.reflections && this->Rays.reflections[i] != this->Rays.reflections[parent]);
    const double* start = lines.positions + 3 * ray.begin;
    const glm::dvec2 inside =
      glm::min(glm::dvec2(start[0], start[1]) - bounds.low, bounds.high - glm::dvec2(start[0], start[1]));
    ray.before = parent < 0 && std::min(inside.x, inside.y) < near;
    ray.beyond = this->Rays.endReason && ray.end == lines.offsets[i + 1] &&
      this->Rays.endReason[i] == static_cast<std::uint8_t>(EndReason::LeftScene);
    ray.first = lines.phase[ray.begin] - (ray.before ? this->Extension * this->Rays.wavenumber[ray.begin] : 0.0);
    ray.last = lines.phase[ray.end - 1] + (ray.beyond ? this->Extension * this->Rays.wavenumber[ray.end - 1] : 0.0);
    this->Sorted.push_back(ray);
  }
  std::sort(this->Sorted.begin(), this->Sorted.end(),
    [&](const Ray& a, const Ray& b)
    {
      return std::make_tuple(lines.launchSegment[a.index], lines.launchParameter[a.index], a.index) <
        std::make_tuple(lines.launchSegment[b.index], lines.launchParameter[b.index], b.index);
    });
}

std::vector<BeamBuilder::Place> BeamBuilder::placesOf(const Ray& ray) const
{
  const RayLines& lines = this->Rays.lines;
  std::vector<Place> places;
  double height = 0.0;
  for (std::int64_t i = ray.begin; i < ray.end; ++i)
  {
    Place place;
    place.point.position = { lines.positions[3 * i], lines.positions[3 * i + 1] };
    place.point.along = { this->Rays.direction[3 * i], this->Rays.direction[3 * i + 1] };
    place.point.phase = lines.phase[i];
    place.point.wavenumber = this->Rays.wavenumber[i];
    place.point.scale = lines.scale ? lines.scale[i] : 1.0;
    place.tube = this->Rays.tubeWidth[i];
    place.caustics = this->Rays.caustics[i];
    const double unit = this->Rays.height[i] / this->Rays.refraction[i];
    height = std::isfinite(unit) ? unit : height; // as before, on a caustic where both are infinite
    place.height = height;
    if (places.empty() || place.point.phase > places.back().point.phase + PhaseTolerance)
    {
      places.push_back(place);
    }
  }
  if (places.size() < 2)
  {
    return {};
  }
  // Straight on outside of the scene.
  const auto goOn = [&](const Place& end, const Place& next, double way)
  {
    Place place = end;
    const double rate = (end.tube - next.tube) / ((end.point.phase - next.point.phase) / end.point.wavenumber);
    place.point.position += way * end.point.scale * end.point.along;
    place.point.phase += way * end.point.wavenumber;
    place.tube += way * rate;
    return place;
  };
  std::vector<Place> all;
  const double stepLength = this->Extension / ExtensionSteps;
  for (int i = ExtensionSteps; ray.before && i > 0; --i)
  {
    all.push_back(goOn(places[0], places[1], -stepLength * i));
  }
  all.insert(all.end(), places.begin(), places.end());
  for (int i = 1; ray.beyond && i <= ExtensionSteps; ++i)
  {
    Place place = goOn(places[places.size() - 1], places[places.size() - 2], stepLength * i);
    place.caustics += place.tube * places.back().tube < 0.0 ? 1 : 0;
    all.push_back(place);
  }
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    const Point& a = all[i - 1].point;
    const Point& b = all[i].point;
    all[i].time = all[i - 1].time +
      0.5 * (b.phase - a.phase) * (1.0 / (a.wavenumber * a.wavenumber) + 1.0 / (b.wavenumber * b.wavenumber));
  }
  return all;
}

std::complex<double> BeamBuilder::spreadAt(const Place& place, const std::vector<double>& timesAtFoci) const
{
  std::complex<double> sum = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < timesAtFoci.size(); ++i)
  {
    const BeamFocus& focus = this->Beams.Foci[i];
    const glm::dvec2 way = (place.point.position - focus.position) / focus.length;
    const double near = 1.0 + glm::dot(way, way);
    const double weight = 1.0 / (near * near * near);
    sum += weight * focus.spread / (1.0 + focus.spread * (place.time - timesAtFoci[i]));
    weights += weight;
  }
  return sum / weights;
}

double BeamBuilder::presence(const Ray& ray, double phase) const
{
  return ray.launched ? 1.0 : smoothStep(0.0, ComingIn, phase - ray.first);
}

double BeamBuilder::ending(const Ray& ray, double phase) const
{
  const double before = ray.launched ? phase - ray.first : Ending;
  return 1.0 - smoothStep(0.0, Ending, std::min(before, ray.last - phase));
}

BeamBuilder::Side BeamBuilder::side(std::size_t order, double phase, int direction) const
{
  const RayLines& lines = this->Rays.lines;
  const std::size_t own = this->Sorted[order].index;
  Side side;
  double rest = 1.0;
  for (std::size_t at = order + static_cast<std::size_t>(direction); at < this->Sorted.size();
       at += static_cast<std::size_t>(direction))
  {
    const Ray& ray = this->Sorted[at];
    if (lines.launchSegment[ray.index] != lines.launchSegment[own])
    {
      break;
    }
    const bool ended = phase > ray.last + PhaseTolerance;
    const bool notYet = phase < ray.first - PhaseTolerance;
    const double end = this->ending(ray, phase);
    if (notYet && !ray.launched)
    {
      continue;
    }
    const double share = rest * (ended || notYet ? 1.0 : this->presence(ray, phase));
    side.gap += share * std::abs(lines.launchParameter[ray.index] - lines.launchParameter[own]);
    side.end += share * end;
    rest -= share;
    if (!(rest > 1e-9))
    {
      return side;
    }
  }
  side.end += rest;
  return side;
}

bool BeamBuilder::matters(const Point& point) const
{
  return std::any_of(this->Beams.Foci.begin(), this->Beams.Foci.end(),
    [&](const BeamFocus& focus)
    { return glm::distance(point.position, focus.position) < GaussianBeams::Farthest * focus.length + point.width; });
}

std::vector<BeamBuilder::Point> BeamBuilder::pointsOf(std::size_t order) const
{
  const Ray& ray = this->Sorted[order];
  const std::vector<Place> places = this->placesOf(ray);
  std::vector<Point> points;
  if (places.size() < 2)
  {
    return points;
  }
  // When the ray has the phase of each focus, before its beginning and after its end on level ground.
  std::vector<double> times;
  for (const BeamFocus& focus : this->Beams.Foci)
  {
    const auto found = std::lower_bound(places.begin() + 1, places.end() - 1, focus.phase,
      [](const Place& place, double phase) { return place.point.phase < phase; });
    const Place& b = *found;
    const Place& a = *(found - 1);
    times.push_back(a.time + (b.time - a.time) * (focus.phase - a.point.phase) / (b.point.phase - a.point.phase));
  }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const Place& place = places[i];
    Point point = place.point;
    point.spread = this->spreadAt(place, times);
    point.width = widthOf(point);
    if (!this->matters(point))
    {
      points.push_back(point);
      continue;
    }
    const Place& a = places[i > 0 ? i - 1 : 0];
    const Place& b = places[std::min(i + 1, places.size() - 1)];
    const bool inner = i > 0 && i + 1 < places.size();
    const double rate = inner ? derivative(a.point.phase, a.tube, place.point.phase, place.tube, b.point.phase, b.tube)
                              : (b.tube - a.tube) / (b.point.phase - a.point.phase);
    const double turn = rate * point.wavenumber * point.wavenumber;
    const Side right = this->side(order, point.phase, -1);
    const Side left = this->side(order, point.phase, 1);
    const double gap = std::max(right.gap, left.gap);
    // No beam may be narrower than the way to the next.
    const double narrow = gap * std::abs(place.tube * point.spread) / std::sqrt(point.spread.imag());
    if (narrow > WidestGap)
    {
      point.spread *= (WidestGap / narrow) * (WidestGap / narrow);
      point.width = widthOf(point);
    }
    const std::complex<double> across = point.spread * place.tube - turn; // M q - p
    const std::complex<double> sheer = across / std::complex<double>(0.0, place.caustics % 2 == 0 ? 1.0 : -1.0);
    const double share = 0.5 * this->presence(ray, point.phase) * (right.gap + left.gap);
    point.amplitude =
      place.height * share / std::sqrt(2.0 * Pi) * std::sqrt(sheer) * std::polar(1.0, -0.5 * Pi * place.caustics);
    const double spacing = gap * std::abs(across) / std::sqrt(point.spread.imag());
    point.end = std::max({ right.end, left.end, this->ending(ray, point.phase) });
    point.coarse = errorOfSum(spacing);
    // All that a tube wider than a beam can bring.
    point.amplitude *= std::min(1.0, std::sqrt(2.0 * Pi) / spacing);
    points.push_back(point);
  }
  return points;
}

}
