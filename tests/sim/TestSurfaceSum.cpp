#include "sim/SurfaceSum.h"

#include "RayBundle.h"

#include "sim/Angles.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

using namespace swellray;
using namespace swellray::bundles;

namespace
{

constexpr double Rounding = 1e-8;

// Arrays for drawing are floats.
constexpr double FloatTolerance = 2e-6;

// The second wave, toward +y.
constexpr double OtherHeight = 0.3;
constexpr double OtherWavelength = 15.0;
constexpr double OtherK = 2.0 * Pi / OtherWavelength;

Bundle across()
{
  Bundle bundle;
  for (int i = 0; i < 30; ++i)
  {
    bundle.begin(5.0 * i);
    for (double y = -30.0; y < 60.5; y += 2.0)
    {
      bundle.add({ 130.0 - 5.0 * i, y }, OtherK * y, { 0.0, 1.0 }, OtherHeight, 0.0, RayState::Alive, OtherK);
    }
  }
  return bundle;
}

struct Sea
{
  Sea()
    : Bed(20.0, 0.0)
    , First(straight(7.0), Bed)
    , Second(across(), Bed)
    , FirstWave(*First.Moved)
    , SecondWave(*Second.Moved)
    , Section(makeWaveSection("airy"))
  {
    this->Motion.section = this->Section.get();
  }

  static double height(const glm::dvec2& place, double time)
  {
    const double omega = 2.0 * Pi / Period;
    return 0.5 * std::cos(K * place.x - omega * time) + 0.5 * OtherHeight * std::cos(OtherK * place.y - omega * time);
  }

  Slope Bed;
  Surface First;
  Surface Second;
  SurfaceFunction FirstWave;
  SurfaceFunction SecondWave;
  std::unique_ptr<WaveSection> Section;
  SurfaceMotion Motion;
};

}

TEST(SurfaceSum, addsHeightsSlopesAndVelocities)
{
  const Sea sea;
  const SurfaceSum sum({ &sea.FirstWave, &sea.SecondWave });
  const std::vector<glm::dvec2> places{ { 10.0, 3.0 }, { 77.7, 18.3 }, { 50.0, 0.4 } };
  constexpr double time = 2.3;
  constexpr double step = 1e-5;
  const auto values = sum.at(places, { time }, sea.Motion);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    EXPECT_EQ(values[i].sheets, 2u);
    EXPECT_NEAR(values[i].elevation, Sea::height(places[i], time), Rounding);
    const double x = (Sea::height(places[i] + glm::dvec2(step, 0.0), time) - Sea::height(places[i], time)) / step;
    const double y = (Sea::height(places[i] + glm::dvec2(0.0, step), time) - Sea::height(places[i], time)) / step;
    EXPECT_NEAR(glm::distance(values[i].normal, glm::normalize(glm::dvec3(-x, -y, 1.0))), 0.0, 1e-5);
    EXPECT_NEAR(
      values[i].velocity.z, (Sea::height(places[i], time + step) - Sea::height(places[i], time)) / step, 1e-5);
  }
  // Where one of them does not come there is the other.
  const auto outside = sum.at({ { 60.0, 40.0 } }, { time }, sea.Motion);
  EXPECT_TRUE(outside[0].covered);
  EXPECT_EQ(outside[0].sheets, 1u);
}

TEST(SurfaceSum, raisesTheMeshAsTheFunctionSays)
{
  Sea sea;
  constexpr double time = 1.1;
  sea.First.at(time, "airy");
  const SurfaceSum others({ &sea.SecondWave });
  const SurfaceArrays arrays{ sea.First.Position.data(), sea.First.Normal.data(), sea.First.Velocity.data(),
    sea.First.Depth.data(), sea.First.Phase.data(), sea.First.Broken.data() };
  const std::vector<double> fine(sea.First.Sheet.pointCount(), 1.0);
  others.addTo(arrays, fine.size(), fine.data(), time, sea.Motion);
  const SurfaceSum both({ &sea.FirstWave, &sea.SecondWave });
  for (std::size_t i = 0; i < fine.size(); ++i)
  {
    const glm::dvec2 place(sea.First.Position[3 * i], sea.First.Position[3 * i + 1]);
    const SurfaceValue value = both.at({ place }, { time }, sea.Motion)[0];
    EXPECT_NEAR(sea.First.Position[3 * i + 2], value.elevation, Rounding);
    for (int c = 0; c < 3; ++c)
    {
      const auto at = 3 * i + static_cast<std::size_t>(c);
      EXPECT_NEAR(sea.First.Normal[at], value.normal[c], FloatTolerance);
      EXPECT_NEAR(sea.First.Velocity[at], value.velocity[c], FloatTolerance);
    }
  }
}

TEST(SurfaceSum, leavesOutWavesShorterThanTwoSamples)
{
  EXPECT_EQ(resolvedShare(10.0, 0.0), 1.0);
  EXPECT_EQ(resolvedShare(10.0, 3.0), 1.0);
  EXPECT_EQ(resolvedShare(10.0, 4.0), 0.5);
  EXPECT_EQ(resolvedShare(10.0, 5.0), 0.0);
  EXPECT_EQ(resolvedShare(10.0, 50.0), 0.0);
  Sea sea;
  const SurfaceSum both({ &sea.FirstWave, &sea.SecondWave });
  const glm::dvec2 place(40.0, 15.0); // both crests, at time 0
  EXPECT_NEAR(both.at({ place }, { 0.0 }, sea.Motion)[0].elevation, 0.65, Rounding);
  sea.Motion.spacing = OtherWavelength / 2.5;
  EXPECT_NEAR(both.at({ place }, { 0.0 }, sea.Motion)[0].elevation, 0.575, Rounding);
  sea.Motion.spacing = OtherWavelength / 2.0;
  EXPECT_NEAR(both.at({ place }, { 0.0 }, sea.Motion)[0].elevation, 0.5, Rounding);
  sea.Motion.spacing = Wavelength;
  const SurfaceValue none = both.at({ place }, { 0.0 }, sea.Motion)[0];
  EXPECT_TRUE(none.covered);
  EXPECT_NEAR(none.elevation, 0.0, Rounding);
}

TEST(SurfaceSum, knowsHowFarPointsAreApart)
{
  const Slope bed(20.0, 0.0);
  const Surface surface(straight(7.0), bed);
  const auto spacing = pointSpacing(surface.Sheet);
  ASSERT_EQ(spacing.size(), surface.Sheet.pointCount());
  // Sides of 2.5 and 5 m, and the diagonal of these.
  EXPECT_NEAR(*std::max_element(spacing.begin(), spacing.end()), std::hypot(2.5, 5.0), 1e-9);
  EXPECT_GE(*std::min_element(spacing.begin(), spacing.end()), 5.0 - 1e-9);
}

TEST(SurfaceSum, refusesWhatMakesNoSense)
{
  EXPECT_THROW(SurfaceSum({}), std::invalid_argument);
  const Sea sea;
  const Surface high(straight(7.0), sea.Bed, 16.0, 1.0);
  const SurfaceFunction other(*high.Moved);
  EXPECT_THROW(SurfaceSum({ &sea.FirstWave, &other }), std::invalid_argument);
}
