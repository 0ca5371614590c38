#pragma once

#include "sim/sections/WaveSection.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** One ray as plain arrays, an entry a point. */
struct HistoryRay
{
  std::size_t count = 0;
  const double* phase = nullptr;            ///< S, rad, increasing
  const double* height = nullptr;           ///< m
  const double* wavenumber = nullptr;       ///< rad/m
  const double* depth = nullptr;            ///< m
  const double* slope = nullptr;            ///< of the bed along the ray, positive where it rises
  const double* breakingDistance = nullptr; ///< m since breaking began
  const std::uint8_t* breaking = nullptr;   ///< 1 where the wave is broken
};

/** One stretch of a ray on which waves are broken. */
struct BreakingStretch
{
  double begin = 0.0;        ///< phase S where the trace says that breaking begins
  double end = 0.0;          ///< phase where the wave is whole again, or where the ray ends
  double index = 0.78;       ///< H/h where it begins
  double plungePhase = 0.0;  ///< rad from there until a plunging crest has come down
  double plungeHeight = 0.0; ///< H there, m
};

/** Way that a plunging crest travels from where it begins to break to where it comes down, over its height there:
 *  4.0 - 9.25 m on a bed of slope m, at least 1 (Galvin 1969, Breaker travel and choice of design wave height, J. Waterw.
 *  Harbors Div. 95). */
double plungeDistance(double slope);

/**
 * What becomes of waves along one ray: the stretches on which they are broken, and the state of a crest anywhere.
 */
class SurfHistory
{
public:
  SurfHistory() = default;

  /**
   * The arrays must outlive this.
   * @param breakerIndex H/h at which waves would break that do not do so on this ray
   */
  SurfHistory(const HistoryRay& ray, double breakerIndex);

  /**
   * Go on from the ray beside which this one was inserted: where that is broken as this one begins, what happened there
   * goes before.
   */
  void continueFrom(const SurfHistory& parent);

  /** In the order of their phase. */
  const std::vector<BreakingStretch>& stretches() const { return this->Stretches; }

  /** Stretch that contains a phase; null where waves are whole there. */
  const BreakingStretch* stretchAt(double phase) const;

  /** H/h over that at which the wave breaks next, at most 1. */
  double ripeness(double height, double depth, double phase) const;

  double firstPhase() const { return this->Ray.count > 0 ? this->Ray.phase[0] : 0.0; }

  /**
   * State of a crest at a phase of the ray, at its ends beyond them.
   * @param delay phase by which this wave breaks later than the trace says, rad, >= 0
   */
  CrestState crest(double phase, double delay) const;

private:
  struct Place
  {
    std::size_t before = 0;
    std::size_t after = 0;
    double weight = 0.0; // of the later one
  };
  Place place(double phase) const;
  static double between(const double* values, const Place& place);

  HistoryRay Ray;
  double BreakerIndex = 0.78;
  std::vector<BreakingStretch> Stretches;
};

/**
 * Delay of the breaking of wave n at a place of its crest, as a share of the largest, 0 to 1: three sines along the crest
 * whose places are drawn for each wave anew (Jeschke et al. 2003, section 3: slightly varying values for every wave).
 * @param launchParameter m along the incident crest
 * @param wavelength of the incident wave, m: the sines are about 1, 2.3 and 5.1 of it long
 */
double breakingDelay(std::uint64_t seed, std::int64_t wave, double launchParameter, double wavelength);

}
