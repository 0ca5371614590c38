#pragma once

#include "bathymetry/Georeference.h"
#include "bathymetry/SeafloorOptions.h"
#include "bathymetry/SoundingReport.h"
#include "bathymetry/Soundings.h"
#include "sim/ElevationGrid.h"
#include "sim/Execution.h"

#include <string>
#include <vector>

namespace swellray
{

/** Soundings brought to a grid. */
struct GriddedSoundings
{
  /**
   * m, positive up; holes are NaN. Georeference's points are this grid's positions; on the ellipsoid it is in degrees of
   * longitude and latitude.
   */
  ElevationGrid grid;
  Georeference georeference;
  double scaleError = 0.0;        ///< largest |map length / true length - 1| on the grid
  VerticalMeaning meaning;        ///< how the values were understood
  std::string crsSource;          ///< "file", "as asked", or why it was assumed
  Rectangle fileExtent;           ///< of the soundings, file coordinates
  SoundingReport report;          ///< counts, distances, errors
  std::vector<std::string> notes; ///< those of the soundings and what else a user should know
};

/**
 * Bring soundings to elevations on a regular grid in metres by natural-neighbour interpolation (Sibson 1981, A brief
 * description of natural neighbour interpolation): the value at a node is the mean of its natural neighbours, each
 * weighted by the area that the node's Voronoi cell would take from the neighbour's. Planes are reproduced, and every
 * sounding is met. It works in metres: longitude and latitude are mapped first (Georeference, centred on the scene).
 *
 * In this order: values become elevations; soundings at the very same place become one, their mean; each is compared
 * with what its natural neighbours say without it, and those far off are counted as outliers and, where asked, dropped;
 * nodes are interpolated.
 *
 * Options used: `resample`, distance of nodes, m (the nominal spacing where the soundings have one, otherwise about
 * their mean distance, the root of the area that they cover over their number); `maxGap`, m: a node further than that
 * from every sounding is a hole (not set: 3.54 times the median radius of the circles of the Delaunay triangles, by
 * area, which closes gaps five cells wide on a lattice; with cells no limit unless set); `crop`, file coordinates: nodes
 * lie in it, soundings around it take part; `positive`, `crs`, `nodata`, `dropOutliers`, `crossValidate`. A node outside
 * the convex hull of the soundings, or outside the cells where there are any, is a hole. The rest of the options is the
 * caller's.
 *
 * On the ellipsoid (options.earth) soundings must be in longitude and latitude, within 85 degrees of latitude: they are
 * interpolated on Mercator's map, which is true in angle, at nodes that lie evenly in degrees, `resample` apart in the
 * middle of the scene.
 *
 * The result is the same for any number of threads. A million soundings take some seconds and 0.5 GB.
 *
 * @throws std::invalid_argument an option out of range, or arrays of the soundings that do not fit each other
 * @throws std::runtime_error fewer than 3 places with data, all on one line, a spacing that gives fewer than 4 x 4
 *   nodes or too many, a CRS that does not fit the coordinates
 */
GriddedSoundings gridSoundings(
  const Soundings& soundings, const SeafloorOptions& options = {}, const Execution& execution = {});

}
