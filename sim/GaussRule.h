#pragma once

#include <array>

namespace swellray
{

/** Gauss-Legendre nodes and weights on [-1, 1], 5 points (Abramowitz and Stegun 1964, table 25.4). */
constexpr std::array<double, 5> GaussNode{ -0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
  0.9061798459386640 };
constexpr std::array<double, 5> GaussWeight{ 0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
  0.4786286704993665, 0.2369268850561891 };

/** Integral of a smooth function from a to b by one panel of the rule: exact for polynomials up to degree 9. */
template <typename Function>
double gaussPanel(double a, double b, const Function& function)
{
  const double middle = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  double sum = 0.0;
  for (std::size_t i = 0; i < GaussNode.size(); ++i)
  {
    sum += GaussWeight[i] * function(middle + half * GaussNode[i]);
  }
  return half * sum;
}

}
