#pragma once

#include "sim/Execution.h"
#include "sim/WaveGroups.h"

#include <cstddef>
#include <cstdint>

namespace swellray
{

/** What foam is made by and how long it stays. */
struct FoamOptions
{
  double period = 10.0;    ///< T of the waves, s, > 0
  double life = 8.0;       ///< s until foam is gone, > 0
  double variation = 0.0;  ///< as WaveSection::variation, wavelengths
  double wavelength = 1.0; ///< as SurfaceOptions::wavelength, m
  std::uint64_t seed = 1;  ///< as SurfaceOptions::seed
  double front = 0.0;      ///< as WaveSection::frontPhase, rad, >= 0
  WaveGroups groups;       ///< as SurfaceOptions::groups

  /** @throws std::invalid_argument naming what is out of range */
  void validate() const;
};

/** Places with waves: plain arrays, an entry a place. */
struct FoamPlaces
{
  std::size_t count = 0;
  const double* phase = nullptr;           ///< S of the traced wave, rad
  const double* breakingPhase = nullptr;   ///< S where its breaking began; NaN where it is not broken
  const double* launchParameter = nullptr; ///< m; null allowed where the variation is 0
  const double* groupTime = nullptr;       ///< as WaveSurface::groupTime; these two: null allowed without groups
  const double* brokenShare = nullptr;     ///< as WaveSurface::brokenShare
  const double* plungePhase = nullptr;     ///< as FoamOrigin::plunge; null: no foam on the front of waves
  const double* foamShare = nullptr;       ///< as FoamOrigin::share; null allowed: 1 everywhere
};

/**
 * Foam left by waves that broke where they passed (Jeschke et al. 2003, section 3.1). Wave n passes a place of phase S at
 * the time t_n = (S - 2 pi n)/omega, and is broken there where S has reached its breaking, which the trace gives, and
 * the wave's own delay. Of every such wave there is 1 - (t - t_n)/life, down to 0, within a sixteenth of a wave from where
 * its breaking began only its share of that; the place has the largest. Of a group only waves count that are high enough to
 * break there, share >= brokenShare, from a fiftieth below that on in part. A wave whose crest has come down has foam on its
 * front too, as far as `front` ahead of the crest, the last fifth of that thinning out. Behind the end of breaking only a share of all
 * this is left (SurfHistory::foam).
 * @param time t, s
 * @param foam one entry a place, 0 to 1
 * @throws std::invalid_argument on bad options
 */
void computeFoam(
  const FoamPlaces& places, double time, const FoamOptions& options, float* foam, const Execution& execution = {});

/** The same of one place; the options are taken as good. */
double foamAt(double phase, double breakingPhase, double launchParameter, double time, const FoamOptions& options,
  double groupTime = 0.0, double brokenShare = 1.0, double plungePhase = 0.0);

}
