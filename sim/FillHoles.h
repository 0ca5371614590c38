#pragma once

#include "sim/ElevationGrid.h"

#include <vector>

namespace swellray
{

/**
 * Give every node that is not finite a smooth continuation of the elevations around it.
 *
 * Near the data (8 nodes) the values minimise the bending energy sum (z_xx^2 + 2 z_xy^2 + z_yy^2) of a thin plate,
 * so that value and slope go on across the edge of the hole; further inside they are averages over ever larger
 * neighbourhoods (push-pull: Gortler et al. 1996, The Lumigraph, section 3.4). A plane goes on as a plane.
 *
 * @return one entry a node, 1 where it was filled; empty where nothing was to fill
 * @throws std::invalid_argument where no node is finite
 */
std::vector<unsigned char> fillHoles(ElevationGrid& grid);

}
