// The dispersion relation and shoaling at normal incidence.
#include "Families.h"
#include "Problems.h"
#include "ReferenceSolutions.h"

#include "sim/Dispersion.h"

#include <cmath>
#include <cstdio>

namespace swellray::validation
{

namespace
{

using reference::Real;

// A few units in the last place of double precision, 2.2e-16 each.
constexpr double WavenumberLimit = 1e-14;
constexpr double SpeedLimit = 5e-14;

void largest(double& error, double computed, double exact)
{
  const double now = std::abs(computed / exact - 1.0);
  if (!(now <= error))
  {
    error = now;
  }
}

Outcome shoaling(const Setting& setting)
{
  Outcome outcome;
  outcome.numbers.columns = { "kh", "Ks_exact", "Ks" };
  Plot plot{ "shoaling", "k h", "Ks", {}, false, false };
  Series exactLine{ "exact", Series::Look::Line, {}, {} };
  Series dots{ "computed", Series::Look::Dots, {}, {} };
  constexpr double period = 10.0;
  IncidentWave wave;
  wave.period = period;
  wave.gravity = setting.gravity;
  const Real omega = 2.0L * reference::Pi / period;
  // Ks of the depth in which the wave has this kh.
  const auto computedAt = [&](Real q)
  {
    const double depth = static_cast<double>(reference::Gravity * q * std::tanh(q) / (omega * omega));
    const double k = solveWavenumber(wave.angularFrequency(), depth, setting.gravity);
    return shoalingCoefficient(wave.groupSpeed(), waveSpeeds(k, depth, setting.gravity).groupSpeed);
  };
  const auto exactAt = [](Real q)
  {
    const Real c = std::cosh(q);
    return static_cast<double>(1.0L / std::sqrt(std::tanh(q) + q / (c * c)));
  };
  double error = 0.0;
  for (int i = 0; i <= 120; ++i)
  {
    const Real q = 0.01L * std::pow(10.0L, i / 40.0L);
    const double computed = computedAt(q);
    largest(error, computed, exactAt(q));
    outcome.numbers.rows.push_back({ static_cast<double>(q), exactAt(q), computed });
    if (q > 0.1L && q < 4.0L)
    {
      exactLine.add(static_cast<double>(q), exactAt(q));
      if (i % 3 == 0)
      {
        dots.add(static_cast<double>(q), computed);
      }
    }
  }
  plot.series = { exactLine, dots };
  outcome.plots = { plot };
  // The least Ks stands where q tanh q = 1, and is 1/sqrt(q).
  Real least = 1.2L;
  for (int i = 0; i < 50; ++i)
  {
    const Real t = std::tanh(least);
    least -= (least * t - 1.0L) / (t + least * (1.0L - t * t));
  }
  const double atLeast = static_cast<double>(1.0L / std::sqrt(least));
  outcome.checks = { { "Ks (relative)", error, SpeedLimit, "some units in the last place of double precision" },
    { "least Ks (relative)", std::abs(computedAt(least) / atLeast - 1.0), SpeedLimit,
      "1/sqrt(q) where q tanh q = 1, in double precision" } };
  return outcome;
}

}

Outcome runDispersion(const std::vector<double>& periods, const Setting& setting)
{
  Outcome outcome;
  outcome.numbers.columns = { "T_s", "h_m", "k_exact", "k", "Cg_exact", "Cg", "Ks_exact", "Ks" };
  Plot plot{ "wavelength over depth", "depth (m)", "wavelength (m)", {}, true, false };
  double k = 0.0;
  double speed = 0.0;
  double group = 0.0;
  double shoaling = 0.0;
  for (const double period : periods)
  {
    const double omega = 2.0 * Pi / period;
    IncidentWave wave;
    wave.period = period;
    wave.gravity = setting.gravity;
    const Real deepGroup = 0.5L * reference::Gravity / omega;
    Series exactLine{ "exact", Series::Look::Line, {}, {} };
    Series dots{ "computed", Series::Look::Dots, {}, {} };
    for (int i = 0; i <= 48; ++i)
    {
      const double depth = 0.01 * std::pow(10.0, i / 8.0);
      const double computed = solveWavenumber(omega, depth, setting.gravity);
      const WaveSpeeds speeds = waveSpeeds(computed, depth, setting.gravity);
      const double ks = shoalingCoefficient(wave.groupSpeed(), speeds.groupSpeed);
      const Real exact = reference::wavenumber(omega, depth);
      const Real exactGroup = reference::groupSpeed(omega, depth);
      const double exactShoaling = static_cast<double>(std::sqrt(deepGroup / exactGroup));
      largest(k, computed, static_cast<double>(exact));
      largest(speed, speeds.phaseSpeed, static_cast<double>(omega / exact));
      largest(group, speeds.groupSpeed, static_cast<double>(exactGroup));
      largest(shoaling, ks, exactShoaling);
      exactLine.add(depth, static_cast<double>(2.0L * reference::Pi / exact));
      if (i % 3 == 0)
      {
        dots.add(depth, wavelengthOf(computed));
      }
      outcome.numbers.rows.push_back({ period, depth, static_cast<double>(exact), computed,
        static_cast<double>(exactGroup), speeds.groupSpeed, exactShoaling, ks });
    }
    exactLine.name = dots.name = ""; // the periods are many: one name each is enough
    plot.series.push_back(exactLine);
    plot.series.push_back(dots);
  }
  char name[64];
  std::snprintf(name, sizeof name, "exact, T = %g to %g s", periods.front(), periods.back());
  plot.series[0].name = name;
  plot.series[1].name = "computed";
  outcome.plots = { plot };
  const std::string digits = "some units in the last place of double precision";
  outcome.checks = { { "wavenumber (relative)", k, WavenumberLimit, digits },
    { "phase speed (relative)", speed, WavenumberLimit, digits },
    { "group speed (relative)", group, SpeedLimit, digits }, { "Ks (relative)", shoaling, SpeedLimit, digits } };
  return outcome;
}

std::vector<Case> dispersionCases()
{
  return {
    { "c1_dispersion", "Dispersion relation",
      "omega^2 = g k tanh(k h) for T = 2 to 600 s and h = 1 cm to 10 km, against Newton's method in long double.",
      [](const Setting& setting) {
        return runDispersion({ 2.0, 5.0, 8.0, 10.0, 14.0, 20.0, 60.0, 600.0 }, setting);
      } },
    { "c1_shoaling", "Shoaling at normal incidence",
      "Ks = (tanh q + q/cosh^2 q)^(-1/2) with q = k h; its least value stands where q tanh q = 1.", shoaling }
  };
}

}
