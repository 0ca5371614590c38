#include "Caustics.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace swellray::validation
{

using reference::Place;

namespace
{

double interpolated(double a, double b, double share)
{
  return a + share * (b - a);
}

/** Places with q = 0, first bracketed coarsely, then linear between places so near that no curvature is left. */
std::vector<Place> exactCaustics(
  const reference::Formula& formula, double omega, const CausticRay& ray, double step, double near)
{
  constexpr int count = 400;
  std::vector<double> lengths;
  for (int i = 1; i <= count; ++i)
  {
    lengths.push_back(ray.reach * i / count);
  }
  const std::vector<Place> coarse = traceMunkArthur(formula, omega, ray.start, lengths, step);
  std::vector<Place> found;
  for (std::size_t i = 1; i < coarse.size(); ++i)
  {
    if ((coarse[i - 1].width < 0.0) == (coarse[i].width < 0.0))
    {
      continue;
    }
    double low = coarse[i - 1].length;
    double high = coarse[i].length;
    double lowWidth = coarse[i - 1].width;
    double highWidth = coarse[i].width;
    std::vector<Place> around;
    // Two rounds of secants: from the bracket to its root, then close around that.
    for (int round = 0; round < 3; ++round)
    {
      const double middle = low + (high - low) * lowWidth / (lowWidth - highWidth);
      const double half = round == 0 ? 0.05 * (high - low) : near;
      around = traceMunkArthur(formula, omega, ray.start, { middle - half, middle + half }, step);
      low = around[0].length;
      high = around[1].length;
      lowWidth = around[0].width;
      highWidth = around[1].width;
    }
    const double share = lowWidth / (lowWidth - highWidth);
    Place place = around[0];
    place.x = interpolated(around[0].x, around[1].x, share);
    place.y = interpolated(around[0].y, around[1].y, share);
    place.phase = interpolated(around[0].phase, around[1].phase, share);
    place.length = interpolated(around[0].length, around[1].length, share);
    place.theta = interpolated(around[0].theta, around[1].theta, share);
    place.width = 0.0;
    place.caustics = static_cast<int>(found.size()) + 1;
    found.push_back(place);
  }
  return found;
}

/** Errors of the places in which the tubes of traced rays have no width. */
struct CausticErrors
{
  double aside = 0.0; // m, of the ray where the exact one has its caustic
  double along = 0.0; // m, from there to its own
  double phase = 0.0; // relative
  double theta = 0.0; // rad
  double miscounted = 0.0;
  double asideSum = 0.0;
  double alongSum = 0.0;
  double found = 0.0;
};

struct KnownCaustic
{
  CausticRay ray;
  Place exact;
};

CausticErrors causticErrors(
  const RayScene& scene, const std::vector<KnownCaustic>& known, double near, const Setting& setting, Outcome* outcome)
{
  const RayMedium medium = mediumOf(scene, setting);
  const auto largest = [](double& error, double now) { error = now <= error ? error : now; };
  Series exactDots{ "exact", Series::Look::Crosses, {}, {} };
  Series dots{ "computed", Series::Look::Dots, {}, {} };
  CausticErrors errors;
  for (const KnownCaustic& one : known)
  {
    const Place& exact = one.exact;
    const Place& begin = one.ray.start;
    HamiltonianRay traced(
      medium, reference::startHeading(medium, { begin.x, begin.y }, begin.theta, { 0.0, 1.0 }), FineTolerance);
    RayPoint before;
    RayPoint after;
    RayPoint point;
    const bool reached = traced.advance(FrontMeasure::Length, exact.length - near, before) &&
      traced.advance(FrontMeasure::Length, exact.length, point) &&
      traced.advance(FrontMeasure::Length, exact.length + near, after);
    const double rate = (after.tubeWidth - before.tubeWidth) / (2.0 * near);
    const double shift = reached ? -point.tubeWidth / rate : std::nan("");
    const double aside = glm::length(point.position - glm::dvec2(exact.x, exact.y));
    const double heading = std::atan2(point.wavenumber.y, point.wavenumber.x);
    largest(errors.aside, aside);
    largest(errors.along, std::abs(shift));
    largest(errors.phase, std::abs(point.phase / exact.phase - 1.0));
    largest(errors.theta, std::abs(std::remainder(heading - exact.theta, 2.0 * Pi)));
    errors.miscounted += before.caustics != exact.caustics - 1 || after.caustics != exact.caustics;
    errors.asideSum += aside * aside;
    errors.alongSum += shift * shift;
    errors.found += 1.0;
    if (outcome)
    {
      exactDots.add(exact.x, exact.y);
      dots.add(point.position.x + shift * point.rayDirection.x, point.position.y + shift * point.rayDirection.y);
      outcome->numbers.rows.push_back(
        { begin.x, begin.y, static_cast<double>(exact.caustics), exact.length, exact.length + shift, exact.x,
          point.position.x, exact.y, point.position.y, exact.theta, heading, exact.phase, point.phase });
    }
  }
  if (outcome)
  {
    outcome->numbers.columns = { "x0_m", "y0_m", "caustic", "length_exact_m", "length_m", "x_exact_m", "x_m",
      "y_exact_m", "y_m", "theta_exact_rad", "theta_rad", "phase_exact_rad", "phase_rad" };
    outcome->plots.push_back({ "points of the caustic", "x (m)", "y (m)", { exactDots, dots }, false, false });
  }
  return errors;
}

/** The same on grids: by how much the caustic is elsewhere, and how fast that falls. */
void addGrids(const RayScene& scene, const std::vector<KnownCaustic>& known, double near, const GridPlan& plan,
  const Setting& setting, Outcome& outcome)
{
  RayScene rays = scene;
  for (const KnownCaustic& one : known)
  {
    const Place start = one.ray.start;
    rays.tracks.push_back({ [start](const RayMedium& medium) {
                             return reference::startHeading(medium, { start.x, start.y }, start.theta, { 0.0, 1.0 });
                           },
      { one.exact } });
  }
  Series aside{ "ray (m)", Series::Look::Dots, {}, {} };
  Series along{ "caustic along the ray (m)", Series::Look::Dots, {}, {} };
  for (const double spacing : plan.spacings)
  {
    double asideSum = 0.0;
    double alongSum = 0.0;
    double count = 0.0;
    for (const double offset : plan.offsets)
    {
      const GriddedScene gridded(rays, plan, spacing, offset, setting);
      const CausticErrors errors = causticErrors(gridded.scene(), known, near, setting, nullptr);
      asideSum += errors.asideSum;
      alongSum += errors.alongSum;
      count += errors.found;
    }
    aside.add(spacing, std::sqrt(asideSum / count));
    along.add(spacing, std::sqrt(alongSum / count));
  }
  const GridRates rates = gridRates(plan.order);
  Plot plot{ "", "spacing (m)", "error, root mean square", {}, true, false };
  plot.title = "on grids: orders";
  addFittedOrder("order of the ray's place in the spacing", aside, rates.path, rates.pathReason, plot, outcome);
  addFittedOrder("order of the caustic's place along it", along, rates.width, rates.widthReason, plot, outcome);
  outcome.plots.push_back(plot);
}

}

Outcome compareCaustics(const RayScene& given, const reference::Formula& formula, const std::vector<CausticRay>& rays,
  double step, double length, const GridPlan& plan, const Setting& setting)
{
  const WrongSeafloor bed(*given.seafloor, setting);
  RayScene scene = given;
  scene.seafloor = &bed;
  const double near = 1e-5 * length;
  std::vector<KnownCaustic> known;
  for (const CausticRay& ray : rays)
  {
    for (const Place& exact : exactCaustics(formula, 2.0 * Pi / scene.period, ray, step, near))
    {
      known.push_back({ ray, exact });
    }
  }
  Outcome outcome;
  const CausticErrors errors = causticErrors(scene, known, near, setting, &outcome);
  const std::string reason = "as a ray's position, and the exact side's steps of order 4";
  outcome.checks = { { "position (m)", errors.aside, 1e-11 * length + 3e-9 * length / 300.0, reason },
    { "place along the ray (m)", errors.along, 3e-9 * length,
      "the tube's 1e-9 over its rate, about one in a third of the form's length" },
    { "heading (rad)", errors.theta, 3e-9, "the position's error over a third of the form's length" },
    { "phase (relative)", errors.phase, 2e-10, "as any ray's" },
    { "caustics counted wrong", errors.miscounted, 0.0, "a count before and after" },
    { "caustics found", errors.found, 1.0, "a shoal focuses", Check::Ask::AtLeast } };
  addGrids(given, known, near, plan, setting, outcome);
  return outcome;
}

}
