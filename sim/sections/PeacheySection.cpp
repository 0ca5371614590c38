#include "sim/sections/PeacheySection.h"

namespace swellray
{

namespace
{

constexpr double DeepRatio = 1.0 / 4.0;
constexpr double ShallowRatio = 1.0 / 20.0;

// Mean of cos(2 pi u^p) over [0, 1]: the integral of its power series, term by term.
double meanOfCosine(double p)
{
  constexpr double square = 4.0 * Pi * Pi;
  double term = 1.0;
  double sum = 0.0;
  for (int m = 0; m < 40; ++m)
  {
    sum += term / (2.0 * m * p + 1.0);
    term *= -square / ((2.0 * m + 1.0) * (2.0 * m + 2.0));
  }
  return sum;
}

// Mean of 8 (u^p - 1/2)^2 - 1 over [0, 1].
double meanOfSharp(double p)
{
  return 8.0 * (1.0 / (2.0 * p + 1.0) - 1.0 / (p + 1.0) + 0.25) - 1.0;
}

}

PeacheySection::PeacheySection(const Parameters& parameters)
  : Values(parameters)
{
  for (std::size_t i = 0; i < this->CosineMeans.size(); ++i)
  {
    this->CosineMeans[i] = meanOfCosine(1.0 + parameters.asymmetry * static_cast<double>(i) / TableSize);
  }
}

double PeacheySection::cosineMean(double power) const
{
  if (!(this->Values.asymmetry > 0.0))
  {
    return this->CosineMeans[0];
  }
  const double at = (power - 1.0) / this->Values.asymmetry * TableSize;
  const auto i = static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(TableSize)));
  return this->CosineMeans[i] + (at - static_cast<double>(i)) * (this->CosineMeans[i + 1] - this->CosineMeans[i]);
}

double PeacheySection::power(double depthRatio) const
{
  const double t = std::clamp((DeepRatio - depthRatio) / (DeepRatio - ShallowRatio), 0.0, 1.0);
  return 1.0 + this->Values.asymmetry * t * t * (3.0 - 2.0 * t);
}

Dual PeacheySection::profile(const Dual& u, double sharpness, double exponent) const
{
  const Dual v = swellray::power(u, exponent);
  const Dual round = sineCosine(2.0 * Pi * v).cosine - this->cosineMean(exponent);
  const Dual fromMiddle = v - 0.5;
  const Dual sharp = 8.0 * (fromMiddle * fromMiddle) - 1.0 - meanOfSharp(exponent);
  return (1.0 - sharpness) * round + sharpness * sharp;
}

}
