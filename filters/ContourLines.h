#ifndef ContourLines_h
#define ContourLines_h

#include "bathymetry/SimplifyLines.h"
#include "sim/ElevationGrid.h"

namespace swellray
{

/**
 * Add the lines of one elevation over a grid of at least 2 x 2 nodes, by marching squares; higher ground on their left.
 * A closed line ends with its first point. Cells that touch a node without elevation (NaN) are left out.
 */
void addContourLines(const ElevationGrid& grid, double elevation, LineSet& lines);

}

#endif
