#pragma once

#include "sim/Seafloor.h"

#include <vector>

namespace swellray
{

/** Convex hull of points, clockwise, without points on its edges (monotone chain, Andrew 1979). */
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points);

/**
 * A convex clockwise polygon with its edges moved inwards, except those that lie on the sides of a rectangle; empty
 * where nothing remains.
 * @param distance m, >= 0
 */
std::vector<glm::dvec2> insetConvex(const std::vector<glm::dvec2>& polygon, double distance, const Rectangle& except);

}
