#include "RayRun.h"

#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace swellray::validation
{

using reference::Place;
using reference::RayErrors;

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double DefaultTolerance = 1e-8;
// Narrower tubes are next to a caustic, where a ray has no height.
constexpr double NarrowestWidth = 0.1;

double groupSpeedOf(const RayMedium& medium, const RayPoint& point)
{
  return waveSpeeds(glm::length(point.wavenumber), point.depth, medium.gravity).groupSpeed;
}

/** H/H0 = sqrt(Cg0/(Cg |q|)), of the exact side. */
double exactHeight(const RayScene& scene, double groupSpeed0, const Place& place)
{
  const auto speed = reference::groupSpeed(2.0L * reference::Pi / scene.period, scene.depth(place));
  return std::sqrt(groupSpeed0 / static_cast<double>(speed) / std::abs(place.width));
}

/** Trace at the finest tolerance: plots, numbers and the error of the heights. */
double fillOutcome(const RayScene& scene, const Setting& setting, Outcome& outcome)
{
  Plot paths{ "rays", "x (m)", "y (m)", {}, false, scene.map };
  Plot heights{ "height along the rays", "distance travelled (m)", "H/H0", {}, false, false };
  Series exactPath{ "exact", Series::Look::Line, {}, {} };
  Series path{ "computed", Series::Look::Dots, {}, {} };
  Series exactHeights = exactPath;
  Series computedHeights = path;
  outcome.numbers.columns = { "ray", "length_m", "x_exact_m", "x_m", "y_exact_m", "y_m", "theta_exact_rad", "theta_rad",
    "phase_exact_rad", "phase_rad", "time_exact_s", "time_s", "width_exact", "width", "height_exact", "height" };
  const RayMedium medium = mediumOf(scene, setting);
  double error = 0.0;
  double number = 0.0;
  for (const Track& track : scene.tracks)
  {
    const RayStart start = track.start(medium);
    HamiltonianRay ray(medium, start, FineTolerance);
    RayPoint point;
    ray.advance(FrontMeasure::Length, 0.0, point);
    const double speed0 = groupSpeedOf(medium, point);
    Place begin;
    begin.x = start.position.x;
    begin.y = start.position.y;
    const double exactSpeed0 =
      static_cast<double>(reference::groupSpeed(2.0L * reference::Pi / scene.period, scene.depth(begin)));
    exactPath.add(begin.x, begin.y);
    for (const Place& place : track.places)
    {
      const double target = scene.by == FrontMeasure::Length ? place.length : place.phase;
      const bool reached = ray.advance(scene.by, target, point);
      const double exact = exactHeight(scene, exactSpeed0, place);
      const double height =
        reached ? std::sqrt(speed0 / groupSpeedOf(medium, point) / std::abs(point.tubeWidth)) : NotANumber;
      const bool wide = std::abs(place.width) > NarrowestWidth;
      if (wide && !(std::abs(height / exact - 1.0) <= error))
      {
        error = std::abs(height / exact - 1.0);
      }
      exactPath.add(place.x, place.y);
      path.add(point.position.x, point.position.y);
      exactHeights.add(place.length, wide ? exact : NotANumber);
      computedHeights.add(place.length, wide ? height : NotANumber);
      outcome.numbers.rows.push_back({ number, place.length, place.x, point.position.x, place.y, point.position.y,
        place.theta, std::atan2(point.wavenumber.y, point.wavenumber.x), place.phase, point.phase, place.time,
        point.travelTime, place.width, point.tubeWidth, exact, height });
    }
    exactPath.add(NotANumber, NotANumber);
    exactHeights.add(NotANumber, NotANumber);
    number += 1.0;
  }
  paths.series = { exactPath, path };
  heights.series = { exactHeights, computedHeights };
  outcome.plots = { paths, heights };
  return error;
}

/**
 * Errors over the tolerance of a step, from loose to fine. The order is fitted where the tolerance sets the steps, not
 * the form's own length, which also bounds them.
 */
void addConvergence(const RayScene& scene, const Setting& setting, Outcome& outcome)
{
  Series dots{ "largest error of position", Series::Look::Dots, {}, {} };
  Series ruled;
  std::size_t fewest = 0;
  for (const double tolerance : { 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10 })
  {
    std::size_t evaluations = 0;
    const double error = rayErrors(scene, setting, tolerance, &evaluations).position;
    fewest = fewest == 0 ? evaluations : fewest;
    dots.add(tolerance, error);
    if (static_cast<double>(evaluations) > 1.2 * static_cast<double>(fewest))
    {
      ruled.add(tolerance, error);
    }
  }
  Plot plot{ "error over tolerance", "tolerance of a step", "position (m a km)", { dots }, true, false };
  constexpr std::size_t enough = 3;
  if (ruled.x.size() >= enough)
  {
    const double order = fittedOrder(ruled.x, ruled.y);
    outcome.checks.push_back({ "order of position in the tolerance", order, 0.75,
      "the error of a step is held to the tolerance, and so is their sum", Check::Ask::AtLeast });
    char title[80];
    std::snprintf(title, sizeof title, "error over tolerance: order %.2f", order);
    plot.title = title;
    plot.series.insert(plot.series.begin(), fittedLine(ruled, order));
  }
  outcome.plots.push_back(plot);
}

}

RayMedium mediumOf(const RayScene& scene, const Setting& setting)
{
  RayMedium medium = reference::mediumOf(*scene.seafloor, scene.period, scene.agroundDepth);
  medium.gravity = setting.gravity;
  return medium;
}

RayErrors rayErrors(const RayScene& scene, const Setting& setting, double tolerance, std::size_t* evaluations)
{
  const RayMedium medium = mediumOf(scene, setting);
  RayErrors errors;
  for (const Track& track : scene.tracks)
  {
    HamiltonianRay ray(medium, track.start(medium), tolerance);
    RayPoint point;
    for (const Place& place : track.places)
    {
      if (!ray.advance(scene.by, scene.by == FrontMeasure::Length ? place.length : place.phase, point))
      {
        errors.position = std::numeric_limits<double>::infinity();
        return errors;
      }
      errors.add(point, place);
    }
    if (evaluations)
    {
      *evaluations += ray.evaluations();
    }
  }
  return errors;
}

void addPathChecks(
  const RayErrors& errors, const RayLimits& limits, const std::string& suffix, std::vector<Check>& checks)
{
  const std::string same = "the same steps, relative";
  checks.push_back({ "position (m a km)" + suffix, errors.position, limits.position, limits.positionReason });
  checks.push_back({ "heading (rad)" + suffix, errors.theta, limits.relative, same });
  checks.push_back({ "phase (relative)" + suffix, errors.phase, limits.relative, same });
  checks.push_back({ "travel time (relative)" + suffix, errors.time, limits.relative, same });
}

Outcome compareRays(const RayScene& scene, const RayLimits& limits, const Setting& setting)
{
  Outcome outcome;
  const RayErrors errors = rayErrors(scene, setting, FineTolerance);
  const double heightError = fillOutcome(scene, setting, outcome);
  addPathChecks(errors, limits, "", outcome.checks);
  outcome.checks.push_back({ "tube width (relative)", errors.width, limits.width, limits.widthReason });
  outcome.checks.push_back(
    { "height (relative)", heightError, limits.width, "H/H0 = sqrt(Cg0/(Cg |q|)) where |q| > 0.1: as the tube" });
  outcome.checks.push_back({ "places with wrong caustics", static_cast<double>(errors.caustics), 0.0, "a count" });
  // Errors go as the tolerance of a step.
  const double looser = DefaultTolerance / FineTolerance;
  const RayErrors usual = rayErrors(scene, setting, DefaultTolerance);
  const std::string reason = "errors go as the tolerance of a step, 1e-8 in place of 1e-12";
  outcome.checks.push_back({ "position (m a km), default", usual.position, looser * limits.position, reason });
  outcome.checks.push_back({ "tube width (relative), default", usual.width, looser * limits.width, reason });
  addConvergence(scene, setting, outcome);
  return outcome;
}

}
