#include "sim/Dispersion.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

void requirePositive(const char* name, const char* unit, double value, bool infinityAllowed)
{
  if (value > 0.0 && (infinityAllowed || value <= std::numeric_limits<double>::max()))
  {
    return;
  }
  std::ostringstream message;
  message << name << " must be " << (infinityAllowed ? "" : "finite and ") << "above 0 " << unit << ", not " << value;
  throw std::invalid_argument(message.str());
}

}

double solveWavenumber(double omega, double depth, double gravity)
{
  requirePositive("angular frequency", "rad/s", omega, false);
  requirePositive("depth", "m", depth, true);
  requirePositive("gravity", "m/s2", gravity, false);

  const double deep = omega * omega / gravity;
  const double y = deep * depth; // = q tanh q
  if (y > 50.0)
  {
    return deep; // tanh q is 1 to the last bit
  }
  const double x = omega * std::sqrt(depth / gravity); // = sqrt(y)
  if (x < 1e-4)
  {
    return x * (1.0 + x * x / 6.0) / depth; // next term: 11 x^4/360
  }

  // First guess to 0.75 %: Guo 2002, Simple and explicit solution of wave dispersion equation, Coastal Eng. 45, eq. 10.
  constexpr double beta = 2.4908;
  double q = y * std::pow(-std::expm1(-std::pow(x, beta)), -1.0 / beta);
  // Newton from there: errors below 3e-5, 1e-9, rounding.
  for (int i = 0; i < 3; ++i)
  {
    const double t = std::tanh(q);
    q -= (q * t - y) / (t + q * (1.0 - t * t));
  }
  return q / depth;
}

WaveSpeeds waveSpeeds(double wavenumber, double depth, double gravity)
{
  const double q = wavenumber * depth;
  WaveSpeeds speeds;
  speeds.phaseSpeed = std::sqrt(gravity * std::tanh(q) / wavenumber);
  // 2q/sinh(2q) = 4 q e/(1 - e^2) with e = exp(-2q): nothing is left of it at q = 200, an infinite depth included.
  const double bounded = std::min(q, 200.0);
  const double e = std::exp(-2.0 * bounded);
  const double ratio = -4.0 * bounded * e / (std::expm1(-2.0 * bounded) * (1.0 + e));
  speeds.groupRatio = 0.5 * (1.0 + ratio);
  speeds.groupSpeed = speeds.groupRatio * speeds.phaseSpeed;
  return speeds;
}

}
