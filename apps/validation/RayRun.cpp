#include "RayRun.h"

#include "sim/Dispersion.h"
#include "sim/RayQuantities.h"

#include <glm/geometric.hpp>

#include <algorithm>
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

/** H/H0 of a computed place but for a factor that a ray keeps. */
double computedHeight(const RayMedium& medium, const RayPoint& point)
{
  const WaveSpeeds speeds = waveSpeeds(glm::length(point.wavenumber), point.depth, medium.gravity);
  return shoalingCoefficient(point, speeds, 1.0, medium.angularFrequency) * refractionCoefficient(point.tubeWidth);
}

/** The exact wave at a place. */
struct ExactWave
{
  double wavenumber;
  double phaseSpeed; // relative to the water
  double groupSpeed;
};

ExactWave exactWave(const RayScene& scene, const Place& place)
{
  const double depth = scene.depth(place);
  reference::Real omega = 2.0L * reference::Pi / scene.period;
  reference::Real k = place.wavenumber;
  if (place.wavenumber > 0.0)
  {
    omega = std::sqrt(reference::Gravity * k * std::tanh(k * depth));
  }
  else
  {
    k = reference::wavenumber(omega, depth);
  }
  return { static_cast<double>(k), static_cast<double>(omega / k),
    static_cast<double>(reference::groupSpeed(omega, depth)) };
}

void largest(double& error, double now)
{
  if (!(now <= error))
  {
    error = now;
  }
}

/** Errors of what is known at a place beside the ray and its tube. */
struct WaveErrors
{
  double depth = 0.0; // m
  double wavenumber = 0.0;
  double phaseSpeed = 0.0;
  double groupSpeed = 0.0;
  double height = 0.0;
};

/** Trace at the finest tolerance: plots, numbers and the errors of the waves. */
WaveErrors fillOutcome(const RayScene& scene, const Setting& setting, Outcome& outcome)
{
  Plot paths{ "rays", "x (m)", "y (m)", {}, false, scene.map };
  Plot heights{ "height along the rays", "distance travelled (m)", "H/H0", {}, false, false };
  Series exactPath{ "exact", Series::Look::Line, {}, {} };
  Series path{ "computed", Series::Look::Dots, {}, {} };
  Series exactHeights = exactPath;
  Series computedHeights = path;
  outcome.numbers.columns = { "ray", "length_m", "x_exact_m", "x_m", "y_exact_m", "y_m", "theta_exact_rad", "theta_rad",
    "phase_exact_rad", "phase_rad", "time_exact_s", "time_s", "width_exact", "width", "height_exact", "height",
    "caustics_exact", "caustics", "h_exact_m", "h_m", "k_exact", "k", "C_exact", "C", "Cg_exact", "Cg" };
  const RayMedium medium = mediumOf(scene, setting);
  WaveErrors errors;
  double number = 0.0;
  for (const Track& track : scene.tracks)
  {
    const RayStart start = track.start(medium);
    HamiltonianRay ray(medium, start, FineTolerance);
    RayPoint point;
    ray.advance(scene.by, 0.0, point);
    const double height0 = computedHeight(medium, point);
    Place begin;
    begin.x = start.position.x;
    begin.y = start.position.y;
    const double exactSpeed0 = exactWave(scene, begin).groupSpeed;
    exactPath.add(begin.x, begin.y);
    for (const Place& place : track.places)
    {
      const bool reached = ray.advance(scene.by, targetOf(scene, place), point);
      const double depth = scene.depth(place);
      const ExactWave wave = exactWave(scene, place);
      const double k = glm::length(point.wavenumber);
      const WaveSpeeds speeds = waveSpeeds(k, point.depth, medium.gravity);
      const double exact =
        place.height > 0.0 ? place.height : std::sqrt(exactSpeed0 / wave.groupSpeed / std::abs(place.width));
      const double height = reached ? computedHeight(medium, point) / height0 : NotANumber;
      const bool wide = std::abs(place.width) > NarrowestWidth;
      largest(errors.height, wide ? std::abs(height / exact - 1.0) : 0.0);
      largest(errors.depth, std::abs(point.depth - depth));
      largest(errors.wavenumber, std::abs(k / wave.wavenumber - 1.0));
      largest(errors.phaseSpeed, std::abs(speeds.phaseSpeed / wave.phaseSpeed - 1.0));
      largest(errors.groupSpeed, std::abs(speeds.groupSpeed / wave.groupSpeed - 1.0));
      exactPath.add(place.x, place.y);
      path.add(point.position.x, point.position.y);
      exactHeights.add(place.length, wide ? exact : NotANumber);
      computedHeights.add(place.length, wide ? height : NotANumber);
      outcome.numbers.rows.push_back({ number, place.length, place.x, point.position.x, place.y, point.position.y,
        place.theta, std::atan2(point.wavenumber.y, point.wavenumber.x), place.phase, point.phase, place.time,
        point.travelTime, place.width, point.tubeWidth, exact, height, static_cast<double>(place.caustics),
        static_cast<double>(point.caustics), depth, point.depth, wave.wavenumber, k, wave.phaseSpeed, speeds.phaseSpeed,
        wave.groupSpeed, speeds.groupSpeed });
    }
    exactPath.add(NotANumber, NotANumber);
    exactHeights.add(NotANumber, NotANumber);
    number += 1.0;
  }
  paths.series = { exactPath, path };
  heights.series = { exactHeights, computedHeights };
  outcome.plots = { paths, heights };
  return errors;
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
  medium.current = scene.current;
  return medium;
}

double targetOf(const RayScene& scene, const Place& place)
{
  switch (scene.by)
  {
  case FrontMeasure::Phase:
    return place.phase;
  case FrontMeasure::Time:
    return place.time;
  case FrontMeasure::Length:
    break;
  }
  return place.length;
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
      if (!ray.advance(scene.by, targetOf(scene, place), point))
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

Outcome compareRays(const RayScene& given, const RayLimits& limits, const Setting& setting)
{
  const WrongSeafloor bed(*given.seafloor, setting);
  RayScene scene = given;
  scene.seafloor = &bed;
  Outcome outcome;
  const RayErrors errors = rayErrors(scene, setting, FineTolerance);
  const WaveErrors waves = fillOutcome(scene, setting, outcome);
  addPathChecks(errors, limits, "", outcome.checks);
  outcome.checks.push_back({ "tube width (relative)", errors.width, limits.width, limits.widthReason });
  outcome.checks.push_back(
    { "height (relative)", waves.height, limits.width, "of a constant flux of action, where |q| > 0.1: as the tube" });
  outcome.checks.push_back({ "places with wrong caustics", static_cast<double>(errors.caustics), 0.0, "a count" });
  const std::string here = "what a place off by the position's error finds, and rounding";
  double kilometres = 1.0;
  for (const Track& track : scene.tracks)
  {
    kilometres = track.places.empty() ? kilometres : std::max(kilometres, track.places.back().length / 1000.0);
  }
  outcome.checks.push_back({ "depth (m)", waves.depth, limits.position * kilometres, here });
  outcome.checks.push_back({ "wavenumber (relative)", waves.wavenumber, limits.relative, here });
  outcome.checks.push_back({ "phase speed (relative)", waves.phaseSpeed, limits.relative, here });
  outcome.checks.push_back({ "group speed (relative)", waves.groupSpeed, limits.relative, here });
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
