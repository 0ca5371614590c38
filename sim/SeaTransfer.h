#pragma once

#include "sim/SpectralSea.h"

#include <optional>
#include <vector>

namespace swellray
{

/**
 * Seas at many places from any number of seas offshore, as matrix products: SpectralTransfer's weights of all places,
 * frequency by frequency, times the spectra offshore. What it gives is what transformSea() gives for each of them alone.
 */
class SeaTransfer
{
public:
  /**
   * @param offshore grid of the spectra offshore; its frequencies must be those of the rays
   * @param places from traceOrigins() with these rays
   * @param gamma largest Hs over depth (saturation); none: waves do not break
   * @throws std::invalid_argument
   */
  SeaTransfer(const SpectralRays& rays, const SpectralGrid& offshore, const std::vector<SpectralOrigins>& places,
    std::optional<double> gamma, const Execution& execution = {});

  std::size_t placeCount() const { return this->Depths.size(); }
  const SpectralGrid& offshore() const { return this->Offshore; }

  /**
   * May be called from several threads at once.
   * @param densities of `count` seas on the offshore grid, one after the other
   * @return the places of the first sea, then those of the second, ...
   * @throws std::invalid_argument where the size does not fit
   */
  std::vector<PlaceSea> apply(const std::vector<double>& densities, std::size_t count) const;

private:
  SpectralGrid Offshore;
  std::vector<double> FrequencyWeights;
  std::vector<double> Depths; // of the places; those with no rays are dry
  std::vector<bool> Wet;
  std::vector<double> Weights; // [frequency][offshore direction][place][3]
  std::optional<double> Gamma;
};

}
