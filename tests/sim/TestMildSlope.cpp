#include "sim/MildSlope.h"

#include "ScatteredWaves.h"

#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>
#include <thread>

using namespace swellray;

namespace
{

IncidentWave waveOf(double period, double directionFrom, double height, double depth)
{
  IncidentWave wave;
  wave.period = period;
  wave.directionFrom = directionFrom;
  wave.height = height;
  wave.offshoreDepth = depth;
  return wave;
}

MildSlopeOptions lossless(double spacing)
{
  MildSlopeOptions options;
  options.spacing = spacing;
  options.height.breaking = BreakingRule::None;
  return options;
}

double wavelengthIn(const IncidentWave& wave, double depth)
{
  return wavelengthOf(solveWavenumber(wave.angularFrequency(), depth, wave.gravity));
}

TEST(MildSlope, LeavesAPlaneWaveOnLevelGroundAlone)
{
  // What is off is interpolation at 10 nodes a wavelength, which is worst along the edges; inside it is 1e-4.
  constexpr double Interpolation = 2e-3;
  const auto seafloor = makeBuiltinSeafloor("shoal:height=0,depth=10,x0=0,x1=500,y0=0,y1=400");
  for (const double direction : { 270.0, 247.0, 225.0, 10.0 })
  {
    const IncidentWave wave = waveOf(10.0, direction, 2.0, 10.0);
    const glm::dvec2 k = wave.wavenumber() * wave.direction();
    const glm::dvec2 corner(k.x < 0.0 ? 500.0 : 0.0, k.y < 0.0 ? 400.0 : 0.0);
    const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, lossless(0.1 * wavelengthOf(wave.wavenumber())));
    EXPECT_LT(field.residual(), 1e-10);
    for (double y = 5.0; y < 400.0; y += 17.0)
    {
      for (double x = 5.0; x < 500.0; x += 19.0)
      {
        const glm::dvec2 way = glm::dvec2(x, y) - corner;
        const std::complex<double> exact = std::polar(1.0, k.x * way.x + k.y * way.y);
        EXPECT_LT(std::abs(field.surface({ x, y }) - exact), Interpolation) << direction << ": " << x << ", " << y;
      }
    }
  }
}

double shoalError(double nodes, double side)
{
  constexpr double Rim = 250.0;
  const reference::PartialWaves exact(
    [](double r)
    {
      const double u = 1.0 - r * r / (Rim * Rim);
      return r < Rim ? 15.0 - 10.5 * u * u * u : 15.0;
    },
    Rim, 8.0, StandardGravity);
  const std::string half = std::to_string(side);
  const auto seafloor = makeBuiltinSeafloor(
    "shoal:kind=poly3,depth=15,height=10.5,radius=250,x0=-" + half + ",x1=" + half + ",y0=-" + half + ",y1=" + half);
  const IncidentWave wave = waveOf(8.0, 270.0, 2.0, 15.0);
  const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, lossless(wavelengthIn(wave, 4.5) / nodes));
  const std::complex<double> shift = std::polar(1.0, exact.offshoreWavenumber() * side);
  double error = 0.0;
  double largest = 0.0;
  for (double y = 5.0; y < side; y += 14.0)
  {
    for (double x = 10.0 - side; x < side; x += 23.0)
    {
      const std::complex<double> eta = exact.at(x, y) * shift;
      largest = std::max(largest, std::abs(eta));
      error = std::max({ error, std::abs(field.surface({ x, y }) - eta), std::abs(field.surface({ x, -y }) - eta) });
    }
  }
  return error / largest;
}

TEST(MildSlope, FollowsThePartialWavesOfAShoal)
{
  // Complex field, phase and all, over its largest modulus; the order is that of coefficients taken as constant in an element.
  constexpr double OnePercent = 0.01;
  const double coarse = shoalError(8.0, 420.0);
  const double fine = shoalError(16.0, 420.0);
  EXPECT_LT(coarse, OnePercent);
  EXPECT_LT(fine, 0.35 * coarse);
}

TEST(MildSlope, LetsWavesOutOfASmallScene)
{
  // The same shoal with its edges just outside of the rim: what the layers reflect would show. Measured 0.5 %.
  EXPECT_LT(shoalError(12.0, 260.0), 0.01);
}

TEST(MildSlope, RefractsAndShoalsOverAPlaneBeachWithoutTroubleAtItsSides)
{
  // Kr Ks of straight contours; WKB is off by some 1e-3 on a slope of 1 in 50 in 3 to 10 m.
  constexpr double Geometric = 0.02;
  const auto seafloor = makeBuiltinSeafloor("plane:slope=0.02,facing=270,x0=-500,x1=-100,y0=0,y1=300");
  const IncidentWave wave = waveOf(8.0, 240.0, 1.0, std::numeric_limits<double>::infinity());
  MildSlopeOptions options = lossless(3.5);
  options.minDepth = 2.0;
  const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, options);
  std::vector<glm::dvec2> places;
  for (double y = 5.0; y < 300.0; y += 20.0)
  {
    for (double x = -480.0; x < -150.0; x += 15.0)
    {
      places.emplace_back(x, y);
    }
  }
  const MildSlopeWaves waves = field.sample(places);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double k = solveWavenumber(wave.angularFrequency(), -0.02 * places[i].x);
    const double sine = std::sin(radians(30.0)) * wave.wavenumber() / k;
    const double kr = std::sqrt(std::cos(radians(30.0)) / std::sqrt(1.0 - sine * sine));
    const double ks = shoalingCoefficient(wave.groupSpeed(), waveSpeeds(k, -0.02 * places[i].x).groupSpeed);
    EXPECT_NEAR(waves.height[i], kr * ks, Geometric) << places[i].x << ", " << places[i].y;
    EXPECT_NEAR(waves.directionFrom[i], 270.0 - degrees(std::asin(sine)), 1.5) << places[i].x << ", " << places[i].y;
    EXPECT_NEAR(waves.wavelength[i], wavelengthOf(k), 0.01 * wavelengthOf(k));
  }
}

// Reflection of a straight coast, from the greatest and the least height of the standing wave before it.
double measuredReflection(double asked, double coastAngle)
{
  // A step from 5 m of water to land.
  class Step final : public Seafloor
  {
  public:
    explicit Step(double turn)
      : Normal(std::cos(turn), std::sin(turn))
    {
    }
    Rectangle bounds() const override { return { { 0.0, 0.0 }, { 300.0, 300.0 } }; }
    void evaluate(const glm::dvec2& p, unsigned, BedSample& bed) const override
    {
      bed = BedSample{};
      const glm::dvec2 way = p - glm::dvec2(180.0, 150.0);
      bed.elevation = way.x * this->Normal.x + way.y * this->Normal.y > 0.0 ? 5.0 : -5.0;
    }
    double featureLength() const override { return 10.0; }
    double resolution() const override { return 5.0; }

  private:
    glm::dvec2 Normal;
  };
  const Step seafloor(coastAngle);
  IncidentWave wave = waveOf(8.0, 270.0 - degrees(coastAngle), 1.0, 5.0);
  MildSlopeOptions options = lossless(wavelengthIn(wave, 5.0) / 14.0);
  options.coastReflection = asked;
  options.edge = EdgeRule::None;
  options.sideWalls = coastAngle == 0.0;
  const MildSlopeField field = solveMildSlope(seafloor, 0.0, wave, options);
  double least = 1e9;
  double most = 0.0;
  const double length = wavelengthIn(wave, 5.0);
  for (double way = 0.4 * length; way < 1.4 * length; way += 0.01 * length)
  {
    const glm::dvec2 place = glm::dvec2(180.0, 150.0) - way * wave.direction();
    const double height = 2.0 * std::abs(field.surface(place));
    least = std::min(least, height);
    most = std::max(most, height);
  }
  return (most - least) / (most + least);
}

TEST(MildSlope, ReflectsAtCoastsAsAsked)
{
  for (const double asked : { 0.0, 0.3, 0.7, 1.0 })
  {
    EXPECT_NEAR(measuredReflection(asked, 0.0), asked, 0.01);
    // A slanting coast is a flight of steps, and past the sides of the scene there is none that would reflect.
    EXPECT_NEAR(measuredReflection(asked, radians(30.0)), asked, 0.08) << asked;
  }
}

TEST(MildSlope, BendsAroundABreakwaterAsSommerfeldHasIt)
{
  // Behind the wall and beside it, shadow and all; the wall is an element thick, a twentieth of a wavelength.
  constexpr double Thickness = 0.03;
  const auto seafloor = makeBuiltinSeafloor("shoal:height=0,depth=8,x0=-300,x1=300,y0=-150,y1=300");
  const IncidentWave wave = waveOf(8.0, 180.0, 2.0, 8.0);
  MildSlopeOptions options = lossless(wavelengthIn(wave, 8.0) / 20.0);
  options.wall = [](const Rectangle& element)
  {
    const bool stands = element.low.x < 0.0 && element.low.y < 1.0 && element.high.y >= 1.0;
    return stands ? std::optional<double>(1.0) : std::nullopt;
  };
  const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, options);
  double squares = 0.0;
  double largest = 0.0;
  double count = 0.0;
  for (double y = 10.0; y < 290.0; y += 15.0)
  {
    for (double x = -200.0; x < 250.0; x += 15.0)
    {
      const double exact = std::abs(reference::halfPlaneWave(wave.wavenumber(), x, y));
      const double error = std::abs(field.surface({ x, y })) - exact;
      squares += error * error;
      largest = std::max(largest, std::abs(error));
      count += 1.0;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), Thickness);
  EXPECT_LT(largest, 2.5 * Thickness);
}

TEST(MildSlope, BreaksOnABeach)
{
  const auto seafloor = makeBuiltinSeafloor("plane:slope=0.02,facing=270,x0=-300,x1=-5,y0=0,y1=120");
  const IncidentWave wave = waveOf(8.0, 270.0, 1.0, std::numeric_limits<double>::infinity());
  // Measured 0.02: what reaches the sides is the wave without the little that the surf reflects.
  constexpr double AlongTheBeach = 0.03;
  for (const BreakingRule rule : { BreakingRule::Gamma, BreakingRule::Weggel, BreakingRule::Miche, BreakingRule::Dally,
         BreakingRule::BattjesJanssen, BreakingRule::Baldock })
  {
    MildSlopeOptions options;
    options.spacing = 2.5;
    options.minDepth = 0.5;
    options.height.breaking = rule;
    const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, options);
    EXPECT_TRUE(field.converged()) << breakingRuleName(rule);
    EXPECT_GT(field.solutions(), 1u);
    std::vector<glm::dvec2> places;
    for (const double x : { -290.0, -45.0, -35.0, -30.0 })
    {
      places.emplace_back(x, 25.0);
      places.emplace_back(x, 60.0);
      places.emplace_back(x, 95.0);
    }
    const MildSlopeWaves waves = field.sample(places);
    EXPECT_GT(waves.height[0], 0.85) << breakingRuleName(rule);
    for (std::size_t i = 3; i < places.size(); ++i)
    {
      EXPECT_LT(waves.height[i], -0.02 * places[i].x) << breakingRuleName(rule);
      EXPECT_GT(waves.height[i], -0.3 * 0.02 * places[i].x) << breakingRuleName(rule);
      EXPECT_EQ(waves.breaking[i], 1) << breakingRuleName(rule);
    }
    // The same along the beach: what enters by the sides breaks as the wave between them does.
    for (std::size_t i = 0; i < places.size(); i += 3)
    {
      EXPECT_NEAR(waves.height[i], waves.height[i + 1], AlongTheBeach) << breakingRuleName(rule) << " " << places[i].x;
      EXPECT_NEAR(waves.height[i + 2], waves.height[i + 1], AlongTheBeach)
        << breakingRuleName(rule) << " " << places[i].x;
    }
    if (rule == BreakingRule::Gamma)
    {
      EXPECT_NEAR(waves.height[10], 0.78 * 0.02 * 30.0, 0.03);
    }
  }
}

TEST(MildSlope, LosesEnergyToTheBedAsAWaveAloneDoes)
{
  // dH/dx = -(D/E) H/(2 Cg), level bed: H = H0/(1 + c x).
  const auto seafloor = makeBuiltinSeafloor("shoal:height=0,depth=6,x0=0,x1=800,y0=0,y1=150");
  const IncidentWave wave = waveOf(10.0, 270.0, 2.0, 6.0);
  MildSlopeOptions options = lossless(6.0);
  options.height.friction = 0.2;
  const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, options);
  const double rate = frictionRate(0.2, 2.0, wave.wavenumber(), 6.0, 10.0, StandardGravity);
  for (const double x : { 50.0, 400.0, 750.0 })
  {
    const double exact = 2.0 / (1.0 + 0.5 * rate * x / wave.groupSpeed());
    EXPECT_NEAR(field.sample({ glm::dvec2(x, 75.0) }).height[0], exact, 0.01 * exact);
  }
}

TEST(MildSlope, LosesEnergyToALaminarLayerWithoutASecondSolution)
{
  // H = H0 exp(-ki x) (Hunt 1952), a tank 0.15 m deep.
  const auto seafloor = makeBuiltinSeafloor("shoal:height=0,depth=0.15,x0=0,x1=40,y0=0,y1=3");
  const IncidentWave wave = waveOf(1.0, 270.0, 0.04, 0.15);
  MildSlopeOptions options = lossless(0.1);
  options.height.viscosity = WaterViscosity;
  const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, options);
  EXPECT_EQ(field.solutions(), 1u);
  const double kh = wave.wavenumber() * 0.15;
  const double decay =
    2.0 * kh * kh / (0.15 * 0.15) * std::sqrt(WaterViscosity / (4.0 * Pi)) / (2.0 * kh + std::sinh(2.0 * kh));
  constexpr double Interpolation = 1e-3; // at 11 nodes a wavelength, against a loss of a seventh
  for (const double x : { 2.0, 20.0, 38.0 })
  {
    const double exact = 0.04 * std::exp(-decay * x);
    EXPECT_NEAR(field.sample({ glm::dvec2(x, 1.5) }).height[0], exact, Interpolation * exact);
  }
  options.height.friction = 0.1;
  EXPECT_THROW(solveMildSlope(*seafloor, 0.0, wave, options), std::invalid_argument);
}

TEST(MildSlope, GrowsLongerWithTheHeightWhereAskedTo)
{
  const auto seafloor = makeBuiltinSeafloor("shoal:height=0,depth=6,x0=0,x1=400,y0=0,y1=150");
  const IncidentWave wave = waveOf(10.0, 270.0, 2.0, 6.0);
  MildSlopeOptions options = lossless(6.0);
  options.dispersion = WaveDispersion::Nonlinear;
  const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, options);
  const double k = finiteAmplitudeWavenumber(wave.angularFrequency(), 6.0, 1.0);
  EXPECT_LT(k, 0.98 * wave.wavenumber());
  const double turn = std::arg(field.surface({ 230.0, 75.0 }) / field.surface({ 200.0, 75.0 }));
  EXPECT_NEAR(turn / 30.0, k, 0.004 * k);
  EXPECT_NEAR(field.sample({ glm::dvec2(200.0, 75.0) }).wavelength[0], wavelengthOf(k), 0.01 * wavelengthOf(k));
}

TEST(MildSlope, IsTheSameOnAnyNumberOfThreads)
{
  const auto seafloor = makeBuiltinSeafloor("berkhoff:x0=-8,x1=8,y0=-6,y1=6");
  const IncidentWave wave = waveOf(1.0, 270.0, 0.0464, 0.45);
  MildSlopeOptions options;
  options.spacing = 0.14;
  Execution threads;
  threads.loop = [](std::size_t n, const std::function<void(std::size_t, std::size_t)>& body)
  {
    std::vector<std::thread> workers;
    const std::size_t part = (n + 3) / 4;
    for (std::size_t begin = 0; begin < n; begin += part)
    {
      workers.emplace_back(body, begin, std::min(n, begin + part));
    }
    for (std::thread& worker : workers)
    {
      worker.join();
    }
  };
  const MapGrid grid{ 30, 20, { -7.5, -5.0 }, { 0.5, 0.5 } };
  const MildSlopeWaves one = solveMildSlope(*seafloor, 0.0, wave, options).sample(grid);
  const MildSlopeWaves many = solveMildSlope(*seafloor, 0.0, wave, options, threads).sample(grid, threads);
  EXPECT_EQ(one.height, many.height);
  EXPECT_EQ(one.directionFrom, many.directionFrom);
}

TEST(MildSlope, PlansAndRefuses)
{
  const auto seafloor = makeBuiltinSeafloor("island");
  const IncidentWave wave = waveOf(10.0, 270.0, 1.0, std::numeric_limits<double>::infinity());
  MildSlopeOptions options;
  const MildSlopePlan plan = planMildSlope(*seafloor, 0.0, wave, options);
  EXPECT_GE(plan.nodesPerWave, 10.0);
  EXPECT_GT(plan.bytes, 1e8);
  EXPECT_GT(plan.solutions, 1u);
  const auto refusal = [&]() -> std::string
  {
    try
    {
      planMildSlope(*seafloor, 0.0, wave, options);
    }
    catch (const std::exception& error)
    {
      return error.what();
    }
    return "";
  };
  options.memory = 0.5 * plan.bytes;
  EXPECT_NE(refusal().find("a spacing of the nodes of "), std::string::npos) << refusal();
  EXPECT_NE(refusal().find(" a crop to "), std::string::npos) << refusal();
  options.memory = 0.0;
  options.spacing = 10.0;
  EXPECT_NE(refusal().find("at least 4 are needed"), std::string::npos) << refusal();
  options.spacing = -1.0;
  EXPECT_NE(refusal().find("must be above 0 m"), std::string::npos) << refusal();
  options = {};
  options.coastReflection = 1.5;
  EXPECT_NE(refusal().find("within 0 to 1"), std::string::npos) << refusal();
  options = {};
  options.minDepth = 1e4;
  EXPECT_NE(refusal().find("no water"), std::string::npos) << refusal();
}

TEST(MildSlope, CanBeCancelled)
{
  const auto seafloor = makeBuiltinSeafloor("berkhoff");
  MildSlopeOptions options = lossless(0.14);
  Execution execution;
  execution.progress = [](double share) { return share < 0.3; };
  EXPECT_TRUE(solveMildSlope(*seafloor, 0.0, waveOf(1.0, 270.0, 0.0464, 0.45), options, execution).cancelled());
}

TEST(MildSlope, KnowsNothingOfLandAndOfPlacesOutside)
{
  const auto seafloor = makeBuiltinSeafloor("plane:slope=0.02,facing=270,x0=-300,x1=100,y0=0,y1=100");
  const IncidentWave wave = waveOf(8.0, 270.0, 1.0, std::numeric_limits<double>::infinity());
  const MildSlopeField field = solveMildSlope(*seafloor, 0.0, wave, lossless(3.0));
  const MildSlopeWaves waves = field.sample({ { -100.0, 50.0 }, { 50.0, 50.0 }, { -100.0, 200.0 } });
  EXPECT_GT(waves.height[0], 0.5);
  EXPECT_TRUE(std::isnan(waves.height[1]));
  EXPECT_TRUE(std::isnan(waves.height[2]));
  EXPECT_TRUE(std::isnan(field.surface({ 50.0, 50.0 }).real()));
}

}
