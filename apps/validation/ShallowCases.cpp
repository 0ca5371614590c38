// Shallow water: the curves of rays where C = sqrt(g h), approached by long waves.
#include "DesignedRays.h"
#include "Families.h"
#include "GridRun.h"
#include "Problems.h"

#include <algorithm>
#include <cmath>

namespace swellray::validation
{

namespace
{

using reference::DesignedRay;
using reference::Jet;
using reference::Place;

struct ShallowErrors
{
  double position = 0.0; // over the way
  double theta = 0.0;
  double time = 0.0; // relative
};

// Waves so long that dispersion adds omega^2 h0/(6 g) = share to the shallow limit, relative.
double periodOf(double share, double depth)
{
  return 2.0 * Pi * std::sqrt(depth / (6.0 * static_cast<double>(reference::Gravity) * share));
}

reference::Formula depthOf(const Shallow& c)
{
  reference::Formula formula;
  formula.depth = [c](const Jet& x, const Jet& y, unsigned)
  {
    const double start = c.curve.position.x;
    const Jet square = c.circular ? x * x + y * y : x * x;
    return c.depth * reference::pow(square / (start * start), 0.5 * c.power);
  };
  return formula;
}

/** Rays of a period at which the seafloor is not shallow, on grids: by the equations of Munk and Arthur on the formula. */
void addGrids(const Shallow& c, const Setting& setting, Outcome& outcome)
{
  constexpr double share = 1e-2;
  const reference::Formula formula = depthOf(c);
  const reference::FormulaSeafloor seafloor(formula, c.curve.bounds, c.curve.feature);
  RayScene scene;
  scene.seafloor = &seafloor;
  scene.period = periodOf(share, c.depth);
  scene.agroundDepth = 1e-3;
  scene.depth = [&](const Place& place) { return formula.depth(Jet(place.x), Jet(place.y), 0).value; };
  Place start;
  start.x = c.curve.position.x;
  start.y = c.curve.position.y;
  start.theta = c.curve.heading;
  std::vector<double> lengths;
  for (const Place& place : c.curve.places)
  {
    lengths.push_back(0.9 * place.length); // dispersion turns the last of the way aside, on the plane to the shore
  }
  scene.tracks = { { [&c](const RayMedium& medium)
    {
      const glm::dvec2 left(-std::sin(c.curve.heading), std::cos(c.curve.heading));
      return reference::startHeading(medium, c.curve.position, c.curve.heading, left);
    },
    traceMunkArthur(formula, 2.0 * Pi / scene.period, start, lengths, 0.02 * c.curve.feature) } };
  // h goes as x, x^2 and r^2: polynomials.
  GridPlan plan = planFor(c.circular && c.power == 1.0 ? GridOrder::Curved : GridOrder::Exact);
  plan.spacings = { 80.0, 40.0, 20.0 };
  addGridConvergence(scene, plan, setting, outcome);
}

ShallowErrors errorsAt(const Shallow& c, double period, const Setting& setting, Outcome* outcome)
{
  const double start = c.curve.position.x;
  const reference::FormulaSeafloor seafloor(depthOf(c), c.curve.bounds, c.curve.feature);
  RayMedium medium = reference::mediumOf(seafloor, period, 1e-3);
  medium.gravity = setting.gravity;
  HamiltonianRay ray(medium, c.curve.start(medium), 1e-13);
  const double k0 = static_cast<double>(reference::wavenumber(2.0 * Pi / c.curve.period, reference::Design{}.depth));
  const double speed0 = std::sqrt(static_cast<double>(reference::Gravity) * c.depth);
  ShallowErrors errors;
  RayPoint point;
  Series exact{ "exact", Series::Look::Line, { start }, { 0.0 } };
  Series dots{ "computed", Series::Look::Dots, {}, {} };
  for (const Place& place : c.curve.places)
  {
    if (!ray.advance(FrontMeasure::Length, place.length, point))
    {
      point.position = glm::dvec2(std::nan(""));
    }
    // Without dispersion the phase is that of k0 = omega/sqrt(g h0), and the time S/omega.
    const double time = place.phase / k0 / speed0;
    const double aside = std::hypot(point.position.x - place.x, point.position.y - place.y) / place.length;
    errors.position = aside <= errors.position ? errors.position : aside;
    const double heading = std::atan2(point.wavenumber.y, point.wavenumber.x);
    errors.theta = std::max(errors.theta, std::abs(std::remainder(heading - place.theta, 2.0 * Pi)));
    errors.time = std::max(errors.time, std::abs(point.travelTime / time - 1.0));
    if (outcome)
    {
      exact.add(place.x, place.y);
      dots.add(point.position.x, point.position.y);
      outcome->numbers.rows.push_back({ period, place.length, place.x, point.position.x, place.y, point.position.y,
        place.theta, heading, time, point.travelTime });
    }
  }
  if (outcome)
  {
    outcome->plots.push_back({ "rays", "x (m)", "y (m)", { exact, dots }, false, true });
  }
  return errors;
}

}

Outcome runShallow(const Shallow& c, const Setting& setting)
{
  Outcome outcome;
  outcome.numbers.columns = { "T_s", "length_m", "x_exact_m", "x_m", "y_exact_m", "y_m", "theta_exact_rad", "theta_rad",
    "time_exact_s", "time_s" };
  // Waves this long leave dispersion a millionth.
  constexpr double share = 1e-6;
  const ShallowErrors errors = errorsAt(c, periodOf(share, c.depth), setting, &outcome);
  // A spiral at angle a turns its heading by tan(a)/cos^2(a) ln(r0/r) of the share: 17 of them at 60 degrees.
  constexpr double limit = 30.0 * share;
  const std::string reason =
    "dispersion changes k by omega^2 h0/(6 g) = 1e-6, a spiral makes 17 of these in its heading";
  outcome.checks = { { "position over path (relative)", errors.position, limit, reason },
    { "heading (rad)", errors.theta, limit, reason }, { "travel time (relative)", errors.time, limit, reason } };

  Series dots{ "position over path", Series::Look::Dots, {}, {} };
  Series times{ "travel time", Series::Look::Dots, {}, {} };
  std::vector<double> frequencies;
  for (const double each : { 1e-4, 2.5e-5, 6.25e-6, 1.5625e-6 })
  {
    const double period = periodOf(each, c.depth);
    const ShallowErrors now = errorsAt(c, period, setting, nullptr);
    frequencies.push_back(2.0 * Pi / period);
    dots.add(period, now.position);
    times.add(period, now.time);
  }
  const double order = fittedOrder(frequencies, times.y);
  outcome.checks.push_back({ "order of travel time in the frequency", order, 1.98,
    "dispersion is of order 2, what follows smaller by 1e-4", Check::Ask::AtLeast });
  char title[80];
  std::snprintf(title, sizeof title, "difference to shallow water: order %.2f in 1/T", order);
  Series line = fittedLine(times, -order);
  line.name = "fitted to travel time";
  outcome.plots.push_back({ title, "period (s)", "relative", { line, dots, times }, true, false });
  addGrids(c, setting, outcome);
  return outcome;
}

std::vector<Case> shallowCases()
{
  // Curves at the design's default period and depth: only their shape is used.
  const auto design = [](double length, double angle)
  {
    reference::Design d;
    d.length = length;
    d.angle = angle;
    return d;
  };
  struct ShallowCase
  {
    const char* name;
    const char* title;
    const char* formula;
    Shallow problem;
  };
  std::vector<Case> cases;
  for (const ShallowCase& c : { ShallowCase{ "c3_shallow_plane_cycloid", "Long waves on a plane beach",
                                  "h = 0.02 x: a cycloid", { cycloidRay(design(1000.0, 40.0)), 1.0, 20.0, false } },
         ShallowCase{ "c3_shallow_x2_circle", "Long waves on a parabolic beach", "h = 2e-5 x^2: a circle",
           { circleRay(design(800.0, 35.0)), 2.0, 12.8, false } },
         ShallowCase{ "c3_shallow_island_cone", "Long waves around a cone", "h = 0.02 r: a parabola around the centre",
           { islandParabolaRay(design(2000.0, 30.0)), 1.0, 40.0, true } },
         ShallowCase{ "c3_shallow_island_par", "Long waves around a paraboloid", "h = 1e-5 r^2: a logarithmic spiral",
           { spiralRay(design(2000.0, 60.0)), 2.0, 40.0, true } } })
  {
    cases.push_back({ c.name, c.title,
      std::string(c.formula) +
        " where C = sqrt(g h). The tracer has full dispersion, so the period is chosen so long that "
        "it adds a millionth, and the difference must fall as 1/T^2.",
      [problem = c.problem](const Setting& setting) { return runShallow(problem, setting); } });
  }
  return cases;
}

}
