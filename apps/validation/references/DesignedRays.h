#pragma once

#include "ReferenceSolutions.h"

#include "sim/RayPath.h"

namespace swellray::reference
{

/** What a seafloor made for a curve is set by. */
struct Design
{
  double period = 10.0;   ///< s
  double depth = 12.0;    ///< m, where the formula's length is
  double length = 1000.0; ///< m: x0, r0 or R
  double angle = 45.0;    ///< degrees
};

/** How the neighbours of a ray start. */
enum class Neighbours
{
  Parallel, ///< at the same heading along a line x = const
  Turned,   ///< the same ray turned about the centre
  Fan,      ///< at the same place with other headings
};

/**
 * A seafloor designed for the curve of its rays, and one of these: the wavenumber k(x, y) is prescribed and the depth
 * is h = atanh(k_inf/k)/k, so that the curve is exact at any period.
 */
struct DesignedRay
{
  Formula formula;
  Rectangle bounds;
  double feature = 0.0; ///< length over which the bed changes, m
  double period = 0.0;  ///< s
  glm::dvec2 position{ 0.0 };
  double heading = 0.0; ///< rad
  Neighbours neighbours = Neighbours::Parallel;
  std::vector<Place> places;

  FormulaSeafloor seafloor() const { return { this->formula, this->bounds, this->feature }; }

  /** Start of the ray and its tube, a unit wide (Fan: a radian), in a medium over that seafloor. */
  RayStart start(const RayMedium& medium) const;
};

/** k = k0 x0/x: a circle; the angle is from the shore normal, waves towards -x. */
DesignedRay circleRay(const Design& design);

/** k = k0 sqrt(x0/x): a cycloid. */
DesignedRay cycloidRay(const Design& design);

/** k = k0 r0/r: a logarithmic spiral; the angle is from the inward radius. */
DesignedRay spiralRay(const Design& design);

/** k = k0 sqrt(r0/r): a parabola around the origin. */
DesignedRay islandParabolaRay(const Design& design);

/**
 * k^2 = k0^2 - mu x: a parabola that turns at x = length, the angle from +x, depth at x = 0.
 * @param neighbours Parallel, with the fold at the turning line, or Fan, with that of the envelope
 */
DesignedRay foldParabolaRay(const Design& design, Neighbours neighbours);

/** Luneburg lens k = k0 sqrt(2 - r^2/R^2): the ray that comes in at y = share R, and on past the focus (R, 0). */
DesignedRay luneburgRay(const Design& design, double share);

}
