// Rays across a shear jet: the wavenumber along it is kept, and wave action.
#include "Families.h"
#include "RayRun.h"

#include "sim/BuiltinCurrent.h"
#include "sim/RayQuantities.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <memory>

namespace swellray::validation
{

namespace
{

using reference::Place;
using reference::Real;

struct Jet
{
  const char* name;
  double speed;  // V0, m/s
  double width;  // w, m
  double depth;  // m
  double period; // absolute, s
  double from;   // x0, m
  double angle;  // of the wavenumber, degrees from +x
};

/** On V = V0 exp(-(x/w)^2) along y the wavenumber ky and the flux of action along x are kept; y, t and S are quadratures. */
class JetRay
{
public:
  explicit JetRay(const Jet& jet)
    : Case(jet)
    , Omega(2.0L * reference::Pi / jet.period)
  {
    const Real sine = std::sin(jet.angle * reference::Pi / 180.0L);
    const Real cosine = std::cos(jet.angle * reference::Pi / 180.0L);
    // sigma + k V sin = omega, by repetition: V is next to nothing at the start.
    Real k = reference::wavenumber(this->Omega, jet.depth);
    for (int i = 0; i < 50; ++i)
    {
      k = reference::wavenumber(this->Omega - k * sine * this->current(jet.from), jet.depth);
    }
    this->Kx0 = k * cosine;
    this->Ky = k * sine;
  }

  struct Rates
  {
    Real kx;
    Real sigma;
    Real vx;
    Real vy;
  };

  Rates rates(Real x) const
  {
    Rates r{};
    r.sigma = this->Omega - this->Ky * this->current(x);
    const Real k = reference::wavenumber(r.sigma, this->Case.depth);
    const Real group = reference::groupSpeed(r.sigma, this->Case.depth);
    r.kx = std::sqrt(k * k - this->Ky * this->Ky);
    r.vx = group * r.kx / k;
    r.vy = group * this->Ky / k + this->current(x);
    return r;
  }

  /** Place at x, in a tube of rays that are one ray moved along y. */
  Place at(Real x) const
  {
    const auto sums = reference::integrate(
      [this](Real u) -> std::array<Real, 4>
      {
        const Rates r = this->rates(u);
        return { r.vy / r.vx, 1.0L / r.vx, r.kx + this->Ky * r.vy / r.vx, std::hypot(r.vx, r.vy) / r.vx };
      },
      this->Case.from, x);
    const Rates here = this->rates(x);
    const Rates start = this->rates(this->Case.from);
    Place place;
    place.x = static_cast<double>(x);
    place.y = static_cast<double>(sums[0]);
    place.theta = static_cast<double>(std::atan2(this->Ky, here.kx));
    place.time = static_cast<double>(sums[1]);
    place.phase = static_cast<double>(sums[2]);
    place.length = static_cast<double>(sums[3]);
    place.width =
      static_cast<double>(here.vx / std::hypot(here.vx, here.vy) / (start.vx / std::hypot(start.vx, start.vy)));
    return place;
  }

  /** H/H0 of a constant flux of action, E vx/sigma. */
  double height(Real x) const
  {
    const Rates here = this->rates(x);
    const Rates start = this->rates(this->Case.from);
    return static_cast<double>(std::sqrt(here.sigma * start.vx / (start.sigma * here.vx)));
  }

  double angleOfRay() const
  {
    const Rates start = this->rates(this->Case.from);
    return static_cast<double>(std::atan2(start.vy, start.vx));
  }

  Real current(Real x) const
  {
    const Real t = x / this->Case.width;
    return this->Case.speed * std::exp(-t * t);
  }

private:
  Jet Case;
  Real Omega;
  Real Kx0 = 0.0L;
  Real Ky = 0.0L;
};

Outcome run(const Jet& jet, const Setting& setting)
{
  reference::Formula formula;
  formula.depth = [&jet](const reference::Jet&, const reference::Jet&, unsigned) { return reference::Jet(jet.depth); };
  const reference::FormulaSeafloor seafloor(formula, { { -3000.0, -50000.0 }, { 3000.0, 50000.0 } }, jet.width);
  const auto current =
    makeBuiltinCurrent("jet:V0=" + std::to_string(jet.speed) + ",width=" + std::to_string(jet.width));
  const JetRay exact(jet);
  RayMedium medium = reference::mediumOf(seafloor, jet.period, 0.1);
  medium.gravity = setting.gravity;
  medium.current = current.get();
  const double across = 1.0 / std::cos(exact.angleOfRay());
  const double angle = radians(jet.angle);
  RayStart start = reference::startHeading(medium, { jet.from, 0.0 }, angle, { 0.0, across });
  // sigma + k V sin = omega, by repetition.
  const double slip = std::sin(angle) * static_cast<double>(exact.current(jet.from));
  for (int i = 0; i < 10; ++i)
  {
    const double sigma = medium.angularFrequency - glm::length(start.wavenumber) * slip;
    const double k = solveWavenumber(sigma, jet.depth, medium.gravity);
    start.wavenumber = k * glm::dvec2(std::cos(angle), std::sin(angle));
  }
  HamiltonianRay ray(medium, start, FineTolerance);
  RayPoint point;
  ray.advance(FrontMeasure::Length, 0.0, point);
  const double speed0 = waveSpeeds(glm::length(point.wavenumber), jet.depth, medium.gravity).groupSpeed;

  Outcome outcome;
  outcome.numbers.columns = { "x_exact_m", "x_m", "y_exact_m", "y_m", "time_s", "theta_exact_rad", "theta_rad",
    "height_exact", "height" };
  Series line{ "exact", Series::Look::Line, {}, {} };
  Series dots{ "computed", Series::Look::Dots, {}, {} };
  Series exactHeights = line;
  Series heights = dots;
  reference::RayErrors errors;
  double height = 0.0;
  constexpr int count = 40;
  for (int i = 1; i <= count; ++i)
  {
    const Place place = exact.at(jet.from - 2.0 * jet.from * i / count);
    if (!ray.advance(FrontMeasure::Time, place.time, point))
    {
      point.position = glm::dvec2(std::nan(""));
    }
    errors.add(point, place);
    const WaveSpeeds speeds = waveSpeeds(glm::length(point.wavenumber), point.depth, medium.gravity);
    const double computed =
      shoalingCoefficient(point, speeds, speed0, medium.angularFrequency) * refractionCoefficient(point.tubeWidth);
    const double now = std::abs(computed / exact.height(place.x) - 1.0);
    height = now <= height ? height : now;
    line.add(place.x, place.y);
    dots.add(point.position.x, point.position.y);
    exactHeights.add(place.x, exact.height(place.x));
    heights.add(place.x, computed);
    outcome.numbers.rows.push_back({ place.x, point.position.x, place.y, point.position.y, place.time, place.theta,
      std::atan2(point.wavenumber.y, point.wavenumber.x), exact.height(place.x), computed });
  }
  outcome.plots = { { "ray", "x (m)", "y (m)", { line, dots }, false, true },
    { "height by wave action", "x (m)", "H/H0", { exactHeights, heights }, false, false } };
  RayLimits limits;
  limits.positionReason = "some thousand steps, each right to 1e-12 of a wavelength near 150 m, add up to less";
  addPathChecks(errors, limits, "", outcome.checks);
  outcome.checks.push_back({ "tube width (relative)", errors.width, limits.width, limits.widthReason });
  outcome.checks.push_back({ "height by wave action (relative)", height, limits.width, "as the tube" });
  return outcome;
}

}

std::vector<Case> currentCases()
{
  std::vector<Case> cases;
  constexpr double deep = 4000.0; // m: tanh k h is 1 to the last digit
  for (const Jet& jet : { Jet{ "c8_jet_1", 2.0, 200.0, deep, 10.0, -1000.0, 40.0 },
         Jet{ "c8_jet_2", -2.5, 250.0, deep, 10.0, -1200.0, 40.0 },
         Jet{ "c8_jet_3", 1.5, 150.0, 12.0, 9.0, -800.0, 30.0 } })
  {
    char formula[120];
    std::snprintf(formula, sizeof formula, "V = %g exp(-(x/%g)^2) m/s along y, h = %g m, T = %g s, %g degrees.",
      jet.speed, jet.width, jet.depth, jet.period, jet.angle);
    cases.push_back({ jet.name, "Ray across a shear jet",
      std::string(formula) +
        " ky and the flux of wave action across the jet are kept; y, t and S by quadrature in long double.",
      [jet](const Setting& setting) { return run(jet, setting); } });
  }
  return cases;
}

}
