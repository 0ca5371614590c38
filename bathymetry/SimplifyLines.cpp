#include "bathymetry/SimplifyLines.h"

#include "bathymetry/Text.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyline_simplification_2/Squared_distance_cost.h>
#include <CGAL/Polyline_simplification_2/Stop_above_cost_threshold.h>
#include <CGAL/Polyline_simplification_2/simplify.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace swellray
{

namespace
{

namespace simplification = CGAL::Polyline_simplification_2;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = simplification::Vertex_base_2<Kernel>;
using Face = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<Delaunay>;

// Share of the tolerance's square by which equal costs are told apart.
constexpr double TieShare = 1e-9;

// Between 0 and 1, scattered by the bits of a number (the finaliser of splitmix64, Steele, Lea and Flood 2014).
double scatter(double x, double y)
{
  std::uint64_t bits[2];
  std::memcpy(&bits[0], &x, sizeof x);
  std::memcpy(&bits[1], &y, sizeof y);
  std::uint64_t z = bits[0] ^ (bits[1] * 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) / 9007199254740992.0;
}

/**
 * Squared distance, a hair more by the place of the point: CGAL takes points of equal cost in the order of their
 * addresses, which no two runs have alike.
 */
class DistinctCost
{
public:
  explicit DistinctCost(double tolerance)
    : Hair(TieShare * tolerance * tolerance)
  {
  }

  template <typename Constraints, typename Place>
  auto operator()(const Constraints& constraints, Place place) const
  {
    auto cost = this->Distance(constraints, place);
    if (cost)
    {
      *cost += this->Hair * scatter((*place)->point().x(), (*place)->point().y());
    }
    return cost;
  }

private:
  simplification::Squared_distance_cost Distance;
  double Hair;
};

void check(const LineSet& lines, double tolerance)
{
  if (!(tolerance >= 0.0 && std::isfinite(tolerance)))
  {
    throw std::invalid_argument("simplify must be 0 m or more, not " + text(tolerance));
  }
  if (lines.offsets.empty() || lines.offsets.front() != 0 || lines.offsets.back() != lines.points.size() ||
    !std::is_sorted(lines.offsets.begin(), lines.offsets.end()))
  {
    throw std::invalid_argument(
      "the offsets of the lines do not fit their " + std::to_string(lines.points.size()) + " points");
  }
}

}

LineSet simplifyLines(const LineSet& lines, double tolerance)
{
  check(lines, tolerance);
  if (tolerance == 0.0)
  {
    return lines;
  }
  const std::size_t count = lines.offsets.size() - 1;
  Triangulation triangulation;
  std::vector<Triangulation::Constraint_id> ids(count);
  std::vector<bool> inserted(count, false);
  std::vector<Kernel::Point_2> points;
  for (std::size_t line = 0; line < count; ++line)
  {
    points.clear();
    for (std::size_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i)
    {
      const Kernel::Point_2 point(lines.points[i].x, lines.points[i].y);
      if (points.empty() || points.back() != point)
      {
        points.push_back(point);
      }
    }
    if (points.size() > 2)
    {
      ids[line] = triangulation.insert_constraint(points.begin(), points.end());
      inserted[line] = true;
    }
  }
  simplification::simplify(
    triangulation, DistinctCost(tolerance), simplification::Stop_above_cost_threshold(tolerance * tolerance));

  LineSet result;
  for (std::size_t line = 0; line < count; ++line)
  {
    if (inserted[line])
    {
      for (auto v = triangulation.vertices_in_constraint_begin(ids[line]);
           v != triangulation.vertices_in_constraint_end(ids[line]); ++v)
      {
        result.points.emplace_back((*v)->point().x(), (*v)->point().y());
      }
    }
    else
    {
      result.points.insert(result.points.end(), lines.points.begin() + static_cast<std::ptrdiff_t>(lines.offsets[line]),
        lines.points.begin() + static_cast<std::ptrdiff_t>(lines.offsets[line + 1]));
    }
    result.offsets.push_back(result.points.size());
  }
  return result;
}

}
