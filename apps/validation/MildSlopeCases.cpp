// Whole wave fields by the mild-slope equation: a fold, circular shoals, the elliptic shoal, a breakwater.
#include "CircularForms.h"
#include "DesignedRays.h"
#include "Families.h"
#include "ScatteredWaves.h"

#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"
#include "sim/MildSlope.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>

namespace swellray::validation
{

namespace
{

using Complex = std::complex<double>;

IncidentWave waveOf(double period, double directionFrom, double depth, const Setting& setting)
{
  IncidentWave wave;
  wave.period = period;
  wave.directionFrom = directionFrom;
  wave.height = 2.0; // eta is then of unit amplitude
  wave.offshoreDepth = depth;
  wave.gravity = setting.gravity;
  return wave;
}

MildSlopeOptions lossless(double spacing)
{
  MildSlopeOptions options;
  options.spacing = spacing;
  options.height.breaking = BreakingRule::None;
  options.minDepth = 0.01;
  return options;
}

/** Solve at several spacings, compare, and fit the order. */
struct Convergence
{
  std::vector<double> spacings;
  std::vector<double> errors; ///< over the largest of the exact field

  void addTo(Outcome& outcome, const char* unit, double orderWanted, const char* why) const
  {
    const double order = fittedOrder(this->spacings, this->errors);
    Series dots{ "error", Series::Look::Dots, this->spacings, this->errors };
    outcome.plots.push_back({ "convergence", fmt::format("distance of the nodes ({})", unit),
      "largest error over the maximum", { dots, fittedLine(dots, order) }, true, false });
    outcome.checks.push_back({ "order of the error", order, orderWanted, why, Check::Ask::AtLeast });
  }
};

/** A field around the origin, waves toward +x. */
struct CircularScene
{
  const Seafloor* seafloor;
  const reference::PartialWaves* exact;
  double period;
  double depth;    ///< offshore, m
  double side;     ///< half the scene's, m
  double shortest; ///< wavelength, m
};

Outcome circular(const CircularScene& scene, const Setting& setting)
{
  Outcome outcome;
  outcome.numbers.columns = { "x_m", "y_m", "eta_exact_re", "eta_exact_im", "eta_re", "eta_im" };
  // Away from the nodes, all over the scene.
  std::vector<glm::dvec2> places;
  std::vector<Complex> exact;
  const double step = scene.side / 15.3;
  const Complex shift = std::polar(1.0, scene.exact->offshoreWavenumber() * scene.side);
  double largest = 0.0;
  for (double y = 0.0; y < scene.side; y += step)
  {
    for (double x = -scene.side + 0.4 * step; x < scene.side; x += step)
    {
      places.emplace_back(x, y);
      exact.push_back(scene.exact->at(x, y) * shift);
      largest = std::max(largest, std::abs(exact.back()));
    }
  }
  Convergence convergence;
  Series line{ "exact", Series::Look::Line, {}, {} };
  Series dots{ "computed", Series::Look::Dots, {}, {} };
  const std::vector<double> nodes =
    setting.quick ? std::vector<double>{ 10.0 } : std::vector<double>{ 10.0, 14.0, 20.0, 28.0 };
  for (const double n : nodes)
  {
    const MildSlopeField field = solveMildSlope(
      *scene.seafloor, 0.0, waveOf(scene.period, 270.0, scene.depth, setting), lossless(scene.shortest / n));
    double error = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const Complex eta = field.surface(places[i]);
      error = std::max(error, std::abs(eta - exact[i]));
      if (n == 10.0)
      {
        outcome.numbers.rows.push_back(
          { places[i].x, places[i].y, exact[i].real(), exact[i].imag(), eta.real(), eta.imag() });
      }
    }
    // With fewer nodes errors of either sign cancel in part.
    if (n > 10.0)
    {
      convergence.spacings.push_back(scene.shortest / n);
      convergence.errors.push_back(error / largest);
    }
    if (n == 10.0)
    {
      for (double x = -scene.side; x <= scene.side; x += 0.01 * scene.side)
      {
        line.add(x, std::abs(scene.exact->at(x, 0.0)));
        dots.add(x, std::abs(field.surface({ x, 0.0 })));
      }
      outcome.checks.push_back({ "eta over its maximum, 10 nodes a wave", error / largest, 0.01,
        "one percent is asked; coefficients constant in an element leave (h/R)^2" });
    }
  }
  outcome.plots.push_back({ "modulus of eta along y = 0", "x (m)", "H/H0", { line, dots }, false, false });
  if (!setting.quick)
  {
    convergence.addTo(outcome, "m", 1.7, "second, of coefficients that are constant in an element");
  }
  return outcome;
}

Outcome shoal(const Setting& setting)
{
  const reference::CircularForm form = reference::polynomialShoal(15.0, 10.5, 250.0);
  const reference::PartialWaves exact(
    [&form](double r) { return static_cast<double>(form.depth(r)); }, 250.0, 8.0, StandardGravity);
  const auto seafloor = makeBuiltinSeafloor(form.spec + ",x0=-420,x1=420,y0=-420,y1=420");
  const double shortest = wavelengthOf(solveWavenumber(2.0 * Pi / 8.0, 4.5));
  return circular({ seafloor.get(), &exact, 8.0, 15.0, 420.0, shortest }, setting);
}

Outcome luneburg(const Setting& setting)
{
  static constexpr double R = 500.0;
  const double deep = std::pow(2.0 * Pi / 10.0, 2) / StandardGravity;
  const double k0 = solveWavenumber(2.0 * Pi / 10.0, 15.0);
  const reference::PartialWaves exact(
    [deep, k0](double r)
    {
      const double k = k0 * std::sqrt(2.0 - std::min(r, R) * std::min(r, R) / (R * R));
      return std::atanh(deep / k) / k;
    },
    R, 10.0, StandardGravity);
  const reference::DesignedRay ray = reference::luneburgRay({ 10.0, 15.0, R, 0.0 }, 0.3);
  const reference::FormulaSeafloor seafloor(ray.formula, { { -620.0, -620.0 }, { 620.0, 620.0 } }, ray.feature);
  return circular({ &seafloor, &exact, 10.0, 15.0, 620.0, 2.0 * Pi / (std::sqrt(2.0) * k0) }, setting);
}

Outcome fold(const Setting& setting)
{
  // Far along the caustic, where the wave that it sends back comes from within the scene.
  constexpr double Length = 4800.0;
  constexpr double Width = 600.0;
  constexpr double Period = 10.0;
  const reference::Design design{ Period, 4.0, 400.0, 60.0 };
  const reference::DesignedRay ray = reference::foldParabolaRay(design, reference::Neighbours::Parallel);
  const reference::FormulaSeafloor seafloor(ray.formula, { { 0.0, 0.0 }, { Width, Length } }, ray.feature);
  const auto depth = [&ray](double x)
  { return ray.formula.depth(reference::Jet(x), reference::Jet(0.0), ray.formula.region(x, 0.0)).value; };
  const double k0 = solveWavenumber(2.0 * Pi / Period, 4.0);
  std::vector<double> places;
  for (double x = 3.0; x < Width - 20.0; x += 7.0)
  {
    places.push_back(x);
  }
  const std::vector<double> exact =
    reference::foldedWave(depth, Period, StandardGravity, k0 * std::sin(Pi / 3.0), Width + 150.0, places);
  const double largest = *std::max_element(exact.begin(), exact.end());

  Outcome outcome;
  outcome.numbers.columns = { "x_m", "eta_exact", "eta" };
  Convergence convergence;
  Series line{ "exact", Series::Look::Line, places, exact };
  Series dots{ "computed", Series::Look::Dots, {}, {} };
  const MildSlopeField field =
    solveMildSlope(seafloor, 0.0, waveOf(Period, 210.0, 4.0, setting), lossless(wavelengthOf(k0) / 10.0));
  double error = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double eta = std::abs(field.surface({ places[i], 0.85 * Length }));
    error = std::max(error, std::abs(eta - exact[i]));
    squares += (eta - exact[i]) * (eta - exact[i]);
    dots.add(places[i], eta);
    outcome.numbers.rows.push_back({ places[i], exact[i], eta });
  }
  const double rms = std::sqrt(squares / static_cast<double>(places.size()));
  outcome.checks = { { "eta over its maximum, rms", rms / largest, 0.01, "one percent is asked" },
    { "eta over its maximum", error / largest, 0.02,
      "incoming and outgoing waves at x = 0 are told apart by their WKB form, to 1e-2" } };
  outcome.plots.push_back({ "across the caustic at x = 400 m", "x (m)", "H/H0", { line, dots }, false, false });
  return outcome;
}

Outcome berkhoff(const Setting& setting)
{
  const auto seafloor = makeBuiltinSeafloor("berkhoff");
  const auto solve = [&](double spacing)
  {
    MildSlopeOptions options = lossless(spacing);
    options.sideWalls = true;
    return solveMildSlope(*seafloor, 0.0, waveOf(1.0, 270.0, 0.45, setting), options);
  };
  const std::vector<double> spacings =
    setting.quick ? std::vector<double>{ 0.14, 0.1 } : std::vector<double>{ 0.14, 0.1, 0.0707, 0.05 };
  std::vector<MildSlopeField> fields;
  for (const double spacing : spacings)
  {
    fields.push_back(solve(spacing));
  }
  // Sections of 1982: across at x = 1, 3, 5, 7, 9 and along at y = -2, 0, 2.
  std::vector<glm::dvec2> places;
  for (int s = 0; s < 5; ++s)
  {
    for (double y = -5.0; y <= 5.0; y += 0.1)
    {
      places.emplace_back(1.0 + 2.0 * s, y);
    }
  }
  for (const double y : { -2.0, 0.0, 2.0 })
  {
    for (double x = 0.0; x <= 10.0; x += 0.1)
    {
      places.emplace_back(x, y);
    }
  }
  const auto change = [&](const MildSlopeField& coarse, const MildSlopeField& fine)
  {
    double most = 0.0;
    for (const glm::dvec2& place : places)
    {
      most = std::max(most, std::abs(std::abs(coarse.surface(place)) - std::abs(fine.surface(place))));
    }
    return most;
  };
  Outcome outcome;
  outcome.numbers.columns = { "x_m", "y_m", "H_over_H0" };
  const std::string fine = fmt::format("elements of {:g} m", spacings.back());
  const std::string coarse = fmt::format("elements of {:g} m", spacings.front());
  Series across{ fine, Series::Look::Line, {}, {} };
  Series acrossCoarse{ coarse, Series::Look::Dots, {}, {} };
  Series along{ fine, Series::Look::Line, {}, {} };
  Series alongCoarse{ coarse, Series::Look::Dots, {}, {} };
  for (const glm::dvec2& place : places)
  {
    const double height = std::abs(fields.back().surface(place));
    outcome.numbers.rows.push_back({ place.x, place.y, height });
    if (place.x == 5.0 && std::abs(place.y) <= 5.0 && outcome.numbers.rows.size() <= 505)
    {
      across.add(place.y, height);
      acrossCoarse.add(place.y, std::abs(fields.front().surface(place)));
    }
  }
  for (double x = 0.0; x <= 10.0; x += 0.05)
  {
    along.add(x, std::abs(fields.back().surface({ x, 0.0 })));
    alongCoarse.add(x, std::abs(fields.front().surface({ x, 0.0 })));
  }
  outcome.plots.push_back({ "section 3: x = 5 m", "y (m)", "H/H0", { across, acrossCoarse }, false, false });
  outcome.plots.push_back({ "section 7: y = 0", "x (m)", "H/H0", { along, alongCoarse }, false, false });
  const std::size_t last = fields.size() - 1;
  outcome.checks.push_back({ setting.quick ? "H/H0, 0.14 to 0.1 m" : "H/H0, 0.07 to 0.05 m",
    change(fields[last - 1], fields[last]), setting.quick ? 0.04 : 0.01, "heights to 1e-2 of the incident one" });
  if (!setting.quick)
  {
    Convergence convergence;
    for (std::size_t i = 0; i < last; ++i)
    {
      convergence.spacings.push_back(spacings[i]);
      convergence.errors.push_back(change(fields[i], fields[i + 1]));
    }
    convergence.addTo(outcome, "m", 0.9, "at least first where kinks of the bed lie across elements");
  }
  double highest = 0.0;
  for (double x = 0.0; x <= 10.0; x += 0.05)
  {
    highest = std::max(highest, std::abs(fields.back().surface({ x, 0.0 })));
  }
  outcome.checks.push_back({ "highest H/H0 along y = 0, off 2.4", std::abs(highest - 2.4), 0.1,
    "linear models of others, parabolic ones too, have about 2.4" });
  return outcome;
}

Outcome halfPlane(const Setting& setting)
{
  const auto seafloor = makeBuiltinSeafloor("shoal:height=0,depth=8,x0=-300,x1=300,y0=-150,y1=300");
  const IncidentWave wave = waveOf(8.0, 180.0, 8.0, setting);
  const double k = solveWavenumber(wave.angularFrequency(), 8.0);
  Outcome outcome;
  outcome.numbers.columns = { "x_m", "y_m", "H_over_H0_exact", "H_over_H0" };
  Series line{ "exact, y = 130 m", Series::Look::Line, {}, {} };
  Series dots{ "computed", Series::Look::Dots, {}, {} };
  Convergence convergence;
  const std::vector<double> nodes =
    setting.quick ? std::vector<double>{ 12.0, 24.0 } : std::vector<double>{ 12.0, 24.0, 48.0 };
  for (const double n : nodes)
  {
    MildSlopeOptions options = lossless(wavelengthOf(k) / n);
    options.wall = [](const Rectangle& element)
    {
      const bool stands = element.low.x < 0.0 && element.low.y < 0.0 && element.high.y >= 0.0;
      return stands ? std::optional<double>(1.0) : std::nullopt;
    };
    const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, options);
    double squares = 0.0;
    double count = 0.0;
    const bool finest = n == nodes.back();
    for (double y = 20.0; y < 290.0; y += 22.0)
    {
      for (double x = -200.0; x < 200.0; x += 10.0)
      {
        const double exact = std::abs(reference::halfPlaneWave(k, x, y));
        const double height = std::abs(field.surface({ x, y }));
        squares += (height - exact) * (height - exact);
        count += 1.0;
        if (finest)
        {
          outcome.numbers.rows.push_back({ x, y, exact, height });
        }
        if (finest && y == 130.0)
        {
          line.add(x, exact);
          dots.add(x, height);
        }
      }
    }
    convergence.spacings.push_back(wavelengthOf(k) / n);
    convergence.errors.push_back(std::sqrt(squares / count));
  }
  outcome.plots.push_back({ "behind and beside the wall", "x (m)", "H/H0", { line, dots }, false, false });
  outcome.checks.push_back({ fmt::format("H/H0, rms, {:g} nodes a wave", nodes.back()), convergence.errors.back(), 0.02,
    "the wall is an element thick, and its edge singular" });
  return outcome;
}

}

std::vector<Case> mildSlopeCases()
{
  return {
    { "c7a_fold_airy_mse", "A fold caustic, whole wave",
      "k^2 = k0^2 - mu x, T = 10 s, 60 degrees: the mild-slope equation in one dimension, integrated from the shadow.",
      fold },
    { "c7b_shoal_poly3_wave_mse", "A circular shoal, whole wave",
      "h = 15 - 10.5 (1 - r^2/R^2)^3 m, R = 250 m, T = 8 s: partial waves of the mild-slope equation.", shoal },
    { "c7b_luneburg_wave_mse", "A Luneburg lens, whole wave",
      "k = k0 sqrt(2 - r^2/R^2), R = 500 m, T = 10 s: partial waves of the mild-slope equation.", luneburg },
    { "c7c_berkhoff_mse", "Elliptic shoal in its tank, whole wave",
      "The shoal of Berkhoff, Booij and Radder 1982 between walls, T = 1 s: linear heights on the eight sections, "
      "against "
      "finer grids.",
      berkhoff },
    { "half_plane_mse", "A breakwater",
      "Thin wall on 8 m of water, T = 8 s, waves straight on: Sommerfeld's solution in Fresnel's integrals.",
      halfPlane }
  };
}

}
