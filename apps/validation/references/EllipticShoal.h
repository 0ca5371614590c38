#pragma once

#include "ReferenceSolutions.h"

namespace swellray::reference
{

/**
 * Elliptic shoal on a slope (Berkhoff, Booij and Radder 1982; without a slope that of Vincent and Briggs 1989):
 * with x' = x cos - y sin of the rotation, y' = x sin + y cos,
 *
 *   h = h0 - slope (x' + toe), not below minDepth, and on the shoal
 *   h less height sqrt(1 - (x'/a)^2 - (y'/b)^2) + sunk.
 */
struct EllipticShoal
{
  double h0 = 0.45; ///< m
  double slope = 0.02;
  double toe = 5.82;      ///< m
  double minDepth = 0.07; ///< m
  double rotation = 20.0; ///< degrees
  double height = 0.5;    ///< m
  double sunk = 0.3;      ///< m
  double a = 3.75;        ///< m
  double b = 5.0;         ///< m

  Formula formula() const;
};

}
