// Caustics that rays touch, and the heights next to them, against plane and circular folds in closed form.
#include "sim/Caustic.h"
#include "sim/CausticRates.h"
#include "sim/Dispersion.h"
#include "sim/RayQuantities.h"
#include "sim/WaveHeight.h"
#include "sim/WaveTracer.h"

#include "DesignedRays.h"
#include "RayComparison.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace swellray;
using namespace swellray::reference;

namespace
{

constexpr double Tolerance = 1e-12;

// As a ray's own position and phase, and its tube.
constexpr double PositionTolerance = 1e-7;
constexpr double RelativeTolerance = 1e-9;

// k^2 = k0^2 - mu x: the caustic is the line x = length.
const Design Folds[] = { { 10.0, 4.0, 400.0, 60.0 }, { 8.0, 2.0, 300.0, 50.0 }, { 15.0, 4.0, 900.0, 35.0 } };

struct PlaneFold
{
  DesignedRay designed;
  FormulaSeafloor bed;
  RayMedium medium;
  double k0;
  double ky;
  double mu;

  explicit PlaneFold(const Design& d)
    : designed(foldParabolaRay(d, Neighbours::Parallel))
    , bed(designed.seafloor())
    , medium(mediumOf(bed, d.period, 1e-3))
    , k0(static_cast<double>(wavenumber(2.0 * swellray::Pi / d.period, d.depth)))
    , ky(k0 * std::sin(d.angle * swellray::Pi / 180.0))
    , mu((k0 * k0 - ky * ky) / d.length)
  {
  }

  /** Phase at which a ray that starts with 0 turns. */
  double turningPhase() const
  {
    const double tau = 2.0 * std::sqrt(this->k0 * this->k0 - this->ky * this->ky) / this->mu;
    return this->k0 * this->k0 * tau - this->mu * this->mu * tau * tau * tau / 6.0;
  }

  /** The ray that starts at y, in its tube, as far as this phase. */
  RayField trace(const std::vector<double>& starts, double phase, double step) const
  {
    RayField field;
    for (const double y : starts)
    {
      RayStart start = this->designed.start(this->medium);
      const double parameter = y / start.dPosition.y;
      start.position.y = y;
      start.phase = this->ky * y;
      HamiltonianRay ray(this->medium, start, Tolerance);
      RayPoint point;
      const double first = start.phase;
      for (double s = first; s < first + phase; s += step)
      {
        EXPECT_TRUE(ray.advance(FrontMeasure::Phase, s, point));
        point.spacingWidth = std::nan("");
        field.points.push_back(point);
      }
      for (RayCaustic caustic : ray.caustics())
      {
        caustic.ray = static_cast<std::int32_t>(field.rays.size());
        field.caustics.push_back(caustic);
      }
      field.rays.emplace_back();
      field.rays.back().launchParameter = parameter;
      field.offsets.push_back(field.points.size());
    }
    findCausticRates(field);
    return field;
  }
};

}

TEST(RayCaustics, areTouchedWhereTheRayTurns)
{
  for (const Design& d : Folds)
  {
    const PlaneFold fold(d);
    const double turning = 2.0 * std::sqrt(fold.k0 * fold.k0 - fold.ky * fold.ky) / fold.mu;
    const RayField field = fold.trace({ 0.0 }, 1.5 * fold.turningPhase(), 3.0);
    ASSERT_EQ(field.caustics.size(), 1u);
    const RayCaustic& caustic = field.caustics[0];
    EXPECT_EQ(caustic.number, 1);
    EXPECT_NEAR(caustic.position.x, d.length, PositionTolerance);
    EXPECT_NEAR(caustic.phase / fold.turningPhase(), 1.0, PositionTolerance);
    EXPECT_NEAR(caustic.position.y, fold.ky * turning, 1e3 * PositionTolerance); // the ray runs along y there
    EXPECT_NEAR(caustic.rayDirection.y, 1.0, RelativeTolerance);
    EXPECT_NEAR(caustic.wavenumber.y / fold.ky, 1.0, RelativeTolerance);
    EXPECT_NEAR(caustic.wavenumber.x / fold.ky, 0.0, RelativeTolerance);
    EXPECT_NEAR(caustic.fanWavenumber / fold.ky, 1.0, RelativeTolerance);
    EXPECT_NEAR(caustic.phaseRate / fold.ky, 1.0, RelativeTolerance);
    // beta = cos theta/cos theta0, cos theta = (kx0 - mu tau/2)/k, ds = k d tau.
    const double rate = -fold.mu / (2.0 * fold.ky * fold.ky * std::cos(d.angle * swellray::Pi / 180.0));
    EXPECT_NEAR(caustic.widthRate / rate, 1.0, RelativeTolerance);
    EXPECT_TRUE(std::isnan(caustic.alongRate)); // it has no neighbour
  }
}

TEST(RayCaustics, areReportedOnlyAsFarAsTheRayWasRead)
{
  const PlaneFold fold(Folds[0]);
  HamiltonianRay ray(fold.medium, fold.designed.start(fold.medium), Tolerance);
  RayPoint point;
  ray.advance(FrontMeasure::Phase, 1.0, point);
  EXPECT_TRUE(ray.caustics().empty());
  int seen = 0;
  for (double s = 2.0; s < 300.0 && ray.advance(FrontMeasure::Phase, s, point); s += 1.0)
  {
    const std::vector<RayCaustic> caustics = ray.caustics();
    ASSERT_EQ(static_cast<int>(caustics.size()), point.caustics) << s;
    seen = point.caustics;
    if (seen > 0)
    {
      EXPECT_LE(caustics[0].phase, s);
    }
  }
  EXPECT_EQ(seen, 1);
}

TEST(RayCaustics, aPlaneFoldIsStraight)
{
  for (const Design& d : Folds)
  {
    const PlaneFold fold(d);
    const RayField field = fold.trace({ 0.0, 40.0, 110.0 }, 1.5 * fold.turningPhase(), 3.0);
    ASSERT_EQ(field.caustics.size(), 3u);
    for (const RayCaustic& caustic : field.caustics)
    {
      // As far along as the rays start, whose parameter is y cos theta0.
      EXPECT_NEAR(caustic.alongRate * std::cos(d.angle * swellray::Pi / 180.0), 1.0, 1e-7);
      EXPECT_NEAR(caustic.alongChange, 0.0, 1e-8);
      // A straight line has the ray's own curvature, d theta/ds = mu/(2 ky^2), less.
      EXPECT_NEAR(caustic.widthRate / caustic.alongRate / (-fold.mu / (2.0 * fold.ky * fold.ky)), 1.0, 1e-7);
      EXPECT_NEAR(roundedCurvature(caustic) / (fold.mu / (2.0 * fold.ky * fold.ky)), 1.0, 1e-7);
    }
  }
}

TEST(RayCaustics, aRoundFoldHasItsRadius)
{
  // Parabolas around the origin, turned about it, touch the circle of their vertices.
  const Design d{ 10.0, 12.0, 1000.0, 40.0 };
  const DesignedRay designed = islandParabolaRay(d);
  const FormulaSeafloor bed = designed.seafloor();
  const RayMedium medium = mediumOf(bed, d.period, 1e-3);
  const double vertex = d.length * std::pow(std::sin(d.angle * swellray::Pi / 180.0), 2);
  RayField field;
  const RayStart start = designed.start(medium);
  for (const double parameter : { -2.0, 0.0, 3.0 })
  {
    // A unit of the tube turns by 1/(r0 cos heading).
    const double turn = parameter / (d.length * std::cos(designed.heading));
    const auto turned = [turn](const glm::dvec2& v)
    { return glm::dvec2(std::cos(turn) * v.x - std::sin(turn) * v.y, std::sin(turn) * v.x + std::cos(turn) * v.y); };
    RayStart from = start;
    from.position = turned(start.position);
    from.wavenumber = turned(start.wavenumber);
    from.dPosition = turned(start.dPosition);
    from.dWavenumber = turned(start.dWavenumber);
    HamiltonianRay ray(medium, from, Tolerance);
    RayPoint point;
    ray.advance(FrontMeasure::Phase, designed.places.back().phase, point);
    for (RayCaustic caustic : ray.caustics())
    {
      caustic.ray = static_cast<std::int32_t>(field.rays.size());
      field.caustics.push_back(caustic);
    }
    field.rays.emplace_back();
    field.rays.back().launchParameter = parameter;
  }
  ASSERT_EQ(field.caustics.size(), 3u);
  findCausticRates(field);
  // The radius of curvature of a parabola at its vertex is twice the distance of its focus. The neighbours are 1/300 of
  // the radius away, and their differences of second order.
  const double expected = 1.0 / vertex - 1.0 / (2.0 * vertex);
  EXPECT_NEAR(std::abs(field.caustics[1].widthRate / field.caustics[1].alongRate) / expected, 1.0, 2e-5);
}

TEST(RayCaustics, ratesAreOfSecondOrderInTheDistanceOfTheRays)
{
  // A caustic whose way is l = 2 lambda + 0.3 lambda^2 + 0.05 lambda^3, at unequal distances.
  const auto errorAt = [](double size, bool middle)
  {
    RayField field;
    for (const double part : { -1.0, 0.0, 1.5 })
    {
      const double lambda = part * size + (middle ? 0.0 : size);
      RayCaustic caustic;
      caustic.ray = static_cast<std::int32_t>(field.rays.size());
      caustic.number = 1;
      caustic.rayDirection = { 0.6, 0.8 };
      caustic.position = (2.0 * lambda + 0.3 * lambda * lambda + 0.05 * std::pow(lambda, 3)) * caustic.rayDirection;
      field.caustics.push_back(caustic);
      field.rays.emplace_back();
      field.rays.back().launchParameter = lambda;
    }
    findCausticRates(field);
    return std::abs(field.caustics[middle ? 1 : 0].alongRate - 2.0);
  };
  for (const bool middle : { true, false })
  {
    const double order = std::log2(errorAt(0.2, middle) / errorAt(0.1, middle));
    EXPECT_NEAR(order, 2.0, 1e-6) << middle;
  }
}

TEST(RayCaustics, neighboursAreOfTheSameKind)
{
  RayField field;
  for (int i = 0; i < 4; ++i)
  {
    RayCaustic caustic;
    caustic.ray = i;
    caustic.number = i == 3 ? 2 : 1;
    caustic.rayDirection = { 1.0, 0.0 };
    caustic.position = { 3.0 * i, 0.0 };
    field.caustics.push_back(caustic);
    field.rays.emplace_back();
    field.rays.back().launchParameter = i;
  }
  field.rays[0].launchSegment = -1;
  findCausticRates(field);
  EXPECT_TRUE(std::isnan(field.caustics[0].alongRate)); // of another piece of the launch line
  EXPECT_NEAR(field.caustics[1].alongRate, 3.0, 1e-12);
  EXPECT_NEAR(field.caustics[2].alongRate, 3.0, 1e-12);
  EXPECT_TRUE(std::isnan(field.caustics[3].alongRate)); // touches another caustic
}

TEST(RayCaustics, aWaveBreaksByTheUniformHeight)
{
  // The rays of a fold with their heights over a level bed, so that only refraction makes the wave higher there.
  const PlaneFold fold(Folds[0]);
  const RayField field = fold.trace({ 0.0, 30.0, 60.0 }, 1.5 * fold.turningPhase(), 2.0 * swellray::Pi / 64.0);
  ASSERT_EQ(field.caustics.size(), 3u);
  const std::size_t count = field.pointCount(1);
  const double level = 20.0;
  std::vector<double> phase, k, kr;
  for (std::size_t i = field.offsets[1]; i < field.offsets[1] + count; ++i)
  {
    phase.push_back(field.points[i].phase);
    k.push_back(glm::length(field.points[i].wavenumber));
    kr.push_back(refractionCoefficient(field.points[i].tubeWidth));
  }
  const std::vector<double> depth(count, level), groupSpeed(count, 10.0), shoaling(count, 1.0);
  const std::vector<std::uint8_t> state(count, static_cast<std::uint8_t>(RayState::Alive));
  RayProfile profile;
  profile.count = count;
  profile.depth = depth.data();
  profile.wavenumber = k.data();
  profile.groupSpeed = groupSpeed.data();
  profile.shoaling = shoaling.data();
  profile.krSpacing = profile.krTube = kr.data();
  profile.state = state.data();
  profile.phase = phase.data();
  profile.caustics = &field.caustics[1];
  profile.causticCount = 1;
  IncidentWave wave;
  wave.period = Folds[0].period;
  HeightOptions options;
  options.gamma = 0.8;
  RayHeights heights;
  const auto run = [&](BreakingRule breaking, double height)
  {
    wave.height = height;
    options.breaking = breaking;
    computeHeights(profile, wave, options, heights);
  };
  run(BreakingRule::None, 1.0);
  const std::vector<double> uniform = heights.refraction;
  const double peak = *std::max_element(uniform.begin(), uniform.end());
  ASSERT_GT(peak, 1.2 * uniform.front());

  // Just lower than the limit: no breaking, where the height by the rays alone, as high as you like, breaks.
  const double limit = 0.8 * level;
  run(BreakingRule::Gamma, 0.999 * limit / peak);
  EXPECT_EQ(std::count(heights.breaking.begin(), heights.breaking.end(), 1), 0);
  options.caustics = CausticRule::Geometric;
  run(BreakingRule::Gamma, 0.999 * limit / peak);
  EXPECT_GT(std::count(heights.breaking.begin(), heights.breaking.end(), 1), 0);

  // Higher: the wave is as high as the depth allows up to its peak, and what it has lost there does not come back.
  options.caustics = CausticRule::Uniform;
  const double height = 1.1 * limit / peak;
  run(BreakingRule::Gamma, height);
  const auto top = static_cast<std::size_t>(std::max_element(uniform.begin(), uniform.end()) - uniform.begin());
  std::size_t broken = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double unbroken = height * uniform[i];
    const bool breaks = i <= top && unbroken > limit;
    broken += breaks ? 1 : 0;
    EXPECT_EQ(heights.breaking[i], breaks ? 1 : 0) << i;
    EXPECT_NEAR(heights.height[i], i <= top ? std::min(unbroken, limit) : unbroken / 1.1, 1e-12 * limit) << i;
  }
  EXPECT_GT(broken, 3u);
}

TEST(RayCaustics, heightsAreTheModulusOfAPlaneFold)
{
  // phi = sqrt(pi) z0^(1/4) (Ai^2 + Bi^2)^(1/2)(-z) of one branch, of unit amplitude in the approximation of rays at x = 0;
  // Kr = phi (k/k0)^(1/2).
  for (const Design& d : Folds)
  {
    const PlaneFold fold(d);
    const double step = 2.0 * swellray::Pi / 64.0;
    const RayField field = fold.trace({ 0.0, 30.0, 60.0 }, 1.9 * fold.turningPhase(), step);
    IncidentWave wave;
    wave.period = d.period;
    wave.offshoreDepth = d.depth;
    const std::size_t begin = field.offsets[1];
    const std::size_t count = field.pointCount(1);
    std::vector<double> phase, depth, k, groupSpeed, shoaling, kr;
    std::vector<std::uint8_t> state(count, static_cast<std::uint8_t>(RayState::Alive));
    for (std::size_t i = begin; i < begin + count; ++i)
    {
      const RayPoint& point = field.points[i];
      phase.push_back(point.phase);
      depth.push_back(point.depth);
      k.push_back(std::hypot(point.wavenumber.x, point.wavenumber.y));
      groupSpeed.push_back(waveSpeeds(k.back(), point.depth).groupSpeed);
      shoaling.push_back(shoalingCoefficient(wave.groupSpeed(), groupSpeed.back()));
      kr.push_back(refractionCoefficient(point.tubeWidth));
    }
    RayProfile profile;
    profile.count = count;
    profile.depth = depth.data();
    profile.wavenumber = k.data();
    profile.groupSpeed = groupSpeed.data();
    profile.shoaling = shoaling.data();
    profile.krSpacing = kr.data();
    profile.krTube = kr.data();
    profile.state = state.data();
    profile.phase = phase.data();
    ASSERT_EQ(field.caustics.size(), 3u);
    profile.caustics = &field.caustics[1];
    profile.causticCount = 1;
    HeightOptions options;
    options.breaking = BreakingRule::None;
    RayHeights heights;
    computeHeights(profile, wave, options, heights);
    double largest = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double z = std::cbrt(fold.mu) * (d.length - field.points[begin + i].position.x);
      const double z0 = std::cbrt(fold.mu) * d.length;
      const double expected =
        std::pow(z0 / z, 0.25) * foldModulus(2.0 / 3.0 * std::pow(z, 1.5)) * std::sqrt(k[i] / fold.k0);
      largest = std::max(largest, std::abs(heights.refraction[i] / expected - 1.0));
    }
    // Trapezia of 64 points a wavelength.
    EXPECT_LT(largest, 1e-5) << d.length;
    EXPECT_GT(largest, 0.0);
    // The rules differ where the tube is narrow.
    const auto highest = [&](CausticRule rule)
    {
      options.caustics = rule;
      computeHeights(profile, wave, options, heights);
      return *std::max_element(heights.refraction.begin(), heights.refraction.end());
    };
    const double peak = foldPeak(field.caustics[1], roundedCurvature(field.caustics[1]));
    EXPECT_NEAR(highest(CausticRule::Uniform), peak, 1e-3);
    EXPECT_GT(highest(CausticRule::Geometric), 3.0);
    EXPECT_EQ(highest(CausticRule::Cap), std::min(3.0, highest(CausticRule::Geometric)));
  }
}
