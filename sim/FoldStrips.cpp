#include "sim/FoldStrips.h"

#include "sim/Angles.h"
#include "sim/Caustic.h"
#include "sim/SheetSearch.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace swellray
{

namespace
{

// How far a strip reaches, in z, and from where on it gives way to the sheets.
constexpr double Darkest = -5.0;
constexpr double GivingWay = 0.75;
constexpr double Lightest = 1.5;

// Triangles next to the caustic reach into the dark as far as this, in z; sheets further there belong to others.
constexpr double RaggedEdge = -0.4;
constexpr double NoSheets = -1.0;

// A pair of sheets is that of a caustic where the phase between them is within these shares of what the curvature says, and
// their mean phase within so many radians.
constexpr double LeastHalf = 0.5;
constexpr double MostHalf = 1.7;
constexpr double MostShift = 1.0;

constexpr int Iterations = 12;

glm::dvec2 leftOf(const glm::dvec2& v)
{
  return { -v.y, v.x };
}

double between(double a, double b, double u)
{
  return a + u * (b - a);
}

// Cubic of Hermite by its ends and slopes, and its derivative.
template <typename T>
T cubic(const T& a, const T& b, const T& slopeA, const T& slopeB, double u)
{
  const double v = 1.0 - u;
  return v * v * ((1.0 + 2.0 * u) * a + u * slopeA) + u * u * ((3.0 - 2.0 * u) * b - v * slopeB);
}

glm::dvec2 cubicSlope(
  const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& slopeA, const glm::dvec2& slopeB, double u)
{
  const double v = 1.0 - u;
  return 6.0 * u * v * (b - a) + v * (1.0 - 3.0 * u) * slopeA + u * (3.0 * u - 2.0) * slopeB;
}

// Height of a ray at a phase with neither refraction nor what is done about it at caustics.
double heightOfAUnitTube(const SheetRays& rays, std::size_t ray, double phase)
{
  const std::int64_t first = rays.lines.offsets[ray];
  const std::int64_t last = rays.lines.offsets[ray + 1] - 1;
  const double* const begin = rays.lines.phase + first;
  const std::int64_t after =
    std::clamp(first + (std::lower_bound(begin, rays.lines.phase + last + 1, phase) - begin), first, last);
  const std::int64_t before = std::max(first, after - 1);
  const auto value = [&](std::int64_t i) { return rays.height[i] / rays.refraction[i]; };
  const double step = rays.lines.phase[after] - rays.lines.phase[before];
  const double share = step > 0.0 ? std::clamp((phase - rays.lines.phase[before]) / step, 0.0, 1.0) : 1.0;
  return between(value(before), value(after), share);
}

}

FoldStrips::FoldStrips(const RaySheets& sheets, const Execution& execution)
  : Sheets(sheets)
{
  const SheetRays& rays = sheets.rays();
  if (rays.touchedCount == 0 || !rays.refraction)
  {
    return;
  }
  std::vector<std::size_t> sorted(rays.touchedCount);
  for (std::size_t i = 0; i < rays.touchedCount; ++i)
  {
    this->Nodes.push_back(this->nodeOf(rays.touched[i]));
    sorted[i] = i;
  }
  this->fit(this->Nodes, execution);
  const auto key = [&](std::size_t i)
  {
    const auto ray = static_cast<std::size_t>(rays.touched[i].ray);
    return std::make_tuple(
      rays.lines.launchSegment[ray], rays.touched[i].number, rays.lines.launchParameter[ray], rays.touched[i].ray);
  };
  std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  this->join(sorted);
}

FoldStrips::Node FoldStrips::nodeOf(const RayCaustic& caustic) const
{
  Node node;
  const double curvature = caustic.widthRate / caustic.alongRate;
  const double spread = std::cbrt(2.0 / (caustic.fanWavenumber * curvature * curvature));
  node.fold =
    std::isfinite(curvature) && 2.0 * std::abs(caustic.alongChange) * spread < caustic.alongRate * caustic.alongRate;
  if (!node.fold)
  {
    return node;
  }
  node.position = caustic.position;
  node.along = caustic.rayDirection;
  node.normal = -std::copysign(1.0, curvature) * leftOf(caustic.rayDirection);
  node.wavenumber = caustic.wavenumber;
  node.phase = caustic.phase;
  node.number = caustic.number;
  const std::int32_t* reflections = this->Sheets.rays().reflections;
  node.reflections = reflections ? reflections[caustic.ray] : 0;
  node.z1 = std::cbrt(2.0 * caustic.fanWavenumber * caustic.fanWavenumber * std::abs(curvature));
  node.m1 = glm::dot(caustic.wavenumber, node.normal);
  const double tube = heightOfAUnitTube(this->Sheets.rays(), static_cast<std::size_t>(caustic.ray), caustic.phase);
  node.g0 = 2.0 * tube * std::pow(0.5 * caustic.fanWavenumber * curvature * curvature, 1.0 / 6.0) /
    std::sqrt(std::abs(caustic.widthRate) / caustic.scale);
  return node;
}

void FoldStrips::fit(std::vector<Node>& nodes, const Execution& execution) const
{
  std::vector<glm::dvec2> places;
  std::vector<char> wanted;
  for (const Node& node : nodes)
  {
    places.push_back(node.fold ? node.position + Lightest / node.z1 * node.normal : glm::dvec2(0.0));
    wanted.push_back(node.fold ? 1 : 0);
  }
  const std::vector<SheetHit> hits = findSheets(this->Sheets, places, &wanted, execution);
  const double expected = 2.0 / 3.0 * std::pow(Lightest, 1.5);
  for (auto begin = hits.begin(); begin != hits.end();)
  {
    const auto end = std::find_if(begin, hits.end(), [&](const SheetHit& hit) { return hit.place != begin->place; });
    Node& node = nodes[begin->place];
    const double n = Lightest / node.z1;
    double least = MostShift;
    for (auto behind = begin; behind != end; ++behind)
    {
      for (auto before = begin; before != end; ++before)
      {
        const double half = 0.5 * (behind->wave.phase - before->wave.phase);
        const double shift = 0.5 * (behind->wave.phase + before->wave.phase) - node.phase - node.m1 * n;
        const bool fits = behind->wave.reflections == node.reflections &&
          before->wave.reflections == node.reflections && behind->wave.caustics == node.number &&
          before->wave.caustics == node.number - 1 && half > LeastHalf * expected && half < MostHalf * expected &&
          std::abs(shift) < least;
        if (fits)
        {
          least = std::abs(shift);
          const double z = std::cbrt(2.25 * half * half);
          const double root = std::sqrt(std::sqrt(z));
          node.z2 = (z - Lightest) / (n * n);
          node.m2 = shift / (n * n);
          node.g1 = ((before->wave.branch + behind->wave.branch) * root - node.g0) / n;
          node.d0 = (before->wave.branch - behind->wave.branch) / root;
        }
      }
    }
    begin = end;
  }
}

void FoldStrips::join(const std::vector<std::size_t>& sorted)
{
  const SheetRays& rays = this->Sheets.rays();
  // The next ray in launch parameter: a ray between two that does not touch the caustic parts them.
  std::vector<std::size_t> order(rays.lines.rays);
  {
    std::vector<std::size_t> launched;
    for (std::size_t ray = 0; ray < rays.lines.rays; ++ray)
    {
      if (rays.lee[ray] == 0)
      {
        launched.push_back(ray);
      }
    }
    std::sort(launched.begin(), launched.end(),
      [&](std::size_t a, std::size_t b)
      {
        return std::make_tuple(rays.lines.launchSegment[a], rays.lines.launchParameter[a], a) <
          std::make_tuple(rays.lines.launchSegment[b], rays.lines.launchParameter[b], b);
      });
    for (std::size_t i = 0; i < launched.size(); ++i)
    {
      order[launched[i]] = i;
    }
  }
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i)
  {
    const Node& a = this->Nodes[sorted[i]];
    const Node& b = this->Nodes[sorted[i + 1]];
    const auto rayA = static_cast<std::size_t>(rays.touched[sorted[i]].ray);
    const auto rayB = static_cast<std::size_t>(rays.touched[sorted[i + 1]].ray);
    const glm::dvec2 chord = b.position - a.position;
    const double length = glm::length(chord);
    const double way = glm::dot(chord, a.along);
    const bool joined = a.fold && b.fold && a.number == b.number && order[rayA] + 1 == order[rayB] &&
      rays.lines.launchSegment[rayA] == rays.lines.launchSegment[rayB] && glm::dot(a.normal, b.normal) > 0.0 &&
      way * glm::dot(chord, b.along) > 0.0 && std::abs(way) > 0.5 * length;
    if (!joined)
    {
      continue;
    }
    Strip strip;
    strip.a = sorted[i];
    strip.b = sorted[i + 1];
    strip.length = std::copysign(length, way);
    strip.low = 1.2 * Darkest / std::min(a.z1, b.z1);
    strip.high = 1.5 * Lightest / std::min(a.z1, b.z1);
    glm::dvec2 low = a.position;
    glm::dvec2 high = a.position;
    for (const double u : { 0.0, 0.25, 0.5, 0.75, 1.0 })
    {
      for (const double n : { strip.low, 0.0, strip.high })
      {
        low = glm::min(low, this->place(strip, u, n));
        high = glm::max(high, this->place(strip, u, n));
      }
    }
    const glm::dvec2 margin = 0.05 * (high - low);
    strip.box = { low - margin, high + margin };
    this->Strips.push_back(strip);
  }
}

glm::dvec2 FoldStrips::place(const Strip& strip, double u, double n) const
{
  const Node& a = this->Nodes[strip.a];
  const Node& b = this->Nodes[strip.b];
  return cubic(a.position, b.position, strip.length * a.along, strip.length * b.along, u) +
    n * between(1.0, 0.0, u) * a.normal + n * u * b.normal;
}

bool FoldStrips::wave(std::size_t index, const glm::dvec2& place, FoldShare& share) const
{
  const Strip& strip = this->Strips[index];
  if (!strip.box.contains(place))
  {
    return false;
  }
  const Node& a = this->Nodes[strip.a];
  const Node& b = this->Nodes[strip.b];
  // Newton's method in both directions of the strip.
  double u = 0.5;
  double n = 0.0;
  glm::dvec2 miss(0.0);
  for (int i = 0; i < Iterations; ++i)
  {
    miss = place - this->place(strip, u, n);
    const glm::dvec2 slope = cubicSlope(a.position, b.position, strip.length * a.along, strip.length * b.along, u);
    const glm::dvec2 along = slope + n * (b.normal - a.normal);
    const glm::dvec2 across = between(1.0, 0.0, u) * a.normal + u * b.normal;
    const double area = along.x * across.y - along.y * across.x;
    if (!(glm::dot(along, slope) > 0.0) || area == 0.0)
    {
      return false; // beyond the centre of the caustic's curvature
    }
    u = std::clamp(u + (miss.x * across.y - miss.y * across.x) / area, -0.5, 1.5);
    n = std::clamp(n + (along.x * miss.y - along.y * miss.x) / area, strip.low, strip.high);
  }
  if (!(u >= 0.0 && u < 1.0) || glm::length(miss) > 1e-6 * std::abs(strip.length))
  {
    return false;
  }

  const Obstacles* walls = this->Sheets.rays().obstacles;
  if (walls && walls->crosses(this->place(strip, u, 0.0), place))
  {
    return false;
  }

  const double z1 = between(a.z1, b.z1, u);
  const double z2 = between(a.z2, b.z2, u);
  // Towards the dark z must go on falling.
  const double z = n < 0.0 && z2 > 0.0 ? z1 * n / (1.0 - z2 / z1 * n) : z1 * n + z2 * n * n;
  const double over = std::clamp((Lightest - z) / (Lightest - GivingWay), 0.0, 1.0);
  share.weight = over * over * (3.0 - 2.0 * over);
  if (!(z > Darkest) || share.weight == 0.0)
  {
    return false;
  }
  const double into = std::clamp((z - NoSheets) / (RaggedEdge - NoSheets), 0.0, 1.0);
  share.hides = share.weight * into * into * (3.0 - 2.0 * into);
  const double g0 = between(a.g0, b.g0, u);
  FoldField field;
  field.z = z;
  field.sum = std::clamp(g0 + between(a.g1, b.g1, u) * n, 0.0, 2.0 * g0);
  field.difference = between(a.d0, b.d0, u);
  field.middle = cubic(a.phase, b.phase, strip.length * glm::dot(a.wavenumber, a.along),
                   strip.length * glm::dot(b.wavenumber, b.along), u) +
    n * (between(a.m1, b.m1, u) + n * between(a.m2, b.m2, u));
  share.number = a.number;
  share.reflections = a.reflections;
  share.middle = field.middle;
  share.half = z > 0.0 ? 2.0 / 3.0 * z * std::sqrt(z) : 0.0;
  share.wave = std::polar(1.0, -0.5 * Pi * (a.number - 1)) * foldWave(field);
  share.wavenumber = between(1.0, 0.0, u) * a.wavenumber + u * b.wavenumber;
  return true;
}

}
