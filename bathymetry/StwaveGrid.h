#pragma once

#include "bathymetry/ModelGrid.h"
#include "bathymetry/SwanGrid.h"

namespace swellray
{

/**
 * The grid of an STWAVE run (STWAVE user's manual, ERDC/CHL SR-11-1: namelists spatial_grid_parms and input_files of
 * the .sim file, depths of the .dep file): n_cell_i x n_cell_j cells, x along `azimuth` (degrees anticlockwise from
 * east, towards the shore), from the corner (x0, y0). Depths lie at the cells' centres, positive down; the first row of
 * the file is the last j. `coord_sys` STATEPLANE or UTM with `spzone` gives the CRS (NAD 83; UTM: northern half).
 * @throws std::runtime_error where a setting or values are missing, or the depth is no field of one file
 */
ModelGrid readStwaveGrid(const std::string& sim, const FileText& open);

}
