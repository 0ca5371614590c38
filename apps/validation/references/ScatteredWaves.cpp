#include "ScatteredWaves.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace swellray::reference
{

namespace
{

using Complex = std::complex<double>;

constexpr double PiHere = 3.14159265358979323846;
constexpr std::size_t Steps = 6000;
// The innermost radius over the rim's: orders are as of constant depth inside.
constexpr double Innermost = 1e-3;

struct Coefficients
{
  double k;
  double flux; // C Cg
};

Coefficients coefficientsOf(double depth, double omega, double gravity)
{
  // Newton on g k tanh kh = omega^2 from above both limits.
  double k = std::max(omega * omega / gravity, omega / std::sqrt(gravity * depth));
  for (int i = 0; i < 60; ++i)
  {
    const double t = std::tanh(k * depth);
    const double f = gravity * k * t - omega * omega;
    k -= f / (gravity * (t + k * depth * (1.0 - t * t)));
  }
  const double q = 2.0 * k * depth;
  const double c = omega / k;
  return { k, 0.5 * c * c * (1.0 + q / std::sinh(q)) };
}

// One step of Runge and Kutta of u' = a(x) v, v' = b(x) u with a and b at both ends and the middle.
struct Sides
{
  std::array<double, 3> a;
  std::array<double, 3> b;
};

void advance(const Sides& s, double h, double& u, double& v)
{
  const double u1 = s.a[0] * v;
  const double v1 = s.b[0] * u;
  const double u2 = s.a[1] * (v + 0.5 * h * v1);
  const double v2 = s.b[1] * (u + 0.5 * h * u1);
  const double u3 = s.a[1] * (v + 0.5 * h * v2);
  const double v3 = s.b[1] * (u + 0.5 * h * u2);
  const double u4 = s.a[2] * (v + h * v3);
  const double v4 = s.b[2] * (u + h * u3);
  u += h / 6.0 * (u1 + 2.0 * u2 + 2.0 * u3 + u4);
  v += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
}

// Integral of exp(i t^2) from a to infinity.
Complex fresnel(double a)
{
  const double size = std::abs(a);
  const int parts = 2 * static_cast<int>(50.0 + 40.0 * size * size);
  const double h = size / parts;
  Complex sum = 0.0;
  for (int i = 0; i <= parts; ++i)
  {
    const double t = h * i;
    sum += std::polar(i == 0 || i == parts ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0), t * t);
  }
  const Complex toA = std::copysign(h / 3.0, a) * sum;
  return 0.5 * std::sqrt(PiHere) * std::polar(1.0, 0.25 * PiHere) - toA;
}

}

PartialWaves::PartialWaves(const std::function<double(double)>& depth, double rim, double period, double gravity)
  : Rim(rim)
{
  const double omega = 2.0 * PiHere / period;
  const Coefficients outside = coefficientsOf(depth(2.0 * rim), omega, gravity);
  this->K0 = outside.k;
  this->LowestLog = std::log(Innermost * rim);
  this->Step = -std::log(Innermost) / static_cast<double>(Steps);
  // At the steps and between them.
  std::vector<double> radius(2 * Steps + 1);
  std::vector<Coefficients> inside(2 * Steps + 1);
  double largest = outside.k * rim;
  for (std::size_t i = 0; i <= 2 * Steps; ++i)
  {
    radius[i] = std::exp(this->LowestLog + 0.5 * this->Step * static_cast<double>(i));
    inside[i] = coefficientsOf(depth(std::min(radius[i], rim * (1.0 - 1e-12))), omega, gravity);
    largest = std::max(largest, inside[i].k * radius[i]);
  }
  const int orders = static_cast<int>(largest + 6.0 * std::cbrt(largest) + 8.0);
  for (int m = 0; m <= orders; ++m)
  {
    Order order;
    const auto coefficient = [&](std::size_t i)
    {
      const double kr = inside[i].k * radius[i];
      return inside[i].flux * (m * m - kr * kr);
    };
    double u = 1.0;
    const double kr = inside[0].k * radius[0];
    double v = inside[0].flux * (m - kr * kr / (2.0 * (m + 1.0)));
    for (std::size_t i = 0; i <= Steps; ++i)
    {
      order.value.push_back(u);
      order.slope.push_back(v / inside[2 * i].flux);
      if (i < Steps)
      {
        advance({ { 1.0 / inside[2 * i].flux, 1.0 / inside[2 * i + 1].flux, 1.0 / inside[2 * i + 2].flux },
                  { coefficient(2 * i), coefficient(2 * i + 1), coefficient(2 * i + 2) } },
          this->Step, u, v);
      }
    }
    // u c = J + a H, v c = p r (J' + a H') at the rim.
    const double q = this->K0 * rim;
    const auto bessel = [&](int n) { return std::cyl_bessel_j(std::abs(n), q) * (n < 0 && n % 2 != 0 ? -1.0 : 1.0); };
    const auto neumann = [&](int n) { return std::cyl_neumann(std::abs(n), q) * (n < 0 && n % 2 != 0 ? -1.0 : 1.0); };
    const double j = bessel(m);
    const double dj = 0.5 * (bessel(m - 1) - bessel(m + 1)) * q;
    const Complex h(j, neumann(m));
    const Complex dh(dj, 0.5 * (neumann(m - 1) - neumann(m + 1)) * q);
    const double slope = v / outside.flux;
    order.outer = (slope * j - u * dj) / (u * dh - slope * h);
    order.inner = (j + order.outer * h) / u;
    this->Orders.push_back(std::move(order));
  }
}

std::complex<double> PartialWaves::at(double x, double y) const
{
  const double r = std::hypot(x, y);
  const double angle = std::atan2(y, x);
  Complex sum = 0.0;
  Complex power = 1.0; // i^m
  for (std::size_t m = 0; m < this->Orders.size(); ++m)
  {
    const Order& order = this->Orders[m];
    Complex radial;
    if (r >= this->Rim)
    {
      // The incident wave is added as a whole.
      const auto n = static_cast<double>(m);
      radial = order.outer * Complex(std::cyl_bessel_j(n, this->K0 * r), std::cyl_neumann(n, this->K0 * r));
    }
    else
    {
      const double place =
        std::clamp((std::log(std::max(r, 1e-300)) - this->LowestLog) / this->Step, 0.0, static_cast<double>(Steps));
      const std::size_t i = std::min(static_cast<std::size_t>(place), Steps - 1);
      const double s = place - static_cast<double>(i);
      const double t = 1.0 - s;
      const double value = t * t * (1.0 + 2.0 * s) * order.value[i] + s * s * (1.0 + 2.0 * t) * order.value[i + 1] +
        this->Step * (t * t * s * order.slope[i] - s * s * t * order.slope[i + 1]);
      const double below = r * std::exp(-this->LowestLog);
      radial = order.inner * value * (below < 1.0 ? std::pow(below, static_cast<double>(m)) : 1.0);
    }
    sum += (m == 0 ? 1.0 : 2.0) * power * radial * std::cos(static_cast<double>(m) * angle);
    power *= Complex(0.0, 1.0);
  }
  return r >= this->Rim ? sum + std::polar(1.0, this->K0 * x) : sum;
}

std::complex<double> halfPlaneWave(double k, double x, double y)
{
  // Angles from the wall, anticlockwise as seen with the wall along the positive axis: the wave comes from 3 pi/2 or pi/2.
  const double r = std::hypot(x, y);
  double angle = std::atan2(-y, -x);
  angle = angle < 0.0 ? angle + 2.0 * PiHere : angle;
  const double from = 0.5 * PiHere;
  Complex sum = 0.0;
  for (const double side : { -1.0, 1.0 })
  {
    const double away = angle + side * from;
    const double a = -std::sqrt(2.0 * k * r) * std::cos(0.5 * away);
    sum += std::polar(1.0, -k * r * std::cos(away)) * fresnel(a);
  }
  return std::polar(1.0 / std::sqrt(PiHere), -0.25 * PiHere) * sum;
}

std::vector<double> foldedWave(const std::function<double(double)>& depth, double period, double gravity, double ky,
  double shadow, const std::vector<double>& places)
{
  const double omega = 2.0 * PiHere / period;
  const auto sidesAt = [&](double from, double to)
  {
    Sides sides{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Coefficients c = coefficientsOf(depth(from + 0.5 * static_cast<double>(i) * (to - from)), omega, gravity);
      sides.a[i] = 1.0 / c.flux;
      sides.b[i] = c.flux * (ky * ky - c.k * c.k);
    }
    return sides;
  };
  const Coefficients start = coefficientsOf(depth(shadow), omega, gravity);
  double u = 1.0;
  double v = -start.flux * std::sqrt(ky * ky - start.k * start.k);
  double x = shadow;
  std::vector<double> values(places.size());
  const auto goTo = [&](double to)
  {
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(to - x) / 0.1)));
    const double h = (to - x) / parts;
    for (int i = 0; i < parts; ++i)
    {
      advance(sidesAt(x, x + h), h, u, v);
      x += h;
    }
  };
  for (std::size_t i = places.size(); i-- > 0;)
  {
    goTo(places[i]);
    values[i] = u;
  }
  goTo(0.0);
  const auto momentum = [&](double at)
  {
    const Coefficients c = coefficientsOf(depth(at), omega, gravity);
    return c.flux * std::sqrt(c.k * c.k - ky * ky);
  };
  const Coefficients c = coefficientsOf(depth(0.0), omega, gravity);
  const double kx = std::sqrt(c.k * c.k - ky * ky);
  const double change = (momentum(1e-3) - momentum(-1e-3)) / (2e-3 * 2.0 * momentum(0.0));
  const Complex incoming = 0.5 * (u + (v / c.flux + change * u) / Complex(0.0, kx));
  for (double& value : values)
  {
    value = std::abs(value / incoming);
  }
  return values;
}

}
