#include "sim/Caustic.h"

#include "sim/Airy.h"
#include "sim/Angles.h"

#include <cmath>

namespace swellray
{

namespace
{

// Below this phase between the branches the Bessel functions lose digits to their own powers, rad.
constexpr double SmallestPhase = 1e-12;

// Beyond it the branches are rays to 1e-4, rad.
constexpr double LargestPhase = 1e3;

// Half phase from which on the modulus is taken from its series.
constexpr double LargeHalf = 20.0;

// Ai(0) = 3^(-2/3)/Gamma(2/3); Bi(0) is the root of 3 times it, so that their modulus is twice it.
constexpr double AiryAtZero = 0.355028053887817239;

// Fourth power of c = (2 sqrt(pi) Ai(0)/(Gamma(5/4) (2/pi)^(1/2) 24^(1/4) sqrt(2)))^3 = 0.17184.
constexpr double CuspRounding = 8.718942320745e-04;

}

std::complex<double> foldWave(const FoldBranch& before, const FoldBranch& behind)
{
  const double half = 0.5 * (behind.phase - before.phase);
  if (!(half > SmallestPhase) || half > LargestPhase)
  {
    return std::polar(before.amplitude, before.phase) + std::polar(behind.amplitude, behind.phase - 0.5 * Pi);
  }
  FoldField field;
  field.z = std::cbrt(2.25 * half * half);
  const double root = std::sqrt(std::sqrt(field.z));
  field.sum = (before.amplitude + behind.amplitude) * root;
  field.difference = (before.amplitude - behind.amplitude) / root;
  field.middle = 0.5 * (before.phase + behind.phase);
  return foldWave(field);
}

std::complex<double> foldWave(const FoldField& field)
{
  const AiryValue ai = airy(-field.z);
  return std::sqrt(Pi) * std::polar(1.0, field.middle - 0.25 * Pi) *
    std::complex<double>(field.sum * ai.value, -field.difference * ai.slope);
}

double foldModulus(double half)
{
  if (half > LargeHalf)
  {
    // Abramowitz and Stegun 1964, eq. 9.2.28.
    const double inverse = 1.0 / (36.0 * half * half);
    return std::sqrt(1.0 - inverse * (2.5 - inverse * 144.375));
  }
  const double j = std::cyl_bessel_j(1.0 / 3.0, half);
  const double y = half > 0.0 ? std::cyl_neumann(1.0 / 3.0, half) : 0.0;
  return std::sqrt(0.5 * Pi * half * (j * j + y * y));
}

double roundedCurvature(const RayCaustic& caustic)
{
  const double rate = caustic.alongRate * caustic.alongRate;
  const double change = 2.0 * std::abs(caustic.alongChange);
  const double turn = caustic.fanWavenumber * caustic.widthRate * caustic.widthRate;
  const double rounding = CuspRounding * change * change * change * 2.0 / turn;
  return std::abs(caustic.widthRate) / std::sqrt(std::sqrt(rate * rate + rounding));
}

double foldPeak(const RayCaustic& caustic, double curvature)
{
  const double scale = std::pow(0.5 * caustic.fanWavenumber * curvature * curvature, 1.0 / 6.0);
  return 2.0 * std::sqrt(Pi) * AiryAtZero * scale / std::sqrt(std::abs(caustic.widthRate) / caustic.scale);
}

}
