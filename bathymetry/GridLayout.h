#pragma once

#include "sim/ElevationGrid.h"

namespace swellray
{

/**
 * Nodes at equal distances in a box, elevations not set.
 * @param centred the nodes lie around the middle of the box; otherwise they begin at its low corner
 * @throws std::runtime_error where fewer than 4 x 4 or more than MostNodes fit
 */
ElevationGrid layOutGrid(const Rectangle& box, const glm::dvec2& spacing, bool centred);

}
