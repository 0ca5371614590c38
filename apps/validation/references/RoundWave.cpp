#include "RoundWave.h"

#include <algorithm>
#include <cmath>

namespace swellray::reference
{

namespace
{

constexpr int Steps = 6000;
constexpr double Innermost = 1e-4; // of the radius

// Modes beyond the momentum of the outermost ray that meets the round part.
constexpr double MoreModes = 14.0;

}

RoundWave::RoundWave(const Profile& k, const Profile& p, double radius)
  : Radius(radius)
  , K0(k(radius))
  , First(std::log(Innermost * radius))
  , StepSize(-std::log(Innermost) / Steps)
{
  // r k and p at whole and half steps.
  std::vector<double> momentum;
  std::vector<double> weight;
  for (int i = 0; i <= 2 * Steps; ++i)
  {
    const double r = std::exp(this->First + 0.5 * this->StepSize * i);
    momentum.push_back(r * k(r));
    weight.push_back(p(r));
  }
  const double x = this->K0 * radius;
  const int last = static_cast<int>(x + MoreModes);
  for (int m = 0; m <= last; ++m)
  {
    // f and p df/dln r.
    Mode mode;
    double f = 1.0;
    double g = weight.front() * m;
    const double order = m;
    const auto rate = [&](int i, double value)
    { return weight[i] * (order * order - momentum[i] * momentum[i]) * value; };
    for (int i = 0; i <= Steps; ++i)
    {
      mode.value.push_back(f);
      mode.slope.push_back(g / weight[2 * i]);
      if (i == Steps)
      {
        break;
      }
      const double h = this->StepSize;
      const int a = 2 * i;
      const double f1 = g / weight[a];
      const double g1 = rate(a, f);
      const double f2 = (g + 0.5 * h * g1) / weight[a + 1];
      const double g2 = rate(a + 1, f + 0.5 * h * f1);
      const double f3 = (g + 0.5 * h * g2) / weight[a + 1];
      const double g3 = rate(a + 1, f + 0.5 * h * f2);
      const double f4 = (g + h * g3) / weight[a + 2];
      const double g4 = rate(a + 2, f + h * f3);
      f += h / 6.0 * (f1 + 2.0 * f2 + 2.0 * f3 + f4);
      g += h / 6.0 * (g1 + 2.0 * g2 + 2.0 * g3 + g4);
    }
    const double whole = mode.value.back();
    for (std::size_t i = 0; i < mode.value.size(); ++i)
    {
      mode.value[i] /= whole;
      mode.slope[i] /= whole;
    }
    const double ratio = mode.slope.back();
    const std::complex<double> hankel(std::cyl_bessel_j(order, x), std::cyl_neumann(order, x));
    const std::complex<double> next(std::cyl_bessel_j(order + 1.0, x), std::cyl_neumann(order + 1.0, x));
    const std::complex<double> hankelSlope = order * hankel - x * next; // by ln r
    mode.outside = (ratio * hankel.real() - hankelSlope.real()) / (hankelSlope - ratio * hankel);
    mode.inside = hankel.real() + mode.outside * hankel;
    this->Modes.push_back(std::move(mode));
  }
}

std::complex<double> RoundWave::at(double x, double y) const
{
  const double r = std::hypot(x, y);
  const double phi = std::atan2(y, x);
  // Outside the incident wave is whole; inside all modes are known.
  std::complex<double> sum = r > this->Radius ? std::polar(1.0, this->K0 * x) : 0.0;
  std::complex<double> turn = 1.0; // i^m
  // In the very middle there is but the first.
  const std::size_t count = r > Innermost * this->Radius ? this->Modes.size() : 1;
  for (std::size_t m = 0; m < count; ++m)
  {
    const Mode& mode = this->Modes[m];
    std::complex<double> f;
    if (r > this->Radius)
    {
      const double order = static_cast<double>(m);
      f = mode.outside *
        std::complex<double>(std::cyl_bessel_j(order, this->K0 * r), std::cyl_neumann(order, this->K0 * r));
    }
    else
    {
      const double place =
        std::max(0.0, (std::log(std::max(r, Innermost * this->Radius)) - this->First) / this->StepSize);
      const auto i = std::min(static_cast<std::size_t>(place), mode.value.size() - 2);
      const double u = place - static_cast<double>(i);
      const double v = 1.0 - u;
      f = mode.inside *
        (v * v * ((1.0 + 2.0 * u) * mode.value[i] + u * this->StepSize * mode.slope[i]) +
          u * u * ((3.0 - 2.0 * u) * mode.value[i + 1] - v * this->StepSize * mode.slope[i + 1]));
    }
    sum += (m == 0 ? 1.0 : 2.0) * turn * f * std::cos(static_cast<double>(m) * phi);
    turn *= std::complex<double>(0.0, 1.0);
  }
  return sum;
}

}
