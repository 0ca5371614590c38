#pragma once

#include "sim/Angles.h"
#include "sim/sections/OrbitSections.h"

namespace swellray
{

/**
 * Gonzato and Le Saec 1997, sections 2.3 to 2.5, eq. 7 as corrected: the ellipses of Fournier and Reeves limited to
 * Gerstner's disc, R Sx <= 1/K, and on them, with psi in [-pi, pi) the phase from the trough,
 *
 *   Stretch      = St_max (psi/pi)^2 exp(-Ks h) along the major axis: crests go ahead, troughs stay (eq. 6)
 *   Displacement = 0 to H at the crest, exp(-Kd h), in the direction
 *   Orientation  = from the slope of the bed to -45 degrees at the crest: gravity,
 *
 * both linear in the three parts -pi, -pi/3, 7 pi/8, pi of psi: behind a crest they set in at once, before it they fade
 * over a third of the wave. Where the bed falls its slope is taken as 0, so no wave breaks backwards. Limits of ours: the
 * major axis stands no higher than the wave, R Sx sin(alpha) <= H/2, and Stretch raises the crest by H/2 at most. Without
 * them crests on beds steeper than beaches, where the axis is long and stands up, rose by several wave heights.
 *
 * The paper has no values for St_max, Ks and Kd. Here they scale with the wave, St_max = stretch H, Ks = ks/H, Kd = kd/H, so
 * that waves of any size begin to plunge at about the same H/h: with the defaults a 9 s swell of 2 m at 0.6, before it
 * breaks at 0.78.
 */
class GonzatoLeSaecSection : public PointwiseSection<GonzatoLeSaecSection>
{
public:
  struct Parameters
  {
    OrbitFactors orbit;
    double stretch = 10.0;          ///< St_max/H, >= 0
    double stretchDepth = 0.5;      ///< Ks H, >= 0
    double displacementDepth = 0.8; ///< Kd H, >= 0
  };

  explicit GonzatoLeSaecSection(const Parameters& parameters)
    : Values(parameters)
  {
  }

  double pointsPerWave() const override { return 32.0; }

  /** The limited ellipse. */
  TiltedOrbit orbit(const SectionPlace& place) const
  {
    const OrbitFactors& factors = this->Values.orbit;
    TiltedOrbit orbit;
    orbit.majorAxis = std::min(0.5 * place.height / -std::expm1(-factors.major * place.depth), 1.0 / place.wavenumber);
    orbit.minorAxis = orbit.majorAxis * -std::expm1(-factors.minor * place.depth);
    const double tilt = sineOfSlope(std::max(0.0, place.slope)) * std::exp(-factors.tilt * place.depth);
    orbit.sine = std::min(tilt, 0.5 * place.height / orbit.majorAxis);
    orbit.cosine = std::sqrt(1.0 - orbit.sine * orbit.sine);
    return orbit;
  }

  /** Share of Displacement at the phase psi from the trough: 1 at the crest, 0 around the trough. */
  static Dual displacementShare(const Dual& psi)
  {
    constexpr double fadeEnd = -Pi / 3.0;
    constexpr double riseStart = 7.0 * Pi / 8.0;
    if (psi.value < fadeEnd)
    {
      return (fadeEnd - psi) / (Pi + fadeEnd);
    }
    return psi.value < riseStart ? Dual(0.0) : (psi - riseStart) / (Pi - riseStart);
  }

  Displacement displacement(const Shape&, const SectionPlace& place, const Dual& phase) const
  {
    const TiltedOrbit orbit = this->orbit(place);
    Displacement moved = orbit.at(phase);
    Dual psi = phase - orbit.troughPhase() - Pi;
    while (psi.value < -Pi)
    {
      psi.value += 2.0 * Pi;
    }
    while (psi.value >= Pi)
    {
      psi.value -= 2.0 * Pi;
    }
    if (!(place.height > 0.0))
    {
      return moved;
    }
    const double relativeDepth = place.depth / place.height;
    const double stretch =
      this->Values.stretch * place.height * std::exp(-this->Values.stretchDepth * relativeDepth) / (Pi * Pi);
    const Dual forward = stretch * (psi * psi);
    moved.along = moved.along + orbit.cosine * forward;
    // At the crest, where it is longest.
    const double rise = orbit.sine * stretch * Pi * Pi;
    moved.up = moved.up + orbit.sine * std::min(1.0, 0.5 * place.height / rise) * forward;

    const Dual share = displacementShare(psi);
    const double beta = std::atan(std::max(0.0, place.slope));
    const SineCosine way = sineCosine(beta - (0.25 * Pi + beta) * share);
    const Dual fall = place.height * std::exp(-this->Values.displacementDepth * relativeDepth) * share;
    moved.along = moved.along + fall * way.cosine;
    moved.up = moved.up + fall * way.sine;
    return moved;
  }

private:
  Parameters Values;
};

}
