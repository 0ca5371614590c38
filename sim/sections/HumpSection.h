#pragma once

#include "sim/Angles.h"
#include "sim/sections/PointwiseSection.h"

#include <algorithm>

namespace swellray
{

/**
 * How a single hump of some width lies in its wavelength: the points of the wave gather on the hump, few are left for
 * the flat trough between it and the next. Continuous, without displacement where two waves meet.
 */
struct HumpLayout
{
  static constexpr double LeastShare = 0.7;

  double share = 1.0; ///< of the points on the hump
  double width = 0.0; ///< m
  double half = 0.0;  ///< m, half a wavelength

  /** @param wanted width, m: kept within the wavelength */
  HumpLayout(double wanted, double wavenumber)
    : half(Pi / wavenumber)
  {
    constexpr double widest = 0.999;
    this->width = std::min(wanted, 2.0 * widest * this->half);
    this->share = std::max(LeastShare, 0.5 * this->width / this->half);
  }

  bool onHump(double phase) const { return std::abs(phase) < this->share * Pi; }

  /** -1/2 to 1/2 over the hump. */
  Dual position(const Dual& phase) const { return phase / (2.0 * Pi * this->share); }

  /** Where a place of the trough goes, m from the crest. */
  Dual trough(const Dual& phase) const
  {
    const double side = phase.value < 0.0 ? -1.0 : 1.0;
    const Dual rest = (side * phase / Pi - this->share) / (1.0 - this->share);
    return side * (0.5 * this->width + (this->half - 0.5 * this->width) * rest);
  }
};

}
