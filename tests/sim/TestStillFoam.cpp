#include "sim/StillFoam.h"

#include "RayBundle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace swellray;
using namespace swellray::bundles;

namespace
{

// Foam is a float.
constexpr double FloatTolerance = 1e-6;

// Steps at which the order in time is looked at, s.
constexpr double Moment = 1e-6;

constexpr double Life = 6.0;

/** Waves that break from x = 60 m on. */
struct Surf
{
  Surf()
    : Bed(20.0, 0.0)
    , Waves(breaking(), Bed)
    , Function(*Waves.Moved)
  {
  }

  std::vector<float> foam(const std::vector<glm::dvec2>& places, double time, double variation = 0.0) const
  {
    std::vector<float> foam(places.size(), -1.0f);
    StillFoam({ &this->Function }, places).at(time, Life, variation, foam.data());
    return foam;
  }

  Slope Bed;
  Surface Waves;
  SurfaceFunction Function;
};

// When the crest of wave 0 passes.
double passage(double x)
{
  return K * x / (2.0 * Pi) * Period;
}

}

TEST(StillFoam, isWhatTheWavesLeaveBehind)
{
  const Surf surf;
  const std::vector<glm::dvec2> places{ { 30.0, 3.0 }, { 80.0, 3.0 }, { 97.3, 7.7 }, { 80.0, 300.0 } };
  for (const double since : { Moment, 1.5, 3.0, 5.9, 6.1, 7.9 })
  {
    const auto foam = surf.foam(places, passage(80.0) + since);
    EXPECT_EQ(foam[0], 0.0f) << "nothing has broken there";
    EXPECT_NEAR(foam[1], std::max(0.0, 1.0 - since / Life), FloatTolerance);
    // The wave before came to 97.3 m so much earlier.
    const double there = std::fmod(since - (passage(97.3) - passage(80.0)) + Period, Period);
    EXPECT_NEAR(foam[2], std::max(0.0, 1.0 - there / Life), FloatTolerance) << since;
    EXPECT_TRUE(std::isnan(foam[3])) << "no wave comes there";
  }
}

TEST(StillFoam, isThatOfTheUndisturbedSurface)
{
  const Surf surf;
  const auto section = makeWaveSection("jeschke");
  SurfaceMotion motion;
  motion.section = section.get();
  motion.foam.life = Life;
  std::vector<glm::dvec2> places;
  for (int i = 0; i < 400; ++i)
  {
    places.emplace_back(50.0 + 0.17 * i, 0.025 * i);
  }
  for (const double time : { 0.0, 3.3, 1234.5 })
  {
    const auto foam = surf.foam(places, time, section->variation());
    int some = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      std::vector<SheetPlace> sheets;
      surf.Function.cover(places[i], sheets);
      ASSERT_EQ(sheets.size(), 1u);
      const double ofSurface = surf.Function.foam(sheets[0], time, motion);
      const double toPass = std::fmod(passage(places[i].x) - time, Period);
      if ((toPass < 0.0 ? toPass + Period : toPass) < section->frontPhase() / (2.0 * Pi) * Period)
      {
        // The front of a wave is over it.
        EXPECT_LE(foam[i], ofSurface + FloatTolerance);
        continue;
      }
      EXPECT_NEAR(foam[i], ofSurface, FloatTolerance);
      some += foam[i] > 0.0f ? 1 : 0;
    }
    EXPECT_GT(some, 100);
  }
}

TEST(StillFoam, takesTheLargestOfSeveralWaves)
{
  const Surf surf;
  // The same waves, half a period later in their phase.
  Bundle later = breaking();
  for (double& phase : later.Phase)
  {
    phase += Pi;
  }
  const Surface second(later, surf.Bed);
  const SurfaceFunction other(*second.Moved);
  const std::vector<glm::dvec2> places{ { 80.0, 3.0 } };
  const StillFoam both({ &surf.Function, &other }, places);
  EXPECT_EQ(both.foamingCount(), 1u);
  float foam = -1.0f;
  both.at(passage(80.0) + 0.5 * Period - Moment, Life, 0.0, &foam);
  EXPECT_NEAR(foam, 1.0 - 0.5 * Period / Life, FloatTolerance);
  both.at(passage(80.0) + 0.5 * Period + Moment, Life, 0.0, &foam);
  EXPECT_NEAR(foam, 1.0, FloatTolerance);
  both.at(passage(80.0) + 0.5 * Period + 1.0, Life, 0.0, &foam);
  EXPECT_NEAR(foam, 1.0 - 1.0 / Life, FloatTolerance);
}

TEST(StillFoam, isTheSameForAnyLoop)
{
  const Surf surf;
  std::vector<glm::dvec2> places;
  for (int i = 0; i < 10000; ++i)
  {
    places.emplace_back(0.02 * i, 5.0);
  }
  const auto whole = surf.foam(places, 7.0);
  Execution backwards;
  backwards.loop = [](std::size_t n, const auto& body)
  {
    for (std::size_t i = n; i > 0; --i)
    {
      body(i - 1, i);
    }
  };
  std::vector<float> parts(places.size());
  StillFoam({ &surf.Function }, places, backwards).at(7.0, Life, 0.0, parts.data(), backwards);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    EXPECT_TRUE(parts[i] == whole[i] || (std::isnan(parts[i]) && std::isnan(whole[i]))) << i;
  }
}

TEST(StillFoam, refusesWhatMakesNoSense)
{
  EXPECT_THROW(StillFoam({}, {}), std::invalid_argument);
  const Surf surf;
  float foam = 0.0f;
  EXPECT_THROW(StillFoam({ &surf.Function }, { { 80.0, 3.0 } }).at(0.0, 0.0, 0.0, &foam), std::invalid_argument);
}
