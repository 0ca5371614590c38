// Breaker lines of rays traced over plane beaches, against the root of the closed form of Snell and shoaling.
#include "ReferenceTable.h"

#include "sim/Angles.h"
#include "sim/BreakerLine.h"
#include "sim/Breaking.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"
#include "sim/RayQuantities.h"
#include "sim/WaveHeight.h"
#include "sim/WaveTracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using namespace swellray;

namespace
{

constexpr double Gamma = 0.78;

/** A wave from deep water onto a plane beach. */
struct Case
{
  double period;
  double height;
  double theta0; ///< degrees from the shore normal
  double slope;
};

/** First breaking, H0 Ks Kr = gamma h, by bisection in the depth. */
struct Breaker
{
  explicit Breaker(const Case& c)
  {
    const double omega = 2.0 * Pi / c.period;
    const double deep = omega * omega / StandardGravity;
    const double along = deep * std::sin(radians(c.theta0));
    double low = 1e-3;
    double high = 100.0;
    for (int i = 0; i < 200; ++i)
    {
      this->depth = 0.5 * (low + high);
      const double k = solveWavenumber(omega, this->depth);
      this->angle = std::asin(along / k);
      const double speed = waveSpeeds(k, this->depth).groupSpeed;
      this->height = c.height * std::sqrt(0.5 * StandardGravity / omega / speed) *
        std::sqrt(std::cos(radians(c.theta0)) / std::cos(this->angle));
      (this->height > Gamma * this->depth ? low : high) = this->depth;
    }
  }

  double depth;
  double height;
  double angle; // rad
};

/** Rays with their arrays, and the breaker lines on them. */
struct Surf
{
  Surf(const Seafloor& seafloor, const IncidentWave& wave, const TraceOptions& trace, const HeightOptions& options,
    double maxGap = 0.0)
    : Field(traceWaves(seafloor, wave, trace))
  {
    const std::size_t n = this->Field.points.size();
    for (std::vector<double>* values : { &this->Depth, &this->Time, &this->Wavenumber, &this->GroupSpeed,
           &this->Shoaling, &this->KrSpacing, &this->KrTube })
    {
      values->resize(n);
    }
    this->Position.resize(3 * n);
    this->Direction.resize(3 * n);
    this->State.resize(n);
    RayQuantities quantities;
    quantities.position = this->Position.data();
    quantities.direction = this->Direction.data();
    quantities.depth = this->Depth.data();
    quantities.travelTime = this->Time.data();
    quantities.wavenumber = this->Wavenumber.data();
    quantities.groupSpeed = this->GroupSpeed.data();
    quantities.shoaling = this->Shoaling.data();
    quantities.krSpacing = this->KrSpacing.data();
    quantities.krTube = this->KrTube.data();
    quantities.state = this->State.data();
    computeRayQuantities(this->Field, wave, 0.0, quantities);

    std::vector<std::int64_t> offsets;
    std::vector<double> parameter;
    std::vector<std::int32_t> segment;
    std::vector<double> distance;
    std::vector<double> refraction;
    std::vector<std::uint8_t> breaking;
    for (std::size_t ray = 0; ray < this->Field.rays.size(); ++ray)
    {
      const std::size_t at = this->Field.offsets[ray];
      RayProfile profile;
      profile.count = this->Field.pointCount(ray);
      profile.position = this->Position.data() + 3 * at;
      profile.travelTime = this->Time.data() + at;
      profile.depth = this->Depth.data() + at;
      profile.wavenumber = this->Wavenumber.data() + at;
      profile.groupSpeed = this->GroupSpeed.data() + at;
      profile.shoaling = this->Shoaling.data() + at;
      profile.krSpacing = this->KrSpacing.data() + at;
      profile.krTube = this->KrTube.data() + at;
      profile.state = this->State.data() + at;
      RayHeights heights;
      computeHeights(profile, wave, options, heights);
      offsets.push_back(static_cast<std::int64_t>(at));
      parameter.push_back(this->Field.rays[ray].launchParameter);
      segment.push_back(this->Field.rays[ray].launchSegment);
      const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
      append(this->Height, heights.height);
      append(distance, heights.breakingDistance);
      append(refraction, heights.refraction);
      append(breaking, heights.breaking);
    }
    offsets.push_back(static_cast<std::int64_t>(n));

    BreakerRays rays;
    rays.rays = this->Field.rays.size();
    rays.offsets = offsets.data();
    rays.launchParameter = parameter.data();
    rays.launchSegment = segment.data();
    rays.positions = this->Position.data();
    rays.direction = this->Direction.data();
    rays.depth = this->Depth.data();
    rays.wavenumber = this->Wavenumber.data();
    rays.groupSpeed = this->GroupSpeed.data();
    rays.shoaling = this->Shoaling.data();
    rays.refraction = refraction.data();
    rays.height = this->Height.data();
    rays.breakingDistance = distance.data();
    rays.breaking = breaking.data();
    this->Lines =
      extractBreakerLines(rays, seafloor, { wave, options.breaking == BreakingRule::BattjesJanssen }, maxGap);
  }

  double x(std::size_t i) const
  {
    const RayPlace& place = this->Lines.places[i];
    const double* a = this->Position.data() + 3 * place.point;
    return a[0] + place.weight * (a[3] - a[0]);
  }

  RayField Field;
  BreakerLines Lines;
  std::vector<double> Position, Direction, Depth, Time, Wavenumber, GroupSpeed, Shoaling, KrSpacing, KrTube, Height;
  std::vector<std::uint8_t> State;
};

/** The wave of a case over a beach three times as wide as its surf. */
Surf surfOf(const Case& c, double stepsPerWave)
{
  const double surf = Breaker(c).depth / c.slope;
  const auto beach =
    makeBuiltinSeafloor("plane:slope=" + std::to_string(c.slope) + ",x0=" + std::to_string(-0.3 * surf) +
      ",x1=" + std::to_string(3.0 * surf) + ",y0=" + std::to_string(-2.0 * surf) + ",y1=" + std::to_string(2.0 * surf));
  IncidentWave wave;
  wave.period = c.period;
  wave.height = c.height;
  wave.directionFrom = 90.0 - c.theta0; // going to theta0 left of west
  TraceOptions trace;
  trace.stepsPerWave = stepsPerWave;
  trace.spacing = 0.2 * surf;
  HeightOptions options;
  options.amplitude = AmplitudeRule::Tube;
  options.gamma = Gamma;
  return Surf(*beach, wave, trace, options);
}

// Depth and height of the worst place against the closed form, relative.
double errorOf(const Surf& surf, const Breaker& exact)
{
  double worst = surf.Lines.places.empty() ? 1.0 : 0.0;
  for (std::size_t i = 0; i < surf.Lines.places.size(); ++i)
  {
    worst = std::max({ worst, std::fabs(surf.Lines.depth[i] / exact.depth - 1.0),
      std::fabs(surf.Lines.height[i] / exact.height - 1.0) });
  }
  return worst;
}

const Case Cases[] = { { 8.0, 1.0, 0.0, 0.02 }, { 8.0, 2.0, 30.0, 0.02 }, { 12.0, 1.5, 45.0, 0.05 },
  { 10.0, 3.0, 60.0, 0.01 }, { 5.0, 0.5, 20.0, 0.1 }, { 9.0, 1.2, -25.0, 0.03 } };

// Rays read linearly between points, 128 a wavelength: (1/128)^2 and what curves within a wavelength on a steep beach.
constexpr double FineTolerance = 1e-4;

}

TEST(BreakerLine, standsWhereTheClosedFormHasIt)
{
  for (const Case& c : Cases)
  {
    const Breaker exact(c);
    const Surf surf = surfOf(c, 128.0);
    const BreakerLines& lines = surf.Lines;
    ASSERT_FALSE(lines.places.empty());
    EXPECT_LT(errorOf(surf, exact), FineTolerance);
    const double deepLength = StandardGravity * c.period * c.period / (2.0 * Pi);
    const double groupSpeed = waveSpeeds(solveWavenumber(2.0 * Pi / c.period, exact.depth), exact.depth).groupSpeed;
    const double flux = longshoreEnergyFlux(exact.height, groupSpeed, exact.angle, StandardGravity);
    for (std::size_t i = 0; i < lines.places.size(); ++i)
    {
      EXPECT_NEAR(surf.x(i) * c.slope, exact.depth, FineTolerance * exact.depth);
      // Up the bed is west; the wave goes west and, with theta0 above 0, to the left of that: south.
      EXPECT_NEAR(lines.angle[i], exact.angle, FineTolerance);
      EXPECT_NEAR(lines.peelAngle[i], std::fabs(exact.angle), 1e-3); // the line's direction is that of its places
      EXPECT_NEAR(lines.iribarrenOffshore[i], c.slope / std::sqrt(c.height / deepLength), 1e-9);
      EXPECT_NEAR(lines.iribarrenBreaking[i], c.slope / std::sqrt(exact.height / deepLength), FineTolerance);
      EXPECT_EQ(lines.type[i], static_cast<std::uint8_t>(breakerType(c.slope / std::sqrt(c.height / deepLength))));
      EXPECT_NEAR(lines.longshoreFlux[i], flux, 5.0 * FineTolerance * std::fabs(flux) + 1e-6);
      EXPECT_LT(lines.setDown[i], 0.0);
      EXPECT_GT(lines.setUp[i], 0.0);
      EXPECT_GT(lines.maximumSetUp[i], lines.setUp[i]);
    }
  }
}

TEST(BreakerLine, convergesWithTheSecondOrder)
{
  // The mean over all places: where breaking falls between two points differs from ray to ray.
  const Case c = Cases[2];
  const Breaker exact(c);
  const double coarse = errorOf(surfOf(c, 8.0), exact);
  const double fine = errorOf(surfOf(c, 32.0), exact);
  EXPECT_GT(coarse / fine, 8.0); // 16 but for where in its step a ray breaks
  EXPECT_LT(coarse, 1e-2);
}

TEST(BreakerLine, isOneLineAlongAStraightBeach)
{
  const Surf surf = surfOf(Cases[0], 16.0);
  ASSERT_EQ(surf.Lines.number, (std::vector<std::int32_t>{ 1 }));
  EXPECT_EQ(surf.Lines.places.size(), surf.Field.rays.size());
}

TEST(BreakerLine, hasASecondBehindABarAndEndsAtGaps)
{
  const auto beach = makeBuiltinSeafloor("bar:slope=0.02,bar-height=1.8,bar-position=150,bar-width=20,x0=-50,x1=400,"
                                         "y0=-200,y1=200");
  IncidentWave wave;
  wave.period = 8.0;
  wave.directionFrom = 90.0;
  wave.height = 1.0;
  TraceOptions trace;
  trace.spacing = 20.0;
  trace.stepsPerWave = 32.0;
  HeightOptions options;
  options.breaking = BreakingRule::Dally;
  const Surf surf(*beach, wave, trace, options);
  ASSERT_EQ(surf.Lines.number, (std::vector<std::int32_t>{ 1, 2 }));
  EXPECT_GT(surf.x(0), 150.0);
  EXPECT_LT(surf.x(surf.Lines.offsets[1]), 130.0);
  const Surf apart(*beach, wave, trace, options, 10.0);
  EXPECT_TRUE(apart.Lines.places.empty());
  options.breaking = BreakingRule::None;
  EXPECT_TRUE(Surf(*beach, wave, trace, options).Lines.places.empty());
}

TEST(BreakerLine, ofRandomWavesIsThatOfTheirSignificantHeight)
{
  const auto beach = makeBuiltinSeafloor("plane:slope=0.02,x0=-50,x1=600,y0=-300,y1=300");
  IncidentWave wave;
  wave.period = 8.0;
  wave.directionFrom = 110.0;
  wave.height = 1.0;
  TraceOptions trace;
  trace.spacing = 20.0;
  HeightOptions options;
  options.breaking = BreakingRule::BattjesJanssen;
  const Surf surf(*beach, wave, trace, options);
  ASSERT_FALSE(surf.Lines.places.empty());
  const BreakerLines& lines = surf.Lines;
  const double k = solveWavenumber(2.0 * Pi / 8.0, lines.depth[3]);
  const double limit = randomWaveLimit(k, lines.depth[3], breakerIndex(options, wave));
  EXPECT_NEAR(brokenShare(lines.height[3] / limit), 0.05, 2e-3); // linear over an eighth of a wave
  const double flux = longshoreEnergyFlux(
    std::sqrt(2.0) * lines.height[3], waveSpeeds(k, lines.depth[3]).groupSpeed, lines.angle[3], StandardGravity);
  EXPECT_NEAR(lines.longshoreFlux[3] / flux, 1.0, 1e-3);
}

TEST(BreakerLine, agreesWithTheTable)
{
  const swellray::testing::ReferenceTable table("c6_breaking");
  if (table.empty())
  {
    GTEST_SKIP() << "no table in " << swellray::testing::referenceFolder();
  }
  EXPECT_GE(table.size(), 7u);
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const Case c{ table.at(row, "T"), table.at(row, "H0"), table.at(row, "theta0_deg"), table.at(row, "slope") };
    const Breaker exact(c);
    EXPECT_NEAR(exact.depth, table.at(row, "hb"), 1e-9);
    EXPECT_NEAR(exact.height, table.at(row, "Hb"), 1e-9);
    // Steep beaches are crossed in a fraction of a wavelength.
    const Surf surf = surfOf(c, c.slope > 0.1 ? 2000.0 : 128.0);
    ASSERT_FALSE(surf.Lines.places.empty());
    EXPECT_LT(errorOf(surf, exact), FineTolerance) << row;
    EXPECT_NEAR(surf.Lines.angle[0] * 180.0 / Pi, table.at(row, "theta_b_deg"), 0.01);
    EXPECT_NEAR(surf.Lines.iribarrenOffshore[0], table.at(row, "xi0"), 1e-9);
    EXPECT_NEAR(surf.Lines.iribarrenBreaking[0], table.at(row, "xib"), FineTolerance * table.at(row, "xib"));
    EXPECT_EQ(surf.Lines.type[0], static_cast<std::uint8_t>(table.at(row, "type0")) + 1);
    EXPECT_EQ(surf.Lines.typeAtBreaking[0], static_cast<std::uint8_t>(table.at(row, "typeb")) + 1);
  }
}
