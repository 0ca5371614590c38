#include "sim/Caustic.h"

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

// J of negative order -n.
double besselOfNegativeOrder(double n, double x)
{
  return std::cos(n * Pi) * std::cyl_bessel_j(n, x) - std::sin(n * Pi) * std::cyl_neumann(n, x);
}

}

std::complex<double> foldWave(const FoldBranch& before, const FoldBranch& behind)
{
  const double half = 0.5 * (behind.phase - before.phase);
  if (!(half > SmallestPhase) || half > LargestPhase)
  {
    return std::polar(before.amplitude, before.phase) + std::polar(behind.amplitude, behind.phase - 0.5 * Pi);
  }
  // Ai(-z) and Ai'(-z) by Bessel functions of the third order (Abramowitz and Stegun 1964, eqs. 10.4.15, 10.4.17).
  const double z = std::cbrt(2.25 * half * half);
  const double airy =
    std::sqrt(z) / 3.0 * (std::cyl_bessel_j(1.0 / 3.0, half) + besselOfNegativeOrder(1.0 / 3.0, half));
  const double slope = z / 3.0 * (std::cyl_bessel_j(2.0 / 3.0, half) - besselOfNegativeOrder(2.0 / 3.0, half));
  const double root = std::sqrt(std::sqrt(z));
  const std::complex<double> wave(
    (before.amplitude + behind.amplitude) * root * airy, (behind.amplitude - before.amplitude) / root * slope);
  return std::sqrt(Pi) * std::polar(1.0, 0.5 * (before.phase + behind.phase) - 0.25 * Pi) * wave;
}

}
