#pragma once

#include "bathymetry/ModelGrid.h"

#include <optional>

namespace swellray
{

/**
 * Bring the cells of a curvilinear grid nearer to squares: where a tenth of them are twice as long along one index as
 * along the other, or more, nodes are put between those of the grid along that index, up to 8 times as many, by cubics in the index of place and value (Catmull and Rom
 * 1974; by straight lines beside the rim and nodes without a value). Natural neighbours of cells much longer than wide
 * would make beads of a bar that runs along them. The nodes of the grid stay,
 * and its nominal spacing.
 * @param nodata value, as stored, that stands for no data; those become NaN
 */
void evenCells(ModelGrid& grid, const std::optional<double>& nodata);

}
