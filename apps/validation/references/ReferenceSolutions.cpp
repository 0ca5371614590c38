#include "ReferenceSolutions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swellray::reference
{

namespace
{

// Gauss-Legendre rule on [-1, 1] by Newton's method on the Legendre polynomial.
struct Rule
{
  static constexpr int Points = 16;
  std::array<Real, Points> node{};
  std::array<Real, Points> weight{};

  Rule()
  {
    for (int i = 0; i < Points; ++i)
    {
      Real z = std::cos(Pi * (i + 0.75L) / (Points + 0.5L));
      Real slope = 1.0L;
      for (int iteration = 0; iteration < 20; ++iteration)
      {
        Real last = 1.0L;
        Real value = z;
        for (int n = 2; n <= Points; ++n)
        {
          last = std::exchange(value, ((2.0L * n - 1.0L) * z * value - (n - 1.0L) * last) / n);
        }
        slope = Points * (z * value - last) / (z * z - 1.0L);
        z -= value / slope;
      }
      this->node[i] = z;
      this->weight[i] = 2.0L / ((1.0L - z * z) * slope * slope);
    }
  }
};

using Sum = std::array<Real, 4>;

Sum quadrature(const Integrand& f, Real from, Real to)
{
  static const Rule rule;
  const Real half = 0.5L * (to - from);
  Sum sum{};
  for (int i = 0; i < Rule::Points; ++i)
  {
    const Sum value = f(from + half * (1.0L + rule.node[i]));
    for (std::size_t j = 0; j < sum.size(); ++j)
    {
      sum[j] += half * rule.weight[i] * value[j];
    }
  }
  return sum;
}

Sum refine(const Integrand& f, Real from, Real to, const Sum& whole, const Sum& error, int depth)
{
  const Real middle = 0.5L * (from + to);
  const Sum left = quadrature(f, from, middle);
  const Sum right = quadrature(f, middle, to);
  Sum sum{};
  bool good = true;
  for (std::size_t j = 0; j < sum.size(); ++j)
  {
    sum[j] = left[j] + right[j];
    good = good && std::abs(sum[j] - whole[j]) <= error[j];
  }
  if (good || depth == 0)
  {
    return sum;
  }
  const Sum a = refine(f, from, middle, left, error, depth - 1);
  const Sum b = refine(f, middle, to, right, error, depth - 1);
  for (std::size_t j = 0; j < sum.size(); ++j)
  {
    sum[j] = a[j] + b[j];
  }
  return sum;
}

// Phase speed and its derivatives by the depth.
struct PhaseSpeed
{
  double c = 0.0;
  double h = 0.0;
  double hh = 0.0;
  double k = 0.0;
  double group = 0.0;

  PhaseSpeed(double omega, double depth)
  {
    k = static_cast<double>(wavenumber(omega, depth));
    const double q = k * depth;
    const double T = std::tanh(q);
    const double s = 1.0 - T * T;
    const double D = T + q * s;
    const double kh = -k * k * s / D;
    const double qh = k * T / D;
    const double sh = -2.0 * T * s * qh;
    const double Dh = 2.0 * s * (1.0 - q * T) * qh;
    const double khh = -(2.0 * k * kh * s + k * k * sh) / D + k * k * s * Dh / (D * D);
    c = omega / k;
    h = -c * kh / k;
    hh = c * (2.0 * kh * kh / (k * k) - khh / k);
    group = 0.5 * c * (1.0 + q * s / T);
  }
};

// x, y, theta, q, p, S, t.
using State = std::array<double, 7>;

struct Rates
{
  State rate{};
  PhaseSpeed speed;
  Jet depth;
};

Rates ratesAt(const Formula& formula, double omega, const State& s, unsigned region)
{
  const Jet x(s[0], 1.0, 0.0, 0.0, 0.0, 0.0);
  const Jet y(s[1], 0.0, 1.0, 0.0, 0.0, 0.0);
  const Jet h = formula.depth(x, y, region);
  const PhaseSpeed v(omega, h.value);
  const double tx = std::cos(s[2]);
  const double ty = std::sin(s[2]);
  const double hn = -ty * h.x + tx * h.y;
  const double hnn = ty * ty * h.xx - 2.0 * tx * ty * h.xy + tx * tx * h.yy;
  const double cnn = v.h * hnn + v.hh * hn * hn;
  return { { tx, ty, -v.h * hn / v.c, v.c * s[4], -cnn / (v.c * v.c) * s[3], v.k, 1.0 / v.group }, v, h };
}

State rungeKutta(const Formula& formula, double omega, const State& s, unsigned region, double step)
{
  const auto shifted = [&s](const State& rate, double by)
  {
    State result = s;
    for (std::size_t i = 0; i < s.size(); ++i)
    {
      result[i] += by * rate[i];
    }
    return result;
  };
  const State k1 = ratesAt(formula, omega, s, region).rate;
  const State k2 = ratesAt(formula, omega, shifted(k1, 0.5 * step), region).rate;
  const State k3 = ratesAt(formula, omega, shifted(k2, 0.5 * step), region).rate;
  const State k4 = ratesAt(formula, omega, shifted(k3, step), region).rate;
  State result = s;
  for (std::size_t i = 0; i < s.size(); ++i)
  {
    result[i] += step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  }
  return result;
}

void crossKink(const Formula& formula, double omega, State& s, unsigned& region, unsigned crossed)
{
  for (unsigned i = 0; i < formula.kinks.size(); ++i)
  {
    if ((crossed >> i & 1u) == 0)
    {
      continue;
    }
    const Rates before = ratesAt(formula, omega, s, region);
    region ^= 1u << i;
    const Rates after = ratesAt(formula, omega, s, region);
    const Jet level = formula.kinks[i](Jet(s[0], 1.0, 0.0, 0.0, 0.0, 0.0), Jet(s[1], 0.0, 1.0, 0.0, 0.0, 0.0));
    const double tx = std::cos(s[2]);
    const double ty = std::sin(s[2]);
    const double size = std::copysign(std::hypot(level.x, level.y), tx * level.x + ty * level.y);
    const double nx = level.x / size;
    const double ny = level.y / size;
    const double jump = after.speed.h * (after.depth.x * nx + after.depth.y * ny) -
      before.speed.h * (before.depth.x * nx + before.depth.y * ny);
    const double across = -ty * nx + tx * ny;
    const double c = before.speed.c;
    s[4] -= jump * across * across * s[3] / (c * c * (tx * nx + ty * ny));
  }
}

}

Real wavenumber(Real omega, Real depth)
{
  const Real y = omega * omega * depth / Gravity;
  // q = y + sqrt(y) is above the root of the convex function q tanh q = y.
  Real q = std::max(y, std::sqrt(y));
  for (int i = 0; i < 100; ++i)
  {
    const Real t = std::tanh(q);
    const Real change = (q * t - y) / (t + q * (1.0L - t * t));
    q -= change;
    if (std::abs(change) < 1e-10L * q)
    {
      break; // the next change would be its square
    }
  }
  return q / depth;
}

Real groupSpeed(Real omega, Real depth)
{
  const Real k = wavenumber(omega, depth);
  return 0.5L * omega / k * (1.0L + 2.0L * k * depth / std::sinh(2.0L * k * depth));
}

Real depthOf(Real omega, Real k)
{
  return std::atanh(omega * omega / (Gravity * k)) / k;
}

Real wavenumberSlope(Real omega, Real depth)
{
  const Real k = wavenumber(omega, depth);
  const Real t = std::tanh(k * depth);
  const Real s = 1.0L - t * t;
  return -k * k * s / (t + k * depth * s);
}

std::array<Real, 4> integrate(const Integrand& f, Real from, Real to)
{
  if (from == to)
  {
    return {};
  }
  // Far below what is asked of the rays; halved panels of this order converge at a stroke.
  constexpr Real accuracy = 1e-15L;
  constexpr int deepest = 40;
  const Sum whole = quadrature(f, from, to);
  Sum error{};
  for (std::size_t j = 0; j < whole.size(); ++j)
  {
    error[j] = accuracy * std::abs(whole[j]);
  }
  return refine(f, from, to, whole, error, deepest);
}

StraightRay::StraightRay(std::function<Real(Real)> depth, double omega, double x0, double theta0)
  : Depth(std::move(depth))
  , Omega(omega)
  , X0(x0)
  , Along(wavenumber(omega, this->Depth(x0)) * std::sin(static_cast<Real>(theta0)))
{
}

Place StraightRay::at(double x) const
{
  const auto sums = integrate(
    [this](Real u) -> Sum
    {
      const Real h = this->Depth(u);
      const Real k = wavenumber(this->Omega, h);
      const Real normal = std::sqrt(k * k - this->Along * this->Along);
      return { this->Along / normal, k * k / normal, k / (groupSpeed(this->Omega, h) * normal), k / normal };
    },
    x, this->X0);
  const auto cosine = [this](Real u)
  {
    const Real sine = this->Along / wavenumber(this->Omega, this->Depth(u));
    return std::sqrt(1.0L - sine * sine);
  };
  Place place;
  place.x = x;
  place.y = static_cast<double>(sums[0]);
  place.theta = static_cast<double>(Pi - std::asin(this->Along / wavenumber(this->Omega, this->Depth(x))));
  place.phase = static_cast<double>(sums[1]);
  place.time = static_cast<double>(sums[2]);
  place.length = static_cast<double>(sums[3]);
  place.width = static_cast<double>(cosine(x) / cosine(this->X0));
  return place;
}

double StraightRay::fanWidth(double x) const
{
  // dy/dK = int k^2/kx^3 dx, dK/dtheta0 = kx at the start; theta0 turns clockwise, so the width is to the right.
  const auto sums = integrate(
    [this](Real u) -> Sum
    {
      const Real k = wavenumber(this->Omega, this->Depth(u));
      const Real normal = std::sqrt(k * k - this->Along * this->Along);
      return { k * k / (normal * normal * normal), 1.0L, 1.0L, 1.0L };
    },
    x, this->X0);
  const auto normal = [this](Real u)
  {
    const Real k = wavenumber(this->Omega, this->Depth(u));
    return std::sqrt(k * k - this->Along * this->Along);
  };
  return static_cast<double>(sums[0] * normal(this->X0) * normal(x) / wavenumber(this->Omega, this->Depth(x)));
}

CircularRay::CircularRay(std::function<Real(Real)> depth, double omega, double x0, double b, double kink)
  : Depth(std::move(depth))
  , Omega(omega)
  , X0(x0)
  , B(b)
  , Kink(kink)
{
  const Real start = std::hypot(this->X0, this->B);
  this->Momentum = wavenumber(this->Omega, this->Depth(start)) * this->B;
  if (this->Momentum != 0.0L)
  {
    // The first radius on the way in at which k r has fallen to the momentum.
    const auto inside = [this](Real r)
    { return wavenumber(this->Omega, this->Depth(r)) * r < std::abs(this->Momentum); };
    constexpr int parts = 4000;
    Real high = start;
    Real low = start;
    for (int i = 1; i < parts && !inside(low); ++i)
    {
      high = low;
      low = start * (parts - i) / parts;
      if (!(this->Depth(low) > 0.0L))
      {
        return; // the shore comes first
      }
    }
    for (int i = 0; i < 200; ++i)
    {
      const Real middle = 0.5L * (low + high);
      (inside(middle) ? low : high) = middle;
    }
    this->Nearest = high;
  }
}

std::array<Real, 4> CircularRay::way(Real radius) const
{
  // r = nearest + w^2 takes the root out of the turning point.
  const auto integrand = [this](Real w) -> Sum
  {
    const Real r = this->Nearest + w * w;
    const Real h = this->Depth(r);
    const Real k = wavenumber(this->Omega, h);
    const Real f = (k * r - this->Momentum) * (k * r + this->Momentum);
    const Real scale = 2.0L * w / std::sqrt(f);
    return { this->Momentum / r * scale, k * r * scale, k * k * r * scale, k * r / groupSpeed(this->Omega, h) * scale };
  };
  const Real from = std::sqrt(std::max(0.0L, radius - this->Nearest));
  const Real to = std::sqrt(std::hypot(this->X0, this->B) - this->Nearest);
  if (!(this->Kink > std::max(radius, this->Nearest)))
  {
    return integrate(integrand, from, to);
  }
  const Real kink = std::sqrt(this->Kink - this->Nearest);
  Sum sum = integrate(integrand, from, kink);
  const Sum rest = integrate(integrand, kink, to);
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    sum[i] += rest[i];
  }
  return sum;
}

Place CircularRay::at(double radius, bool outward) const
{
  Sum sums = this->way(radius);
  if (outward)
  {
    const Sum whole = this->way(this->Nearest);
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] = 2.0L * whole[i] - sums[i];
    }
  }
  // Heading +x at (x0, b) the angular momentum x ky - y kx is -k b: phi falls for b > 0.
  const Real phi = std::atan2(this->B, this->X0) - sums[0];
  const Real sine = this->Momentum / (wavenumber(this->Omega, this->Depth(radius)) * radius);
  const Real alpha = std::asin(std::clamp(sine, -1.0L, 1.0L)); // from the radial line
  Place place;
  place.x = static_cast<double>(radius * std::cos(phi));
  place.y = static_cast<double>(radius * std::sin(phi));
  place.theta = static_cast<double>(outward ? phi - alpha : phi + Pi + alpha);
  place.length = static_cast<double>(sums[1]);
  place.phase = static_cast<double>(sums[2]);
  place.time = static_cast<double>(sums[3]);
  return place;
}

unsigned Formula::region(double x, double y) const
{
  unsigned bits = 0;
  for (unsigned i = 0; i < this->kinks.size(); ++i)
  {
    bits |= this->kinks[i](Jet(x), Jet(y)).value > 0.0 ? 1u << i : 0u;
  }
  return bits;
}

Jet depthFormula(double omega, const Jet& k)
{
  return atanh(Jet(omega * omega / static_cast<double>(Gravity)) / k) / k;
}

FormulaSeafloor::FormulaSeafloor(Formula formula, const Rectangle& bounds, double featureLength)
  : Depth(std::move(formula))
  , Bounds(bounds)
  , FeatureLength(featureLength)
{
}

void FormulaSeafloor::evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const
{
  const Jet h = this->Depth.depth(Jet(p.x, 1.0, 0.0, 0.0, 0.0, 0.0), Jet(p.y, 0.0, 1.0, 0.0, 0.0, 0.0), region);
  bed.elevation = -h.value;
  bed.gradient = { -h.x, -h.y };
  bed.xx = -h.xx;
  bed.xy = -h.xy;
  bed.yy = -h.yy;
}

double FormulaSeafloor::kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const
{
  const Jet level = this->Depth.kinks[i](Jet(p.x, 1.0, 0.0, 0.0, 0.0, 0.0), Jet(p.y, 0.0, 1.0, 0.0, 0.0, 0.0));
  gradient = { level.x, level.y };
  return level.value;
}

std::vector<Place> traceMunkArthur(
  const Formula& formula, double omega, const Place& start, const std::vector<double>& lengths, double step)
{
  State s{ start.x, start.y, start.theta, 1.0, 0.0, 0.0, 0.0 };
  unsigned region = formula.region(start.x, start.y);
  double length = 0.0;
  int caustics = 0;
  std::vector<Place> places;
  for (const double wanted : lengths)
  {
    while (length < wanted)
    {
      const double parts = std::ceil((wanted - length) / step);
      double advance = (wanted - length) / parts;
      State next = rungeKutta(formula, omega, s, region, advance);
      unsigned crossed = formula.region(next[0], next[1]) ^ region;
      const bool last = parts == 1.0 && crossed == 0;
      if (crossed != 0)
      {
        double low = 0.0;
        double high = advance;
        for (int halving = 0; halving < 60; ++halving)
        {
          const double middle = 0.5 * (low + high);
          const State there = rungeKutta(formula, omega, s, region, middle);
          ((formula.region(there[0], there[1]) ^ region) != 0 ? high : low) = middle;
        }
        advance = high;
        next = rungeKutta(formula, omega, s, region, advance);
        crossed = formula.region(next[0], next[1]) ^ region;
      }
      if ((next[3] < 0.0) != (s[3] < 0.0))
      {
        ++caustics;
      }
      s = next;
      length = last ? wanted : length + advance;
      crossKink(formula, omega, s, region, crossed);
    }
    places.push_back({ s[0], s[1], s[2], s[5], s[6], length, s[3], caustics });
  }
  return places;
}

}
