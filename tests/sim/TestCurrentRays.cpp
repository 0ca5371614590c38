// Rays on currents against closed forms, quadratures and integrations of their own.
#include "Currents.h"

#include "sim/BuiltinCurrent.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/SplineCurrent.h"
#include "sim/WaveHeight.h"

#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace swellray;
using namespace swellray::testing;

namespace
{

constexpr double Tolerance = 1e-12;

const Rectangle Scene{ { -4000.0, -40000.0 }, { 4000.0, 40000.0 } };

/** Deep water, the wave and the current both along x (Longuet-Higgins and Stewart 1961). */
struct Collinear
{
  double still; // c0, m/s
  double speed(double u) const { return 0.5 * this->still * (1.0 + std::sqrt(1.0 + 4.0 * u / this->still)); }
  double wavenumber(double u) const { return StandardGravity / (this->speed(u) * this->speed(u)); }
  double height(double u) const
  {
    const double c = this->speed(u);
    return std::sqrt(this->still * this->still / (c * (c + 2.0 * u)));
  }
};

struct JetRay
{
  double speed;
  double width;
  double depth;
  double period;
  double from;  // x0
  double angle; // of the wavenumber, degrees from +x
};

/** On a jet along y: ky and the flux of action along x are kept; y and t are quadratures over x. */
class JetSolution
{
public:
  explicit JetSolution(const JetRay& ray)
    : Ray(ray)
    , Omega(2.0 * Pi / ray.period)
  {
    const double v = this->current(ray.from);
    // The wavenumber's angle is given: sigma + k V sin(angle) = omega by halving.
    double low = 0.0;
    double high = 100.0;
    for (int i = 0; i < 200; ++i)
    {
      const double k = 0.5 * (low + high);
      const double sigma = std::sqrt(StandardGravity * k * std::tanh(k * ray.depth));
      (sigma + k * v * std::sin(radians(ray.angle)) < this->Omega ? low : high) = k;
    }
    this->Kx0 = low * std::cos(radians(ray.angle));
    this->Ky = low * std::sin(radians(ray.angle));
  }

  struct At
  {
    double kx;
    double sigma;
    double vx;
    double vy;
  };

  double current(double x) const { return this->Ray.speed * std::exp(-std::pow(x / this->Ray.width, 2)); }
  double ky() const { return this->Ky; }
  double kx0() const { return this->Kx0; }

  At at(double x) const
  {
    At a;
    a.sigma = this->Omega - this->Ky * this->current(x);
    const double k = solveWavenumber(a.sigma, this->Ray.depth);
    a.kx = std::sqrt(k * k - this->Ky * this->Ky);
    const double q = k * this->Ray.depth;
    const double n = 0.5 * (1.0 + (q > 300.0 ? 0.0 : 2.0 * q / std::sinh(2.0 * q)));
    const double groupSpeed = n * a.sigma / k;
    a.vx = groupSpeed * a.kx / k;
    a.vy = groupSpeed * this->Ky / k + this->current(x);
    return a;
  }

  /** y and t at x, by Simpson's rule on a fine mesh. */
  glm::dvec2 yAndTime(double x) const
  {
    const int parts = 4000;
    const double h = (x - this->Ray.from) / parts;
    glm::dvec2 sum(0.0);
    for (int i = 0; i <= parts; ++i)
    {
      const At a = this->at(this->Ray.from + i * h);
      const double weight = i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += weight * glm::dvec2(a.vy / a.vx, 1.0 / a.vx);
    }
    return sum * (h / 3.0);
  }

  /** H/H0 from sigma^-1 E Vx = const. */
  double height(double x) const
  {
    const At a = this->at(x);
    const At start = this->at(this->Ray.from);
    return std::sqrt(a.sigma * start.vx / (start.sigma * a.vx));
  }

  RayStart start() const
  {
    RayStart s;
    s.position = { this->Ray.from, 0.0 };
    s.wavenumber = { this->Kx0, this->Ky };
    const At a = this->at(this->Ray.from);
    // As wide as 1 across the ray; nothing changes along y.
    s.dPosition = { 0.0, std::hypot(a.vx, a.vy) / a.vx };
    return s;
  }

private:
  JetRay Ray;
  double Omega;
  double Kx0 = 0.0;
  double Ky = 0.0;
};

/** Classical Runge-Kutta steps of the ray on an eddy in deep water, written for polar velocities. */
glm::dvec4 eddyRay(double u0, double radius, double gravity, glm::dvec4 state, double time, int steps)
{
  const auto rate = [&](const glm::dvec4& s)
  {
    const double r = std::hypot(s.x, s.y);
    const double k = std::hypot(s.z, s.w);
    const double turn = u0 / radius * std::exp(0.5 * (1.0 - r * r / (radius * radius))); // angular velocity
    const double group = 0.5 * std::sqrt(gravity / k);
    // k.U = turn * Lz with Lz = x ky - y kx
    const double lz = s.x * s.w - s.y * s.z;
    const double slope = -turn / (radius * radius) * lz; // times x or y: d turn/dx Lz
    return glm::dvec4(group * s.z / k - turn * s.y, group * s.w / k + turn * s.x, -(slope * s.x + turn * s.w),
      -(slope * s.y - turn * s.z));
  };
  const double h = time / steps;
  for (int i = 0; i < steps; ++i)
  {
    const glm::dvec4 a = rate(state);
    const glm::dvec4 b = rate(state + 0.5 * h * a);
    const glm::dvec4 c = rate(state + 0.5 * h * b);
    const glm::dvec4 d = rate(state + h * c);
    state += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return state;
}

}

TEST(CurrentRays, collinearCurrentsChangeLengthAndHeight)
{
  // Errors of the integration at tolerance 1e-12, over some dozen steps.
  constexpr double Relative = 1e-9;
  for (const double period : { 10.0, 6.0 })
  {
    const Collinear exact{ StandardGravity * period / (2.0 * Pi) };
    for (const double share : { -0.24, -0.1, 0.15, 0.8 })
    {
      const double to = share * exact.still;
      const CollinearCurrent current(0.0, to, 0.0, 300.0);
      const FlatBed bed(Scene, DeepBed);
      const RayMedium medium = mediumWith(bed, current, period);
      RayStart start;
      start.position = { -3900.0, 0.0 };
      start.wavenumber = { exact.wavenumber(current.at(-3900.0)), 0.0 };
      start.dPosition = { 0.0, 1.0 };
      HamiltonianRay ray(medium, start, Tolerance);
      RayPoint point;
      int places = 0;
      for (double s = 0.0; s < 7800.0; s += 100.0)
      {
        ASSERT_TRUE(ray.advance(FrontMeasure::Length, s, point)) << share;
        const double u = current.at(point.position.x);
        EXPECT_NEAR(glm::length(point.wavenumber) / exact.wavenumber(u), 1.0, Relative) << share << " " << s;
        EXPECT_NEAR(amplification(point, medium, 0.5 * exact.still) / exact.height(u), 1.0, Relative) << share;
        EXPECT_EQ(point.rayDirection.y, 0.0);
        ++places;
      }
      EXPECT_EQ(places, 78);
      EXPECT_LT(ray.dispersionError(), Relative);
    }
  }
}

TEST(CurrentRays, keepWhatAJetKeeps)
{
  // Tolerance 1e-12 a step over up to 100 wavelengths; Simpson's rule on 4000 parts is finer.
  constexpr double Place = 1e-6; // m
  constexpr double Relative = 1e-8;
  for (const JetRay& jet : { JetRay{ 2.0, 200.0, DeepBed, 10.0, -1000.0, 40.0 },
         JetRay{ -2.5, 250.0, DeepBed, 10.0, -1200.0, 40.0 }, JetRay{ 1.5, 150.0, 12.0, 9.0, -800.0, 30.0 },
         JetRay{ -1.2, 120.0, 5.0, 7.0, -700.0, -25.0 }, JetRay{ 1.0, 90.0, 25.0, 6.0, -500.0, 55.0 } })
  {
    const JetSolution exact(jet);
    const auto current = makeBuiltinCurrent("jet:V0=" + std::to_string(jet.speed) + ",w=" + std::to_string(jet.width));
    const FlatBed bed(Scene, jet.depth);
    const RayMedium medium = mediumWith(bed, *current, jet.period);
    const RayStart start = exact.start();
    const double group0 = std::hypot(exact.at(jet.from).vx, exact.at(jet.from).vy - exact.current(jet.from));
    HamiltonianRay ray(medium, start, Tolerance);
    RayPoint point;
    for (double time = 0.0; ray.advance(FrontMeasure::Time, time, point) && point.position.x < -jet.from; time += 10.0)
    {
      const glm::dvec2 place = exact.yAndTime(point.position.x);
      EXPECT_NEAR(point.wavenumber.y, exact.ky(), Relative * std::abs(exact.ky()));
      EXPECT_NEAR(point.wavenumber.x, exact.at(point.position.x).kx, Relative * exact.kx0());
      EXPECT_NEAR(point.position.y, place.x, Place) << jet.speed << " " << time;
      EXPECT_NEAR(point.travelTime, place.y, Place) << jet.speed << " " << time;
      EXPECT_NEAR(amplification(point, medium, group0), exact.height(point.position.x), Relative) << time;
      EXPECT_EQ(point.caustics, 0);
    }
    EXPECT_GT(point.position.x, -jet.from);
  }
}

TEST(CurrentRays, carryTheirActionAsEnergyFlux)
{
  // The flux through the tube is kept; the energy is not: the waves take from the jet and give to it.
  const JetRay jet{ -1.2, 120.0, 5.0, 7.0, -700.0, 25.0 };
  const JetSolution exact(jet);
  const auto current = makeBuiltinCurrent("jet:V0=-1.2,w=120");
  const FlatBed bed(Scene, jet.depth);
  const RayMedium medium = mediumWith(bed, *current, jet.period);
  IncidentWave wave;
  wave.period = jet.period;
  wave.height = 1.5;
  wave.offshoreDepth = jet.depth;
  HeightOptions options;
  options.amplitude = AmplitudeRule::Tube;
  options.breaking = BreakingRule::None;
  HamiltonianRay ray(medium, exact.start(), Tolerance);
  RayPoint point;
  double incoming = 0.0;
  double most = 0.0;
  for (double time = 0.0; ray.advance(FrontMeasure::Time, time, point) && point.position.x < -jet.from; time += 10.0)
  {
    const double k = glm::length(point.wavenumber);
    const WaveSpeeds speeds = waveSpeeds(k, point.depth);
    const double shoaling = shoalingCoefficient(point, speeds, wave.groupSpeed(), medium.angularFrequency);
    const double kr = refractionCoefficient(point.tubeWidth);
    const auto state = static_cast<std::uint8_t>(RayState::Alive);
    RayProfile profile;
    profile.count = 1;
    profile.depth = &point.depth;
    profile.wavenumber = &k;
    profile.groupSpeed = &speeds.groupSpeed;
    profile.shoaling = &shoaling;
    profile.krSpacing = &kr;
    profile.krTube = &kr;
    profile.state = &state;
    RayHeights heights;
    computeHeights(profile, wave, options, heights);
    const double energy = SeaWaterDensity * StandardGravity * heights.height[0] * heights.height[0] / 8.0;
    const glm::dvec2 velocity = speeds.groupSpeed / k * point.wavenumber + point.current;
    const double sigma = k * speeds.phaseSpeed;
    constexpr double Relative = 1e-9;
    EXPECT_NEAR(
      heights.energyFlux[0] / (energy * medium.angularFrequency / sigma * glm::length(velocity)), 1.0, Relative);
    const double through = heights.energyFlux[0] * std::abs(point.tubeWidth);
    incoming = time == 0.0 ? through : incoming;
    EXPECT_NEAR(through / incoming, 1.0, Relative);
    most = std::max(most, std::abs(energy * glm::length(velocity) * std::abs(point.tubeWidth) / incoming - 1.0));
  }
  EXPECT_GT(most, 0.02);
}

TEST(CurrentRays, turnBackFromAJetThatTheyCannotCross)
{
  const JetRay jet{ 3.0, 200.0, DeepBed, 10.0, -1000.0, 62.0 };
  const JetSolution exact(jet);
  const auto current = makeBuiltinCurrent("jet:V0=3,w=200");
  const FlatBed bed(Scene, jet.depth);
  const RayMedium medium = mediumWith(bed, *current, jet.period);
  HamiltonianRay ray(medium, exact.start(), Tolerance);
  // Where k = ky: omega - ky V = sqrt(g ky).
  const double v = (medium.angularFrequency - std::sqrt(StandardGravity * exact.ky())) / exact.ky();
  const double turn = -jet.width * std::sqrt(std::log(jet.speed / v));
  RayPoint point;
  double farthest = jet.from;
  double signBefore = 1.0;
  for (double time = 0.0; time < 600.0; time += 0.5)
  {
    ASSERT_TRUE(ray.advance(FrontMeasure::Time, time, point));
    farthest = std::max(farthest, point.position.x);
    if (std::abs(point.position.x - turn) > 5.0)
    {
      const bool back = point.wavenumber.x < 0.0;
      EXPECT_EQ(point.caustics, back ? 1 : 0) << time;
      EXPECT_EQ(point.tubeWidth < 0.0, back) << time;
      // The way back mirrors the way in.
      EXPECT_NEAR(amplification(point, medium, 0.5 * StandardGravity / medium.angularFrequency),
        exact.height(point.position.x), 1e-7)
        << time;
      signBefore = back ? -1.0 : 1.0;
    }
  }
  EXPECT_EQ(signBefore, -1.0);
  // Half a second passes between two looks: the ray turns along a parabola of some metres.
  EXPECT_NEAR(farthest, turn, 0.05);
}

TEST(CurrentRays, keepWhatAnEddyKeeps)
{
  constexpr double Place = 1e-6;     // m; RK4 with 20000 steps is good for 1e-8
  constexpr double Relative = 1e-10; // of the invariants
  struct Eddy
  {
    double speed;
    double radius;
    double period;
    double b;
  };
  for (const Eddy& eddy : { Eddy{ 1.5, 300.0, 10.0, -450.0 }, Eddy{ 1.5, 300.0, 10.0, 150.0 },
         Eddy{ -0.8, 350.0, 7.0, 320.0 }, Eddy{ 2.2, 200.0, 12.0, -60.0 } })
  {
    const auto current =
      makeBuiltinCurrent("eddy:U0=" + std::to_string(eddy.speed) + ",R=" + std::to_string(eddy.radius));
    const FlatBed bed(Scene, DeepBed);
    const RayMedium medium = mediumWith(bed, *current, eddy.period);
    const double omega = medium.angularFrequency;
    RayStart start;
    start.position = { -2500.0, eddy.b };
    start.wavenumber = { omega * omega / StandardGravity, 0.0 };
    start.dPosition = { 0.0, 1.0 };
    HamiltonianRay ray(medium, start, Tolerance);
    const double lz0 = -eddy.b * start.wavenumber.x;
    RayPoint point;
    for (const double time : { 100.0, 300.0, 450.0 })
    {
      ASSERT_TRUE(ray.advance(FrontMeasure::Time, time, point));
      const glm::dvec4 exact = eddyRay(eddy.speed, eddy.radius, StandardGravity,
        { start.position.x, start.position.y, start.wavenumber.x, start.wavenumber.y }, time, 20000);
      EXPECT_NEAR(point.position.x, exact.x, Place);
      EXPECT_NEAR(point.position.y, exact.y, Place);
      EXPECT_NEAR(point.wavenumber.x, exact.z, Relative);
      EXPECT_NEAR(point.wavenumber.y, exact.w, Relative);
      const double lz = point.position.x * point.wavenumber.y - point.position.y * point.wavenumber.x;
      EXPECT_NEAR(lz / lz0, 1.0, 1e-9);
    }
    EXPECT_LT(ray.dispersionError(), 1e-9); // the eddy leaves that much at the start
  }
}

TEST(CurrentRays, carryTheTubeOfTheirNeighbours)
{
  // Central differences of neighbours: their own error is about h^2, 1e-6; over depth and current that both vary.
  constexpr double Step = 0.5; // m
  constexpr double Relative = 2e-4;
  const auto bed = makeBuiltinSeafloor("shoal:kind=gauss");
  const auto current = makeBuiltinCurrent("eddy:U0=1.2,R=350,xc=-300,yc=100");
  const RayMedium medium = mediumWith(*bed, *current, 10.0);
  const auto startAt = [&](double b)
  {
    RayStart start;
    start.position = { -1800.0, b };
    start.wavenumber = { solveWavenumber(medium.angularFrequency, medium.depth(start.position)), 0.0 };
    start.dPosition = { 0.0, 1.0 };
    return start;
  };
  for (const double b : { -400.0, -100.0, 50.0, 300.0 })
  {
    HamiltonianRay middle(medium, startAt(b), Tolerance);
    HamiltonianRay left(medium, startAt(b + Step), Tolerance);
    HamiltonianRay right(medium, startAt(b - Step), Tolerance);
    RayPoint m;
    RayPoint l;
    RayPoint r;
    for (double time = 50.0; time < 350.0; time += 50.0)
    {
      ASSERT_TRUE(middle.advance(FrontMeasure::Time, time, m));
      ASSERT_TRUE(left.advance(FrontMeasure::Time, time, l));
      ASSERT_TRUE(right.advance(FrontMeasure::Time, time, r));
      const glm::dvec2 across(-m.rayDirection.y, m.rayDirection.x);
      const double width = glm::dot(l.position - r.position, across) / (2.0 * Step);
      EXPECT_NEAR(m.tubeWidth, width, Relative * std::max(1.0, std::abs(width))) << b << " " << time;
    }
    // The start on the far rim of the eddy is not quite still.
    EXPECT_GT(m.position.x, 0.0);
  }
}

TEST(CurrentRays, endWhereTheCurrentStopsThem)
{
  for (const double period : { 10.0, 6.0 })
  {
    const Collinear exact{ StandardGravity * period / (2.0 * Pi) };
    const CollinearCurrent current(0.0, -0.5 * exact.still, 0.0, 400.0);
    const FlatBed bed(Scene, DeepBed);
    const RayMedium medium = mediumWith(bed, current, period);
    RayStart start;
    start.position = { -3900.0, 0.0 };
    start.wavenumber = { exact.wavenumber(current.at(-3900.0)), 0.0 };
    start.dPosition = { 0.0, 1.0 };
    HamiltonianRay ray(medium, start, 1e-8);
    RayPoint point;
    EXPECT_FALSE(ray.advance(FrontMeasure::Phase, 1e9, point));
    EXPECT_EQ(ray.endReason(), EndReason::BlockedByCurrent);
    // A share s of the group speed is left at U = -c0/4 (1 - s^2), and k = 4 k0/(1 + s)^2.
    constexpr double Left = 0.01;
    EXPECT_NEAR(current.at(point.position.x) / (-0.25 * exact.still), 1.0 - Left * Left, 1e-7);
    EXPECT_NEAR(glm::length(point.wavenumber) / start.wavenumber.x, 4.0 / ((1.0 + Left) * (1.0 + Left)), 1e-5);
    EXPECT_LT(ray.steps(), 1000u);
  }
}

TEST(CurrentRays, endAtLaunchOnACurrentTooStrong)
{
  const CollinearCurrent current(-6.0, -6.0, 0.0, 400.0);
  const FlatBed bed(Scene, DeepBed);
  const RayMedium medium = mediumWith(bed, current, 6.0);
  RayStart start;
  start.wavenumber = { 0.2, 0.0 };
  HamiltonianRay ray(medium, start, 1e-8);
  RayPoint point;
  EXPECT_FALSE(ray.advance(FrontMeasure::Phase, 1.0, point));
  EXPECT_EQ(ray.endReason(), EndReason::BlockedByCurrent);
  EXPECT_TRUE(std::isfinite(point.position.x + point.rayDirection.x + point.tubeWidth));
}

TEST(CurrentRays, onAGriddedCurrentConvergeToThoseOnTheFormula)
{
  const auto formula = makeBuiltinCurrent("eddy:U0=1.5,R=300");
  const FlatBed bed({ { -1500.0, -1500.0 }, { 1500.0, 1500.0 } }, DeepBed);
  const auto endOf = [&](const Current& current)
  {
    const RayMedium medium = mediumWith(bed, current, 10.0);
    RayStart start;
    start.position = { -1400.0, 160.0 };
    start.wavenumber = { medium.angularFrequency * medium.angularFrequency / medium.gravity, 0.0 };
    start.dPosition = { 0.0, 1.0 };
    HamiltonianRay ray(medium, start, Tolerance);
    RayPoint point;
    EXPECT_TRUE(ray.advance(FrontMeasure::Time, 300.0, point));
    return point;
  };
  const RayPoint exact = endOf(*formula);
  std::vector<double> place;
  std::vector<double> width;
  for (const double spacing : { 60.0, 30.0, 15.0 })
  {
    ElevationGrid u;
    u.origin = { -1500.0, -1500.0 };
    u.spacing = glm::dvec2(spacing);
    u.columns = u.rows = static_cast<std::size_t>(3000.0 / spacing) + 1;
    u.elevation.resize(u.columns * u.rows);
    ElevationGrid v = u;
    for (std::size_t row = 0; row < u.rows; ++row)
    {
      for (std::size_t column = 0; column < u.columns; ++column)
      {
        const glm::dvec2 at = formula->velocity(u.node(column, row));
        u.at(column, row) = at.x;
        v.at(column, row) = at.y;
      }
    }
    const SplineCurrent gridded(u, v);
    const RayPoint point = endOf(gridded);
    place.push_back(glm::length(point.position - exact.position));
    width.push_back(std::abs(point.tubeWidth - exact.tubeWidth));
  }
  // A spline's gradient, which turns the ray, errs as the third power of the spacing and its second derivative, which
  // widens the tube, as the second; averaged along a ray they do better.
  EXPECT_GT(std::log2(place[1] / place[2]), 2.8) << place[1] << " " << place[2];
  EXPECT_GT(std::log2(width[1] / width[2]), 1.8) << width[1] << " " << width[2];
  EXPECT_LT(place[2], 0.01);
}
