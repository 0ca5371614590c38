#pragma once

#include "bathymetry/Georeference.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace swellray
{

/**
 * Read the lines of a vector file (GeoJSON, GeoPackage, Shapefile and whatever else OGR reads), all its layers, in the metres of a
 * scene; coordinates as VectorPlaces has them.
 * @throws std::runtime_error a file that cannot be read, has no lines of some length, or anything but lines
 */
std::vector<std::vector<glm::dvec2>> readPolyLines(const std::string& path, const Georeference& scene);

}
