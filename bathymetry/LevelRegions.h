#pragma once

#include "sim/ElevationGrid.h"

#include <cstdint>
#include <vector>

namespace swellray
{

/**
 * On which side of a level each node of a grid lies: 1 at or above it, 0 below it or without data. Where connected
 * nodes of one side (4 neighbours) nowhere depart from the level by `relief` they are noise, such as a flat that is stored
 * as just this level and rings where it was resampled: with all noise that they touch they count as what is above, where
 * that comes up to them anywhere, otherwise as what is below. So the line between the two sides runs along the edge of
 * a flat in deeper water, or not at all; where it runs it is the same as without.
 *
 * @param relief m, >= 0; 0: the plain comparison
 */
std::vector<std::uint8_t> sidesOfLevel(const ElevationGrid& grid, double level, double relief);

}
