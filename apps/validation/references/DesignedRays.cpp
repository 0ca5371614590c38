#include "DesignedRays.h"

#include "RayComparison.h"

#include <cmath>

namespace swellray::reference
{

namespace
{

using Wavenumber = std::function<Jet(const Jet& x, const Jet& y, unsigned region)>;
using Path = std::function<Real(Real)>;

struct Setting
{
  double omega;
  double k0;
  double angle;

  explicit Setting(const Design& d)
    : omega(2.0 * swellray::Pi / d.period)
    , k0(static_cast<double>(wavenumber(omega, d.depth)))
    , angle(radians(d.angle))
  {
  }
};

DesignedRay designed(
  const Design& d, const Wavenumber& k, const Rectangle& bounds, double feature, Neighbours neighbours)
{
  DesignedRay ray;
  const double omega = 2.0 * swellray::Pi / d.period;
  ray.formula.depth = [omega, k](const Jet& x, const Jet& y, unsigned region)
  { return depthFormula(omega, k(x, y, region)); };
  ray.bounds = bounds;
  ray.feature = feature;
  ray.period = d.period;
  ray.neighbours = neighbours;
  return ray;
}

Jet radius(const Jet& x, const Jet& y)
{
  return sqrt(x * x + y * y);
}

/** Time along a path of which k and ds are known, by quadrature over its parameter. */
double timeAlong(double omega, double from, double to, const Path& k, const Path& ds)
{
  const auto sums = integrate(
    [&](Real at) -> std::array<Real, 4> {
      return { ds(at) / groupSpeed(omega, depthOf(omega, k(at))), 1.0L, 1.0L, 1.0L };
    },
    from, to);
  return static_cast<double>(sums[0]);
}

// Width of a tube of turned rays: n.(z x r) = t.r, over its value at the start.
double turnedWidth(const Place& place, double r0, double heading)
{
  return (std::cos(place.theta) * place.x + std::sin(place.theta) * place.y) / (r0 * std::cos(heading));
}

}

RayStart DesignedRay::start(const RayMedium& medium) const
{
  if (this->neighbours == Neighbours::Parallel)
  {
    return startHeading(medium, this->position, this->heading, { 0.0, 1.0 / std::cos(this->heading) });
  }
  RayStart start;
  start.position = this->position;
  start.wavenumber = wavenumberAt(medium, start.position, this->heading);
  // A turn by 1/(r0 cos heading) moves the ray sideways by one.
  const bool fan = this->neighbours == Neighbours::Fan;
  const double turn = fan ? 1.0 : 1.0 / (this->position.x * std::cos(this->heading));
  start.dPosition = { 0.0, fan ? 0.0 : this->position.x * turn };
  start.dWavenumber = { -start.wavenumber.y * turn, start.wavenumber.x * turn };
  return start;
}

DesignedRay circleRay(const Design& d)
{
  const Setting s(d);
  const double x0 = d.length;
  DesignedRay ray = designed(
    d, [k0 = s.k0, x0](const Jet& x, const Jet&, unsigned) { return k0 * x0 / x; },
    { { 1e-3 * x0, -5.0 * x0 }, { 1.1 * x0, 5.0 * x0 } }, 0.1 * x0, Neighbours::Parallel);
  ray.position = { x0, 0.0 };
  ray.heading = swellray::Pi - s.angle;
  const double r = x0 / std::sin(s.angle);
  for (int i = 1; i <= 20; ++i)
  {
    const double theta = s.angle * (1.0 - 0.045 * i);
    Place place;
    place.x = r * std::sin(theta);
    place.y = r * (std::cos(theta) - std::cos(s.angle));
    place.theta = swellray::Pi - theta;
    place.length = r * (s.angle - theta);
    place.phase = s.k0 * x0 * std::log(std::tan(0.5 * s.angle) / std::tan(0.5 * theta));
    place.time = timeAlong(
      s.omega, theta, s.angle, [&](Real at) { return s.k0 * x0 / (r * std::sin(at)); },
      [&](Real) -> Real { return r; });
    place.width = std::cos(theta) / std::cos(s.angle);
    ray.places.push_back(place);
  }
  return ray;
}

DesignedRay cycloidRay(const Design& d)
{
  const Setting s(d);
  const double x0 = d.length;
  DesignedRay ray = designed(
    d, [k0 = s.k0, x0](const Jet& x, const Jet&, unsigned) { return k0 * std::sqrt(x0) / sqrt(x); },
    { { 1e-3 * x0, -5.0 * x0 }, { 1.1 * x0, 5.0 * x0 } }, 0.1 * x0, Neighbours::Parallel);
  ray.position = { x0, 0.0 };
  ray.heading = swellray::Pi - s.angle;
  const double sine = std::sin(s.angle);
  const double D = x0 / (sine * sine);
  for (int i = 1; i <= 20; ++i)
  {
    // x = D sin^2 theta: ds = 2 D sin theta dtheta, k = k0 sin theta0/sin theta.
    const double theta = s.angle * (1.0 - 0.045 * i);
    Place place;
    place.x = D * std::sin(theta) * std::sin(theta);
    place.y = 0.5 * D * (2.0 * (s.angle - theta) - std::sin(2.0 * s.angle) + std::sin(2.0 * theta));
    place.theta = swellray::Pi - theta;
    place.length = 2.0 * D * (std::cos(theta) - std::cos(s.angle));
    place.phase = 2.0 * D * s.k0 * sine * (s.angle - theta);
    place.time = timeAlong(
      s.omega, theta, s.angle, [&](Real at) { return s.k0 * sine / std::sin(at); },
      [&](Real at) { return 2.0L * D * std::sin(at); });
    place.width = std::cos(theta) / std::cos(s.angle);
    ray.places.push_back(place);
  }
  return ray;
}

DesignedRay spiralRay(const Design& d)
{
  const Setting s(d);
  const double r0 = d.length;
  DesignedRay ray = designed(
    d, [k0 = s.k0, r0](const Jet& x, const Jet& y, unsigned) { return k0 * r0 / radius(x, y); },
    { { -1.1 * r0, -1.1 * r0 }, { 1.1 * r0, 1.1 * r0 } }, 0.05 * r0, Neighbours::Turned);
  ray.position = { r0, 0.0 };
  ray.heading = swellray::Pi - s.angle;
  for (int i = 1; i <= 24; ++i)
  {
    const double r = r0 * std::exp(-0.1 * i);
    const double phi = std::tan(s.angle) * std::log(r0 / r);
    Place place;
    place.x = r * std::cos(phi);
    place.y = r * std::sin(phi);
    place.theta = ray.heading + phi;
    place.length = (r0 - r) / std::cos(s.angle);
    place.phase = s.k0 * r0 * std::log(r0 / r) / std::cos(s.angle);
    place.time = timeAlong(
      s.omega, r, r0, [&](Real at) { return s.k0 * r0 / at; }, [&](Real) -> Real { return 1.0 / std::cos(s.angle); });
    place.width = turnedWidth(place, r0, ray.heading);
    ray.places.push_back(place);
  }
  return ray;
}

DesignedRay islandParabolaRay(const Design& d)
{
  const Setting s(d);
  const double r0 = d.length;
  DesignedRay ray = designed(
    d, [k0 = s.k0, r0](const Jet& x, const Jet& y, unsigned) { return k0 * std::sqrt(r0) / sqrt(radius(x, y)); },
    { { -1.2 * r0, -1.2 * r0 }, { 1.2 * r0, 1.2 * r0 } }, 0.05 * r0, Neighbours::Turned);
  ray.position = { r0, 0.0 };
  ray.heading = swellray::Pi - s.angle;
  const double rt = r0 * std::sin(s.angle) * std::sin(s.angle);
  // r = rt/cos^2 u, u from -u0 = -(pi/2 - angle); phi = 2 (u + u0): ds = 2 rt/cos^3 u du, k = k0 sqrt(r0/rt) cos u.
  const double u0 = 0.5 * swellray::Pi - s.angle;
  const auto lengthTo = [&](double at)
  { return rt * (std::sin(at) / (std::cos(at) * std::cos(at)) + std::asinh(std::tan(at))); };
  for (int i = 1; i <= 25; ++i)
  {
    const double u = -u0 + 0.077 * i * u0; // to nearly r0 on the other side, past the caustic where t.r = 0
    const double r = rt / (std::cos(u) * std::cos(u));
    const double phi = 2.0 * (u + u0);
    Place place;
    place.x = r * std::cos(phi);
    place.y = r * std::sin(phi);
    place.theta = phi + 0.5 * swellray::Pi - u;
    place.length = lengthTo(u) - lengthTo(-u0);
    place.phase = 2.0 * s.k0 * std::sqrt(r0 * rt) * (std::tan(u) + std::tan(u0));
    place.time = timeAlong(
      s.omega, -u0, u, [&](Real at) { return s.k0 * std::sqrt(r0 / rt) * std::cos(at); },
      [&](Real at)
      {
        const Real cosine = std::cos(at);
        return 2.0L * rt / (cosine * cosine * cosine);
      });
    place.width = turnedWidth(place, r0, ray.heading);
    place.caustics = u > 0.0 ? 1 : 0;
    ray.places.push_back(place);
  }
  return ray;
}

DesignedRay foldParabolaRay(const Design& d, Neighbours neighbours)
{
  const Setting s(d);
  const double k0 = s.k0;
  const double kx0 = k0 * std::cos(s.angle);
  const double ky = k0 * std::sin(s.angle);
  const double mu = kx0 * kx0 / d.length;
  DesignedRay ray = designed(
    d, [k0, mu](const Jet& x, const Jet&, unsigned) { return sqrt(Jet(k0 * k0) - mu * x); },
    { { -0.5 * d.length, -10.0 * d.length }, { 1.1 * d.length, 40.0 * d.length } }, 0.1 * d.length, neighbours);
  ray.heading = s.angle;
  // By tau with d tau = ds/k; the ray turns at 2 kx0/mu.
  const double turning = 2.0 * kx0 / mu;
  const auto x = [=](Real t) { return kx0 * t - 0.25L * mu * t * t; };
  const auto k = [=](Real t) { return std::sqrt(static_cast<Real>(k0) * k0 - mu * x(t)); };
  for (int i = 1; i <= 21; ++i)
  {
    const double tau = 0.094 * i * turning;
    Place place;
    place.x = static_cast<double>(x(tau));
    place.y = ky * tau;
    place.theta = std::atan2(ky, kx0 - 0.5 * mu * tau);
    place.phase = k0 * k0 * tau - 0.5 * mu * kx0 * tau * tau + mu * mu * tau * tau * tau / 12.0;
    const auto sums = integrate(
      [&](Real t) -> std::array<Real, 4> {
        return { k(t), 1.0L, 1.0L, 1.0L };
      },
      0.0L, tau);
    place.length = static_cast<double>(sums[0]);
    place.time = timeAlong(s.omega, 0.0, tau, k, k);
    if (neighbours == Neighbours::Fan)
    {
      // d(x, y)/d angle at equal tau is k0 tau (-sin, cos) of the angle at the start.
      place.width = k0 * tau * std::cos(place.theta - s.angle);
      place.caustics = tau > 2.0 * k0 / (mu * std::cos(s.angle)) ? 1 : 0;
    }
    else
    {
      place.width = std::cos(place.theta) / std::cos(s.angle);
      place.caustics = tau > turning ? 1 : 0;
    }
    ray.places.push_back(place);
  }
  return ray;
}

DesignedRay luneburgRay(const Design& d, double share)
{
  const Setting s(d);
  const double R = d.length;
  const double k0 = s.k0;
  DesignedRay ray = designed(
    d,
    [k0, R](const Jet& x, const Jet& y, unsigned region)
    { return region ? Jet(k0) : k0 * sqrt(Jet(2.0) - (x * x + y * y) / (R * R)); },
    { { -2.0 * R, -2.0 * R }, { 2.0 * R, 2.0 * R } }, 0.1 * R, Neighbours::Parallel);
  ray.formula.kinks.push_back([R](const Jet& x, const Jet& y) { return x * x + y * y - Jet(R * R); });
  const double b = share * R;
  const double root = std::sqrt(R * R - b * b);
  ray.position = { -R, b };
  const double speedOutside = static_cast<double>(groupSpeed(s.omega, d.depth));
  // x = -root cos w + R sin w, y = b cos w; ds = k R/k0 dw.
  const auto squared = [=](Real at)
  { return static_cast<Real>(R) * R - 2.0L * R * root * std::sin(at) * std::cos(at); };
  const auto k = [=](Real at) { return k0 * std::sqrt(2.0L - squared(at) / (R * R)); };
  const auto at = [&](double w)
  {
    const auto sums = integrate(
      [&](Real angle) -> std::array<Real, 4> {
        return { k(angle) * R / k0, 1.0L, 1.0L, 1.0L };
      },
      0.0L, w);
    const double tx = root * std::sin(w) + R * std::cos(w);
    const double ty = -b * std::sin(w);
    Place place;
    place.x = -root * std::cos(w) + R * std::sin(w);
    place.y = b * std::cos(w);
    place.theta = std::atan2(ty, tx);
    place.phase = k0 * (R - root + R * w + root * std::sin(w) * std::sin(w));
    place.length = R - root + static_cast<double>(sums[0]);
    place.time =
      (R - root) / speedOutside + timeAlong(s.omega, 0.0, w, k, [&](Real angle) { return k(angle) * R / k0; });
    place.width = std::cos(w) * (tx - ty * b / root) / std::hypot(tx, ty);
    return place;
  };
  for (int i = 1; i < 20; ++i)
  {
    ray.places.push_back(at(0.5 * swellray::Pi * i / 20.0));
  }
  // Where all meet the width is 0 and has no sign: the next places count.
  const Place focus = at(0.5 * swellray::Pi);
  for (const double beyond : { 0.1 * R, 0.4 * R })
  {
    Place past = focus;
    past.x += beyond * root / R;
    past.y -= beyond * b / R;
    past.phase += k0 * beyond;
    past.length += beyond;
    past.time += beyond / speedOutside;
    past.width = -beyond / root;
    past.caustics = 1;
    ray.places.push_back(past);
  }
  return ray;
}

}
