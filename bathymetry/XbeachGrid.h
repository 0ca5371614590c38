#pragma once

#include "bathymetry/ModelGrid.h"
#include "bathymetry/SwanGrid.h"

namespace swellray
{

/**
 * The grid of an XBeach run, from its params.txt (XBeach manual, grid and bathymetry): gridform xbeach with equal steps
 * (vardx = 0: nx, ny, dx, dy) or places from xfile and yfile (vardx = 1), turned by alfa (degrees anticlockwise from
 * east) and moved by xori, yori; or gridform delft3d with xyfile. Values of depfile are depths unless posdwn is 0 or
 * less; posdwn is 1 where it is not set.
 * @throws std::runtime_error where a setting, a file or values are missing
 */
ModelGrid readXbeachGrid(const std::string& params, const FileText& open);

}
