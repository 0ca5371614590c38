#include "sim/WaveHeight.h"

#include "sim/Angles.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

void requirePositive(const char* name, double value, bool infinityAllowed)
{
  if (!(value > 0.0) || (!infinityAllowed && std::isinf(value)))
  {
    std::ostringstream message;
    message << name << " must be above 0, not " << value;
    throw std::invalid_argument(message.str());
  }
}

}

void HeightOptions::validate() const
{
  requirePositive("breaker index gamma", this->gamma, false);
  requirePositive("largest refraction coefficient", this->maxRefraction, true);
}

void computeHeights(
  const RayProfile& profile, const IncidentWave& wave, const HeightOptions& options, RayHeights& result)
{
  wave.validate();
  options.validate();
  result.refraction.resize(profile.count);
  result.height.resize(profile.count);
  result.energyFlux.resize(profile.count);
  result.orbitalVelocity.resize(profile.count);
  result.breaking.resize(profile.count);

  const bool spacing = options.amplitude == AmplitudeRule::Spacing;
  const double* const first = spacing ? profile.krSpacing : profile.krTube;
  const double* const second = spacing ? profile.krTube : profile.krSpacing;
  const double fluxFactor = SeaWaterDensity * wave.gravity / 8.0;

  double refraction = std::min(1.0, options.maxRefraction); // in use until one is known
  double remaining = 1.0;                                   // share of the height that breaking has left
  for (std::size_t i = 0; i < profile.count; ++i)
  {
    const double known = std::isnan(first[i]) ? second[i] : first[i];
    if (!std::isnan(known))
    {
      refraction = std::min(known, options.maxRefraction);
    }
    double height = remaining * wave.height * profile.shoaling[i] * refraction;

    // The shore's own points lie in water too shallow for any wave theory but this limit.
    const bool aground = profile.state[i] == static_cast<std::uint8_t>(RayState::Aground);
    const double highest = options.gamma * std::max(0.0, profile.depth[i]);
    const bool broken = (aground || options.breaking == BreakingRule::Gamma) && height > highest;
    if (broken)
    {
      remaining *= highest / height;
      height = highest;
    }
    result.refraction[i] = refraction;
    result.height[i] = height;
    result.energyFlux[i] = fluxFactor * height * height * profile.groupSpeed[i];
    result.orbitalVelocity[i] = Pi * height / (wave.period * std::sinh(profile.wavenumber[i] * profile.depth[i]));
    result.breaking[i] = broken ? 1 : 0;
  }
}

}
