#include "sim/Obstacles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

// Ends of ways nearer to a wall than this lie on it, m: hits are found far closer, and no wave is that short.
constexpr double Touching = 1e-6;

// A segment is met this share of its length beyond its ends, so that no path slips between two of them.
constexpr double EndOverlap = 1e-9;

// A wall that turns by more than this at a point (sine, 20 degrees) has a corner there; by less it is a curve.
constexpr double CornerSine = 0.35;

constexpr std::uint32_t LeafSize = 4;

// Halving four thousand million segments takes 32 levels.
constexpr std::size_t DeepestStack = 64;

constexpr int BisectionSteps = 100;

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

bool overlap(const Rectangle& a, const Rectangle& b)
{
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

using Quartic = std::array<double, 5>;

double valueAt(const double* c, int degree, double x)
{
  double value = c[degree];
  for (int i = degree - 1; i >= 0; --i)
  {
    value = value * x + c[i];
  }
  return value;
}

// Roots with a change of sign in [low, high], ascending: between the extremes, which are the roots of the derivative,
// a polynomial is monotone.
int rootsOf(const double* c, int degree, double low, double high, double* roots)
{
  double ends[6] = { low };
  int intervals = 1;
  if (degree > 1)
  {
    double derivative[4];
    for (int i = 1; i <= degree; ++i)
    {
      derivative[i - 1] = i * c[i];
    }
    intervals += rootsOf(derivative, degree - 1, low, high, ends + 1);
  }
  ends[intervals] = high;
  int count = 0;
  for (int i = 0; i < intervals; ++i)
  {
    double a = ends[i];
    double b = ends[i + 1];
    const bool positive = valueAt(c, degree, a) > 0.0;
    if ((valueAt(c, degree, b) > 0.0) == positive)
    {
      continue;
    }
    for (int step = 0; step < BisectionSteps; ++step)
    {
      const double middle = 0.5 * (a + b);
      if (!(middle > a && middle < b))
      {
        break;
      }
      ((valueAt(c, degree, middle) > 0.0) == positive ? a : b) = middle;
    }
    roots[count++] = b;
  }
  return count;
}

// Control points of the same curve: it lies in their convex hull.
template <typename Value>
std::array<Value, 5> bernstein(const std::array<Value, 5>& c)
{
  return { c[0], c[0] + c[1] / 4.0, c[0] + c[1] / 2.0 + c[2] / 6.0, c[0] + c[1] * 0.75 + c[2] / 2.0 + c[3] / 4.0,
    c[0] + c[1] + c[2] + c[3] + c[4] };
}

glm::dvec2 positionAt(const PathPiece& path, double theta)
{
  const std::array<glm::dvec2, 5>& c = path.coefficients;
  return c[0] + theta * (c[1] + theta * (c[2] + theta * (c[3] + theta * c[4])));
}

void check(const Obstacle& obstacle, std::size_t index)
{
  std::ostringstream message;
  message << "obstacle " << index << ": ";
  const std::size_t least = obstacle.closed ? 3 : 2;
  if (obstacle.points.size() < least)
  {
    message << obstacle.points.size() << " points; " << (obstacle.closed ? "a ring" : "a line") << " has at least "
            << least;
    throw std::invalid_argument(message.str());
  }
  if (!(obstacle.reflection >= 0.0 && obstacle.reflection <= 1.0))
  {
    message << "the reflection coefficient must be 0 to 1, not " << obstacle.reflection;
    throw std::invalid_argument(message.str());
  }
  if (!(obstacle.slope >= 0.0 && std::isfinite(obstacle.slope)))
  {
    message << "the slope of its faces must be 0 (vertical) or above, not " << obstacle.slope;
    throw std::invalid_argument(message.str());
  }
  for (const glm::dvec2& point : obstacle.points)
  {
    if (!std::isfinite(point.x + point.y))
    {
      message << "a corner has no finite coordinates";
      throw std::invalid_argument(message.str());
    }
  }
}

}

Obstacles::Obstacles(const std::vector<Obstacle>& obstacles)
{
  for (std::size_t i = 0; i < obstacles.size(); ++i)
  {
    check(obstacles[i], i);
    this->addSegments(obstacles[i], i);
    this->AnyReflects = this->AnyReflects || obstacles[i].reflection > 0.0;
  }
  if (!this->Segments.empty())
  {
    this->build(0, static_cast<std::uint32_t>(this->Segments.size()));
  }
}

void Obstacles::addSegments(const Obstacle& obstacle, std::size_t index)
{
  std::vector<glm::dvec2> points;
  for (const glm::dvec2& point : obstacle.points)
  {
    if (points.empty() || glm::distance(points.back(), point) > Touching)
    {
      points.push_back(point);
    }
  }
  if (obstacle.closed && points.size() > 1 && glm::distance(points.back(), points.front()) <= Touching)
  {
    points.pop_back();
  }
  const std::size_t count = points.size();
  const std::size_t sides = obstacle.closed ? count : count - 1;
  if (count < (obstacle.closed ? 3U : 2U))
  {
    return;
  }
  const auto turns = [&](std::size_t corner)
  {
    if (!obstacle.closed && (corner == 0 || corner + 1 == count))
    {
      return true;
    }
    const glm::dvec2 before = glm::normalize(points[corner] - points[(corner + count - 1) % count]);
    const glm::dvec2 after = glm::normalize(points[(corner + 1) % count] - points[corner]);
    return std::abs(cross(before, after)) > CornerSine || glm::dot(before, after) < 0.0;
  };
  for (std::size_t i = 0; i < sides; ++i)
  {
    const std::size_t next = (i + 1) % count;
    this->Segments.push_back(
      { points[i], points[next], index, obstacle.reflection, obstacle.slope, obstacle.closed, turns(i), turns(next) });
  }
}

void Obstacles::build(std::uint32_t first, std::uint32_t count)
{
  const std::size_t node = this->Nodes.size();
  this->Nodes.emplace_back();
  const auto begin = this->Segments.begin() + first;
  Rectangle box{ glm::min(begin->from, begin->to), glm::max(begin->from, begin->to) };
  Rectangle middles{ 0.5 * (begin->from + begin->to), 0.5 * (begin->from + begin->to) };
  for (auto segment = begin; segment != begin + count; ++segment)
  {
    box.low = glm::min(box.low, glm::min(segment->from, segment->to));
    box.high = glm::max(box.high, glm::max(segment->from, segment->to));
    const glm::dvec2 middle = 0.5 * (segment->from + segment->to);
    middles.low = glm::min(middles.low, middle);
    middles.high = glm::max(middles.high, middle);
  }
  this->Nodes[node].box = { box.low - Touching, box.high + Touching };
  this->Nodes[node].first = first;
  if (count <= LeafSize)
  {
    this->Nodes[node].count = count;
    return;
  }
  const int axis = middles.size().x >= middles.size().y ? 0 : 1;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count,
    [axis](const Segment& a, const Segment& b) { return a.from[axis] + a.to[axis] < b.from[axis] + b.to[axis]; });
  this->build(first, half);
  this->Nodes[node].second = static_cast<std::uint32_t>(this->Nodes.size());
  this->build(first + half, count - half);
}

template <typename Overlaps, typename Visit>
void Obstacles::visit(const Overlaps& overlaps, const Visit& visitSegment) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  std::array<std::uint32_t, DeepestStack> waiting;
  std::size_t depth = 0;
  waiting[depth++] = 0;
  while (depth > 0)
  {
    const std::uint32_t at = waiting[--depth];
    const Node& node = this->Nodes[at];
    if (!overlaps(node.box))
    {
      continue;
    }
    if (node.count == 0)
    {
      waiting[depth++] = node.second;
      waiting[depth++] = at + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
    {
      visitSegment(i);
    }
  }
}

std::optional<WallHit> Obstacles::firstHit(
  const PathPiece& path, double until, std::optional<std::size_t> leaving, double leavingSide) const
{
  const std::array<glm::dvec2, 5> hull = bernstein(path.coefficients);
  Rectangle box{ hull[0], hull[0] };
  for (const glm::dvec2& point : hull)
  {
    box.low = glm::min(box.low, point);
    box.high = glm::max(box.high, point);
  }
  std::optional<WallHit> first;
  double last = until;
  this->visit([&](const Rectangle& node) { return overlap(node, box); },
    [&](std::uint32_t index)
    {
      const Segment& segment = this->Segments[index];
      const glm::dvec2 along = segment.to - segment.from;
      const double length = glm::length(along);
      const glm::dvec2 normal = glm::dvec2(-along.y, along.x) / length;
      Quartic distance;
      distance[0] = glm::dot(normal, path.coefficients[0] - segment.from);
      for (std::size_t i = 1; i < distance.size(); ++i)
      {
        distance[i] = glm::dot(normal, path.coefficients[i]);
      }
      const Quartic bounds = bernstein(distance);
      const auto [least, most] = std::minmax_element(bounds.begin(), bounds.end());
      if (*least > 0.0 || *most < 0.0)
      {
        return;
      }
      double roots[4];
      const int count = rootsOf(distance.data(), 4, 0.0, last, roots);
      for (int i = 0; i < count; ++i)
      {
        const double share = glm::dot(positionAt(path, roots[i]) - segment.from, along) / (length * length);
        if (share < -EndOverlap || share > 1.0 + EndOverlap)
        {
          continue;
        }
        // Which side it comes from is told by where it goes: at the root itself the distance is rounding.
        const double rate =
          distance[1] + roots[i] * (2.0 * distance[2] + roots[i] * (3.0 * distance[3] + roots[i] * 4.0 * distance[4]));
        const double side = rate < 0.0 ? 1.0 : -1.0;
        if (leaving == index && side != leavingSide)
        {
          continue;
        }
        if (!first || roots[i] < first->theta || (roots[i] == first->theta && index < first->wall))
        {
          last = roots[i];
          const bool corner =
            (share < EndOverlap && segment.cornerFrom) || (share > 1.0 - EndOverlap && segment.cornerTo);
          first = WallHit{ roots[i], index, side, side * normal, segment.reflection, segment.slope, segment.obstacle,
            corner };
        }
        break;
      }
    });
  return first;
}

bool Obstacles::crosses(const glm::dvec2& a, const glm::dvec2& b) const
{
  const Rectangle box{ glm::min(a, b), glm::max(a, b) };
  bool crossed = false;
  this->visit([&](const Rectangle& node) { return !crossed && overlap(node, box); },
    [&](std::uint32_t index)
    {
      const Segment& segment = this->Segments[index];
      const glm::dvec2 along = segment.to - segment.from;
      const double length = glm::length(along);
      const double fromA = cross(along, a - segment.from) / length;
      const double fromB = cross(along, b - segment.from) / length;
      if (std::min(fromA, fromB) > -Touching || std::max(fromA, fromB) < Touching)
      {
        return;
      }
      const glm::dvec2 at = a + (b - a) * (fromA / (fromA - fromB));
      const double share = glm::dot(at - segment.from, along) / (length * length);
      crossed = crossed || (share >= -EndOverlap && share <= 1.0 + EndOverlap);
    });
  return crossed;
}

bool Obstacles::inside(const glm::dvec2& p) const
{
  int winding = 0;
  this->visit([&](const Rectangle& node) { return node.low.y <= p.y && p.y <= node.high.y && p.x <= node.high.x; },
    [&](std::uint32_t index)
    {
      const Segment& segment = this->Segments[index];
      const bool up = segment.from.y <= p.y;
      if (!segment.closed || up == (segment.to.y <= p.y))
      {
        return;
      }
      const double left = cross(segment.to - segment.from, p - segment.from);
      winding += up ? (left > 0.0 ? 1 : 0) : (left < 0.0 ? -1 : 0);
    });
  return winding != 0;
}

}
