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
  simplification::simplify(triangulation, simplification::Squared_distance_cost(),
    simplification::Stop_above_cost_threshold(tolerance * tolerance));

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
