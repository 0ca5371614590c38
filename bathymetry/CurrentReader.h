#pragma once

#include "bathymetry/Georeference.h"
#include "sim/ElevationGrid.h"
#include "sim/Execution.h"

#include <string>
#include <vector>

namespace swellray
{

/** A current read from a file, in the metres of a scene. */
struct CurrentGrids
{
  ElevationGrid u; ///< along x, m/s, in the place of elevations; NaN: no data
  ElevationGrid v; ///< along y, on the same nodes
  std::vector<std::string> notes;
};

/**
 * Read a current from a raster that GDAL opens: two variables or bands, known by their CF standard names
 * (eastward_ and northward_sea_water_velocity, or sea_water_x_ and _y_velocity), by their names (u and v, uo and vo,
 * water_u and water_v, ubar and vbar), or bands 1 and 2; m/s unless their unit is cm/s or knots.
 *
 * A file in the plane of the scene (the same CRS, or none) keeps its nodes, components along its axes. One in another CRS is
 * brought to the scene's metres over `bounds` by its own C2 spline, about as finely as it is; its components, along its axes
 * (in longitude and latitude towards east and true north), are turned by the meridian convergence between the two.
 *
 * @param bounds the scene, m
 * @throws std::runtime_error a file that cannot be read or understood, or that is in another CRS, or in one where the scene has
 *   none, and does not cover the scene; the message names the file
 */
CurrentGrids readCurrent(
  const std::string& path, const Georeference& scene, const Rectangle& bounds, const Execution& execution = {});

}
