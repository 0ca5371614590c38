#pragma once

#include "ReferenceSolutions.h"

namespace swellray::reference
{

/**
 * Trapped ray of a plane beach h = s x, from (x0, 0) at theta0 from the seaward normal: with the heading as the
 * parameter, k = K/sin theta and x = h(k)/s, nothing is singular where the ray turns.
 */
struct TrappedRay
{
  double slope = 0.0;
  double period = 0.0; ///< s
  double x0 = 0.0;     ///< m
  double theta0 = 0.0; ///< degrees, above 0 and below 90

  /** Place at a heading, rad, in a tube of parallel rays: width cos theta/cos theta0. */
  Place at(Real theta) const;
};

}
