#include "sim/SeaState.h"

#include <stdexcept>

namespace swellray
{

namespace
{

constexpr double BandShare = 0.995;

// Frequency below which a share of the energy lies, by halving.
double frequencyOfShare(const FrequencySpectrum& spectrum, double share)
{
  double low = 0.2 * spectrum.peakFrequency();
  double high = 50.0 * spectrum.peakFrequency();
  for (int i = 0; i < 40; ++i)
  {
    const double middle = 0.5 * (low + high);
    (spectrum.shareBelow(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}

FrequencySpectrum SeaState::spectrum() const
{
  if (wind)
  {
    return fetch ? FrequencySpectrum::jonswapOfWind(*wind, *fetch, peakedness, gravity)
                 : FrequencySpectrum::piersonMoskowitzOfWind(*wind, gravity);
  }
  switch (shape)
  {
  case SpectrumShape::PiersonMoskowitz:
    return FrequencySpectrum::piersonMoskowitz(height, peakPeriod);
  case SpectrumShape::Jonswap:
    return FrequencySpectrum::jonswap(height, peakPeriod, peakedness);
  case SpectrumShape::Tma:
    if (!depth)
    {
      throw std::invalid_argument("a TMA spectrum needs the depth in which it holds");
    }
    return FrequencySpectrum::tma(height, peakPeriod, *depth, peakedness, gravity);
  case SpectrumShape::OchiHubble:
    break;
  }
  throw std::invalid_argument("a sea of one height and period is no Ochi-Hubble spectrum");
}

SpectralGrid spectralGridOf(const FrequencySpectrum& spectrum, std::size_t count, std::size_t directions)
{
  const double beyond = 0.5 * (1.0 - BandShare);
  return SpectralGrid::logarithmic(
    frequencyOfShare(spectrum, beyond), frequencyOfShare(spectrum, 1.0 - beyond), count, directions);
}

SpectralGrid spectralGridOf(const DirectionalSpectrum& spectrum, std::size_t count, std::size_t directions)
{
  const std::array<double, 2> band = energyBand(spectrum, BandShare);
  return SpectralGrid::logarithmic(band[0], band[1], count, directions);
}

}
