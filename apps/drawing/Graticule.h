#pragma once

#include "bathymetry/Georeference.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace swellray::drawing
{

/** A meridian or a parallel on a map. */
struct GraticuleLine
{
  bool meridian = true;
  double degrees = 0.0;           ///< longitude or latitude
  std::string label;              ///< degrees, minutes where there are some, seconds where there are some, side
  std::vector<glm::dvec2> points; ///< in the scene's plane, m: from the south or from the west on
};

/** A longitude or a latitude as 73 degrees 30' W. */
std::string degreesMinutes(double degrees, bool isLongitude);

/**
 * Meridians and parallels, at round degrees, minutes or seconds, that cross a map.
 * @param bounds lowest and highest x, then y, m
 * @return none where the georeference knows no longitude and latitude
 */
std::vector<GraticuleLine> makeGraticule(const Georeference& georeference, const double bounds[4]);

}
