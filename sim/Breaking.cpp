#include "sim/Breaking.h"

#include "sim/Angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace swellray
{

const char* breakingRuleName(BreakingRule rule)
{
  static constexpr std::array<const char*, BreakingRuleCount> Names{ "none", "gamma", "weggel", "miche", "dally",
    "battjes-janssen", "baldock" };
  return Names.at(static_cast<std::size_t>(rule));
}

bool ofRandomWaves(BreakingRule rule)
{
  return rule == BreakingRule::BattjesJanssen || rule == BreakingRule::Baldock;
}

double weggelHeight(double depth, double slope, double period, double gravity)
{
  const double m = std::clamp(slope, 0.0, 0.1);
  const double a = -43.75 * std::expm1(-19.0 * m);
  const double b = 1.56 / (1.0 + std::exp(-19.5 * m));
  return b * depth / (1.0 + a * depth / (gravity * period * period));
}

double micheHeight(double wavenumber, double depth)
{
  return 0.142 * 2.0 * Pi / wavenumber * std::tanh(wavenumber * depth);
}

double randomWaveLimit(double wavenumber, double depth, double gamma)
{
  return 0.88 / wavenumber * std::tanh(gamma / 0.88 * wavenumber * depth);
}

double battjesStiveGamma(double steepness)
{
  return 0.5 + 0.4 * std::tanh(33.0 * steepness);
}

double brokenShare(double ratio)
{
  if (ratio >= 1.0)
  {
    return 1.0;
  }
  if (!(ratio > 0.2))
  {
    return 0.0;
  }
  // Root of f(u) = 1 - exp(u) + b u, u = ln Qb < 0. f is concave with f(0) = 0 and f'(u) > 0 left of ln b, so Newton's
  // method from a place left of the root climbs to it and never passes it.
  const double b = ratio * ratio;
  double u = -1.0 / b; // f = -exp(u) < 0
  for (int i = 0; i < 100; ++i)
  {
    const double e = std::exp(u);
    const double step = (-std::expm1(u) + b * u) / (b - e);
    u -= step;
    if (std::fabs(step) <= 1e-13 * std::fabs(u))
    {
      break;
    }
  }
  return std::exp(u);
}

double randomWaveLossRate(double ratio, double period)
{
  const double r = std::min(ratio, 1.0);
  return r > 0.0 ? 2.0 / period * brokenShare(r) / (r * r) : 0.0;
}

double ruessinkGamma(double wavenumber, double depth)
{
  return 0.76 * wavenumber * depth + 0.29;
}

double higherShare(double ratio)
{
  return ratio > 0.0 ? std::exp(-1.0 / (ratio * ratio)) : 0.0;
}

double baldockLossRate(double ratio, double heightOverDepth, double period)
{
  if (!(ratio > 0.0))
  {
    return 0.0;
  }
  const double r = 1.0 / ratio;
  const double root = std::sqrt(Pi);
  const double share = 4.0 / (3.0 * root) * r * (r * r + 1.5) * std::exp(-r * r) + std::erfc(r);
  return 1.5 * root * heightOverDepth / period * share;
}

double iribarrenNumber(double slope, double height, double period, double gravity)
{
  const double deepLength = gravity * period * period / (2.0 * Pi);
  return slope / std::sqrt(height / deepLength);
}

BreakerType breakerType(double iribarrenOffshore)
{
  return iribarrenOffshore < 0.5 ? BreakerType::Spilling
    : iribarrenOffshore <= 3.3   ? BreakerType::Plunging
                                 : BreakerType::Surging;
}

BreakerType breakerTypeAtBreaking(double iribarrenBreaking)
{
  return iribarrenBreaking < 0.4 ? BreakerType::Spilling
    : iribarrenBreaking <= 2.0   ? BreakerType::Plunging
                                 : BreakerType::Surging;
}

double frictionRate(
  double frictionFactor, double height, double wavenumber, double depth, double period, double gravity)
{
  const double velocityOverHeight = Pi / (period * std::sinh(wavenumber * depth));
  return 16.0 / (3.0 * Pi) * frictionFactor * height * velocityOverHeight * velocityOverHeight * velocityOverHeight /
    gravity;
}

double laminarFrictionRate(double viscosity, double wavenumber, double depth, double period, double gravity)
{
  const double omega = 2.0 * Pi / period;
  const double velocityOverAmplitude = omega / std::sinh(wavenumber * depth);
  return velocityOverAmplitude * velocityOverAmplitude / gravity * std::sqrt(0.5 * viscosity * omega);
}

}
