#include "sim/AmplitudeDispersion.h"

#include <cmath>

namespace swellray
{

namespace
{

// Beyond this kh the hyperbolic functions of D are its limit to rounding, and may not overflow.
constexpr double DeepWater = 12.0;

double frequencySquared(double k, double depth, double amplitude, double gravity)
{
  const double q = k * depth;
  const double e = k * amplitude;
  double d = 1.0;
  double f2 = 0.0;
  const double tanh = std::tanh(q);
  if (q < DeepWater)
  {
    const double sinh = std::sinh(q);
    d = (std::cosh(4.0 * q) + 8.0 - 2.0 * tanh * tanh) / (8.0 * sinh * sinh * sinh * sinh);
    f2 = std::pow(q / sinh, 4);
  }
  return gravity * k * (1.0 + std::pow(tanh, 5) * e * e * d) * std::tanh(q + f2 * e);
}

}

double finiteAmplitudeWavenumber(double omega, double depth, double amplitude, double gravity)
{
  const double linear = solveWavenumber(omega, depth, gravity);
  if (!(amplitude > 0.0))
  {
    return linear;
  }
  const double wanted = omega * omega;
  double low = 0.0;
  double high = linear;
  double lowError = -wanted;
  double highError = frequencySquared(high, depth, amplitude, gravity) - wanted;
  // False position, the end that stays weighted down (Dowell and Jarratt 1971, "Illinois").
  for (int i = 0; i < 100 && std::fabs(high - low) > 1e-15 * linear; ++i)
  {
    const double k = (low * highError - high * lowError) / (highError - lowError);
    const double error = frequencySquared(k, depth, amplitude, gravity) - wanted;
    if (std::fabs(error) <= 1e-14 * wanted)
    {
      return k;
    }
    if ((error < 0.0) == (highError < 0.0))
    {
      lowError *= 0.5;
    }
    else
    {
      low = high;
      lowError = highError;
    }
    high = k;
    highError = error;
  }
  return high;
}

}
