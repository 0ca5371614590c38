// Straight parallel contours: Snell's law, trapped rays, and the way from deep water through the whole tracer.
#include "Families.h"
#include "GridRun.h"
#include "Problems.h"
#include "TrappedRay.h"

#include "sim/BuiltinSeafloor.h"
#include "sim/RayQuantities.h"
#include "sim/SplineSeafloor.h"
#include "sim/WaveHeight.h"
#include "sim/WaveTracer.h"
#include "sim/forms/PlaneBeach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellray::validation
{

namespace
{

using reference::Place;
using reference::Real;

/** As far as the grid holds the formula. */
RayScene upTo(RayScene scene, double nearest)
{
  for (Track& track : scene.tracks)
  {
    std::vector<Place>& places = track.places;
    places.erase(
      std::remove_if(places.begin(), places.end(), [nearest](const Place& place) { return place.x < nearest; }),
      places.end());
  }
  return scene;
}

}

Outcome runBeach(const Beach& beach, const Setting& setting)
{
  const auto seafloor =
    makeBuiltinSeafloor(beach.spec + ",x0=-100,x1=" + std::to_string(beach.x0 + 100.0) + ",y0=-40000,y1=40000");
  const double omega = 2.0 * Pi / beach.period;
  const double theta0 = radians(beach.theta0);
  const reference::StraightRay exact(beach.depth, omega, beach.x0, theta0);
  Track track;
  // Parallel rays, a unit apart across: the left of them is -y.
  track.start = [&](const RayMedium& medium) {
    return reference::startHeading(medium, { beach.x0, 0.0 }, Pi - theta0, { 0.0, -1.0 / std::cos(theta0) });
  };
  constexpr int count = 30;
  for (int i = 1; i <= count; ++i)
  {
    track.places.push_back(exact.at(beach.x0 * std::pow(beach.nearest / beach.x0, static_cast<double>(i) / count)));
  }
  RayScene scene;
  scene.seafloor = seafloor.get();
  scene.period = beach.period;
  scene.tracks = { track };
  scene.depth = [&](const Place& place) { return static_cast<double>(beach.depth(place.x)); };
  Outcome outcome = compareRays(scene, {}, setting);
  GridPlan plan = planFor(beach.plane ? GridOrder::Exact : GridOrder::Straight);
  for (const double part : { 1.0, 0.5, 0.25 })
  {
    plan.spacings.push_back(part * beach.coarsest);
  }
  plan.within.low.x = beach.gridFrom;
  addGridConvergence(upTo(scene, beach.nearestOnGrid), plan, setting, outcome);
  return outcome;
}

Outcome runTrapped(const reference::TrappedRay& exact, const Setting& setting)
{
  const auto seafloor =
    makeBuiltinSeafloor("plane:s=" + std::to_string(exact.slope) + ",x0=-1000,x1=20000,y0=-50000,y1=50000");
  const double theta0 = radians(exact.theta0);
  Track track;
  track.start = [&](const RayMedium& medium) {
    return reference::startHeading(medium, { exact.x0, 0.0 }, theta0, { 0.0, 1.0 / std::cos(theta0) });
  };
  const double step = 0.02 * (Pi - 2.0 * theta0);
  for (int i = 1; i <= 50; ++i)
  {
    // No place is the turning point itself, where the width has no sign.
    track.places.push_back(exact.at(theta0 + (i < 50 ? i + 0.37 : i) * step));
  }
  RayScene scene;
  scene.seafloor = seafloor.get();
  scene.period = exact.period;
  scene.tracks = { track };
  scene.depth = [&](const Place& place) { return exact.slope * place.x; };
  Outcome outcome = compareRays(scene, {}, setting);
  GridPlan plan = planFor(GridOrder::Exact);
  plan.spacings = { 0.4 * exact.x0, 0.2 * exact.x0, 0.1 * exact.x0 };
  addGridConvergence(scene, plan, setting, outcome);
  return outcome;
}

namespace
{

/** Errors of a wave traced from deep water onto a plane beach, as `swellray trace` does it. */
struct DeepErrors
{
  double theta = 0.0;
  double kr = 0.0;
  double ks = 0.0;
  double height = 0.0;
};

void largest(double& error, double now)
{
  if (!(now <= error))
  {
    error = now;
  }
}

// Waves towards -x, the shore at x = 0; the crest comes from the side. Depths at the edges are those of this slope.
constexpr double DeepSlope = 0.02;
const Rectangle DeepScene{ { -100.0, -3000.0 }, { 9000.0, 3000.0 } };
constexpr double DeepNearest = 0.52; // m, the least depth that is compared

DeepErrors traceFromDeep(const Seafloor& seafloor, double slope, double period, double degreesFromNormal,
  const Setting& setting, double tolerance, Outcome* outcome)
{
  const double size = DeepSlope / slope;
  IncidentWave wave;
  wave.period = period;
  wave.directionFrom = 90.0 + degreesFromNormal;
  wave.height = 1.5;
  wave.gravity = setting.gravity;
  TraceOptions options;
  options.tolerance = tolerance;
  options.insertion = InsertionRule::None;
  options.leeRays = false;
  options.spacing = 1000.0 * size;
  options.step = 150.0 * size;
  options.agroundDepth = 0.5;
  const RayField field = traceWaves(seafloor, wave, options);
  const std::size_t n = field.points.size();
  std::vector<double> depth(n);
  std::vector<double> k(n);
  std::vector<double> group(n);
  std::vector<double> kr(n);
  std::vector<double> ks(n);
  std::vector<double> position(3 * n);
  std::vector<double> direction(3 * n);
  std::vector<std::uint8_t> state(n);
  RayQuantities quantities;
  quantities.position = position.data();
  quantities.depth = depth.data();
  quantities.wavenumber = k.data();
  quantities.groupSpeed = group.data();
  quantities.krTube = kr.data();
  quantities.shoaling = ks.data();
  quantities.direction = direction.data();
  quantities.state = state.data();
  computeRayQuantities(field, wave, 0.0, quantities);
  HeightOptions heightOptions;
  heightOptions.amplitude = AmplitudeRule::Tube;
  heightOptions.breaking = BreakingRule::None;
  heightOptions.maxRefraction = std::numeric_limits<double>::infinity();
  std::vector<double> height;
  for (std::size_t ray = 0; ray < field.rays.size(); ++ray)
  {
    const std::size_t first = field.offsets[ray];
    RayProfile profile;
    profile.count = field.pointCount(ray);
    profile.depth = depth.data() + first;
    profile.wavenumber = k.data() + first;
    profile.groupSpeed = group.data() + first;
    profile.shoaling = ks.data() + first;
    profile.krSpacing = kr.data() + first;
    profile.krTube = kr.data() + first;
    profile.state = state.data() + first;
    RayHeights heights;
    computeHeights(profile, wave, heightOptions, heights);
    height.insert(height.end(), heights.height.begin(), heights.height.end());
  }

  const Real omega = 2.0L * reference::Pi / period;
  const double sine0 = std::sin(radians(degreesFromNormal));
  DeepErrors errors;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (state[i] == static_cast<std::uint8_t>(RayState::Aground) || !(slope * position[3 * i] > DeepNearest))
    {
      continue;
    }
    const Real h = slope * position[3 * i];
    const Real exactSine = sine0 * omega * omega / (reference::Gravity * reference::wavenumber(omega, h));
    const double theta = static_cast<double>(std::asin(exactSine));
    const double exactKr = static_cast<double>(
      std::sqrt(std::sqrt(1.0L - static_cast<Real>(sine0) * sine0) / std::sqrt(1.0L - exactSine * exactSine)));
    const double exactKs =
      static_cast<double>(std::sqrt(0.5L * reference::Gravity / omega / reference::groupSpeed(omega, h)));
    const double computed = std::atan2(std::abs(direction[3 * i + 1]), -direction[3 * i]);
    largest(errors.theta, std::abs(computed - theta));
    largest(errors.kr, std::abs(kr[i] / exactKr - 1.0));
    largest(errors.ks, std::abs(ks[i] / exactKs - 1.0));
    const double exactHeight = wave.height * exactKr * exactKs;
    largest(errors.height, std::abs(height[i] / exactHeight - 1.0));
    if (outcome)
    {
      outcome->numbers.rows.push_back({ period, degreesFromNormal, static_cast<double>(h), degrees(theta),
        degrees(computed), exactKr, kr[i], exactKs, ks[i], exactHeight, height[i] });
    }
  }
  return errors;
}

}

Outcome runDeepToDepth(const DeepBeach& deep, const Setting& setting)
{
  Outcome outcome;
  outcome.numbers.columns = { "T_s", "theta_deep_deg", "h_m", "theta_exact_deg", "theta_deg", "Kr_exact", "Kr",
    "Ks_exact", "Ks", "H_exact_m", "H_m" };
  const double size = DeepSlope / deep.slope;
  const Rectangle scene{ size * DeepScene.low, size * DeepScene.high };
  const PlaneBeach beach(scene, 90.0, deep.slope, 0.0);
  DeepErrors worst;
  Plot plot{ "height from deep water to the shore", "depth (m)", "H (m)", {}, false, false };
  for (const double period : deep.periods)
  {
    for (const double theta : deep.angles)
    {
      const std::size_t first = outcome.numbers.rows.size();
      const DeepErrors errors = traceFromDeep(beach, deep.slope, period, theta, setting, FineTolerance, &outcome);
      largest(worst.theta, errors.theta);
      largest(worst.kr, errors.kr);
      largest(worst.ks, errors.ks);
      largest(worst.height, errors.height);
      if (period == deep.periods.back())
      {
        Series exact{ "exact, " + std::to_string(static_cast<int>(theta)) + " deg", Series::Look::Line, {}, {} };
        Series dots{ "", Series::Look::Dots, {}, {} };
        std::vector<std::vector<double>> rows(
          outcome.numbers.rows.begin() + static_cast<std::ptrdiff_t>(first), outcome.numbers.rows.end());
        std::sort(rows.begin(), rows.end(), [](const auto& x, const auto& y) { return x[2] < y[2]; });
        const std::size_t every = 1 + rows.size() / 40;
        for (std::size_t i = 0; i < rows.size(); i += every)
        {
          exact.add(rows[i][2], rows[i][9]);
          dots.add(rows[i][2], rows[i][10]);
        }
        plot.series.push_back(exact);
        plot.series.push_back(dots);
      }
    }
  }
  plot.series[1].name = "computed";
  outcome.plots = { plot };
  const DeepErrors usual =
    traceFromDeep(beach, deep.slope, deep.periods.back(), deep.angles[deep.angles.size() / 2], setting, 1e-8, nullptr);
  constexpr double fine = 2e-10;
  const std::string steps = "some hundred steps, each right to 1e-12";
  outcome.checks = { { "heading (rad)", worst.theta, fine, steps },
    { "Kr (relative)", worst.kr, 1e-9, "as any tube's width" }, { "Ks (relative)", worst.ks, fine, steps },
    { "H (relative)", worst.height, 1e-9, "product of Ks and Kr" },
    { "H (relative), default", usual.height, 1e-5, "errors go as the tolerance of a step, 1e-8 in place of 1e-12" } };
  for (const double spacing : { 200.0 * size, 100.0 * size, 50.0 * size })
  {
    const SplineSeafloor grid(
      sampledGrid([&](const glm::dvec2& p) { return -deep.slope * p.x; }, scene, glm::dvec2(spacing), 0.0));
    const DeepErrors gridded = traceFromDeep(
      grid, deep.slope, deep.periods.back(), deep.angles[deep.angles.size() / 2], setting, FineTolerance, nullptr);
    const std::string at = ", grid of " + std::to_string(static_cast<int>(spacing)) + " m";
    const std::string reason = "a cubic spline reproduces a plane at any spacing: as on the formula";
    outcome.checks.push_back({ "heading (rad)" + at, gridded.theta, 10.0 * fine, reason });
    outcome.checks.push_back({ "H (relative)" + at, gridded.height, 1e-8, reason });
  }
  return outcome;
}

std::vector<Case> straightCases()
{
  std::vector<Case> cases;
  for (const Beach& beach :
    { Beach{ "c2_plane_A", "Plane beach, 1 in 50, 45 degrees", "h = 0.02 x, T = 10 s", "plane:s=0.02",
        reference::planeDepth(0.02L), 10.0, 2000.0, 45.0, 5.0, true, 200.0, 0.0, -100.0 },
      Beach{ "c2_plane_B", "Plane beach, 1 in 20, 30 degrees", "h = 0.05 x, T = 7 s", "plane:s=0.05",
        reference::planeDepth(0.05L), 7.0, 1500.0, 30.0, 2.0, true, 100.0, 0.0, -100.0 },
      Beach{ "c2_plane_C_deep70", "Plane beach, 1 in 100, 70 degrees", "h = 0.01 x, T = 12 s", "plane:s=0.01",
        reference::planeDepth(0.01L), 12.0, 12000.0, 70.0, 10.0, true, 400.0, 0.0, -100.0 },
      Beach{ "c5_dean_A", "Dean's equilibrium beach", "h = 0.12 x^(2/3), T = 9 s", "dean:A=0.12",
        reference::deanDepth(0.12L), 9.0, 3000.0, 40.0, 5.0, false, 50.0, 300.0, 40.0 },
      Beach{ "c5_bar_A", "Barred beach", "h = 0.02 x - 2 exp(-((x - 200)/40)^2), T = 9 s",
        "bar:s=0.02,hb=2,xb=200,wb=40", reference::barDepth(0.02L, 2.0L, 200.0L, 40.0L), 9.0, 1500.0, 40.0, 10.0, false,
        10.0, 10.0, -100.0 } })
  {
    cases.push_back({ beach.name, beach.title,
      beach.formula +
        ". Snell's law: k sin(theta) is constant; y, S and t by quadrature in long double, q = cos(theta)/cos(theta0).",
      [beach](const Setting& setting) { return runBeach(beach, setting); } });
  }
  cases.push_back({ "c2_deep_to_depth", "From deep water to any depth",
    "Waves of 8 and 12 s from deep water at 20, 45 and 70 degrees onto h = 0.02 x by the whole tracer, launch "
    "included: "
    "sin(theta)/C, Kr and Ks in closed form.",
    [](const Setting& setting) {
      return runDeepToDepth({ 0.02, { 8.0, 12.0 }, { 20.0, 45.0, 70.0 } }, setting);
    } });
  const auto trapped = [&cases](const char* name, const char* formula, const reference::TrappedRay& ray)
  {
    cases.push_back({ name, "Ray trapped by a plane beach",
      std::string(formula) +
        ". The ray turns where k = k sin(theta) of its start and comes back to the shore; by quadrature over the "
        "heading.",
      [ray](const Setting& setting) { return runTrapped(ray, setting); } });
  };
  trapped("c5_trapped_plane_1", "h = 0.02 x, T = 10 s, from x = 100 m at 50 degrees from the seaward normal",
    { 0.02, 10.0, 100.0, 50.0 });
  trapped("c5_trapped_plane_2", "h = 0.01 x, T = 60 s, from x = 300 m at 30 degrees from the seaward normal",
    { 0.01, 60.0, 300.0, 30.0 });
  return cases;
}

}
