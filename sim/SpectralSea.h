#pragma once

#include "sim/Breaking.h"
#include "sim/SpectralTransfer.h"

#include <optional>

namespace swellray
{

/** How the sea offshore becomes that at places. */
struct SpectralSeaOptions
{
  SpectralRays rays;

  /**
   * What becomes of a sea that is too high for the depth; its spectrum is scaled down as a whole. None; Gamma: Hs <= gamma h
   * (saturation, Thornton and Guza 1982, J. Geophys. Res. 87); BattjesJanssen, Baldock: along the waves' ways (SpectralSurf).
   */
  BreakingRule breaking = BreakingRule::None;
  std::optional<double> gamma; ///< none: SaturationGamma, or as SpectralSurf has it

  /** @throws std::invalid_argument */
  void validate() const;
};

/** Hs over depth of saturated random waves unless set: Thornton and Guza 1982 have Hrms = 0.42 h. */
constexpr double SaturationGamma = 0.6;

/** The sea at a place. */
struct PlaceSea
{
  double depth = 0.0; ///< m; NaN in a hole or outside
  bool known = false; ///< the place is in water; otherwise all parameters are NaN
  bool breaking = false;
  std::size_t rays = 0;  ///< that it is made of, those by which it breaks among them
  std::size_t steps = 0; ///< of these rays; 0 of those from a file
  SeaParameters parameters;
};

/**
 * The sea at places. No more than one place's spectrum a thread is held in memory, unless spectra are asked for.
 *
 * @param offshore spectrum whose frequencies are those of the rays
 * @param spectra where the spectrum of each place goes, one a place, empty for dry ones; null: not wanted
 * @return one a place; the same for any loop in `execution`. Places that were not reached before a cancel are not known
 * @throws std::invalid_argument
 */
std::vector<PlaceSea> transformSea(const BackwardTracer& tracer, const SpectralSeaOptions& options,
  const DirectionalSpectrum& offshore, const std::vector<glm::dvec2>& places, const Execution& execution = {},
  std::vector<DirectionalSpectrum>* spectra = nullptr);

/**
 * The same from places that were traced before; not with breaking along the way, which needs rays of its own.
 * @param origins from traceOrigins() with these rays
 */
std::vector<PlaceSea> transformSea(const SpectralSeaOptions& options, const DirectionalSpectrum& offshore,
  const std::vector<SpectralOrigins>& origins, const Execution& execution = {},
  std::vector<DirectionalSpectrum>* spectra = nullptr);

/** Scale the spectrum down where its Hs is above gamma h. @return true where it is */
bool saturate(DirectionalSpectrum& spectrum, double depth, double gamma);

}
