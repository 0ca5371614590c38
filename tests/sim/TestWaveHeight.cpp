#include "sim/WaveHeight.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace swellray;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Some roundings of products and square roots.
constexpr double Rounding = 1e-13;

// A ray over given depths; what depends on depth follows from the dispersion relation.
struct Ray
{
  IncidentWave wave;
  HeightOptions options;
  std::vector<double> depth;
  std::vector<double> wavenumber;
  std::vector<double> groupSpeed;
  std::vector<double> shoaling;
  std::vector<double> krSpacing;
  std::vector<double> krTube;
  std::vector<std::uint8_t> state;

  explicit Ray(const std::vector<double>& depths, double kr = 1.0)
    : depth(depths)
    , krSpacing(depths.size(), kr)
    , krTube(depths.size(), kr)
    , state(depths.size(), static_cast<std::uint8_t>(RayState::Alive))
  {
    this->wave.period = 10.0;
    this->wave.height = 2.0;
    for (const double h : depths)
    {
      this->wavenumber.push_back(solveWavenumber(this->wave.angularFrequency(), h));
      this->groupSpeed.push_back(waveSpeeds(this->wavenumber.back(), h).groupSpeed);
      this->shoaling.push_back(shoalingCoefficient(this->wave.groupSpeed(), this->groupSpeed.back()));
    }
  }

  RayHeights heights() const
  {
    RayProfile profile;
    profile.count = this->depth.size();
    profile.depth = this->depth.data();
    profile.wavenumber = this->wavenumber.data();
    profile.groupSpeed = this->groupSpeed.data();
    profile.shoaling = this->shoaling.data();
    profile.krSpacing = this->krSpacing.data();
    profile.krTube = this->krTube.data();
    profile.state = this->state.data();
    RayHeights result;
    computeHeights(profile, this->wave, this->options, result);
    return result;
  }
};

// Ks of q = kh against deep water: (tanh q + q sech^2 q)^(-1/2).
double shoalingOf(double q)
{
  const double c = std::cosh(q);
  return 1.0 / std::sqrt(std::tanh(q) + q / (c * c));
}

TEST(WaveHeight, ShoalsAndRefracts)
{
  Ray ray({ 200.0, 50.0, 20.0, 10.0, 6.0 }, 0.8);
  const RayHeights heights = ray.heights();
  ASSERT_EQ(heights.height.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i)
  {
    const double q = ray.wavenumber[i] * ray.depth[i];
    EXPECT_EQ(heights.refraction[i], 0.8) << i;
    EXPECT_NEAR(heights.height[i], 2.0 * shoalingOf(q) * 0.8, Rounding) << i;
    EXPECT_EQ(heights.breaking[i], 0) << i;
  }
}

TEST(WaveHeight, LeastWhereItMust)
{
  // q tanh q = 1: Ks = 0.912993187050684.
  Ray ray({ 1.0 });
  const double omega = ray.wave.angularFrequency();
  ray = Ray({ StandardGravity / (omega * omega) });
  EXPECT_NEAR(ray.heights().height[0], 2.0 * 0.912993187050684, Rounding);
}

TEST(WaveHeight, KeepsTheEnergyFluxOfATube)
{
  // Kr = sqrt(b0/b): flux times width is what came in.
  Ray ray({ 100.0, 30.0, 12.0 });
  const std::vector<double> width{ 1.0, 2.5, 0.4 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    ray.krSpacing[i] = 1.0 / std::sqrt(width[i]);
  }
  const RayHeights heights = ray.heights();
  const double incoming = 1025.0 * StandardGravity * 4.0 / 8.0 * ray.wave.groupSpeed();
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(heights.energyFlux[i] * width[i] / incoming, 1.0, Rounding) << i;
  }
}

TEST(WaveHeight, TakesTheShoalingAsGiven)
{
  Ray ray({ 15.0, 8.0 });
  ray.shoaling = { 1.25, 0.5 }; // as on a current, not what the depths say
  const RayHeights heights = ray.heights();
  EXPECT_NEAR(heights.height[0], 2.0 * 1.25, Rounding);
  EXPECT_NEAR(heights.height[1], 2.0 * 0.5, Rounding);
  // H^2 goes as Ks^2, so that what is kept is the flux that came in.
  const double incoming = 1025.0 * StandardGravity * 4.0 / 8.0 * ray.wave.groupSpeed();
  EXPECT_NEAR(heights.energyFlux[0] / incoming, 1.0, Rounding);
  EXPECT_NEAR(heights.energyFlux[1] / incoming, 1.0, Rounding);
}

TEST(WaveHeight, OrbitalVelocityNearTheBed)
{
  Ray ray({ 20000.0, 40.0, 5.0 });
  ray.options.breaking = BreakingRule::None;
  const RayHeights heights = ray.heights();
  // kh = 800, beyond the range of sinh: nothing arrives.
  EXPECT_EQ(heights.orbitalVelocity[0], 0.0);
  for (std::size_t i = 1; i < 3; ++i)
  {
    const double q = ray.wavenumber[i] * ray.depth[i];
    EXPECT_NEAR(heights.orbitalVelocity[i], Pi * heights.height[i] / (10.0 * std::sinh(q)), Rounding) << i;
  }
  EXPECT_GT(heights.orbitalVelocity[2], heights.orbitalVelocity[1]);
}

TEST(WaveHeight, TheRuleChoosesTheCoefficient)
{
  Ray ray({ 30.0 });
  ray.krSpacing = { 0.7 };
  ray.krTube = { 1.2 };
  ray.options.amplitude = AmplitudeRule::Spacing;
  EXPECT_EQ(ray.heights().refraction[0], 0.7);
  ray.options.amplitude = AmplitudeRule::Tube;
  EXPECT_EQ(ray.heights().refraction[0], 1.2);
}

TEST(WaveHeight, AnUnknownCoefficientHasAStandIn)
{
  Ray ray({ 30.0, 29.0, 28.0, 27.0, 26.0 });
  ray.krSpacing = { NotANumber, 0.7, NotANumber, NotANumber, 0.9 };
  ray.krTube = { NotANumber, 1.2, 1.3, NotANumber, NotANumber };
  // The other estimate; where there is none, the last known on this ray, and 1 before any.
  EXPECT_EQ(ray.heights().refraction, (std::vector<double>{ 1.0, 0.7, 1.3, 1.3, 0.9 }));
  ray.options.amplitude = AmplitudeRule::Tube;
  EXPECT_EQ(ray.heights().refraction, (std::vector<double>{ 1.0, 1.2, 1.3, 1.3, 0.9 }));
}

TEST(WaveHeight, CausticsAreCapped)
{
  Ray ray({ 30.0, 30.0, 30.0, 30.0 });
  ray.krSpacing = { 2.9, 3.5, Infinity, NotANumber };
  ray.krTube = { 1.0, 1.0, 1.0, Infinity };
  EXPECT_EQ(ray.heights().refraction, (std::vector<double>{ 2.9, 3.0, 3.0, 3.0 }));
  ray.options.maxRefraction = 5.0;
  EXPECT_EQ(ray.heights().refraction, (std::vector<double>{ 2.9, 3.5, 5.0, 5.0 }));
  ray.options.maxRefraction = Infinity;
  EXPECT_EQ(ray.heights().refraction[2], Infinity);
}

TEST(WaveHeight, BreaksWhereTheDepthLimitsIt)
{
  std::vector<double> depths;
  for (double h = 10.0; h > 0.5; h -= 0.25)
  {
    depths.push_back(h);
  }
  Ray ray(depths);
  const RayHeights heights = ray.heights();
  ray.options.breaking = BreakingRule::None;
  const RayHeights unbroken = ray.heights();
  bool seen = false;
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    const bool tooHigh = unbroken.height[i] > 0.78 * depths[i];
    seen = seen || tooHigh;
    EXPECT_EQ(heights.breaking[i], tooHigh ? 1 : 0) << depths[i];
    EXPECT_NEAR(heights.height[i], tooHigh ? 0.78 * depths[i] : unbroken.height[i], Rounding) << depths[i];
    EXPECT_EQ(unbroken.breaking[i], 0);
  }
  EXPECT_TRUE(seen);
  EXPECT_EQ(heights.breaking[0], 0);
}

TEST(WaveHeight, DoesNotComeBackBehindABar)
{
  // Over the bar the wave loses height; in the trough behind it, it has what is left, and shoals on with that.
  Ray ray({ 20.0, 2.0, 20.0, 2.2, 1.0 });
  const RayHeights heights = ray.heights();
  ray.options.breaking = BreakingRule::None;
  const RayHeights unbroken = ray.heights();
  const double kept = 0.78 * 2.0 / unbroken.height[1];
  ASSERT_LT(kept, 1.0);
  EXPECT_NEAR(heights.height[0], unbroken.height[0], Rounding);
  EXPECT_NEAR(heights.height[1], 0.78 * 2.0, Rounding);
  EXPECT_NEAR(heights.height[2], kept * unbroken.height[2], Rounding);
  EXPECT_NEAR(heights.height[3], kept * unbroken.height[3], Rounding);
  EXPECT_NEAR(heights.height[4], 0.78 * 1.0, Rounding);
  EXPECT_EQ(heights.breaking, (std::vector<std::uint8_t>{ 0, 1, 0, 0, 1 }));
  EXPECT_LT(heights.energyFlux[2], heights.energyFlux[0]);
  EXPECT_NEAR(heights.energyFlux[2], heights.energyFlux[1], Rounding * heights.energyFlux[1]);
}

TEST(WaveHeight, GammaIsAnOption)
{
  Ray ray({ 2.0 });
  ray.options.gamma = 0.5;
  EXPECT_NEAR(ray.heights().height[0], 1.0, Rounding);
}

TEST(WaveHeight, AgroundTheDepthAllowsTheHeight)
{
  // Without breaking too; but no more than the wave has.
  for (const BreakingRule rule : { BreakingRule::None, BreakingRule::Gamma })
  {
    Ray ray({ 5.0, 0.1, 0.1, 4.0 });
    ray.options.breaking = rule;
    ray.state = { 1, 3, 3, 3 };
    const RayHeights heights = ray.heights();
    EXPECT_NEAR(heights.height[1], 0.078, Rounding);
    EXPECT_NEAR(heights.height[2], 0.078, Rounding);
    EXPECT_EQ(heights.breaking[1], 1);
    EXPECT_LT(heights.height[3], 0.1);
  }
}

TEST(WaveHeight, AnEmptyRayHasNoHeights)
{
  EXPECT_TRUE(Ray({}).heights().height.empty());
}

TEST(WaveHeight, NamesWhatIsOutOfRange)
{
  const auto complaint = [](const HeightOptions& options) -> std::string
  {
    try
    {
      options.validate();
    }
    catch (const std::invalid_argument& error)
    {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint(HeightOptions()), "");
  for (const double bad : { 0.0, -1.0, NotANumber })
  {
    HeightOptions options;
    options.gamma = bad;
    EXPECT_THAT(complaint(options), testing::HasSubstr("gamma must be above 0")) << bad;
    options = HeightOptions();
    options.maxRefraction = bad;
    EXPECT_THAT(complaint(options), testing::HasSubstr("refraction coefficient must be above 0")) << bad;
    Ray ray({ 5.0 });
    ray.options = options;
    EXPECT_THROW(ray.heights(), std::invalid_argument);
  }
}

}
