#pragma once

#include "sim/IncidentWave.h"
#include "sim/RayField.h"

#include <cstdint>
#include <vector>

namespace swellray
{

enum class AmplitudeRule
{
  Spacing, ///< from the distance of neighbouring rays
  Tube,    ///< from dynamic ray tracing along each ray
};

enum class BreakingRule
{
  None,
  Gamma, ///< saturated: H <= gamma h from the first breaking on
};

struct HeightOptions
{
  AmplitudeRule amplitude = AmplitudeRule::Spacing;
  BreakingRule breaking = BreakingRule::Gamma;
  double gamma = 0.78;        ///< breaker index H/h, > 0
  double maxRefraction = 3.0; ///< cap of the refraction coefficient at caustics, > 0

  /** @throws std::invalid_argument naming the option that is out of range */
  void validate() const;
};

/** Wave quantities at the points of one ray; all vectors have one entry a point. */
struct RayHeights
{
  std::vector<double> refraction;      ///< Kr in use, -
  std::vector<double> height;          ///< H, m
  std::vector<double> energyFlux;      ///< rho g H^2 Cg / 8, W/m
  std::vector<double> orbitalVelocity; ///< pi H/(T sinh kh), amplitude near the bed, m/s
  std::vector<std::uint8_t> breaking;  ///< 1 where the wave is broken
};

/** Density of sea water, kg/m3. */
constexpr double SeaWaterDensity = 1025.0;

/** Input of the heights along one ray: plain arrays, one entry a point, as they lie in a ray file. */
struct RayProfile
{
  std::size_t count = 0;
  const double* depth = nullptr;       ///< m
  const double* wavenumber = nullptr;  ///< rad/m
  const double* groupSpeed = nullptr;  ///< relative to the water, m/s
  const double* shoaling = nullptr;    ///< Ks, -
  const double* krSpacing = nullptr;   ///< -, NaN or infinite allowed
  const double* krTube = nullptr;      ///< -
  const std::uint8_t* state = nullptr; ///< RayState
};

/**
 * H = H0 Ks Kr with breaking, point by point along a ray.
 * Ks is taken as the tracer found it. Where the rule's coefficient is not known (NaN)
 * the other one is taken; an aground ray has the height its depth allows.
 * @param result resized to profile.count
 */
void computeHeights(
  const RayProfile& profile, const IncidentWave& wave, const HeightOptions& options, RayHeights& result);

}
