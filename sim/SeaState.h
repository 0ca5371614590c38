#pragma once

#include "sim/DirectionalSpectrum.h"

#include <optional>
#include <string>

namespace swellray
{

/** A sea as people give it. */
struct SeaState
{
  SpectrumShape shape = SpectrumShape::Jonswap; ///< not OchiHubble
  double height = 2.0;                          ///< Hs, m, > 0
  double peakPeriod = 10.0;                     ///< Tp, s, > 0
  double directionFrom = 270.0;                 ///< mean direction, nautical degrees, -360 to 360
  double spread = 25.0;                         ///< circular standard deviation, degrees, 1 to 80
  double peakedness = StandardPeakedness;       ///< of JONSWAP and TMA, 1 to 20
  std::optional<double> depth;                  ///< of TMA, m, > 0
  std::optional<double> wind;  ///< U10, m/s, > 0: sets height and period of a fully developed sea, or with a fetch
  std::optional<double> fetch; ///< m, > 0: of a growing one (JONSWAP)
  double gravity = StandardGravity;

  /** @throws std::invalid_argument naming what is out of range or missing */
  FrequencySpectrum spectrum() const;
};

/** Directions of a sea offshore: twice the usual ones of rays, as refraction gathers many of them into few at the shore. */
constexpr std::size_t OffshoreDirections = 72;

/**
 * Frequencies on which a sea is transformed: in geometric progression over the band that holds 99.5 % of its energy.
 * @param count >= 2
 */
SpectralGrid spectralGridOf(const FrequencySpectrum& spectrum, std::size_t count, std::size_t directions);
SpectralGrid spectralGridOf(const DirectionalSpectrum& spectrum, std::size_t count, std::size_t directions);

}
