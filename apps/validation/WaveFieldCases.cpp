// Maps of regular waves against exact fields: a plane fold caustic, and round shoals and lenses.
#include "Families.h"
#include "ReferenceSolutions.h"
#include "RoundWave.h"
#include "TracedField.h"

#include "sim/Airy.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Caustic.h"
#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

namespace swellray::validation
{

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

/** k^2 = k0^2 - mu x: waves from x < 0 turn at the caustic x = length. */
struct PlaneFold
{
  double period = 10.0;
  double depth = 4.0; // at x = 0
  double length = 400.0;
  double angle = Pi / 3.0;
  double omega = 2.0 * Pi / period;
  double k0 = static_cast<double>(reference::wavenumber(omega, depth));
  double ky = k0 * std::sin(angle);
  double mu = (k0 * k0 - ky * ky) / length;
  double scale = std::cbrt(mu); // z = scale (length - x)

  double k(double x) const { return std::sqrt(k0 * k0 - mu * x); }
  double speeds(double x) const // C Cg
  {
    const double h = static_cast<double>(reference::depthOf(omega, k(x)));
    return omega / k(x) * static_cast<double>(reference::groupSpeed(omega, h));
  }
  /** phi_exact, the incident wave of unit height by the approximation of rays at x = 0. */
  double exact(double x) const
  {
    const double z0 = scale * length;
    return 2.0 * std::sqrt(Pi) * std::pow(z0, 0.25) * airy(-scale * (length - x)).value;
  }
};

/**
 * |eta| of the mild-slope equation (C Cg eta')' + (k^2 - ky^2) C Cg eta = 0 at rising places, by Runge-Kutta steps of order 4
 * from where nothing is left of it; of unit incident height by the approximation of rays at x = 0.
 */
std::vector<double> mildSlope(const PlaneFold& fold, const std::vector<double>& x)
{
  constexpr double step = -0.5;
  const auto rates = [&](double at, double f, double g) -> std::pair<double, double>
  {
    const double weight = fold.speeds(at);
    return { g / weight, -weight * (fold.k(at) * fold.k(at) - fold.ky * fold.ky) * f };
  };
  double at = fold.length + 7.0 / fold.scale;
  double f = 1.0;
  double g = -fold.speeds(at) * std::sqrt(fold.ky * fold.ky - fold.k(at) * fold.k(at));
  const auto goTo = [&](double target)
  {
    while (at > target)
    {
      const double h = std::max(step, target - at);
      const auto [f1, g1] = rates(at, f, g);
      const auto [f2, g2] = rates(at + 0.5 * h, f + 0.5 * h * f1, g + 0.5 * h * g1);
      const auto [f3, g3] = rates(at + 0.5 * h, f + 0.5 * h * f2, g + 0.5 * h * g2);
      const auto [f4, g4] = rates(at + h, f + h * f3, g + h * g3);
      f += h / 6.0 * (f1 + 2.0 * f2 + 2.0 * f3 + f4);
      g += h / 6.0 * (g1 + 2.0 * g2 + 2.0 * g3 + g4);
      at += h;
    }
  };
  std::vector<double> eta(x.size());
  for (std::size_t i = x.size(); i-- > 0;)
  {
    goTo(x[i]);
    eta[i] = std::abs(f);
  }
  goTo(0.0);
  // A standing wave of twice the incident height.
  const double kx = fold.k0 * std::cos(fold.angle);
  const double incident = 0.5 * std::hypot(f, g / (fold.speeds(0.0) * kx));
  for (double& value : eta)
  {
    value /= incident;
  }
  return eta;
}

struct FoldErrors
{
  double phi = 0.0; // of its maximum
  double dark = 0.0;
  double uniform = 0.0;
  double mildSlope = 0.0;
  double energy = 0.0;
};

FoldErrors foldErrors(const PlaneFold& fold, const Setting& setting, double spacing, Outcome* outcome)
{
  reference::Formula formula;
  formula.depth = [omega = fold.omega, k0 = fold.k0, mu = fold.mu](const reference::Jet& x, const reference::Jet&,
                    unsigned) { return reference::depthFormula(omega, sqrt(reference::Jet(k0 * k0) - mu * x)); };
  const reference::FormulaSeafloor seafloor(formula,
    { { -0.1 * fold.length, 0.0 }, { fold.length + 6.0 / fold.scale, 10.0 * fold.length } }, 0.1 * fold.length);
  IncidentWave wave;
  wave.period = fold.period;
  wave.directionFrom = 270.0 - 60.0;
  wave.height = 1.0;
  wave.offshoreDepth = fold.depth;
  wave.gravity = setting.gravity;
  TraceOptions trace;
  trace.shoreNormal = 90.0;
  trace.spacing = spacing;
  const TracedField field(seafloor, wave, trace, {});

  std::vector<glm::dvec2> places;
  std::vector<double> x;
  for (double at = 0.0; at < fold.length + 4.0 / fold.scale; at += 4.0)
  {
    x.push_back(at);
    places.emplace_back(at, 8.0 * fold.length);
  }
  const RayMap map = field.at(places, CombineRule::Phase);
  const RayMap energies = field.at(places, CombineRule::Energy);
  const std::vector<double> eta = mildSlope(fold, x);
  double highest = 0.0;
  double highestEta = 0.0;
  double highestUniform = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    highest = std::max(highest, std::abs(fold.exact(x[i])));
    highestEta = std::max(highestEta, eta[i]);
    highestUniform =
      std::max(highestUniform, std::abs(fold.exact(x[i])) * std::sqrt(fold.speeds(0.0) / fold.speeds(x[i])));
  }
  FoldErrors errors;
  const auto largest = [](double& error, double now) { error = now <= error ? error : now; };
  Series exactLine{ "exact, Airy", Series::Look::Line, {}, {} };
  Series dots{ "computed, --combine phase", Series::Look::Dots, {}, {} };
  Series energyDots{ "computed, --combine energy", Series::Look::Dashes, {}, {} };
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double conversion = std::sqrt(fold.speeds(x[i]) / fold.speeds(0.0));
    const double phi = std::abs(fold.exact(x[i]));
    const double error = std::abs(map.height[i] * conversion - phi) / highest;
    largest(errors.phi, error);
    largest(errors.uniform, std::abs(map.height[i] - phi / conversion) / highestUniform);
    largest(errors.mildSlope, std::abs(map.height[i] - eta[i]) / highestEta);
    const double z = fold.scale * (fold.length - x[i]);
    if (z < 0.0)
    {
      largest(errors.dark, error);
    }
    else if (z > 0.5)
    {
      // Two sheets, each as high as its own modulus.
      const double half = 2.0 / 3.0 * z * std::sqrt(z);
      const double each = std::pow(fold.length / (fold.length - x[i]), 0.25) * foldModulus(half) / conversion;
      largest(errors.energy, std::abs(energies.height[i] / (std::sqrt(2.0) * each) - 1.0));
    }
    exactLine.add(x[i], phi / conversion);
    dots.add(x[i], map.height[i]);
    energyDots.add(x[i], energies.height[i]);
    if (outcome)
    {
      outcome->numbers.rows.push_back({ x[i], z, phi, map.height[i] * conversion, phi / conversion, eta[i],
        map.height[i], energies.height[i], static_cast<double>(map.count[i]) });
    }
  }
  if (outcome)
  {
    outcome->numbers.columns = { "x_m", "z", "phi_exact", "phi", "H_uniform", "eta_mse", "height", "height_energy",
      "sheets" };
    outcome->plots.push_back(
      { "across a fold caustic at 400 m", "x (m)", "H/H0", { exactLine, energyDots, dots }, false, false });
  }
  return errors;
}

Outcome foldCase(const Setting& setting)
{
  const PlaneFold fold;
  Outcome outcome;
  const FoldErrors errors = foldErrors(fold, setting, 10.0, &outcome);
  outcome.checks = { { "phi (of its maximum)", errors.phi, 1e-3,
                       "sheets 10 m apart, Airy length 53 m; strips of second order" },
    { "phi on the dark side (of its maximum)", errors.dark, 1e-3, "no rays there: the strip along the caustic" },
    { "H, uniform (of its maximum)", errors.uniform, 1e-2, "phi with the shoaling of leading order" },
    { "H, mild slope (of its maximum)", errors.mildSlope, 1e-2, "the next order of the shoaling, a slope of 1:250" },
    { "height with energies added (relative), z > 0.5", errors.energy, 2e-2, "two moduli; linear in a triangle" } };
  Series line{ "largest error of phi", Series::Look::Dots, {}, {} };
  for (const double spacing : { 160.0, 80.0, 40.0, 20.0 })
  {
    line.add(spacing, foldErrors(fold, setting, spacing, nullptr).phi);
  }
  const double order = fittedOrder(line.x, line.y);
  outcome.checks.push_back({ "order of phi in the spacing", order, 1.5,
    "heights and tubes are linear, phases quadratic between rays", Check::Ask::AtLeast });
  char title[80];
  std::snprintf(title, sizeof title, "error over the spacing of rays: order %.2f", order);
  outcome.plots.push_back(
    { title, "spacing (m)", "phi (of its maximum)", { fittedLine(line, order), line }, true, false });
  return outcome;
}

/** A wave over a round seafloor. */
struct RoundScene
{
  double period = 8.0;
  double depth = 15.0; // outside
  double radius = 250.0;
  std::function<double(double)> depthAt;
  const Seafloor* seafloor = nullptr;
  double spacing = 5.0;
  std::vector<double> across; // transects x = const that are judged, m
  std::vector<double> shown;  // and others
  bool axisIsJudged = true;   // y = 0
};

// Half length of a transect x = const, and ends of the one along y = 0, in radii.
constexpr double Across = 1.2;
constexpr double Before = -1.5;
constexpr double Behind = 3.0;

// What the field by rays may be off by, rms: a plain sum of rays is off by as much where there is no caustic.
constexpr double PlainSum = 0.08;

Outcome roundCase(const RoundScene& scene, const Setting& setting)
{
  const double omega = 2.0 * Pi / scene.period;
  const auto k = [&](double r) { return static_cast<double>(reference::wavenumber(omega, scene.depthAt(r))); };
  const auto speeds = [&](double r)
  { return omega / k(r) * static_cast<double>(reference::groupSpeed(omega, scene.depthAt(r))); };
  const reference::RoundWave helmholtz(
    k, [](double) { return 1.0; }, scene.radius);
  const reference::RoundWave mildSlopes(k, speeds, scene.radius);
  IncidentWave wave;
  wave.period = scene.period;
  wave.directionFrom = 270.0;
  wave.height = 1.0;
  wave.offshoreDepth = scene.depth;
  wave.gravity = setting.gravity;
  TraceOptions trace;
  trace.edge = EdgeRule::None;
  trace.spacing = scene.spacing;
  HeightOptions options;
  options.amplitude = AmplitudeRule::Tube;
  const TracedField field(*scene.seafloor, wave, trace, options);

  Outcome outcome;
  outcome.numbers.columns = { "x_m", "y_m", "phi_exact", "phi", "eta_exact", "height", "height_plain", "sheets" };
  const auto transect = [&](const std::vector<glm::dvec2>& places, const std::string& title, bool along, bool judged)
  {
    const RayMap map = field.at(places, CombineRule::Phase);
    const std::vector<double> plain = field.plainSum(places);
    Series exact{ "exact", Series::Look::Line, {}, {} };
    Series dots{ "computed", Series::Look::Dots, {}, {} };
    double phiSum = 0.0;
    double etaSum = 0.0;
    double plainSum = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const double phi = std::abs(helmholtz.at(places[i].x, places[i].y));
      const double eta = std::abs(mildSlopes.at(places[i].x, places[i].y));
      const double conversion = std::sqrt(speeds(glm::length(places[i])) / speeds(scene.radius));
      phiSum += std::pow(map.height[i] * conversion - phi, 2);
      etaSum += std::pow(map.height[i] - eta, 2);
      plainSum += std::pow(plain[i] - eta, 2);
      exact.add(along ? places[i].x : places[i].y, eta);
      dots.add(along ? places[i].x : places[i].y, map.height[i]);
      outcome.numbers.rows.push_back({ places[i].x, places[i].y, phi, map.height[i] * conversion, eta, map.height[i],
        plain[i], static_cast<double>(map.count[i]) });
    }
    const auto count = static_cast<double>(places.size());
    outcome.plots.push_back({ title, along ? "x (m)" : "y (m)", "H/H0", { exact, dots }, false, false });
    const std::string where = " on " + title + " (rms)";
    const auto ask = judged ? Check::Ask::AtMost : Check::Ask::Nothing;
    outcome.checks.push_back({ "phi" + where, std::sqrt(phiSum / count), PlainSum,
      "less than the plain sum of rays away from caustics", ask });
    outcome.checks.push_back({ "H against mild slope" + where, std::sqrt(etaSum / count), PlainSum,
      "the same, with the shoaling of leading order", ask });
    outcome.checks.push_back({ "H of the plain sum of rays" + where, std::sqrt(plainSum / count), 0.0, "for comparison",
      Check::Ask::Nothing });
  };
  const auto acrossAt = [&](double x, bool judged)
  {
    std::vector<glm::dvec2> places;
    for (int i = -120; i <= 120; ++i)
    {
      places.emplace_back(x, i / 120.0 * Across * scene.radius);
    }
    char title[64];
    std::snprintf(title, sizeof title, "x = %.0f m", x);
    transect(places, title, false, judged);
  };
  std::vector<glm::dvec2> axis;
  for (int i = 0; i <= 225; ++i)
  {
    axis.emplace_back((Before + (Behind - Before) * i / 225.0) * scene.radius, 0.0);
  }
  transect(axis, "y = 0", true, scene.axisIsJudged);
  for (const double x : scene.across)
  {
    acrossAt(x, true);
  }
  for (const double x : scene.shown)
  {
    acrossAt(x, false);
  }
  return outcome;
}

Outcome shoalCase(const Setting& setting)
{
  RoundScene scene;
  scene.depthAt = [](double r)
  {
    const double q = std::max(0.0, 1.0 - r * r / (250.0 * 250.0));
    return 15.0 - 10.5 * q * q * q;
  };
  const std::unique_ptr<Seafloor> seafloor =
    makeBuiltinSeafloor("shoal:kind=poly3,depth=15,height=10.5,radius=250,x0=-1000,x1=1000,y0=-1000,y1=1000");
  scene.seafloor = seafloor.get();
  scene.across = { 75.0, 125.0, 250.0, 500.0 };
  scene.shown = { 350.0, 700.0 };
  Outcome outcome = roundCase(scene, setting);

  // The ray along the axis runs into the cusp.
  const double omega = 2.0 * Pi / scene.period;
  IncidentWave wave;
  wave.period = scene.period;
  wave.directionFrom = 270.0;
  wave.offshoreDepth = scene.depth;
  wave.gravity = setting.gravity;
  TraceOptions trace;
  trace.edge = EdgeRule::None;
  trace.spacing = 2.0;
  const RayField rays = traceWaves(*seafloor, wave, trace);
  const RayCaustic* tip = nullptr;
  for (const RayCaustic& caustic : rays.caustics)
  {
    tip = !tip || std::abs(caustic.position.y) < std::abs(tip->position.y) ? &caustic : tip;
  }
  double error = NotANumber;
  if (tip)
  {
    const auto k = [&](double r) { return static_cast<double>(reference::wavenumber(omega, scene.depthAt(r))); };
    const reference::RoundWave helmholtz(
      k, [](double) { return 1.0; }, scene.radius);
    const double exact = std::abs(helmholtz.at(tip->position.x, tip->position.y));
    const double peak = foldPeak(*tip, roundedCurvature(*tip)) * std::sqrt(k(scene.radius) / k(tip->position.x));
    error = std::abs(peak / exact - 1.0);
  }
  outcome.checks.push_back({ "phi in the tip of the cusp (relative)", error, 0.02,
    "Pearcey's integral at its origin: the next order of the caustic" });
  return outcome;
}

Outcome lensCase(const Setting& setting)
{
  RoundScene scene;
  scene.period = 10.0;
  scene.radius = 500.0;
  const double omega = 2.0 * Pi / scene.period;
  const double k0 = static_cast<double>(reference::wavenumber(omega, scene.depth));
  const double radius = scene.radius;
  scene.depthAt = [=](double r)
  {
    return r < radius ? static_cast<double>(reference::depthOf(omega, k0 * std::sqrt(2.0 - r * r / (radius * radius))))
                      : scene.depth;
  };
  reference::Formula formula;
  formula.depth = [=, depth = scene.depth](const reference::Jet& x, const reference::Jet& y, unsigned region)
  {
    return region
      ? reference::Jet(depth)
      : reference::depthFormula(omega, k0 * sqrt(reference::Jet(2.0) - (x * x + y * y) / (radius * radius)));
  };
  formula.kinks.push_back([radius](const reference::Jet& x, const reference::Jet& y)
    { return x * x + y * y - reference::Jet(radius * radius); });
  const reference::FormulaSeafloor seafloor(
    formula, { { -2.0 * radius, -2.0 * radius }, { 3.2 * radius, 2.0 * radius } }, 0.1 * radius);
  scene.seafloor = &seafloor;
  // From 20 degrees on to 90 from the axis rays come into the focus from a rim at which they graze: shown.
  scene.axisIsJudged = false;
  scene.across = { -250.0, 0.0 };
  scene.shown = { 300.0, 500.0, 750.0 };
  return roundCase(scene, setting);
}

}

std::vector<Case> waveFieldCases()
{
  return { { "c7a_fold_airy", "Across a plane fold caustic",
             "k^2 = k0^2 - mu x, h = atanh(k_inf/k)/k, T = 10 s, h(0) = 4 m, 60 degrees: phi = 2 sqrt(pi) z0^(1/4) "
             "Ai(-z), z = "
             "mu^(1/3) (400 m - x); maps of the whole tracer with --combine phase and energy.",
             foldCase },
    { "c7b_shoal_poly3_wave", "Regular waves over a round shoal",
      "h = 15 - 10.5 (1 - (r/250 m)^2)^3, T = 8 s: exact by partial waves of the equation of Helmholtz and the "
      "mild-slope "
      "equation (Berkhoff 1972); |H| across the way behind the shoal, and in the tip of its cusp.",
      shoalCase },
    { "c7b_luneburg_wave", "Regular waves through a Luneburg lens",
      "k = k0 sqrt(2 - r^2/R^2), R = 500 m, T = 10 s, all rays meet in (R, 0): exact by partial waves.", lensCase } };
}

}
