#pragma once

#include "sim/BreakingMarch.h"
#include "sim/SpectralTransfer.h"

#include <optional>
#include <vector>

namespace swellray
{

/**
 * Random waves that break on their way to a place (Battjes and Janssen 1978 or Baldock et al. 1998, see BreakingMarch).
 *
 * A sea is followed along the ways of its waves of the peak frequency, one for each direction in which they arrive with at
 * least 5 % of the energy of the main one. A way begins where waves of 1.5 times the height could break. Without losses the
 * root mean square height on it is Hs/sqrt(2) of the unbroken sea, which is found from rays of its own at up to 6 places, a
 * wavelength or more apart; between these Hs over the shoaling coefficient of the peak is linear in phase. What is left is
 * the mean of the ways, weighted by their energy: a share of the energy, the same for all components.
 */
class SpectralSurf
{
public:
  struct Outcome
  {
    double share = 1.0;    ///< of the energy that is left
    bool breaking = false; ///< more than 5 % of the waves are broken
    std::size_t rays = 0;  ///< traced for it
    std::size_t steps = 0; ///< of these rays
  };

  /**
   * Tracer, rays and sea must outlive this.
   * @param rule BattjesJanssen or Baldock
   * @param gamma breaker index; none: of the steepness in deep water (battjesStiveGamma), with Baldock of each place
   * @throws std::invalid_argument
   */
  SpectralSurf(const BackwardTracer& tracer, const SpectralRays& rays, const DirectionalSpectrum& offshore,
    BreakingRule rule, std::optional<double> gamma);

  /**
   * What breaking leaves. The largest height of Battjes and Janssen at the place holds in any case. May be called from several threads at once.
   * @param depth m, > 0
   * @param unbroken the sea at the place without breaking, on the grid of the rays
   */
  Outcome at(const glm::dvec2& place, double depth, const DirectionalSpectrum& unbroken) const;

  /** Of the whole sea; with Baldock's index of each place not in use. */
  double gamma() const { return this->Rule.gamma; }

private:
  double shareAlong(const std::vector<RayPoint>& way, double height, Outcome& outcome) const;
  double rootMeanSquareHeight(const glm::dvec2& place, Outcome& outcome) const;

  const BackwardTracer& Tracer;
  const SpectralRays& Rays;
  const DirectionalSpectrum& Offshore;
  SurfRule Rule; // period of the peak offshore, NaN without a sea; its deepHeight is Hs offshore
};

}
