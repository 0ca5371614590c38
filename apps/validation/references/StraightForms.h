#pragma once

#include "ReferenceSolutions.h"

#include <cmath>

/** Depths over straight contours, x seaward of the shoreline, m. */
namespace swellray::reference
{

using Depth = std::function<Real(Real x)>;

/** h = s x. */
inline Depth planeDepth(Real slope)
{
  return [slope](Real x) { return slope * x; };
}

/** h = A x^(2/3), A in m^(1/3) (Dean 1977). */
inline Depth deanDepth(Real scale)
{
  return [scale](Real x) { return scale * std::cbrt(x * x); };
}

/** h = s x - hb exp(-((x - xb)/wb)^2). */
inline Depth barDepth(Real slope, Real height, Real position, Real width)
{
  return [=](Real x)
  {
    const Real t = (x - position) / width;
    return slope * x - height * std::exp(-t * t);
  };
}

}
