#pragma once

#include "sim/Obstacles.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** Rays as plain arrays, as they lie in a ray file. */
struct RayLines
{
  std::size_t rays = 0;
  const std::int64_t* offsets = nullptr;       ///< rays + 1 entries into the point arrays
  const double* positions = nullptr;           ///< x, y, z a point, m
  const double* phase = nullptr;               ///< a point, rad
  const double* scale = nullptr;               ///< a point: length on the map of the Earth over true length; null: 1
  const double* launchParameter = nullptr;     ///< a ray, m
  const std::int32_t* launchSegment = nullptr; ///< a ray
};

/** True distance of two points of rays; exact on a plane, on a map to the third power of it over the Earth's radius. */
double trueDistance(const RayLines& lines, std::int64_t a, std::int64_t b);

/** A place on a ray between two of its points. */
struct RayPlace
{
  std::int64_t point = 0; ///< first of the two points
  double weight = 0.0;    ///< of the second point, 0 to 1
};

/** Crest lines: places[offsets[i]] to places[offsets[i+1] - 1] form line i, in the order of lambda. */
struct CrestLines
{
  std::vector<std::int64_t> number; ///< n of phase = 2 pi n, one a line
  std::vector<std::size_t> offsets{ 0 };
  std::vector<RayPlace> places;
};

/**
 * Lines of equal phase S = 2 pi n over neighbouring rays. A line breaks where a ray between two others has
 * ended, between launch segments, where two neighbours are further apart than maxGap (m; 0: no limit), and where an
 * obstacle stands between them.
 * Places lie on the straight line between two points of a ray; a ray alone makes no line.
 * @param lines rays whose phase increases along them
 * @param every only crests whose number is a multiple of this, >= 1
 * @throws std::invalid_argument every < 1; std::runtime_error where a ray begins or ends with a phase that is not finite or beyond 1e7 waves
 */
CrestLines extractCrests(
  const RayLines& lines, double maxGap, std::int64_t every = 1, const Obstacles* obstacles = nullptr);

}
