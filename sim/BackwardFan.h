#pragma once

#include "sim/BackwardTracer.h"
#include "sim/Execution.h"
#include "sim/RayField.h"

#include <vector>

namespace swellray
{

/** The ways by which waves come to a place. */
struct BackwardFan
{
  std::vector<double> headings;    ///< at the place, going to, rad
  std::vector<WaveOrigin> origins; ///< one a heading
  RayField field;                  ///< one ray a heading, in the sense of the wave; it ends at the place
};

/**
 * Follow waves from `count` directions, evenly around the circle, the first from north and clockwise from there, back from a place.
 * @param stepsPerWave points a wavelength
 * @throws std::invalid_argument a period, a number of directions or of steps not above 0, or a place outside of the scene, on land or
 *   within an obstacle
 */
BackwardFan traceFan(const BackwardTracer& tracer, const glm::dvec2& place, double period, std::size_t count,
  double stepsPerWave, const Execution& execution = {});

}
