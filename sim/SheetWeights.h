#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace swellray
{

/**
 * Twice the area to the left of the edge from point a to point b towards a place, never 0: computed the same way for
 * either triangle at the edge, or rounding would count a place twice or not at all.
 * @param positions 3 a point, m
 */
inline double sheetSide(const double* positions, std::int64_t a, std::int64_t b, const glm::dvec2& place)
{
  const std::int64_t low = std::min(a, b);
  const std::int64_t high = std::max(a, b);
  const glm::dvec2 from(positions[3 * low], positions[3 * low + 1]);
  const glm::dvec2 edge = glm::dvec2(positions[3 * high], positions[3 * high + 1]) - from;
  const glm::dvec2 way = place - from;
  const double value = edge.x * way.y - edge.y * way.x;
  const double whole = value == 0.0 ? std::numeric_limits<double>::min() : value;
  return low == a ? whole : -whole;
}

/** Barycentric coordinates of a place in a triangle of a sheet; `inside` false where it is not in it. */
struct SheetWeights
{
  std::array<double, 3> weight{};
  bool inside = false;
  bool anticlockwise = false;

  SheetWeights(const double* positions, const std::array<std::int64_t, 3>& triangle, const glm::dvec2& place)
    : weight{ sheetSide(positions, triangle[1], triangle[2], place),
      sheetSide(positions, triangle[2], triangle[0], place), sheetSide(positions, triangle[0], triangle[1], place) }
    , anticlockwise(weight[0] > 0.0)
  {
    this->inside = (weight[1] > 0.0) == this->anticlockwise && (weight[2] > 0.0) == this->anticlockwise;
    const double area = weight[0] + weight[1] + weight[2];
    for (double& part : this->weight)
    {
      part /= area;
    }
  }
};

}
