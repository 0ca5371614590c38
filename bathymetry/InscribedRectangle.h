#pragma once

#include "sim/Seafloor.h"

#include <vector>

namespace swellray
{

/**
 * The axis-aligned rectangle of largest area in a polygon (largest among those whose left and right sides lie at
 * vertices' x). It never reaches out of the polygon.
 *
 * @param outline vertices, m, in either sense, not closed, at least 3; every line along y meets the polygon in one
 *   stretch
 * @return a rectangle of size 0 where none fits
 */
Rectangle inscribedRectangle(const std::vector<glm::dvec2>& outline);

}
