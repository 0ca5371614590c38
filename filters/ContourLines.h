#ifndef ContourLines_h
#define ContourLines_h

#include "bathymetry/SimplifyLines.h"
#include "sim/ElevationGrid.h"

namespace swellray
{

/**
 * Add the lines of one elevation over a grid of at least 2 x 2 nodes, by marching squares; higher ground on their left.
 * A closed line ends with its first point. Cells that touch a node without elevation (NaN) are left out.
 * @param relief m, >= 0: ground that departs less than this from the elevation gets no line of its own (sidesOfLevel())
 */
void addContourLines(const ElevationGrid& grid, double elevation, double relief, LineSet& lines);

}

#endif
