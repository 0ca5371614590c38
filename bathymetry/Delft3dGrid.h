#pragma once

#include "bathymetry/ModelGrid.h"

#include <string>

namespace swellray
{

/** True for the text of a Delft3D grid file (RGFGRID): it has lines ETA= after its header. */
bool isDelft3dGrid(const std::string& text);

/**
 * A curvilinear grid of Delft3D (Delft3D-FLOW user manual, appendix A: .grd and .dep files) and the depths at its
 * corners, positive down. Nodes at the grid's missing value, and depths of -999, are none; the .dep file has one row
 * and one column more than the grid, or as many. `Coordinate System = Spherical` means longitude and latitude.
 * @throws std::runtime_error where they do not fit each other or values are missing
 */
ModelGrid readDelft3dGrid(const std::string& grd, const std::string& dep);

}
