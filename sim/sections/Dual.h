#pragma once

#include <cmath>

namespace swellray
{

/**
 * A number with its rate of change by one variable: arithmetic on it differentiates exactly (forward mode; Clifford
 * 1873). Functions of a section are written once and give their derivative along.
 */
struct Dual
{
  double value = 0.0;
  double rate = 0.0;

  constexpr Dual() = default;
  constexpr Dual(double number, double change = 0.0)
    : value(number)
    , rate(change)
  {
  }
};

constexpr Dual operator-(const Dual& a)
{
  return { -a.value, -a.rate };
}

constexpr Dual operator+(const Dual& a, const Dual& b)
{
  return { a.value + b.value, a.rate + b.rate };
}

constexpr Dual operator-(const Dual& a, const Dual& b)
{
  return { a.value - b.value, a.rate - b.rate };
}

constexpr Dual operator*(const Dual& a, const Dual& b)
{
  return { a.value * b.value, a.rate * b.value + a.value * b.rate };
}

constexpr Dual operator*(double a, const Dual& b)
{
  return { a * b.value, a * b.rate };
}

constexpr Dual operator*(const Dual& a, double b)
{
  return { a.value * b, a.rate * b };
}

constexpr Dual operator/(const Dual& a, double b)
{
  return { a.value / b, a.rate / b };
}

/** Sine and cosine at once. */
struct SineCosine
{
  Dual sine;
  Dual cosine;
};

inline SineCosine sineCosine(const Dual& a)
{
  const double s = std::sin(a.value);
  const double c = std::cos(a.value);
  return { { s, c * a.rate }, { c, -s * a.rate } };
}

/** a to a constant power, a >= 0; the rate is 0 where the power's is not defined (a = 0 below the first power). */
inline Dual power(const Dual& a, double exponent)
{
  if (exponent == 1.0)
  {
    return a;
  }
  if (!(a.value > 0.0))
  {
    return { exponent == 0.0 ? 1.0 : 0.0, 0.0 };
  }
  const double value = std::pow(a.value, exponent);
  return { value, exponent * value / a.value * a.rate };
}

}
