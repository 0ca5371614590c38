#include "sim/DirectionalSpreading.h"

#include "sim/Angles.h"
#include "sim/GaussRule.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

void requireSpread(double spread)
{
  if (!(spread > radians(1.0) * (1.0 - 1e-12) && spread <= radians(80.0) * (1.0 + 1e-12)))
  {
    throw std::invalid_argument(
      "the directional spread must be within 1 to 80 degrees, not " + std::to_string(degrees(spread)));
  }
}

double cosineNorm(double s)
{
  return std::exp((2.0 * s - 1.0) * std::log(2.0) + 2.0 * std::lgamma(s + 1.0) - std::lgamma(2.0 * s + 1.0)) / Pi;
}

double wrapped(double angle)
{
  return std::remainder(angle, 2.0 * Pi);
}

}

DirectionalSpreading DirectionalSpreading::cosinePower(double spread)
{
  requireSpread(spread);
  DirectionalSpreading spreading;
  spreading.Exponent = 2.0 / (spread * spread) - 1.0;
  return spreading;
}

DirectionalSpreading DirectionalSpreading::wrappedNormal(double spread)
{
  requireSpread(spread);
  DirectionalSpreading spreading;
  spreading.Shape = SpreadingShape::WrappedNormal;
  spreading.Deviation = std::sqrt(-2.0 * std::log(1.0 - 0.5 * spread * spread));
  return spreading;
}

DirectionalSpreading DirectionalSpreading::hasselmann(double peakFrequency, HasselmannExponent exponent)
{
  if (!(peakFrequency > 0.0 && std::isfinite(peakFrequency)))
  {
    throw std::invalid_argument("the peak frequency must be above 0, not " + std::to_string(peakFrequency));
  }
  DirectionalSpreading spreading;
  spreading.Shape = SpreadingShape::Hasselmann;
  spreading.Peak = peakFrequency;
  spreading.BelowPeak = exponent == HasselmannExponent::Hasselmann1980 ? 6.97 : 9.77;
  return spreading;
}

double DirectionalSpreading::exponent(double frequency) const
{
  if (this->Shape != SpreadingShape::Hasselmann)
  {
    return this->Exponent;
  }
  const double x = frequency / this->Peak;
  return x < 1.0 ? this->BelowPeak * std::pow(x, 4.06) : 9.77 * std::pow(x, -2.34);
}

double DirectionalSpreading::density(double frequency, double angle) const
{
  const double a = wrapped(angle);
  if (this->Shape == SpreadingShape::WrappedNormal)
  {
    // Turns beyond the third add nothing up to 80 degrees.
    double sum = 0.0;
    for (int turn = -3; turn <= 3; ++turn)
    {
      const double t = (a + 2.0 * Pi * turn) / this->Deviation;
      sum += std::exp(-0.5 * t * t);
    }
    return sum / (std::sqrt(2.0 * Pi) * this->Deviation);
  }
  const double s = this->exponent(frequency);
  return cosineNorm(s) * std::pow(std::abs(std::cos(0.5 * a)), 2.0 * s);
}

double DirectionalSpreading::share(double frequency, double from, double to) const
{
  // Panels of a third of the narrowest feature, 1 degree, would do anywhere; wide distributions need fewer.
  const double panel = std::max(this->spread(frequency) / 3.0, radians(0.3));
  const int count = std::max(1, static_cast<int>(std::ceil((to - from) / panel)));
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double a = from + (to - from) * i / count;
    const double b = from + (to - from) * (i + 1) / count;
    sum += gaussPanel(a, b, [&](double angle) { return this->density(frequency, angle); });
  }
  return sum;
}

double DirectionalSpreading::spread(double frequency) const
{
  if (this->Shape == SpreadingShape::WrappedNormal)
  {
    return std::sqrt(2.0 * (1.0 - std::exp(-0.5 * this->Deviation * this->Deviation)));
  }
  return std::sqrt(2.0 / (this->exponent(frequency) + 1.0));
}

}
