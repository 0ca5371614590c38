#include "sim/ConvexOutline.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace swellray
{

namespace
{

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

bool liesOnSide(const glm::dvec2& a, const glm::dvec2& b, const Rectangle& box)
{
  const auto both = [](double p, double q, double side) { return p == side && q == side; };
  return both(a.x, b.x, box.low.x) || both(a.x, b.x, box.high.x) || both(a.y, b.y, box.low.y) ||
    both(a.y, b.y, box.high.y);
}

// The part of the polygon to the right of the line through `point` along `direction`.
std::vector<glm::dvec2> clip(
  const std::vector<glm::dvec2>& polygon, const glm::dvec2& point, const glm::dvec2& direction)
{
  std::vector<glm::dvec2> result;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec2& a = polygon[i];
    const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
    const double da = -cross(direction, a - point);
    const double db = -cross(direction, b - point);
    if (da >= 0.0)
    {
      result.push_back(a);
    }
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0))
    {
      result.push_back(a + (b - a) * (da / (da - db)));
    }
  }
  return result;
}

}

std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points)
{
  const auto before = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
  {
    return points;
  }
  // The upper chain from west to east, then the lower one back: clockwise.
  std::vector<glm::dvec2> hull;
  const auto add = [&hull](const glm::dvec2& p, std::size_t fixed)
  {
    while (hull.size() > fixed && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) >= 0.0)
    {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const glm::dvec2& p : points)
  {
    add(p, 1);
  }
  const std::size_t upper = hull.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p)
  {
    add(*p, upper);
  }
  hull.pop_back();
  return hull;
}

std::vector<glm::dvec2> insetConvex(const std::vector<glm::dvec2>& polygon, double distance, const Rectangle& except)
{
  std::vector<glm::dvec2> result = polygon;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec2& a = polygon[i];
    const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
    if (liesOnSide(a, b, except))
    {
      continue;
    }
    const glm::dvec2 along = glm::normalize(b - a);
    result = clip(result, a + distance * glm::dvec2(along.y, -along.x), along);
  }
  return result;
}

}
