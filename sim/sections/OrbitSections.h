#pragma once

#include "sim/sections/PointwiseSection.h"

#include <algorithm>

namespace swellray
{

/**
 * Particles on tilted ellipses: with R = H/2, half axes R Sx along the tilt alpha and R Sz across it,
 *
 *   along = -R Sx cos(alpha) sin Phi - R Sz sin(alpha) cos Phi
 *   up    =  R Sz cos(alpha) cos Phi - R Sx sin(alpha) sin Phi
 *
 * (Gonzato and Le Saec 1997, eq. 4, with the crest and not the trough at Phi = 0).
 */
struct TiltedOrbit
{
  double majorAxis = 0.0; ///< R Sx, m
  double minorAxis = 0.0; ///< R Sz, m
  double sine = 0.0;      ///< of the tilt alpha
  double cosine = 1.0;

  /** Phase of the trough from Phi = pi: -atan(sin(alpha) Sx/(cos(alpha) Sz)) (eq. 5). */
  double troughPhase() const
  {
    return minorAxis > 0.0 ? -std::atan2(this->sine * this->majorAxis, this->cosine * this->minorAxis) : 0.0;
  }

  Displacement at(const Dual& phase) const
  {
    const SineCosine turn = sineCosine(phase);
    const Dual major = -this->majorAxis * turn.sine;
    const Dual minor = this->minorAxis * turn.cosine;
    return { this->cosine * major - this->sine * minor, this->cosine * minor + this->sine * major };
  }
};

/** Sine of an angle whose tangent is given. */
inline double sineOfSlope(double tangent)
{
  return tangent / std::sqrt(1.0 + tangent * tangent);
}

/**
 * Biesel 1952 as Gonzato and Le Saec 1997 (section 2.1) state it: on the way to the shore the circles of deep water
 * become ellipses with the major axis along the slope of the bed, and the wave leans over until it breaks. The half axes
 * are those of linear theory, R coth(kh) and R (Dean and Dalrymple 1991, eqs. 4.18); the tilt fades from the bed to the
 * surface as the orbits grow, sin(alpha) = sin(beta)/cosh(kh).
 */
class BieselSection : public PointwiseSection<BieselSection>
{
public:
  static TiltedOrbit orbit(const SectionPlace& place)
  {
    const double kh = place.wavenumber * place.depth;
    TiltedOrbit orbit;
    orbit.minorAxis = 0.5 * place.height;
    orbit.majorAxis = orbit.minorAxis / std::tanh(kh);
    orbit.sine = sineOfSlope(place.slope) / std::cosh(std::min(kh, 300.0));
    orbit.cosine = std::sqrt(1.0 - orbit.sine * orbit.sine);
    return orbit;
  }

  Displacement displacement(const Shape&, const SectionPlace& place, const Dual& phase) const
  {
    return orbit(place).at(phase);
  }
};

/** Factors of Fournier and Reeves 1986, 1/m, > 0; the defaults are those of Gonzato and Le Saec 1997, section 2.3. */
struct OrbitFactors
{
  double tilt = 0.1;   ///< K0: influence of the depth on the tilt
  double major = 0.11; ///< Kx: enlargement of the major axis
  double minor = 0.09; ///< Kz: reduction of the minor axis
};

/**
 * Fournier and Reeves 1986 (Gonzato and Le Saec 1997, eq. 4): Biesel's ellipses made easy to compute,
 *
 *   Sx = 1/(1 - exp(-Kx h)),  Sz = Sx (1 - exp(-Kz h)),  sin(alpha) = sin(beta) exp(-K0 h).
 *
 * Sx has no limit: in shallow water the surface makes loops and goes below the ground, and where the bed falls waves
 * break backwards, as the 1997 paper says of it.
 */
class FournierReevesSection : public PointwiseSection<FournierReevesSection>
{
public:
  explicit FournierReevesSection(const OrbitFactors& factors = {})
    : Factors(factors)
  {
  }

  Displacement displacement(const Shape&, const SectionPlace& place, const Dual& phase) const
  {
    const double radius = 0.5 * place.height;
    TiltedOrbit orbit;
    orbit.majorAxis = radius / -std::expm1(-this->Factors.major * place.depth);
    orbit.minorAxis = orbit.majorAxis * -std::expm1(-this->Factors.minor * place.depth);
    orbit.sine = sineOfSlope(place.slope) * std::exp(-this->Factors.tilt * place.depth);
    orbit.cosine = std::sqrt(1.0 - orbit.sine * orbit.sine);
    return orbit.at(phase);
  }

private:
  OrbitFactors Factors;
};

}
