#include "sim/Airy.h"

#include "sim/Angles.h"

#include <cmath>

namespace swellray
{

namespace
{

// Ai(0) = 3^(-2/3)/Gamma(2/3), -Ai'(0) = 3^(-1/3)/Gamma(1/3).
constexpr double AtZero = 0.355028053887817239;
constexpr double SlopeAtZero = -0.258819403792806798;

constexpr double Third = 1.0 / 3.0;

// J of order -n.
double besselOfNegativeOrder(double n, double x)
{
  return std::cos(n * Pi) * std::cyl_bessel_j(n, x) - std::sin(n * Pi) * std::cyl_neumann(n, x);
}

AiryValue series(double x)
{
  // Ai = Ai(0) f + Ai'(0) g with f = 1 + x^3/(2.3) + ..., g = x + x^4/(3.4) + ...
  constexpr int terms = 10;
  const double cube = x * x * x;
  double f = 1.0;
  double g = x;
  double fSlope = 0.5 * x * x;
  double gSlope = 1.0;
  AiryValue sum;
  for (int i = 1; i <= terms; ++i)
  {
    const double n = 3.0 * i;
    sum.value += AtZero * f + SlopeAtZero * g;
    sum.slope += AtZero * fSlope + SlopeAtZero * gSlope;
    f *= cube / ((n - 1.0) * n);
    g *= cube / (n * (n + 1.0));
    fSlope *= cube / (n * (n + 2.0));
    gSlope *= cube / ((n - 2.0) * n);
  }
  return sum;
}

}

AiryValue airy(double x)
{
  if (std::abs(x) < 1.0)
  {
    return series(x);
  }
  const double z = std::abs(x);
  const double root = std::sqrt(z);
  const double half = 2.0 * Third * z * root;
  if (x > 0.0)
  {
    return { std::sqrt(z * Third) / Pi * std::cyl_bessel_k(Third, half),
      -z / (Pi * std::sqrt(3.0)) * std::cyl_bessel_k(2.0 * Third, half) };
  }
  return { root * Third * (std::cyl_bessel_j(Third, half) + besselOfNegativeOrder(Third, half)),
    z * Third * (std::cyl_bessel_j(2.0 * Third, half) - besselOfNegativeOrder(2.0 * Third, half)) };
}

}
