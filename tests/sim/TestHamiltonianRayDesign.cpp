// Rays over seafloors designed for their curves: k(x, y) is given, h = atanh(k_inf/k)/k, and the ray is a circle, a
// cycloid, a parabola, a logarithmic spiral or an ellipse at any period.
#include "RayComparison.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

using namespace swellray;
using namespace swellray::reference;

namespace
{

constexpr double Tolerance = 1e-12;

// Asked for: 1e-6 m a km, 1e-6 in all else. Some hundred steps, each right to 1e-12 wavelengths of 100 m.
constexpr double PositionTolerance = 3e-9;
constexpr double RelativeTolerance = 2e-10;
// The tube is held to fewer digits than the ray.
constexpr double WidthTolerance = 1e-9;

using Wavenumber = std::function<Jet(const Jet& x, const Jet& y, unsigned region)>;

FormulaSeafloor designed(double omega, const Wavenumber& k, const Rectangle& bounds, double feature,
  std::vector<std::function<Jet(const Jet&, const Jet&)>> kinks = {})
{
  Formula formula;
  formula.depth = [omega, k](const Jet& x, const Jet& y, unsigned region)
  { return depthFormula(omega, k(x, y, region)); };
  formula.kinks = std::move(kinks);
  return { formula, bounds, feature };
}

Jet radius(const Jet& x, const Jet& y)
{
  return sqrt(x * x + y * y);
}

/** A period, and a depth where the formula's length is. */
struct Design
{
  double period;
  double depth;
  double length; // m: x0, r0 or R
  double angle;  // degrees
};

// The first of each is that of the tables, others are chosen freely.
const Design Designs[] = { { 10.0, 12.0, 1000.0, 45.0 }, { 7.0, 8.0, 400.0, 62.0 }, { 14.0, 30.0, 2500.0, 25.0 } };

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

/** Time along a path of which place and ds are known, by quadrature over its parameter. */
double timeAlong(
  double omega, double from, double to, const std::function<Real(Real)>& k, const std::function<Real(Real)>& ds)
{
  const auto sums = integrate(
    [&](Real at) -> std::array<Real, 4> {
      return { ds(at) / groupSpeed(omega, reference::depthOf(omega, k(at))), 1.0L, 1.0L, 1.0L };
    },
    from, to);
  return static_cast<double>(sums[0]);
}

void expectAccurate(const RayErrors& errors)
{
  EXPECT_LT(errors.position, PositionTolerance) << errors;
  EXPECT_LT(errors.theta, RelativeTolerance) << errors;
  EXPECT_LT(errors.phase, RelativeTolerance) << errors;
  EXPECT_LT(errors.time, RelativeTolerance) << errors;
  EXPECT_LT(errors.width, WidthTolerance) << errors;
  EXPECT_EQ(errors.caustics, 0) << errors;
}

void follow(HamiltonianRay& ray, const std::vector<Place>& places)
{
  RayErrors errors;
  RayPoint point;
  for (const Place& place : places)
  {
    ASSERT_TRUE(ray.advance(FrontMeasure::Phase, place.phase, point)) << "at " << place.x << ", " << place.y;
    EXPECT_NEAR(
      ray.length() / std::max(1.0, place.length), place.length / std::max(1.0, place.length), RelativeTolerance);
    errors.add(point, place);
  }
  expectAccurate(errors);
}

/** Start of parallel rays over contours x = const, a unit apart across. */
RayStart parallelStart(const RayMedium& medium, double x0, double heading)
{
  return startHeading(medium, { x0, 0.0 }, heading, { 0.0, 1.0 / std::cos(heading) });
}

/** Start at (r0, 0) of a tube of rays that are one ray turned about the centre. */
RayStart turnedStart(const RayMedium& medium, double r0, double heading)
{
  RayStart start;
  start.position = { r0, 0.0 };
  start.wavenumber = wavenumberAt(medium, start.position, heading);
  // A turn by 1/(r0 cos heading) moves the ray sideways by one.
  const double turn = 1.0 / (r0 * std::cos(heading));
  start.dPosition = { 0.0, r0 * turn };
  start.dWavenumber = { -start.wavenumber.y * turn, start.wavenumber.x * turn };
  return start;
}

// Width of that tube: n.(z x r) = t.r, over its value at the start.
double turnedWidth(const Place& place, double r0, double heading)
{
  return (std::cos(place.theta) * place.x + std::sin(place.theta) * place.y) / (r0 * std::cos(heading));
}

}

TEST(HamiltonianRayDesign, isACircleWhereTheWavelengthGrowsAsTheDistance)
{
  for (const Design& d : Designs)
  {
    const Setting s(d);
    const double x0 = d.length;
    const FormulaSeafloor bed = designed(
      s.omega, [&](const Jet& x, const Jet&, unsigned) { return s.k0 * x0 / x; },
      { { 1e-3 * x0, -5.0 * x0 }, { 1.1 * x0, 5.0 * x0 } }, 0.1 * x0);
    const RayMedium medium = mediumOf(bed, d.period, 1e-3);
    const double r = x0 / std::sin(s.angle);
    std::vector<Place> places;
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
      places.push_back(place);
    }
    HamiltonianRay ray(medium, parallelStart(medium, x0, swellray::Pi - s.angle), Tolerance);
    follow(ray, places);
  }
}

TEST(HamiltonianRayDesign, isACycloidWhereTheWavelengthGrowsAsTheRootOfTheDistance)
{
  for (const Design& d : Designs)
  {
    const Setting s(d);
    const double x0 = d.length;
    const FormulaSeafloor bed = designed(
      s.omega, [&](const Jet& x, const Jet&, unsigned) { return s.k0 * std::sqrt(x0) / sqrt(x); },
      { { 1e-3 * x0, -5.0 * x0 }, { 1.1 * x0, 5.0 * x0 } }, 0.1 * x0);
    const RayMedium medium = mediumOf(bed, d.period, 1e-3);
    const double sine = std::sin(s.angle);
    const double D = x0 / (sine * sine);
    std::vector<Place> places;
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
      places.push_back(place);
    }
    HamiltonianRay ray(medium, parallelStart(medium, x0, swellray::Pi - s.angle), Tolerance);
    follow(ray, places);
  }
}

TEST(HamiltonianRayDesign, isASpiralAroundAnIsland)
{
  for (const Design& d : Designs)
  {
    const Setting s(d);
    const double r0 = d.length;
    const FormulaSeafloor bed = designed(
      s.omega, [&](const Jet& x, const Jet& y, unsigned) { return s.k0 * r0 / radius(x, y); },
      { { -1.1 * r0, -1.1 * r0 }, { 1.1 * r0, 1.1 * r0 } }, 0.05 * r0);
    const RayMedium medium = mediumOf(bed, d.period, 1e-3);
    const double heading = swellray::Pi - s.angle;
    std::vector<Place> places;
    for (int i = 1; i <= 24; ++i)
    {
      const double r = r0 * std::exp(-0.1 * i);
      const double phi = std::tan(s.angle) * std::log(r0 / r);
      Place place;
      place.x = r * std::cos(phi);
      place.y = r * std::sin(phi);
      place.theta = heading + phi;
      place.length = (r0 - r) / std::cos(s.angle);
      place.phase = s.k0 * r0 * std::log(r0 / r) / std::cos(s.angle);
      place.time = timeAlong(
        s.omega, r, r0, [&](Real at) { return s.k0 * r0 / at; }, [&](Real) -> Real { return 1.0 / std::cos(s.angle); });
      place.width = turnedWidth(place, r0, heading);
      places.push_back(place);
    }
    HamiltonianRay ray(medium, turnedStart(medium, r0, heading), Tolerance);
    follow(ray, places);
  }
}

TEST(HamiltonianRayDesign, isAParabolaAroundAnIsland)
{
  for (const Design& d : Designs)
  {
    const Setting s(d);
    const double r0 = d.length;
    const FormulaSeafloor bed = designed(
      s.omega, [&](const Jet& x, const Jet& y, unsigned) { return s.k0 * std::sqrt(r0) / sqrt(radius(x, y)); },
      { { -1.2 * r0, -1.2 * r0 }, { 1.2 * r0, 1.2 * r0 } }, 0.05 * r0);
    const RayMedium medium = mediumOf(bed, d.period, 1e-3);
    const double heading = swellray::Pi - s.angle;
    const double rt = r0 * std::sin(s.angle) * std::sin(s.angle);
    // r = rt/cos^2 u, u from -u0 = -(pi/2 - angle); phi = 2 (u + u0): ds = 2 rt/cos^3 u du, k = k0 sqrt(r0/rt) cos u.
    const double u0 = 0.5 * swellray::Pi - s.angle;
    std::vector<Place> places;
    for (int i = 1; i <= 25; ++i)
    {
      const double u = -u0 + 0.077 * i * u0; // to nearly r0 on the other side, past the caustic where t.r = 0
      const double r = rt / (std::cos(u) * std::cos(u));
      const double phi = 2.0 * (u + u0);
      const auto lengthTo = [&](double at)
      { return rt * (std::sin(at) / (std::cos(at) * std::cos(at)) + std::asinh(std::tan(at))); };
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
      place.width = turnedWidth(place, r0, heading);
      place.caustics = u > 0.0 ? 1 : 0;
      places.push_back(place);
    }
    HamiltonianRay ray(medium, turnedStart(medium, r0, heading), Tolerance);
    follow(ray, places);
  }
}

namespace
{

/** k^2 = k0^2 - mu x: parabolas, by tau with d tau = ds/k. */
struct LinearSquare
{
  Setting setting;
  double mu;
  FormulaSeafloor bed;

  explicit LinearSquare(const Design& d)
    : setting(d)
    , mu(setting.k0 * setting.k0 * std::cos(setting.angle) * std::cos(setting.angle) / d.length)
    , bed(designed(
        setting.omega,
        [k0 = setting.k0, m = mu](const Jet& x, const Jet&, unsigned) { return sqrt(Jet(k0 * k0) - m * x); },
        { { -0.5 * d.length, -10.0 * d.length }, { 1.1 * d.length, 40.0 * d.length } }, 0.1 * d.length))
  {
  }

  double turning() const { return 2.0 * this->setting.k0 * std::cos(this->setting.angle) / this->mu; }

  Place at(double tau) const
  {
    const double k0 = this->setting.k0;
    const double kx0 = k0 * std::cos(this->setting.angle);
    const double ky = k0 * std::sin(this->setting.angle);
    const auto x = [=](Real t) { return kx0 * t - 0.25L * this->mu * t * t; };
    const auto k = [=](Real t) { return std::sqrt(static_cast<Real>(k0) * k0 - this->mu * x(t)); };
    Place place;
    place.x = static_cast<double>(x(tau));
    place.y = ky * tau;
    place.theta = std::atan2(ky, kx0 - 0.5 * this->mu * tau);
    place.phase = k0 * k0 * tau - 0.5 * this->mu * kx0 * tau * tau + this->mu * this->mu * tau * tau * tau / 12.0;
    const auto sums = integrate(
      [&](Real t) -> std::array<Real, 4> {
        return { k(t), 1.0L, 1.0L, 1.0L };
      },
      0.0L, tau);
    place.length = static_cast<double>(sums[0]);
    place.time = timeAlong(this->setting.omega, 0.0, tau, k, k);
    return place;
  }
};

// k must stay above k_inf up to the turning point: k sin theta0 tanh... holds for these.
const Design Parabolas[] = { { 10.0, 5.0, 428.654868376, 65.0 }, { 8.0, 2.0, 300.0, 50.0 },
  { 15.0, 4.0, 900.0, 35.0 } };

}

TEST(HamiltonianRayDesign, foldsAtTheTurningLineOfParallelParabolas)
{
  for (const Design& d : Parabolas)
  {
    const LinearSquare law(d);
    const RayMedium medium = mediumOf(law.bed, d.period, 1e-3);
    const double kx0 = law.setting.k0 * std::cos(law.setting.angle);
    std::vector<Place> places;
    for (int i = 1; i <= 21; ++i)
    {
      Place place = law.at(0.094 * i * law.turning());
      place.width = std::cos(place.theta) / std::cos(law.setting.angle);
      place.caustics = kx0 < 0.5 * law.mu * 0.094 * i * law.turning() ? 1 : 0;
      places.push_back(place);
    }
    HamiltonianRay ray(medium, parallelStart(medium, 0.0, law.setting.angle), Tolerance);
    follow(ray, places);
  }
}

TEST(HamiltonianRayDesign, touchesTheEnvelopeOfAFanOfParabolas)
{
  for (const Design& d : Parabolas)
  {
    const LinearSquare law(d);
    const RayMedium medium = mediumOf(law.bed, d.period, 1e-3);
    const double k0 = law.setting.k0;
    const double cosine = std::cos(law.setting.angle);
    std::vector<Place> places;
    for (int i = 1; i <= 21; ++i)
    {
      // d(x, y)/d angle at equal tau is k0 tau (-sin, cos) of the angle at the start.
      const double tau = 0.094 * i * law.turning();
      Place place = law.at(tau);
      place.width = k0 * tau * std::cos(place.theta - law.setting.angle);
      place.caustics = tau > 2.0 * k0 / (law.mu * cosine) ? 1 : 0;
      places.push_back(place);
    }
    RayStart start;
    start.wavenumber = wavenumberAt(medium, start.position, law.setting.angle);
    start.dWavenumber = { -start.wavenumber.y, start.wavenumber.x };
    HamiltonianRay ray(medium, start, Tolerance);
    follow(ray, places);
  }
}

TEST(HamiltonianRayDesign, meetsAllOthersAtTheFocusOfALuneburgLens)
{
  for (const Design& d : { Design{ 10.0, 15.0, 500.0, 0.0 }, Design{ 6.0, 6.0, 200.0, 0.0 } })
  {
    const Setting s(d);
    const double R = d.length;
    const FormulaSeafloor bed = designed(s.omega,
      [&](const Jet& x, const Jet& y, unsigned region)
      { return region ? Jet(s.k0) : s.k0 * sqrt(Jet(2.0) - (x * x + y * y) / (R * R)); },
      { { -2.0 * R, -2.0 * R }, { 2.0 * R, 2.0 * R } }, 0.1 * R,
      { [R](const Jet& x, const Jet& y) { return x * x + y * y - Jet(R * R); } });
    const RayMedium medium = mediumOf(bed, d.period, 1e-3);
    for (const double share : { -0.93, -0.5, -0.1, 0.0, 0.3, 0.65, 0.9 })
    {
      const double b = share * R;
      const double root = std::sqrt(R * R - b * b);
      const RayStart start = startHeading(medium, { -R, b }, 0.0, { 0.0, 1.0 });
      const double k0 = s.k0;
      const double speedOutside = static_cast<double>(groupSpeed(s.omega, d.depth));
      std::vector<Place> places;
      for (int i = 1; i <= 20; ++i)
      {
        // x = -root cos w + R sin w, y = b cos w; ds = k R/k0 dw.
        const double w = 0.5 * swellray::Pi * i / 20.0;
        const auto squared = [=](Real at)
        { return static_cast<Real>(R) * R - 2.0L * R * root * std::sin(at) * std::cos(at); };
        const auto k = [=](Real at) { return k0 * std::sqrt(2.0L - squared(at) / (R * R)); };
        const auto sums = integrate(
          [&](Real at) -> std::array<Real, 4> {
            return { k(at) * R / k0, 1.0L, 1.0L, 1.0L };
          },
          0.0L, w);
        Place place;
        place.x = -root * std::cos(w) + R * std::sin(w);
        place.y = b * std::cos(w);
        const double tx = root * std::sin(w) + R * std::cos(w);
        const double ty = -b * std::sin(w);
        place.theta = std::atan2(ty, tx);
        place.phase = k0 * (R - root + R * w + root * std::sin(w) * std::sin(w));
        place.length = R - root + static_cast<double>(sums[0]);
        place.time = (R - root) / speedOutside + timeAlong(s.omega, 0.0, w, k, [&](Real at) { return k(at) * R / k0; });
        place.width = std::cos(w) * (tx - ty * b / root) / std::hypot(tx, ty);
        // Where all meet the width is 0 and has no sign yet: the next places count.
        if (i < 20)
        {
          places.push_back(place);
        }
        else
        {
          EXPECT_NEAR(place.phase, k0 * R * (1.0 + 0.5 * swellray::Pi), RelativeTolerance * place.phase);
          for (const double beyond : { 0.1 * R, 0.4 * R })
          {
            Place past = place;
            past.x += beyond * root / R;
            past.y -= beyond * b / R;
            past.phase += k0 * beyond;
            past.length += beyond;
            past.time += beyond / speedOutside;
            past.width = -beyond / root;
            past.caustics = 1;
            places.push_back(past);
          }
        }
      }
      HamiltonianRay ray(medium, start, Tolerance);
      follow(ray, places);
    }
  }
}

TEST(HamiltonianRayDesign, approachesTheShallowCycloidAsTheSquareOfTheFrequency)
{
  // Over a plane beach in shallow water the ray is a cycloid; what full dispersion adds is of order omega^2 h/g.
  constexpr double slope = 0.02;
  constexpr double x0 = 1000.0;
  constexpr double theta0 = radians(40.0);
  constexpr double theta = radians(12.0);
  Formula formula;
  formula.depth = [](const Jet& x, const Jet&, unsigned) { return slope * x; };
  const FormulaSeafloor bed(formula, { { 0.0, -2000.0 }, { 1100.0, 2000.0 } }, 100.0);
  const double D = x0 / (std::sin(theta0) * std::sin(theta0));
  const double length = 2.0 * D * (std::cos(theta) - std::cos(theta0));
  const glm::dvec2 exact(D * std::sin(theta) * std::sin(theta),
    0.5 * D * (2.0 * theta0 - std::sin(2.0 * theta0) - 2.0 * theta + std::sin(2.0 * theta)));
  double before = 0.0;
  for (const double period : { 400.0, 800.0, 1600.0 })
  {
    const RayMedium medium = mediumOf(bed, period, 1e-3);
    HamiltonianRay ray(medium, parallelStart(medium, x0, swellray::Pi - theta0), Tolerance);
    RayPoint point;
    ASSERT_TRUE(ray.advance(FrontMeasure::Length, length, point));
    const double error = std::hypot(point.position.x - exact.x, point.position.y - exact.y);
    if (before > 0.0)
    {
      // The next term is omega^2 h/g smaller: 5e-4.
      EXPECT_NEAR(before / error, 4.0, 0.01);
    }
    before = error;
  }
  EXPECT_LT(before / length, 1e-5); // omega^2 h0/(6 g) = 5e-6
}
