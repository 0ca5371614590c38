#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <limits>

namespace swellray
{

/**
 * A place at which a ray touches a caustic: its tube has no width there. Lengths, and what is a metre, are those on the map
 * of the rays, whose scale is beside.
 */
struct RayCaustic
{
  std::int32_t ray = 0;           ///< index of the ray
  std::int32_t number = 0;        ///< of the caustics touched by this ray, from 1
  glm::dvec2 position{ 0.0 };     ///< m
  glm::dvec2 rayDirection{ 0.0 }; ///< unit vector along the ray, and along the caustic
  double phase = 0.0;             ///< S, rad
  double travelTime = 0.0;        ///< s since launch
  double scale = 1.0;             ///< of the map: lengths on it over true ones
  glm::dvec2 wavenumber{ 0.0 };   ///< vector, rad/m
  double phaseRate = 0.0;         ///< dS/ds along the ray, rad/m; |k| without a current
  double widthRate = 0.0;         ///< d beta/ds along the ray, 1/m

  /** K: how far the wavenumber moves for the turn of the ray across the caustic, rad/m; |k| without a current. */
  double fanWavenumber = 0.0;

  /**
   * dl/dlambda, - , and its derivative, 1/m: rate of the way along the caustic, in the direction of the rays, from ray to
   * ray. NaN where no neighbour touches it. 0 at a cusp. The curvature of the caustic relative to that of the ray is
   * widthRate/alongRate, 1/m, positive where it turns to the left of the ray.
   */
  double alongRate = std::numeric_limits<double>::quiet_NaN();
  double alongChange = std::numeric_limits<double>::quiet_NaN();
};

}
