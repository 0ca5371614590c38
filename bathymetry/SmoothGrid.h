#pragma once

#include "sim/ElevationGrid.h"
#include "sim/Execution.h"

namespace swellray
{

/**
 * Smooth a grid by a Gaussian, along the rows, then along the columns, cut off at 4 standard deviations.
 *
 * A node takes part in an average only together with its mirror image about the centre, where both lie on the grid
 * and have a value: so planes stay planes, also beside edges and holes, where the smoothing fades. Nodes without a
 * value (NaN) keep none.
 *
 * @param sigma standard deviation, m, >= 0
 */
void smoothGrid(ElevationGrid& grid, double sigma, const Execution& execution = {});

}
