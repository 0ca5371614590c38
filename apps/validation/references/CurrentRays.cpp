#include "CurrentRays.h"

#include <cmath>
#include <utility>

namespace swellray::reference
{

namespace
{

Real omegaOf(const CurrentScene& scene)
{
  return 2.0L * Pi / scene.period;
}

/** The frequency of waves on still water, rad/s. */
Real frequency(Real k, Real depth)
{
  return std::sqrt(Gravity * k * std::tanh(k * depth));
}

/** Largest radius or x at which a level has fallen to 0, between `from` where it is positive and `to`. */
template <typename Level>
Real firstRoot(const Level& level, Real from, Real to)
{
  constexpr int parts = 4000;
  Real before = from;
  Real after = from;
  for (int i = 1; i <= parts && level(after) > 0.0L; ++i)
  {
    before = after;
    after = from + (to - from) * i / parts;
  }
  for (int i = 0; i < 200; ++i)
  {
    const Real middle = 0.5L * (before + after);
    (level(middle) > 0.0L ? before : after) = middle;
  }
  return before;
}

}

FormulaCurrent::FormulaCurrent(Component u, Component v, double featureLength)
  : U(std::move(u))
  , V(std::move(v))
  , FeatureLength(featureLength)
{
}

void FormulaCurrent::evaluate(const glm::dvec2& p, CurrentSample& sample) const
{
  const Jet x(p.x, 1.0, 0.0, 0.0, 0.0, 0.0);
  const Jet y(p.y, 0.0, 1.0, 0.0, 0.0, 0.0);
  const Jet u = this->U(x, y);
  const Jet v = this->V(x, y);
  sample.velocity = { u.value, v.value };
  sample.dx = { u.x, v.x };
  sample.dy = { u.y, v.y };
  sample.dxx = { u.xx, v.xx };
  sample.dxy = { u.xy, v.xy };
  sample.dyy = { u.yy, v.yy };
}

Real wavenumberOnCurrent(const CurrentScene& scene, Real u)
{
  const Real omega = omegaOf(scene);
  Real k = wavenumber(omega, scene.depth);
  for (int i = 0; i < 200; ++i)
  {
    const Real sigma = frequency(k, scene.depth);
    const Real change = (sigma + k * u - omega) / (groupSpeed(sigma, scene.depth) + u);
    k -= change;
    if (std::abs(change) < 1e-17L * k)
    {
      break;
    }
  }
  return k;
}

JetRay::JetRay(const CurrentScene& scene, double speed, double width, double from, double angle)
  : Scene(scene)
  , Omega(omegaOf(scene))
  , Speed(speed)
  , Width(width)
  , From(from)
{
  const Real sine = std::sin(static_cast<Real>(angle) * Pi / 180.0L);
  this->Ky = wavenumberOnCurrent(scene, sine * this->current(this->From)) * sine;
  const auto level = [this](Real x)
  {
    const Real sigma = this->Omega - this->Ky * this->current(x);
    return sigma > 0.0L ? wavenumber(sigma, this->Scene.depth) - std::abs(this->Ky) : -1.0L;
  };
  // The jet is strongest at x = 0: a ray that comes so far crosses it.
  if (!(level(0.0L) > 0.0L))
  {
    this->Turns = true;
    this->Turning = firstRoot(level, this->From, 0.0L);
  }
}

Real JetRay::current(Real x) const
{
  const Real t = x / this->Width;
  return this->Speed * std::exp(-t * t);
}

JetRay::Rates JetRay::rates(Real x) const
{
  Rates r{};
  r.sigma = this->Omega - this->Ky * this->current(x);
  r.k = wavenumber(r.sigma, this->Scene.depth);
  r.kx = std::sqrt((r.k - this->Ky) * (r.k + this->Ky));
  r.group = groupSpeed(r.sigma, this->Scene.depth);
  r.vx = r.group * r.kx / r.k;
  r.vy = r.group * this->Ky / r.k + this->current(x);
  return r;
}

double JetRay::heading() const
{
  const Rates start = this->rates(this->From);
  return static_cast<double>(std::atan2(start.vy, start.vx));
}

std::array<Real, 4> JetRay::way(Real x) const
{
  const auto integrand = [this](Real u) -> std::array<Real, 4>
  {
    const Rates r = this->rates(u);
    return { r.vy / r.vx, 1.0L / r.vx, r.kx + this->Ky * r.vy / r.vx, std::hypot(r.vx, r.vy) / r.vx };
  };
  if (!this->Turns)
  {
    return integrate(integrand, this->From, x);
  }
  // x = turning - w^2 takes the root out of the turning point.
  const auto turning = [&](Real w)
  {
    std::array<Real, 4> rates = integrand(this->Turning - w * w);
    for (Real& rate : rates)
    {
      rate *= 2.0L * w;
    }
    return rates;
  };
  return integrate(turning, std::sqrt(this->Turning - x), std::sqrt(this->Turning - this->From));
}

Place JetRay::at(Real x, bool back) const
{
  std::array<Real, 4> sums = this->way(x);
  if (back)
  {
    const auto whole = this->way(this->Turning);
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] = 2.0L * whole[i] - sums[i];
    }
  }
  const Rates here = this->rates(x);
  const Rates start = this->rates(this->From);
  const Real sign = back ? -1.0L : 1.0L;
  Place place;
  place.x = static_cast<double>(x);
  place.y = static_cast<double>(sums[0]);
  place.theta = static_cast<double>(std::atan2(this->Ky, sign * here.kx));
  place.time = static_cast<double>(sums[1]);
  place.phase = static_cast<double>(sums[2]);
  place.length = static_cast<double>(sums[3]);
  place.width =
    static_cast<double>(sign * here.vx / std::hypot(here.vx, here.vy) / (start.vx / std::hypot(start.vx, start.vy)));
  place.caustics = back ? 1 : 0;
  place.wavenumber = static_cast<double>(here.k);
  place.height = static_cast<double>(std::sqrt(here.sigma * start.vx / (start.sigma * here.vx)));
  return place;
}

EddyRay::EddyRay(const CurrentScene& scene, double speed, double radius, double from, double b)
  : Scene(scene)
  , Omega(omegaOf(scene))
  , Speed(speed)
  , Radius(radius)
  , From(from)
  , B(b)
{
  const Real start = std::hypot(this->From, this->B);
  const Real t = start / this->Radius;
  const Real rotation = this->Speed / this->Radius * std::exp(0.5L * (1.0L - t * t));
  // Along +x the current is -rotation y.
  this->Momentum = -this->B * wavenumberOnCurrent(scene, -rotation * this->B);
  this->Nearest = firstRoot(
    [this](Real r)
    {
      const Rates at = this->rates(r);
      return at.k - std::abs(at.kphi);
    },
    start, start * 1e-6L);
}

EddyRay EddyRay::moved(double by) const
{
  return { this->Scene, static_cast<double>(this->Speed), static_cast<double>(this->Radius),
    static_cast<double>(this->From), static_cast<double>(this->B) + by };
}

EddyRay::Rates EddyRay::rates(Real r) const
{
  Rates at{};
  const Real t = r / this->Radius;
  at.rotation = this->Speed / this->Radius * std::exp(0.5L * (1.0L - t * t));
  at.kphi = this->Momentum / r;
  at.sigma = this->Omega - this->Momentum * at.rotation;
  at.k = wavenumber(at.sigma, this->Scene.depth);
  at.kr = std::sqrt((at.k - at.kphi) * (at.k + at.kphi));
  at.group = groupSpeed(at.sigma, this->Scene.depth);
  return at;
}

std::array<Real, 4> EddyRay::way(Real w) const
{
  return integrate(
    [this](Real u) -> std::array<Real, 4>
    {
      const Real r = this->Nearest + u * u;
      const Rates at = this->rates(r);
      const Real dt = 2.0L * u * at.k / (at.group * at.kr);
      const Real across = at.group * at.kphi / at.k + r * at.rotation;
      return { across / r * dt, dt, (at.k * at.group + this->Momentum * at.rotation) * dt,
        std::hypot(at.group * at.kr / at.k, across) * dt };
    },
    std::abs(w), -this->start());
}

Place EddyRay::place(Real w) const
{
  std::array<Real, 4> sums = this->way(w);
  if (w > 0.0L)
  {
    const auto whole = this->way(0.0L);
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] = 2.0L * whole[i] - sums[i];
    }
  }
  const Real r = this->Nearest + w * w;
  const Real phi = std::atan2(this->B, this->From) + sums[0];
  const Rates at = this->rates(r);
  Place place;
  place.x = static_cast<double>(r * std::cos(phi));
  place.y = static_cast<double>(r * std::sin(phi));
  place.theta = static_cast<double>(phi + std::atan2(at.kphi, w > 0.0L ? at.kr : -at.kr));
  place.time = static_cast<double>(sums[1]);
  place.phase = static_cast<double>(sums[2]);
  place.length = static_cast<double>(sums[3]);
  place.wavenumber = static_cast<double>(at.k);
  return place;
}

Place EddyRay::at(Real w) const
{
  Place place = this->place(w);
  // Neighbours at the same w, of order 4 in their distance: 1e-11 of the width at half a metre.
  constexpr double apart = 0.5;
  const auto beside = [&](int steps) { return this->moved(steps * apart).place(w); };
  const Place a = beside(-2);
  const Place b = beside(-1);
  const Place c = beside(1);
  const Place d = beside(2);
  const double dx = (8.0 * (c.x - b.x) - (d.x - a.x)) / (12.0 * apart);
  const double dy = (8.0 * (c.y - b.y) - (d.y - a.y)) / (12.0 * apart);
  struct Flux
  {
    Real vx;
    Real vy;
    Real sigma;
  };
  const auto flux = [this](Real r, const Place& at) -> Flux
  {
    const Rates rates = this->rates(r);
    return { rates.group * std::cos(static_cast<Real>(at.theta)) - rates.rotation * at.y,
      rates.group * std::sin(static_cast<Real>(at.theta)) + rates.rotation * at.x, rates.sigma };
  };
  Place first;
  first.x = static_cast<double>(this->From);
  first.y = static_cast<double>(this->B);
  const Flux here = flux(this->Nearest + w * w, place);
  const Flux start = flux(std::hypot(this->From, this->B), first);
  // |V| times the width: V x dx.
  const Real tube = here.vx * dy - here.vy * dx;
  place.width = static_cast<double>(tube / std::hypot(here.vx, here.vy));
  place.height = static_cast<double>(std::sqrt(here.sigma / start.sigma * std::abs(start.vx / tube)));
  return place;
}

CollinearRay::CollinearRay(const CurrentScene& scene, double speed, double middle, double width, double from)
  : Scene(scene)
  , Speed(speed)
  , Middle(middle)
  , Width(width)
  , From(from)
{
}

double CollinearRay::current(double x) const
{
  return static_cast<double>(0.5L * this->Speed * (1.0L + std::tanh((x - this->Middle) / this->Width)));
}

FormulaCurrent CollinearRay::formula() const
{
  const auto speed = static_cast<double>(this->Speed);
  const auto middle = static_cast<double>(this->Middle);
  const auto width = static_cast<double>(this->Width);
  // (1 + tanh t)/2 = 1/(1 + exp(-2t)).
  return { [=](const Jet& x, const Jet&) { return speed * inverse(Jet(1.0) + exp(-2.0 / width * (x - middle))); },
    [](const Jet&, const Jet&) { return Jet(0.0); }, width };
}

Place CollinearRay::at(Real x) const
{
  struct Wave
  {
    Real k;
    Real sigma;
    Real speed;
  };
  const auto waveAt = [this](Real u) -> Wave
  {
    const Real current = 0.5L * this->Speed * (1.0L + std::tanh((u - this->Middle) / this->Width));
    const Real k = wavenumberOnCurrent(this->Scene, current);
    const Real sigma = frequency(k, this->Scene.depth);
    return { k, sigma, groupSpeed(sigma, this->Scene.depth) + current };
  };
  const auto sums = integrate(
    [&](Real u) -> std::array<Real, 4>
    {
      const Wave wave = waveAt(u);
      return { 1.0L / wave.speed, wave.k, 1.0L, 1.0L };
    },
    this->From, x);
  const Wave here = waveAt(x);
  const Wave start = waveAt(this->From);
  Place place;
  place.x = static_cast<double>(x);
  place.time = static_cast<double>(sums[0]);
  place.phase = static_cast<double>(sums[1]);
  place.length = static_cast<double>(x - this->From);
  place.wavenumber = static_cast<double>(here.k);
  place.height = static_cast<double>(std::sqrt(here.sigma / start.sigma * start.speed / here.speed));
  return place;
}

}
