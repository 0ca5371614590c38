// Rays on currents: what a jet, an eddy and a current along the wave keep, and wave action.
#include "Families.h"
#include "GridRun.h"
#include "Problems.h"

#include "sim/BuiltinCurrent.h"

#include <fmt/format.h>

#include <cmath>

namespace swellray::validation
{

namespace
{

using reference::Place;
using reference::Real;

/** A flat bed under a current. */
reference::FormulaSeafloor flatBed(double depth, double halfWidth)
{
  reference::Formula formula;
  formula.depth = [depth](const reference::Jet&, const reference::Jet&, unsigned) { return reference::Jet(depth); };
  const glm::dvec2 corner(halfWidth, 50.0 * halfWidth);
  return { formula, { -corner, corner }, halfWidth };
}

RayScene sceneOn(const Seafloor& bed, const Current& current, const reference::CurrentScene& water)
{
  RayScene scene;
  scene.seafloor = &bed;
  scene.current = &current;
  scene.period = water.period;
  scene.agroundDepth = 1e-3 * water.depth;
  scene.by = FrontMeasure::Time;
  scene.map = true;
  scene.depth = [depth = water.depth](const Place&) { return depth; };
  return scene;
}

Outcome compareOnGridsToo(const RayScene& scene, GridPlan plan, double length, const Setting& setting)
{
  RayLimits limits;
  limits.positionReason = "some thousand steps, each right to 1e-12 of a wavelength near 150 m, add up to less";
  Outcome outcome = compareRays(scene, limits, setting);
  plan.spacings = { length / 4.0, length / 8.0, length / 16.0 };
  addGridConvergence(scene, plan, setting, outcome);
  return outcome;
}

}

Outcome runJet(const JetProblem& jet, const Setting& setting)
{
  const reference::FormulaSeafloor bed = flatBed(jet.scene.depth, -2.5 * jet.from);
  const auto current = makeBuiltinCurrent(fmt::format("jet:V0={},width={}", jet.speed, jet.width));
  const reference::JetRay exact(jet.scene, jet.speed, jet.width, jet.from, jet.angle);
  RayScene scene = sceneOn(bed, *current, jet.scene);
  Track track;
  track.start = [&](const RayMedium& medium)
  {
    return reference::startHeading(
      medium, { jet.from, 0.0 }, radians(jet.angle), { 0.0, 1.0 / std::cos(exact.heading()) });
  };
  constexpr int count = 40;
  for (int i = 1; i <= count; ++i)
  {
    if (exact.turns())
    {
      // By the way w, x = turning - w^2, equal steps of which are none of them the turning point, where H is infinite.
      const double share = 1.0 - 2.0 * (i == count ? 1.0 : (i - 0.37) / count);
      const double x = exact.turning() - (exact.turning() - jet.from) * share * share;
      track.places.push_back(exact.at(x, share < 0.0));
    }
    else
    {
      track.places.push_back(exact.at(jet.from - 2.0 * jet.from * i / count));
    }
  }
  scene.tracks = { track };
  return compareOnGridsToo(
    scene, planFor(exact.turns() ? GridOrder::Turning : GridOrder::Straight), jet.width, setting);
}

Outcome runEddy(const EddyProblem& eddy, const Setting& setting)
{
  const reference::FormulaSeafloor bed = flatBed(eddy.scene.depth, -2.5 * eddy.from);
  const auto current = makeBuiltinCurrent(fmt::format("eddy:U0={},radius={}", eddy.speed, eddy.radius));
  RayScene scene = sceneOn(bed, *current, eddy.scene);
  for (const double b : eddy.b)
  {
    const reference::EddyRay exact(eddy.scene, eddy.speed, eddy.radius, eddy.from, b);
    Track track;
    track.start = [&eddy, b](const RayMedium& medium) {
      return reference::startHeading(medium, { eddy.from, b }, 0.0, { 0.0, 1.0 });
    };
    constexpr int count = 30;
    double before = 1.0;
    int caustics = 0;
    for (int i = 1; i <= count; ++i)
    {
      // None is where the ray is nearest, its radial wavenumber the root of a difference.
      Place place = exact.at(exact.start() * (1.0 - 2.0L * (i - 0.37L) / count));
      caustics += (place.width < 0.0) != (before < 0.0) ? 1 : 0;
      place.caustics = caustics;
      before = place.width;
      track.places.push_back(place);
    }
    scene.tracks.push_back(track);
  }
  return compareOnGridsToo(scene, planFor(GridOrder::Curved), eddy.radius, setting);
}

Outcome runCollinear(const CollinearProblem& collinear, const Setting& setting)
{
  const double from = -8.0 * collinear.width;
  const reference::FormulaSeafloor bed = flatBed(collinear.scene.depth, -2.0 * from);
  Outcome all;
  Plot heights{ "height along the current", "distance travelled (m)", "H/H0", {}, false, false };
  Plot grids{ "on grids", "spacing (m)", "position (m), root mean square", {}, true, false };
  for (const double speed : collinear.speeds)
  {
    const reference::CollinearRay exact(collinear.scene, speed, 0.0, collinear.width, from);
    const reference::FormulaCurrent current = exact.formula();
    RayScene scene = sceneOn(bed, current, collinear.scene);
    scene.map = false;
    Track track;
    track.start = [from](const RayMedium& medium) {
      return reference::startHeading(medium, { from, 0.0 }, 0.0, { 0.0, 1.0 });
    };
    for (int i = 1; i <= 30; ++i)
    {
      track.places.push_back(exact.at(from - 2.0 * from * i / 30.0));
    }
    scene.tracks = { track };
    GridPlan plan = planFor(GridOrder::Straight);
    plan.symmetric = true;
    Outcome outcome = compareOnGridsToo(scene, plan, collinear.width, setting);
    for (Check& check : outcome.checks)
    {
      check.quantity += fmt::format(", U = {:.3g} m/s", speed);
      all.checks.push_back(check);
    }
    for (std::vector<double>& row : outcome.numbers.rows)
    {
      row.insert(row.begin(), speed);
      all.numbers.rows.push_back(row);
    }
    all.numbers.columns = outcome.numbers.columns;
    // Of the ray's plots the heights, and of those on grids the position: the rest is symmetry.
    const std::string name = fmt::format("U = {:.3g} m/s", speed);
    Series exactHeights = outcome.plots[1].series[0];
    Series found = outcome.plots[1].series[1];
    exactHeights.name = "";
    found.name = name;
    heights.series.push_back(exactHeights);
    heights.series.push_back(found);
    const std::vector<Series>& errors = outcome.plots.back().series;
    grids.series.push_back(errors[0]);
    grids.series.push_back(errors[1]);
    grids.series.back().name.replace(0, std::string("position (m)").size(), name);
  }
  all.plots = { heights, grids };
  all.numbers.columns.insert(all.numbers.columns.begin(), "U_m_s");
  return all;
}

std::vector<Case> currentCases()
{
  std::vector<Case> cases;
  const reference::CurrentScene deep;
  struct Named
  {
    const char* name;
    const char* title;
    JetProblem jet;
  };
  const char* const across = "Ray across a shear jet";
  for (const Named& c : { Named{ "c8_jet_1", across, { 2.0, 200.0, deep, -1000.0, 40.0 } },
         Named{ "c8_jet_2", across, { -2.5, 250.0, deep, -1200.0, 40.0 } },
         Named{ "c8_jet_3", across, { 1.5, 150.0, { 9.0, 12.0 }, -800.0, 30.0 } },
         Named{ "c8_jet_4", "Ray turned back by a shear jet", { 3.0, 200.0, deep, -1000.0, 62.0 } } })
  {
    cases.push_back({ c.name, c.title,
      fmt::format(
        "V = {:g} exp(-(x/{:g})^2) m/s along y, h = {:g} m, T = {:g} s, {:g} degrees. ky and the flux of wave "
        "action across the jet are kept; y, t and S by quadrature in long double.",
        c.jet.speed, c.jet.width, c.jet.scene.depth, c.jet.scene.period, c.jet.angle),
      [jet = c.jet](const Setting& setting) { return runJet(jet, setting); } });
  }
  // Blocking is at -C0/4 = -3.903 m/s.
  cases.push_back({ "c8_collinear", "Waves along a current",
    "Deep water, T = 10 s, U growing along x to -0.96 of the blocking current -g T/8 pi, to -2.5, 2 and 5 m/s: omega "
    "and "
    "the flux of wave action are kept (Longuet-Higgins and Stewart 1961); t and S by quadrature in long double.",
    [deep](const Setting& setting) {
      return runCollinear({ deep, { -3.75, -2.5, 2.0, 5.0 }, 200.0 }, setting);
    } });
  cases.push_back({ "c8_eddy", "Rays through an eddy",
    "U = 1.5 (r/R) exp((1 - r^2/R^2)/2) m/s, R = 300 m, deep water, T = 10 s, from x = -1500 m along +x: omega and the "
    "angular momentum x ky - y kx are kept; places by quadrature in long double, the tube by neighbours of order 4.",
    [deep](const Setting& setting) {
      return runEddy({ 1.5, 300.0, deep, -1500.0, { -450.0, -150.0, 60.0, 300.0, 600.0 } }, setting);
    } });
  return cases;
}

}
