#pragma once

#include "bathymetry/Georeference.h"
#include "bathymetry/ModelGrid.h"
#include "bathymetry/SeafloorOptions.h"
#include "bathymetry/SeafloorReport.h"
#include "sim/ElevationGrid.h"
#include "sim/Execution.h"

#include <optional>
#include <string>

namespace swellray
{

/** A seafloor read from a file. */
struct Bathymetry
{
  ElevationGrid grid; ///< m; holes are NaN. Georeference's points are this grid's positions.
  Georeference georeference;
  SeafloorReport report;
  std::optional<ElevationGrid> geographic; ///< on the ellipsoid: the file's own nodes, in degrees (GeographicSeafloor)
};

/**
 * Read a seafloor as elevations in metres on a regular grid in metres: a raster that GDAL opens, the grid of a model
 * (readModelGrid()), a curvilinear one in NetCDF (readNetcdfCurvilinear()), a UGRID mesh (readUgridMesh()) or soundings
 * (readSoundings()). Meshes, curvilinear grids and
 * soundings are gridded by gridSoundings(); for the others holds what follows.
 *
 * Nodes are the centres of the file's cells. In this order: the part asked for is read, values become elevations,
 * gaps are filled (fillGaps()), the grid is brought to metres, smoothed (smoothGrid()).
 *
 * Longitude and latitude, and rotated grids, are resampled once by their own C2 spline (SplineSeafloor) with the metric
 * cell sizes at the centre as spacing unless `resample` is set; map: Georeference, centred on the scene. An upright
 * grid of longitudes and latitudes is resampled on the largest axis-aligned rectangle in its mapped outline, a rotated
 * one on the box around it, where nodes outside of it are holes. Other grids keep their nodes; the point (0, 0) is the
 * south-west node.
 *
 * On the ellipsoid (options.earth) a grid in longitude and latitude is kept as it is, for GeographicSeafloor, and `grid`,
 * on Mercator's map, is there to be looked at.
 *
 * @throws std::invalid_argument an option out of range
 * @throws std::runtime_error a file that cannot be read, has nothing but land or no data, or cannot be understood;
 *   the message names the file
 */
Bathymetry readSeafloor(const std::string& path, const SeafloorOptions& options = {}, const Execution& execution = {});

/** The same of a grid or of soundings that somebody else has read. @param path for the report and errors */
Bathymetry readSeafloor(
  const std::string& path, ModelGrid grid, const SeafloorOptions& options, const Execution& execution = {});
Bathymetry readSeafloor(
  const std::string& path, const Soundings& soundings, const SeafloorOptions& options, const Execution& execution = {});

}
