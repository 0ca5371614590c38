#include "sim/RaySheets.h"

#include "sim/RayField.h"
#include "sim/SheetWeights.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace swellray
{

namespace
{

// Fronts are equal phases to the accuracy of the integration, rad.
constexpr double PhaseTolerance = 1e-6;

// Beyond the end of one ray its sheet goes on along the other until this many widths away from that end: enough for
// rays that leave the scene at up to 60 degrees from the normal of its edge.
constexpr double LongestFan = 2.0;

// The same at a wall, up to 80 degrees: what lies behind it is not reached.
constexpr double LongestWallFan = 6.0;

// Widest gaps that are spanned, in insertion thresholds. Refinement between rays on the water stops where tubes are 12
// times as wide as offshore; at the edge of a shadow it goes on.
constexpr double WidestGap = 8.0;
constexpr double WidestShoreGap = 2.0;

// Share of the way to the next point by which a point on a wall is taken to stand off it.
constexpr double OffWall = 1e-3;

// Share of the size of the scene.
constexpr double InwardShare = 1e-7;

}

/** Joins rays to sheets in the order of their phase. */
class SheetWeaver
{
public:
  SheetWeaver(RaySheets& sheets, double maxSpacing)
    : Sheets(sheets)
    , Rays(sheets.Rays)
    , MaxGap(WidestGap * maxSpacing)
    , MaxShoreGap(WidestShoreGap * maxSpacing)
  {
  }

  void weave()
  {
    this->sortRays();
    for (std::size_t order = 0; order < this->Sorted.size(); ++order)
    {
      if (this->isLaunched(this->Sorted[order]))
      {
        this->Standing.insert(this->Standing.end(), order);
      }
    }
    for (auto at = this->Standing.begin(); at != this->Standing.end(); ++at)
    {
      const auto after = std::next(at);
      if (after != this->Standing.end() && this->segment(*at) == this->segment(*after))
      {
        this->Strips[*at] = { true, this->first(*at), this->first(*after) };
      }
    }
    for (const Event& event : this->events())
    {
      if (event.end)
      {
        this->endRay(event.order);
      }
      else
      {
        this->insertRay(event.order);
      }
    }
  }

private:
  // What is woven between a ray and the next one that stands.
  struct Strip
  {
    bool joined = false;
    std::int64_t lower = 0; // points reached: on the ray of the lower launch parameter
    std::int64_t upper = 0; // and on the other, which stands to its left
  };

  struct Event
  {
    double phase = 0.0;
    bool end = false;
    std::size_t ray = 0;
    std::size_t order = 0;
  };

  // By the edge of the scene, or by a wall.
  bool isLaunched(std::size_t ray) const
  {
    const std::int32_t parent = this->Rays.parent[ray];
    return parent < 0 || (this->Rays.reflections && this->Rays.reflections[ray] != this->Rays.reflections[parent]);
  }

  void sortRays()
  {
    const RayLines& lines = this->Rays.lines;
    for (std::size_t ray = 0; ray < lines.rays; ++ray)
    {
      if (lines.offsets[ray + 1] > lines.offsets[ray])
      {
        this->Sorted.push_back(ray);
      }
    }
    std::sort(this->Sorted.begin(), this->Sorted.end(),
      [&](std::size_t a, std::size_t b)
      {
        return std::make_tuple(lines.launchSegment[a], lines.launchParameter[a], a) <
          std::make_tuple(lines.launchSegment[b], lines.launchParameter[b], b);
      });
    this->Strips.resize(this->Sorted.size());
  }

  std::vector<Event> events() const
  {
    std::vector<Event> events;
    for (std::size_t order = 0; order < this->Sorted.size(); ++order)
    {
      const std::size_t ray = this->Sorted[order];
      if (!this->isLaunched(ray))
      {
        events.push_back({ this->phase(this->first(order)), false, ray, order });
      }
      events.push_back({ this->phase(this->last(order)), true, ray, order });
    }
    std::sort(events.begin(), events.end(),
      [](const Event& a, const Event& b)
      { return std::make_tuple(a.phase, a.end, a.ray) < std::make_tuple(b.phase, b.end, b.ray); });
    this->orderFronts(events);
    return events;
  }

  // Within the tolerance of one front rays come in before others end, in the order in which they were inserted.
  static void orderFronts(std::vector<Event>& events)
  {
    for (auto begin = events.begin(); begin != events.end();)
    {
      auto end = begin;
      while (end != events.end() && end->phase <= begin->phase + PhaseTolerance)
      {
        ++end;
      }
      std::sort(begin, end,
        [](const Event& a, const Event& b) { return std::make_tuple(a.end, a.ray) < std::make_tuple(b.end, b.ray); });
      begin = end;
    }
  }

  void insertRay(std::size_t order)
  {
    const auto at = this->Standing.insert(order).first;
    const auto after = std::next(at);
    if (at == this->Standing.begin() || after == this->Standing.end())
    {
      return;
    }
    const std::size_t before = *std::prev(at);
    Strip& strip = this->Strips[before];
    if (!strip.joined)
    {
      return;
    }
    const std::int64_t start = this->first(order);
    this->stitch(before, *after, this->phase(start));
    this->add(strip.lower, start, strip.upper, true);
    this->Strips[order] = { true, start, strip.upper };
    strip.upper = start;
  }

  void endRay(std::size_t order)
  {
    const auto at = this->Standing.find(order);
    const std::int64_t end = this->last(order);
    const auto after = std::next(at);
    Strip& own = this->Strips[order];
    if (own.joined && after != this->Standing.end())
    {
      this->stitch(order, *after, this->phase(end));
      this->fan(own.lower, own.upper, this->last(*after), true);
    }
    own.joined = false;
    if (at != this->Standing.begin())
    {
      const std::size_t before = *std::prev(at);
      Strip& strip = this->Strips[before];
      if (strip.joined)
      {
        this->stitch(before, order, this->phase(end));
        this->fan(strip.upper, strip.lower, this->last(before), false);
      }
      strip.joined = false;
    }
    this->Standing.erase(at);
  }

  // Go on along both rays to this phase, always on the one whose next point comes first.
  void stitch(std::size_t lower, std::size_t upper, double phase)
  {
    Strip& strip = this->Strips[lower];
    const std::int64_t lastLower = this->last(lower);
    const std::int64_t lastUpper = this->last(upper);
    const auto next = [&](std::int64_t point, std::int64_t last)
    {
      const double value = point < last ? this->phase(point + 1) : std::numeric_limits<double>::infinity();
      return value <= phase + PhaseTolerance ? value : std::numeric_limits<double>::infinity();
    };
    for (;;)
    {
      const double a = next(strip.lower, lastLower);
      const double b = next(strip.upper, lastUpper);
      if (std::isinf(a) && std::isinf(b))
      {
        return;
      }
      if (a <= b)
      {
        this->add(strip.lower, strip.lower + 1, strip.upper, true);
        ++strip.lower;
      }
      else
      {
        this->add(strip.lower, strip.upper + 1, strip.upper, false);
        ++strip.upper;
      }
    }
  }

  // Between the end of a ray and the way on of its neighbour.
  void fan(std::int64_t end, std::int64_t along, std::int64_t last, bool endIsLower)
  {
    if (this->aground(end))
    {
      return;
    }
    const bool onWall = this->Rays.obstacles && this->Sheets.besideWall(end) != end;
    const double reach = (onWall ? LongestWallFan : LongestFan) * this->distance(end, along);
    while (along < last && this->distance(end, along + 1) <= reach)
    {
      if (endIsLower)
      {
        this->add(end, along + 1, along, false);
      }
      else
      {
        this->add(along, along + 1, end, true);
      }
      ++along;
    }
  }

  // Corners anticlockwise where the tube has not turned over; `ahead` is the next point on one of the two rays.
  void add(std::int64_t lower, std::int64_t ahead, std::int64_t upper, bool aheadIsLower)
  {
    if (this->aground(lower) && this->aground(ahead) && this->aground(upper))
    {
      return;
    }
    const bool shore = this->atShore(lower) || this->atShore(ahead) || this->atShore(upper);
    const double gap = shore ? this->MaxShoreGap : this->MaxGap;
    const double width = std::min(this->distance(lower, upper), this->distance(ahead, aheadIsLower ? upper : lower));
    if (gap > 0.0 && width > gap)
    {
      return;
    }
    if (this->Rays.obstacles && (this->parts(lower, upper) || this->parts(ahead, aheadIsLower ? upper : lower)))
    {
      return;
    }
    this->Sheets.Triangles.push_back({ lower, ahead, upper });
  }

  // True where a wall stands between points of two rays. A point on a wall is on the side from which its ray comes.
  bool parts(std::int64_t a, std::int64_t b) const
  {
    const std::int64_t besideA = this->Sheets.besideWall(a);
    const std::int64_t besideB = this->Sheets.besideWall(b);
    if (besideA != a && besideB != b)
    {
      return false;
    }
    const auto off = [&](std::int64_t point, std::int64_t beside)
    { return glm::mix(this->Sheets.position(point), this->Sheets.position(beside), OffWall); };
    return this->Rays.obstacles->crosses(off(a, besideA), off(b, besideB));
  }

  bool atShore(std::int64_t point) const
  {
    return this->aground(point) || this->Sheets.LeePoint[static_cast<std::size_t>(point)] != 0;
  }

  bool aground(std::int64_t point) const
  {
    return this->Rays.state[point] == static_cast<std::uint8_t>(RayState::Aground);
  }

  double distance(std::int64_t a, std::int64_t b) const { return trueDistance(this->Rays.lines, a, b); }

  double phase(std::int64_t point) const { return this->Rays.lines.phase[point]; }
  std::int64_t first(std::size_t order) const { return this->Rays.lines.offsets[this->Sorted[order]]; }
  std::int64_t last(std::size_t order) const { return this->Rays.lines.offsets[this->Sorted[order] + 1] - 1; }
  std::int32_t segment(std::size_t order) const { return this->Rays.lines.launchSegment[this->Sorted[order]]; }

  RaySheets& Sheets;
  const SheetRays& Rays;
  double MaxGap;
  double MaxShoreGap;
  std::vector<std::size_t> Sorted; // rays in the order of the launch line
  std::set<std::size_t> Standing;  // those on their way, by their place in that order
  std::vector<Strip> Strips;       // one a place in that order
};

RaySheets::RaySheets(const SheetRays& rays, double maxSpacing)
  : Rays(rays)
{
  const RayLines& lines = rays.lines;
  const std::int64_t points = lines.rays > 0 ? lines.offsets[lines.rays] : 0;
  this->LeePoint.resize(static_cast<std::size_t>(points), 0);
  this->Reflections.resize(rays.reflections ? static_cast<std::size_t>(points) : 0, 0);
  this->Beside.resize(rays.obstacles ? static_cast<std::size_t>(points) : 0, 0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  glm::dvec2 low(infinity);
  glm::dvec2 high(-infinity);
  for (std::size_t ray = 0; ray < lines.rays; ++ray)
  {
    for (std::int64_t i = lines.offsets[ray]; i < lines.offsets[ray + 1]; ++i)
    {
      const glm::dvec2 place = this->position(i);
      if (!std::isfinite(place.x + place.y + lines.phase[i] + rays.wavenumber[i] + rays.direction[3 * i] +
            rays.direction[3 * i + 1]))
      {
        std::ostringstream message;
        message << "ray " << ray << ": its point " << i - lines.offsets[ray]
                << " has no finite position, phase and wavenumber; trace the rays again";
        throw std::runtime_error(message.str());
      }
      low = glm::min(low, place);
      high = glm::max(high, place);
      this->LeePoint[static_cast<std::size_t>(i)] = rays.lee[ray];
      if (rays.reflections)
      {
        this->Reflections[static_cast<std::size_t>(i)] = rays.reflections[ray];
      }
    }
    if (rays.obstacles && lines.offsets[ray + 1] > lines.offsets[ray] + 1)
    {
      const bool stopped = rays.endReason[ray] == static_cast<std::uint8_t>(EndReason::StoppedByObstacle);
      const std::int32_t parent = rays.parent[ray];
      const bool begins = parent >= 0 && rays.reflections && rays.reflections[ray] != rays.reflections[parent];
      this->Beside[static_cast<std::size_t>(lines.offsets[ray])] = begins ? 1 : 0;
      this->Beside[static_cast<std::size_t>(lines.offsets[ray + 1] - 1)] = stopped ? -1 : 0;
    }
  }
  if (points > 0)
  {
    this->Bounds = { low, high };
  }
  SheetWeaver(*this, maxSpacing).weave();
}

glm::dvec2 RaySheets::position(std::int64_t point) const
{
  const double* place = this->Rays.lines.positions + 3 * point;
  return { place[0], place[1] };
}

std::int64_t RaySheets::besideWall(std::int64_t point) const
{
  return point + this->Beside[static_cast<std::size_t>(point)];
}

glm::dvec2 RaySheets::inwards(const glm::dvec2& place) const
{
  const glm::dvec2 middle = 0.5 * (this->Bounds.low + this->Bounds.high);
  const double step = InwardShare * glm::length(this->Bounds.size());
  // No two the same, so that no place is moved along an edge of a regular mesh.
  return { place.x + (place.x < middle.x ? step : -step), place.y + (place.y < middle.y ? 0.7 * step : -0.7 * step) };
}

Rectangle RaySheets::box(const Triangle& triangle) const
{
  const glm::dvec2 a = this->position(triangle[0]);
  const glm::dvec2 b = this->position(triangle[1]);
  const glm::dvec2 c = this->position(triangle[2]);
  return { glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)) };
}

bool RaySheets::wave(const Triangle& triangle, const glm::dvec2& place, WaveSheet& wave) const
{
  const SheetWeights weights(this->Rays.lines.positions, triangle, place);
  if (!weights.inside)
  {
    return false;
  }
  const std::array<double, 3>& weight = weights.weight;
  wave = WaveSheet();
  double inverseSquare = 0.0;
  double width = 0.0;
  double lossless = 0.0; // height without refraction
  std::size_t heaviest = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    heaviest = weight[i] > weight[heaviest] ? i : heaviest;
    const std::int64_t point = triangle[i];
    const double* direction = this->Rays.direction + 3 * point;
    const glm::dvec2 k = this->Rays.wavenumber[point] * glm::dvec2(direction[0], direction[1]);
    wave.wavenumber += weight[i] * k;
    const double scale = this->Rays.lines.scale ? this->Rays.lines.scale[point] : 1.0;
    wave.phase +=
      weight[i] * (this->Rays.lines.phase[point] + 0.5 * glm::dot(k, place - this->position(point)) / scale);
    wave.height += weight[i] * this->Rays.height[point];
    if (this->Rays.refraction && this->Rays.tubeWidth)
    {
      width += weight[i] * this->Rays.tubeWidth[point];
      lossless += weight[i] * this->Rays.height[point] / this->Rays.refraction[point];
    }
    inverseSquare += weight[i] / (this->Rays.height[point] * this->Rays.height[point]);
    wave.lee = wave.lee || this->LeePoint[static_cast<std::size_t>(point)];
  }
  if (std::isinf(wave.height))
  {
    wave.height = 1.0 / std::sqrt(inverseSquare);
  }
  const double branch = lossless / std::sqrt(std::abs(width));
  wave.branch = lossless > 0.0 && std::isfinite(branch) ? branch : wave.height;
  wave.broken = this->Rays.breaking[triangle[heaviest]] != 0;
  wave.caustics = this->Rays.caustics[triangle[heaviest]];
  // The launch parameter grows to the left of the rays: a tube that has not turned over is anticlockwise.
  wave.reflections = this->Reflections.empty() ? 0 : this->Reflections[static_cast<std::size_t>(triangle[0])];
  const int parity = (weights.anticlockwise ? 0 : 1) ^ (wave.reflections % 2);
  for (std::size_t i = 0; i < 3 && wave.caustics % 2 != parity; ++i)
  {
    wave.caustics = this->Rays.caustics[triangle[i]] % 2 == parity ? this->Rays.caustics[triangle[i]] : wave.caustics;
  }
  return true;
}

}
