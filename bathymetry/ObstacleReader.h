#pragma once

#include "bathymetry/Georeference.h"
#include "sim/Obstacles.h"

#include <string>
#include <vector>

namespace swellray
{

/** Obstacles in the plane of a scene, and what is worth saying about how they were read. */
struct ObstacleFile
{
  std::vector<Obstacle> obstacles; ///< m
  std::vector<std::string> notes;
};

/**
 * Read walls from a vector file (GeoJSON, GeoPackage, Shapefile and whatever else OGR reads), all its layers: a
 * polygon is land behind a wall, its holes are water; a line is a wall without thickness; points are passed over and
 * counted. Coordinates are brought from the CRS of their layer to that of the scene, and to its metres. Where either
 * has none, they are taken as those of the scene's file.
 *
 * Rings are oriented (CGAL, exact), with repeated points and those on a straight wall left out. A ring that crosses
 * itself is noted: rays stop at all of its walls, and land is where it winds around.
 *
 * A number property `slope` is the slope of a feature's faces, rise over run; without it they are vertical.
 *
 * @param reflection coefficient of features without a number property of the name `reflection`, 0 to 1
 * @param scene rectangle, m: lines that do not come near it, and polygons that neither do nor hold it, are left out
 * @throws std::invalid_argument a coefficient out of range; std::runtime_error where the file cannot be read, has
 *   neither lines nor polygons, none of them in the scene, or a property `reflection` or `slope` out of range, naming the
 *   feature
 */
ObstacleFile readObstacles(
  const std::string& path, const Georeference& georeference, const Rectangle& scene, double reflection);

}
