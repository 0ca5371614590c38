#pragma once

#include "bathymetry/FileGrid.h"
#include "bathymetry/RasterSource.h"
#include "bathymetry/SeafloorOptions.h"
#include "bathymetry/VerticalMeaning.h"
#include "sim/Execution.h"

#include <string>
#include <vector>

namespace swellray
{

/**
 * Elevations of the part of a raster that is asked for, in metres, positive up. Where `resample` is at least twice the
 * size of a cell, cells are averaged over as many as fit, from the coarsest of the raster's overviews that is fine
 * enough, in strips: a raster of any size takes the memory of the result.
 *
 * @param source switched to the overview that is used
 * @param notes told what was averaged
 * @throws std::runtime_error no data, an elevation that no place on Earth has, or what reading throws
 */
FileGrid readElevations(RasterSource& source, const SeafloorOptions& options, const VerticalMeaning& meaning,
  std::vector<std::string>& notes, const Execution& execution);

/** Root mean square of the slopes between neighbours, metres a unit of the file. */
double rmsSlope(const FileGrid& file);

}
