#pragma once

#include <cmath>

namespace swellray::reference
{

/**
 * A function of x and y with its gradient and Hessian: formulas written with it bring their own exact derivatives.
 */
struct Jet
{
  double value = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;

  Jet() = default;
  Jet(double constant) // not explicit: constants mix freely with jets in a formula
    : value(constant)
  {
  }
  Jet(double v, double gx, double gy, double hxx, double hxy, double hyy)
    : value(v)
    , x(gx)
    , y(gy)
    , xx(hxx)
    , xy(hxy)
    , yy(hyy)
  {
  }
};

/** f(u), of the value of f and its first two derivatives at u. */
inline Jet chain(const Jet& u, double f, double f1, double f2)
{
  return { f, f1 * u.x, f1 * u.y, f2 * u.x * u.x + f1 * u.xx, f2 * u.x * u.y + f1 * u.xy, f2 * u.y * u.y + f1 * u.yy };
}

inline Jet operator+(const Jet& a, const Jet& b)
{
  return { a.value + b.value, a.x + b.x, a.y + b.y, a.xx + b.xx, a.xy + b.xy, a.yy + b.yy };
}

inline Jet operator-(const Jet& a)
{
  return { -a.value, -a.x, -a.y, -a.xx, -a.xy, -a.yy };
}

inline Jet operator-(const Jet& a, const Jet& b)
{
  return a + (-b);
}

inline Jet operator*(const Jet& a, const Jet& b)
{
  return { a.value * b.value, a.x * b.value + a.value * b.x, a.y * b.value + a.value * b.y,
    a.xx * b.value + 2.0 * a.x * b.x + a.value * b.xx, a.xy * b.value + a.x * b.y + a.y * b.x + a.value * b.xy,
    a.yy * b.value + 2.0 * a.y * b.y + a.value * b.yy };
}

inline Jet inverse(const Jet& a)
{
  const double i = 1.0 / a.value;
  return chain(a, i, -i * i, 2.0 * i * i * i);
}

inline Jet operator/(const Jet& a, const Jet& b)
{
  return a * inverse(b);
}

inline Jet pow(const Jet& a, double power)
{
  const double f = std::pow(a.value, power);
  return chain(a, f, power * f / a.value, power * (power - 1.0) * f / (a.value * a.value));
}

inline Jet sqrt(const Jet& a)
{
  return pow(a, 0.5);
}

inline Jet exp(const Jet& a)
{
  const double f = std::exp(a.value);
  return chain(a, f, f, f);
}

inline Jet atanh(const Jet& a)
{
  const double i = 1.0 / (1.0 - a.value * a.value);
  return chain(a, std::atanh(a.value), i, 2.0 * a.value * i * i);
}

}
