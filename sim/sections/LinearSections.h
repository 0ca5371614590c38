#pragma once

#include "sim/sections/PointwiseSection.h"

#include <algorithm>

namespace swellray
{

/** Airy 1845: up = H/2 cos Phi. The sinusoid of small waves (Peachey 1986, eq. 1). */
class AirySection : public PointwiseSection<AirySection>
{
public:
  bool movesAlong() const override { return false; }

  Displacement displacement(const Shape&, const SectionPlace& place, const Dual& phase) const
  {
    return { 0.0, 0.5 * place.height * sineCosine(phase).cosine };
  }
};

/**
 * Gerstner 1804 (Gonzato and Le Saec 1997, eq. 1): particles on circles of radius R = H/2 within the disc K R <= 1,
 *
 *   along = -R sin Phi,  up = K R^2/2 + R cos Phi.
 *
 * The circles stand pi A^2/(4 L) = K R^2/2 above still water (A = H), so that it is the mean level of the surface. At
 * K R = 1 the curve is a cycloid, the steepest: H/L = 1/pi.
 */
class GerstnerSection : public PointwiseSection<GerstnerSection>
{
public:
  Displacement displacement(const Shape&, const SectionPlace& place, const Dual& phase) const
  {
    const double radius = std::min(0.5 * place.height, 1.0 / place.wavenumber);
    const SineCosine orbit = sineCosine(phase);
    return { -radius * orbit.sine, 0.5 * place.wavenumber * radius * radius + radius * orbit.cosine };
  }
};

}
