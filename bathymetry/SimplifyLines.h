#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace swellray
{

/** Poly-lines: points[offsets[i]] to points[offsets[i + 1] - 1] form line i. */
struct LineSet
{
  std::vector<glm::dvec2> points; ///< m
  std::vector<std::size_t> offsets{ 0 };
};

/**
 * Leave out points of lines: every point left out lies within `tolerance` of the line that remains in its place, and
 * lines that did not cross do not cross afterwards. The ends of a line stay; a closed line (first point equal to
 * last) stays closed.
 *
 * Method: Dyken, Daehlen, Sevaldrud 2009, Simultaneous curve simplification, J. Geographical Systems 11, as
 * implemented in CGAL.
 *
 * @param tolerance m, >= 0; 0 leaves the lines as they are
 * @throws std::invalid_argument a tolerance out of range, or offsets that do not fit the points
 */
LineSet simplifyLines(const LineSet& lines, double tolerance);

}
