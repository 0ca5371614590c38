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

}

Outcome compareCaustics(const RayScene& scene, const reference::Formula& formula, const std::vector<CausticRay>& rays,
  double step, double length, const Setting& setting)
{
  const RayMedium medium = mediumOf(scene, setting);
  const double near = 1e-5 * length;
  Outcome outcome;
  outcome.numbers.columns = { "x0_m", "y0_m", "caustic", "length_exact_m", "length_m", "x_exact_m", "x_m", "y_exact_m",
    "y_m", "phase_exact_rad", "phase_rad" };
  Series exactDots{ "exact", Series::Look::Line, {}, {} };
  Series dots{ "computed", Series::Look::Dots, {}, {} };
  double aside = 0.0;
  double along = 0.0;
  double phase = 0.0;
  double miscounted = 0.0;
  double found = 0.0;
  const auto largest = [](double& error, double now) { error = now <= error ? error : now; };
  for (const CausticRay& ray : rays)
  {
    for (const Place& exact : exactCaustics(formula, medium.angularFrequency, ray, step, near))
    {
      const RayStart start =
        reference::startHeading(medium, { ray.start.x, ray.start.y }, ray.start.theta, { 0.0, 1.0 });
      HamiltonianRay traced(medium, start, FineTolerance);
      RayPoint before;
      RayPoint after;
      RayPoint point;
      const bool reached = traced.advance(FrontMeasure::Length, exact.length - near, before) &&
        traced.advance(FrontMeasure::Length, exact.length, point) &&
        traced.advance(FrontMeasure::Length, exact.length + near, after);
      const double rate = (after.tubeWidth - before.tubeWidth) / (2.0 * near);
      const double shift = reached ? -point.tubeWidth / rate : std::nan("");
      largest(aside, glm::length(point.position - glm::dvec2(exact.x, exact.y)));
      largest(along, std::abs(shift));
      largest(phase, std::abs(point.phase / exact.phase - 1.0));
      miscounted += before.caustics != exact.caustics - 1 || after.caustics != exact.caustics;
      found += 1.0;
      exactDots.add(exact.x, exact.y);
      dots.add(point.position.x + shift * point.rayDirection.x, point.position.y + shift * point.rayDirection.y);
      outcome.numbers.rows.push_back({ ray.start.x, ray.start.y, static_cast<double>(exact.caustics), exact.length,
        exact.length + shift, exact.x, point.position.x, exact.y, point.position.y, exact.phase, point.phase });
    }
    exactDots.add(std::nan(""), std::nan(""));
  }
  outcome.plots.push_back({ "points of the caustic", "x (m)", "y (m)", { exactDots, dots }, false, false });
  const std::string reason = "as a ray's position, and the exact side's steps of order 4";
  outcome.checks = { { "position (m)", aside, 1e-11 * length + 3e-9 * length / 300.0, reason },
    { "place along the ray (m)", along, 3e-9 * length,
      "the tube's 1e-9 over its rate, about one in a third of the form's length" },
    { "phase (relative)", phase, 2e-10, "as any ray's" },
    { "caustics counted wrong", miscounted, 0.0, "a count before and after" },
    { "caustics found", found, 1.0, "a shoal focuses", Check::Ask::AtLeast } };
  return outcome;
}

}
