#pragma once

#include "sim/ElevationGrid.h"

#include <vector>

namespace swellray
{

/**
 * Give every node that is not finite a smooth continuation of the elevations around it.
 *
 * From coarse grids of averages to the fine one (push-pull: Gortler et al. 1996, The Lumigraph, section 3.4) the
 * values near the data (8 nodes) are relaxed towards a thin plate, the least sum of squared second differences, and on
 * the grid itself at last towards the least third differences, so that the curvature goes on too, as in the C2
 * spline laid through them. A plane goes on as a plane.
 *
 * @return one entry a node, 1 where it was filled; empty where nothing was to fill
 * @throws std::invalid_argument where no node is finite
 */
std::vector<unsigned char> fillHoles(ElevationGrid& grid);

}
