// First breaking on a plane beach, H = gamma h.
#include "Families.h"
#include "Problems.h"
#include "ReferenceSolutions.h"

#include "sim/Breaking.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"
#include "sim/HamiltonianRay.h"
#include "sim/LaunchLine.h"
#include "sim/WaveHeight.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellray::validation
{

namespace
{

using reference::Real;

/** Depth at which the wave first breaks, by bisection on H0 Ks Kr = gamma h. */
Real exactDepth(const Breaking& c)
{
  const Real omega = 2.0L * reference::Pi / c.period;
  const Real sine0 = std::sin(static_cast<Real>(c.theta0) * reference::Pi / 180.0L);
  const Real group0 = 0.5L * reference::Gravity / omega;
  const auto excess = [&](Real h)
  {
    const Real sine = sine0 * omega * omega / (reference::Gravity * reference::wavenumber(omega, h));
    const Real kr = std::sqrt(std::sqrt((1.0L - sine0 * sine0) / (1.0L - sine * sine)));
    return c.height * std::sqrt(group0 / reference::groupSpeed(omega, h)) * kr - c.gamma * h;
  };
  Real low = 0.01L * c.height;
  Real high = 10.0L * c.height;
  for (int i = 0; i < 200; ++i)
  {
    const Real middle = 0.5L * (low + high);
    (excess(middle) > 0.0L ? low : high) = middle;
  }
  return 0.5L * (low + high);
}

struct Found
{
  double depth = std::numeric_limits<double>::quiet_NaN();
  double height = 0.0;
  double theta = 0.0; // rad from the shore normal
  double shore = 0.0; // distance from the shoreline, m
  double phaseSpeed = 0.0;
  double groupSpeed = 0.0;
};

/** Type of a breaker as the table's number, 0 to 2, of its Iribarren number and the bounds of plunging (Battjes 1974). */
int exactType(Real iribarren, Real low, Real high)
{
  return iribarren < low ? 0 : iribarren < high ? 1 : 2;
}

/** The same along a traced ray: where the heights first say that it breaks. */
Found tracedBreaking(const Breaking& c, const Setting& setting)
{
  // From a depth in which the wave feels no bottom to the shore at x = 0.
  const double far = std::ceil(1.6 * c.period * c.period / c.slope);
  const double half = 5.0 * far;
  const auto seafloor = makeBuiltinSeafloor("plane:s=" + std::to_string(c.slope) +
    ",x0=-100,x1=" + std::to_string(far) + ",y0=" + std::to_string(-half) + ",y1=" + std::to_string(half));
  IncidentWave wave;
  wave.period = c.period;
  wave.height = c.height;
  wave.directionFrom = 90.0 + c.theta0;
  wave.gravity = setting.gravity;
  RayMedium medium;
  medium.seafloor = seafloor.get();
  medium.angularFrequency = wave.angularFrequency();
  medium.gravity = setting.gravity;
  medium.agroundDepth = 0.1 * c.height;
  const LaunchLine line(*seafloor, 0.0, wave, medium.agroundDepth, { EdgeRule::Contours });
  // On the offshore edge, as far up the wave's way along the shore as there is room.
  LaunchPoint launch = line.at(0.5 * line.length());
  for (int i = 1; i < 400; ++i)
  {
    const LaunchPoint other = line.at(line.length() * i / 400.0);
    const bool offshore = other.position.x > far - 1e-6;
    const bool nowOffshore = launch.position.x > far - 1e-6;
    const double up = std::copysign(1.0, other.wavenumber.y) * (launch.position.y - other.position.y);
    if (offshore && (!nowOffshore || (c.theta0 > 0.0 && up > 0.0)))
    {
      launch = other;
    }
  }
  RayStart start;
  start.position = launch.position;
  start.wavenumber = launch.wavenumber;
  start.dPosition = launch.dPosition;
  start.dWavenumber = launch.dWavenumber;

  HeightOptions options;
  options.amplitude = AmplitudeRule::Tube;
  options.breaking = BreakingRule::Gamma;
  options.gamma = c.gamma;
  const auto at = [&](double length, Found& found)
  {
    HamiltonianRay ray(medium, start, 1e-12);
    RayPoint point;
    if (!ray.advance(FrontMeasure::Length, length, point))
    {
      return true; // ashore: certainly broken
    }
    const double k = glm::length(point.wavenumber);
    const WaveSpeeds speeds = waveSpeeds(k, point.depth, medium.gravity);
    const double group = speeds.groupSpeed;
    const double shoaling = shoalingCoefficient(wave.groupSpeed(), group);
    const double kr = 1.0 / std::sqrt(std::abs(point.tubeWidth));
    const auto state = static_cast<std::uint8_t>(RayState::Alive);
    RayProfile profile;
    profile.count = 1;
    profile.depth = &point.depth;
    profile.wavenumber = &k;
    profile.groupSpeed = &group;
    profile.shoaling = &shoaling;
    profile.krSpacing = &kr;
    profile.krTube = &kr;
    profile.state = &state;
    RayHeights heights;
    computeHeights(profile, wave, options, heights);
    found = { point.depth, heights.height[0], std::atan2(std::abs(point.wavenumber.y), -point.wavenumber.x),
      point.position.x, speeds.phaseSpeed, group };
    return heights.breaking[0] != 0;
  };
  double low = 0.0;
  double high = 5.0 * far;
  Found found;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (at(middle, found) ? high : low) = middle;
  }
  at(low, found);
  return found;
}

}

Outcome runBreaking(const std::vector<Breaking>& waves, const Setting& setting)
{
  Outcome outcome;
  outcome.numbers.columns = { "T_s", "H0_m", "theta0_deg", "slope", "gamma", "hb_exact_m", "hb_m", "Hb_exact_m", "Hb_m",
    "xb_exact_m", "xb_m", "theta_b_exact_deg", "theta_b_deg", "Cb_exact", "Cb", "Cgb_exact", "Cgb", "xi0_exact", "xi0",
    "xib_exact", "xib", "type0_exact", "type0", "typeb_exact", "typeb" };
  Series exactLine{ "exact", Series::Look::Crosses, {}, {} };
  Series dots{ "computed", Series::Look::Dots, {}, {} };
  Series exactXi = exactLine;
  Series xiDots = dots;
  double depth = 0.0;
  double height = 0.0;
  double place = 0.0;
  double angle = 0.0;
  double speed = 0.0;
  double xi = 0.0;
  double types = 0.0;
  const auto largest = [](double& error, double now) { error = now <= error ? error : now; };
  const auto relative = [](double found, Real exact) { return std::abs(found / static_cast<double>(exact) - 1.0); };
  double number = 0.0;
  for (const Breaking& c : waves)
  {
    const Real exact = exactDepth(c);
    const Real omega = 2.0L * reference::Pi / c.period;
    const Real k = reference::wavenumber(omega, exact);
    const Real sine =
      std::sin(static_cast<Real>(c.theta0) * reference::Pi / 180.0L) * omega * omega / (reference::Gravity * k);
    const double theta = static_cast<double>(std::asin(sine));
    const Real exactHeight = c.gamma * exact;
    const Real exactGroup = reference::groupSpeed(omega, exact);
    // tan(beta)/sqrt(H/L0), L0 = 2 pi g/omega^2.
    const Real deepLength = 2.0L * reference::Pi * reference::Gravity / (omega * omega);
    const Real exactXi0 = c.slope / std::sqrt(c.height / deepLength);
    const Real exactXib = c.slope / std::sqrt(exactHeight / deepLength);
    const int exactType0 = exactType(exactXi0, 0.5L, 3.3L);
    const int exactTypeb = exactType(exactXib, 0.4L, 2.0L);

    const Found found = tracedBreaking(c, setting);
    const double xi0 = iribarrenNumber(c.slope, c.height, c.period, setting.gravity);
    const double xib = iribarrenNumber(c.slope, found.height, c.period, setting.gravity);
    // Counted from 1, none being 0.
    const int type0 = static_cast<int>(breakerType(xi0)) - 1;
    const int typeb = static_cast<int>(breakerTypeAtBreaking(xib)) - 1;
    largest(depth, relative(found.depth, exact));
    largest(height, relative(found.height, exactHeight));
    largest(place, relative(found.shore, exact / c.slope));
    largest(angle, std::abs(found.theta - theta));
    largest(speed, relative(found.phaseSpeed, omega / k));
    largest(speed, relative(found.groupSpeed, exactGroup));
    largest(xi, relative(xi0, exactXi0));
    largest(xi, relative(xib, exactXib));
    types += (type0 != exactType0) + (typeb != exactTypeb);
    number += 1.0;
    exactLine.add(number, static_cast<double>(exact));
    dots.add(number, found.depth);
    exactXi.add(static_cast<double>(exactXi0), static_cast<double>(exactXib));
    xiDots.add(xi0, xib);
    outcome.numbers.rows.push_back({ c.period, c.height, c.theta0, c.slope, c.gamma, static_cast<double>(exact),
      found.depth, static_cast<double>(exactHeight), found.height, static_cast<double>(exact / c.slope), found.shore,
      degrees(theta), degrees(found.theta), static_cast<double>(omega / k), found.phaseSpeed,
      static_cast<double>(exactGroup), found.groupSpeed, static_cast<double>(exactXi0), xi0,
      static_cast<double>(exactXib), xib, static_cast<double>(exactType0), static_cast<double>(type0),
      static_cast<double>(exactTypeb), static_cast<double>(typeb) });
  }
  outcome.plots = { { "depth at first breaking", "wave, as in the table", "h (m)", { exactLine, dots }, false, false },
    { "Iribarren numbers", "in deep water, xi_0", "at breaking, xi_b", { exactXi, xiDots }, true, false } };
  constexpr double limit = 2e-9;
  const std::string reason = "the tube's 1e-9; the depth goes as the 4/5 power of the height";
  outcome.checks = { { "breaker depth (relative)", depth, limit, reason },
    { "breaker height (relative)", height, limit, reason },
    { "distance from the shore (relative)", place, limit, "as the depth, on a plane" },
    { "breaker angle (rad)", angle, limit, reason }, { "speeds at breaking (relative)", speed, limit, reason },
    { "Iribarren numbers (relative)", xi, limit, "the inverse root of the height" },
    { "breaker types told wrong", types, 0.0, "by xi_0 and by xi_b, none at a bound (Battjes 1974)" } };
  return outcome;
}

std::vector<Case> breakingCases()
{
  return { { "c6_breaking", "First breaking on a plane beach",
    "H0 Ks Kr = gamma h by bisection in long double, against the first place of a traced ray that is said to break; "
    "the "
    "Iribarren numbers in deep water and at breaking, and the types by both: seven waves of 6 to 15 s, 0.3 to 3 m, 0 "
    "to "
    "70 degrees, slopes of 0.01 to 0.3, gamma of 0.6 to 1.",
    [](const Setting& setting)
    {
      return runBreaking(
        { { 8.0, 1.0, 0.0, 0.02, 0.78 }, { 8.0, 2.0, 30.0, 0.02, 0.78 }, { 12.0, 1.5, 45.0, 0.05, 0.78 },
          { 6.0, 0.5, 60.0, 0.03, 0.6 }, { 15.0, 3.0, 20.0, 0.01, 0.78 }, { 10.0, 1.0, 70.0, 0.1, 1.0 },
          { 14.0, 0.3, 15.0, 0.3, 0.9 } },
        setting);
    } } };
}

}
