// The papers' own scheme, Snell's law over steps of fixed length, shown beside the integrator: of first order.
#include "CircularForms.h"
#include "Families.h"
#include "RayRun.h"
#include "StraightForms.h"

#include "sim/BuiltinSeafloor.h"
#include "sim/SnellRay.h"

#include <cmath>

namespace swellray::validation
{

namespace
{

using reference::Place;

/** Rays, each with the one place compared. */
struct SnellScene
{
  const Seafloor* seafloor = nullptr;
  double period = 10.0;
  std::vector<glm::dvec2> from;
  double heading = 0.0;
  std::vector<std::vector<Place>> exact; // the last place of a ray is the one compared
};

Outcome run(const SnellScene& scene, const Setting& setting)
{
  RayMedium medium = reference::mediumOf(*scene.seafloor, scene.period, 0.05);
  medium.gravity = setting.gravity;
  Outcome outcome;
  outcome.numbers.columns = { "step_m", "position_rms_m", "ode_position_rms_m" };
  Plot paths{ "rays, steps of 16 m", "x (m)", "y (m)", {}, false, true };
  Series line{ "exact", Series::Look::Line, {}, {} };
  Series marks{ "Snell's law step by step", Series::Look::Dots, {}, {} };
  const auto rms = [&](const std::function<double(std::size_t)>& error)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < scene.from.size(); ++i)
    {
      sum += error(i) * error(i);
    }
    return std::sqrt(sum / static_cast<double>(scene.from.size()));
  };
  const auto aside = [](const RayPoint& point, const Place& place)
  { return std::hypot(point.position.x - place.x, point.position.y - place.y); };
  const auto startAt = [&](std::size_t i) {
    return reference::startHeading(medium, scene.from[i], scene.heading, { 0.0, 1.0 / std::cos(scene.heading) });
  };
  const double ode = rms(
    [&](std::size_t i)
    {
      HamiltonianRay ray(medium, startAt(i), 1e-8);
      RayPoint point;
      ray.advance(FrontMeasure::Length, scene.exact[i].back().length, point);
      return aside(point, scene.exact[i].back());
    });
  std::vector<double> steps;
  Series dots{ "Snell", Series::Look::Dots, {}, {} };
  for (const double step : { 16.0, 8.0, 4.0, 2.0 })
  {
    const double error = rms(
      [&](std::size_t i)
      {
        SnellRay ray(medium, startAt(i), step);
        RayPoint point;
        for (const Place& place : scene.exact[i])
        {
          ray.advance(FrontMeasure::Length, place.length, point);
          if (step == 16.0)
          {
            line.add(place.x, place.y);
            marks.add(point.position.x, point.position.y);
          }
        }
        line.add(std::nan(""), std::nan(""));
        return aside(point, scene.exact[i].back());
      });
    steps.push_back(step);
    dots.add(step, error);
    outcome.numbers.rows.push_back({ step, error, ode });
    outcome.checks.push_back({ "position, rms (m), steps of " + std::to_string(static_cast<int>(step)) + " m", error,
      0.0, "shown beside the integrator", Check::Ask::Nothing });
  }
  const double order = fittedOrder(steps, dots.y);
  outcome.checks.push_back({ "order of position", order, 0.8, "the scheme is of first order", Check::Ask::AtLeast });
  outcome.checks.push_back({ "position, rms (m), integrator at 1e-8", ode, 1e-4 * dots.y.back(),
    "four digits and more lie between the two at a comparable cost" });
  paths.series = { line, marks };
  char title[80];
  std::snprintf(title, sizeof title, "error over step: order %.2f", order);
  outcome.plots = { paths, { title, "step (m)", "position, rms (m)", { fittedLine(dots, order), dots }, true, false } };
  return outcome;
}

Outcome plane(const Setting& setting)
{
  constexpr double theta0 = radians(45.0);
  const auto seafloor = makeBuiltinSeafloor("plane:s=0.02,x0=-100,x1=12000,y0=-40000,y1=40000");
  SnellScene scene;
  scene.seafloor = seafloor.get();
  scene.heading = Pi - theta0;
  scene.from = { { 2000.0, 0.0 } };
  const reference::StraightRay exact(reference::planeDepth(0.02L), 2.0 * Pi / scene.period, 2000.0, theta0);
  scene.exact.emplace_back();
  for (int i = 1; i <= 18; ++i)
  {
    scene.exact.back().push_back(exact.at(2000.0 - 100.0 * i));
  }
  return run(scene, setting);
}

Outcome shoal(const Setting& setting)
{
  const reference::CircularForm form = reference::gaussianShoal(20.0, 14.0, 300.0);
  const auto seafloor = makeBuiltinSeafloor(form.spec + ",x0=-1900,x1=1900,y0=-1900,y1=1900");
  SnellScene scene;
  scene.seafloor = seafloor.get();
  std::vector<double> lengths;
  for (int i = 1; i <= 28; ++i)
  {
    lengths.push_back(100.0 * i);
  }
  const double apart = setting.quick ? 60.0 : 20.0;
  for (int i = 0; - 600.0 + 1.7 + i * apart < 600.0; ++i)
  {
    Place start;
    start.x = -1800.0;
    start.y = -600.0 + 1.7 + i * apart;
    scene.from.push_back({ start.x, start.y });
    scene.exact.push_back(
      traceMunkArthur(form.formula(), 2.0 * Pi / scene.period, start, lengths, form.feature / 400.0));
  }
  return run(scene, setting);
}

}

std::vector<Case> schemeCases()
{
  const std::string about = "Gonzato and Le Saec 1997, section 3.3: the scheme of --scheme snell. ";
  return { { "c2_plane_A_snell", "Snell's law step by step on a plane beach",
             about + "h = 0.02 x, T = 10 s, 45 degrees, from x = 2000 m to 200 m.", plane },
    { "c4_shoal_gauss_snell", "Snell's law step by step over a Gaussian shoal",
      about + "h = 20 - 14 exp(-r^2/(2 300^2)), T = 10 s, rays of 2800 m past the cusp.", shoal } };
}

}
