#include "sim/WaveHeight.h"

#include "sim/Angles.h"
#include "sim/BreakingMarch.h"
#include "sim/RayFolds.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

double square(double x)
{
  return x * x;
}

// Slope of the bed along the ray, rising forward, from the depths at three points; second order in their distance.
double slopeAt(const RayProfile& profile, const std::vector<double>& way, std::size_t i)
{
  const std::size_t before = i > 0 ? i - 1 : i;
  const std::size_t after = i + 1 < profile.count ? i + 1 : i;
  const double behind = way[i] - way[before];
  const double ahead = way[after] - way[i];
  const double riseBehind = behind > 0.0 ? (profile.depth[before] - profile.depth[i]) / behind : 0.0;
  const double riseAhead = ahead > 0.0 ? (profile.depth[i] - profile.depth[after]) / ahead : 0.0;
  if (behind == 0.0 || ahead == 0.0)
  {
    return riseBehind + riseAhead; // only one of them is known
  }
  return (riseBehind * ahead + riseAhead * behind) / (behind + ahead);
}

std::vector<double> waysAlong(const RayProfile& profile)
{
  std::vector<double> way(profile.count, 0.0);
  for (std::size_t i = 1; profile.position && i < profile.count; ++i)
  {
    const double* const a = profile.position + 3 * (i - 1);
    const double onMap = std::hypot(a[3] - a[0], a[4] - a[1]);
    way[i] = way[i - 1] + (profile.scale ? onMap / std::sqrt(profile.scale[i - 1] * profile.scale[i]) : onMap);
  }
  return way;
}

void requireArrays(const RayProfile& profile, const HeightOptions& options)
{
  const bool marches = options.rubs() || options.breaking == BreakingRule::Dally || ofRandomWaves(options.breaking);
  if (marches && !profile.travelTime)
  {
    throw std::invalid_argument("friction and breaking by the way need the travel times of the ray");
  }
  if (options.breaking == BreakingRule::Weggel && !profile.position)
  {
    throw std::invalid_argument("breaking by weggel needs the positions of the ray");
  }
  if (profile.causticCount > 0 && !(profile.caustics && profile.phase))
  {
    throw std::invalid_argument("caustics need the phases of the ray");
  }
}

}

const char* causticRuleName(CausticRule rule)
{
  switch (rule)
  {
  case CausticRule::Geometric:
    return "geometric";
  case CausticRule::Cap:
    return "cap";
  default:
    return "uniform";
  }
}

void HeightOptions::validate() const
{
  if (this->gamma)
  {
    requirePositive("breaker index gamma", *this->gamma, false);
  }
  requirePositive("largest refraction coefficient", this->maxRefraction, true);
  if (this->breaking == BreakingRule::Dally && this->gamma && *this->gamma <= DallyStableIndex)
  {
    std::ostringstream message;
    message << "breaker index gamma must be above " << DallyStableIndex
            << ", the stable height over depth of dally, not " << *this->gamma;
    throw std::invalid_argument(message.str());
  }
  if (!(this->friction >= 0.0) || std::isinf(this->friction))
  {
    std::ostringstream message;
    message << "friction factor must be 0 or more, not " << this->friction;
    throw std::invalid_argument(message.str());
  }
  if (!(this->viscosity >= 0.0) || std::isinf(this->viscosity))
  {
    std::ostringstream message;
    message << "viscosity must be 0 m2/s or more, not " << this->viscosity;
    throw std::invalid_argument(message.str());
  }
  if (this->friction > 0.0 && this->viscosity > 0.0)
  {
    throw std::invalid_argument(
      "the boundary layer at the bed has a friction factor or a viscosity, not both: leave one at 0");
  }
}

double deepWaterHeight(const IncidentWave& wave)
{
  const double deepGroupSpeed = wave.gravity * wave.period / (4.0 * Pi);
  return wave.height * std::sqrt(wave.groupSpeed() / deepGroupSpeed);
}

double breakerIndex(const HeightOptions& options, const IncidentWave& wave)
{
  if (options.gamma)
  {
    return *options.gamma;
  }
  const double deepLength = wave.gravity * wave.period * wave.period / (2.0 * Pi);
  return options.breaking == BreakingRule::BattjesJanssen ? battjesStiveGamma(deepWaterHeight(wave) / deepLength)
                                                          : StandardGamma;
}

SurfRule surfRule(const HeightOptions& options, const IncidentWave& wave)
{
  SurfRule rule;
  rule.breaking = options.breaking;
  rule.gamma = breakerIndex(options, wave);
  rule.localGamma = options.breaking == BreakingRule::Baldock && !options.gamma;
  rule.friction = options.friction;
  rule.viscosity = options.viscosity;
  rule.period = wave.period;
  rule.gravity = wave.gravity;
  rule.deepHeight = deepWaterHeight(wave);
  return rule;
}

RayLosses lossesAt(const RayLossArrays& ray, double phase)
{
  if (ray.count == 0)
  {
    return {};
  }
  const double* const end = ray.phase + ray.count;
  auto i = static_cast<std::size_t>(std::lower_bound(ray.phase, end, phase) - ray.phase);
  if (i == ray.count || (i > 0 && phase - ray.phase[i - 1] < ray.phase[i] - phase))
  {
    --i;
  }
  if (ray.state[i] == static_cast<std::uint8_t>(RayState::Aground))
  {
    return {};
  }
  return { ray.share[i], ray.friction[i], ray.breakingDistance[i], ray.breaking[i] != 0,
    static_cast<BreakerType>(ray.breakerType[i]) };
}

void computeHeights(
  const RayProfile& profile, const IncidentWave& wave, const HeightOptions& options, RayHeights& result)
{
  wave.validate();
  options.validate();
  requireArrays(profile, options);
  const std::size_t count = profile.count;
  for (std::vector<double>* values : { &result.refraction, &result.height, &result.energyFlux, &result.orbitalVelocity,
         &result.breakingDistance, &result.friction, &result.share, &result.brokenShare })
  {
    values->resize(count);
  }
  result.breaking.resize(count);
  result.breakerType.resize(count);
  if (count == 0)
  {
    return;
  }

  const bool spacing = options.amplitude == AmplitudeRule::Spacing;
  const double* const first = spacing ? profile.krSpacing : profile.krTube;
  const double* const second = spacing ? profile.krTube : profile.krSpacing;
  const bool uniform = options.caustics == CausticRule::Uniform;
  const RayFolds folds(profile.caustics, uniform ? profile.causticCount : 0, profile.phase, profile.wavenumber,
    profile.count, uniform ? profile.foldBeside : nullptr);
  const double cap = options.caustics == CausticRule::Geometric ? std::numeric_limits<double>::infinity()
                                                                : std::max(options.maxRefraction, folds.highestPeak());
  const double fluxFactor = SeaWaterDensity * wave.gravity / 8.0;
  const double groupSpeedOffshore = wave.groupSpeed();
  const std::vector<double> way = waysAlong(profile);

  double refraction = std::min(1.0, cap); // in use until one is known
  const auto sampleAt = [&](std::size_t i)
  {
    double known = std::isnan(first[i]) ? second[i] : first[i];
    if (!folds.empty() && !std::isnan(known))
    {
      const double share = std::isnan(profile.krTube[i]) ? 0.0 : folds.tubeShare(i);
      const double tube = share > 0.0 ? share / square(profile.krTube[i]) : 0.0;
      known = folds.refraction(i, (1.0 - share) / square(known) + tube);
    }
    refraction = std::isnan(known) ? refraction : std::min(known, cap);
    SurfSample sample;
    sample.depth = profile.depth[i];
    sample.wavenumber = profile.wavenumber[i];
    sample.groupSpeed = profile.groupSpeed[i];
    sample.slope = slopeAt(profile, way, i);
    sample.lossless = wave.height * profile.shoaling[i] * refraction * profile.reflection;
    return sample;
  };
  BreakingMarch march(surfRule(options, wave), sampleAt(0), profile.before);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i > 0)
    {
      const double seconds = profile.travelTime ? profile.travelTime[i] - profile.travelTime[i - 1] : 0.0;
      march.advance(sampleAt(i), seconds, way[i] - way[i - 1]);
    }
    // The shore's own points lie in water too shallow for any wave theory but this limit.
    const bool aground = profile.state[i] == static_cast<std::uint8_t>(RayState::Aground);
    const bool limited = aground && march.limitToDepth();
    const double height = march.height();
    result.refraction[i] = refraction;
    result.height[i] = height;
    // Cg without a current and omega |V|/sigma on one: both are Cg0/Ks^2.
    const double fluxSpeed = groupSpeedOffshore / (profile.shoaling[i] * profile.shoaling[i]);
    result.energyFlux[i] = fluxFactor * height * height * fluxSpeed;
    // H sigma/(2 sinh kh) with sigma^2 = g k tanh kh, which holds on a current too.
    const double k = profile.wavenumber[i];
    result.orbitalVelocity[i] = height * std::sqrt(wave.gravity * k / (2.0 * std::sinh(2.0 * k * profile.depth[i])));
    result.breaking[i] = march.broken() || limited ? 1 : 0;
    result.breakerType[i] = static_cast<std::uint8_t>(profile.position ? march.type() : BreakerType::None);
    result.breakingDistance[i] = march.distance();
    result.friction[i] = march.friction();
    result.share[i] = march.share();
    result.brokenShare[i] = limited ? 1.0 : march.brokenShare();
  }
}

}
