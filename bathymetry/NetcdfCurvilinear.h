#pragma once

#include "bathymetry/ModelGrid.h"

#include <optional>
#include <string>

namespace swellray
{

/**
 * Values on a curvilinear grid in a NetCDF file (CF 1.8, section 5.2): a variable along two dimensions, whose places are
 * two coordinate variables along the same two, longitude and latitude or x and y. They are those that its attribute
 * `coordinates` names, or the only ones along these dimensions. Longitudes that jump by a turn count on. A node
 * whose place is missing is none.
 *
 * A variable that also has a coordinate variable along each of its dimensions, one of x and one of y, lies on a regular
 * grid and is left to openRaster(); a count of the columns and rows is no such coordinate.
 *
 * @param variable of the values; empty: the only one, or the only one whose standard name is that of a seafloor
 * @return nothing where the file is no NetCDF file or holds no such grid
 * @throws std::runtime_error where it holds one that cannot be understood
 */
std::optional<ModelGrid> readNetcdfCurvilinear(const std::string& path, const std::string& variable);

}
