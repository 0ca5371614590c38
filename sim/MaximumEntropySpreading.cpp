#include "sim/MaximumEntropySpreading.h"

#include "sim/Angles.h"

#include <cmath>
#include <stdexcept>

namespace swellray
{

MaximumEntropySpreading::MaximumEntropySpreading(double r1, double angle1, double r2, double angle2)
{
  const std::complex<double> c1 = std::polar(r1, angle1);
  const std::complex<double> c2 = std::polar(r2, 2.0 * angle2);
  const double rest = 1.0 - std::norm(c1);
  this->First = (c1 - c2 * std::conj(c1)) / rest;
  this->Second = c2 - c1 * this->First;
  const std::complex<double> scale = 1.0 - this->First * std::conj(c1) - this->Second * std::conj(c2);
  this->Scale = scale.real() / (2.0 * Pi);
  // Of a positive-definite pair of moments: |c1| < 1 and |c2 - c1^2| < 1 - |c1|^2.
  if (!(r1 >= 0.0 && r2 >= 0.0 && rest > 0.0 && std::abs(c2 - c1 * c1) < rest && this->Scale > 0.0))
  {
    throw std::invalid_argument("no distribution of directions has such moments");
  }
}

double MaximumEntropySpreading::density(double angle) const
{
  const std::complex<double> turn = std::polar(1.0, -angle);
  return this->Scale / std::norm(1.0 - this->First * turn - this->Second * turn * turn);
}

std::vector<double> MaximumEntropySpreading::shares(const std::vector<double>& middles) const
{
  // The distribution may be narrow: enough points that the sum over the circle is the integral.
  constexpr int Points = 64;
  const double width = 2.0 * Pi / static_cast<double>(middles.size());
  std::vector<double> shares(middles.size(), 0.0);
  double sum = 0.0;
  for (std::size_t j = 0; j < middles.size(); ++j)
  {
    for (int i = 0; i < Points; ++i)
    {
      shares[j] += this->density(middles[j] + width * ((i + 0.5) / Points - 0.5));
    }
    sum += shares[j];
  }
  for (double& share : shares)
  {
    share /= sum;
  }
  return shares;
}

}
