#pragma once

#include "bathymetry/FileGrid.h"
#include "bathymetry/Georeference.h"
#include "bathymetry/SeafloorOptions.h"
#include "sim/Execution.h"

namespace swellray
{

/**
 * Widest scene that one transverse Mercator map may hold, degrees: at 30 degrees from the meridian on the equator its
 * scale is off by 15 %.
 */
constexpr double WidestScene = 60.0;

/** A grid in metres and where it lies. */
struct MetricGrid
{
  ElevationGrid grid;
  Georeference georeference;
  bool resampled = false;
  double scaleError = 0.0;                 ///< largest |map length / true length - 1| on the grid
  std::optional<ElevationGrid> geographic; ///< on the ellipsoid: the elevations as they are, on nodes in degrees
};

/**
 * Georeference of a file's grid: geographic grids are centred on the scene, others have their origin at the low
 * corner of their extent. Longitudes of the grid are turned so that its centre lies within -180 to 180.
 *
 * @param crs WKT, or empty for local metres
 * @param earth on the ellipsoid the grid must be geographic, north up and within 85 degrees of latitude
 * @throws std::runtime_error a CRS that cannot be understood or does not fit the coordinates
 */
Georeference placeGrid(FileGrid& file, const std::string& crs, EarthModel earth = EarthModel::Plane);

/** Largest |map length / true length - 1| in a box of a scene, m. */
double largestScaleError(const Rectangle& box, const Georeference& georeference);

/** Distances of nodes at the centre of a grid, m: along a row, along a column. */
glm::dvec2 cellSize(const FileGrid& file, const Georeference& georeference);

/**
 * Bring a grid in longitude and latitude to Mercator's map, for those who look at it: as many nodes, those of a column
 * on the meridian of the file's. The grid itself goes along.
 */
MetricGrid toMercator(const FileGrid& file, const Georeference& georeference, const Execution& execution = {});

/**
 * Bring a grid to metres (rules: readSeafloor()).
 * @param resample distance of nodes, m; the grid's own where not set
 * @throws std::runtime_error where the result would have fewer than 4 x 4 nodes or too many
 */
MetricGrid toMetres(const FileGrid& file, const Georeference& georeference, const std::optional<double>& resample,
  const Execution& execution = {});

}
