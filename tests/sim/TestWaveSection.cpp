// What holds for every section, and the sections of Airy, Gerstner, Biesel, and Fournier and Reeves.
#include "SectionChecks.h"

#include "sim/sections/LinearSections.h"
#include "sim/sections/OrbitSections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace swellray;

namespace
{

// Formulas in another order of operations.
constexpr double Rounding = 1e-12;

// Central differences over 1e-5 rad: their own error is of its square times the third derivative, which the sharpest
// curls bring to some hundred metres.
constexpr double Step = 1e-5;
constexpr double DifferenceTolerance = 2e-6;

// Trapezoids over 2000 intervals of curves with kinks.
constexpr double AreaTolerance = 1e-5;

struct State
{
  SectionPlace place;
  CrestState crest;
};

/** From deep water over breaking to the beach. */
std::vector<State> states()
{
  std::vector<State> all;
  for (const SectionPlace& place :
    { placeOf(1.9, 120.0, 60.0), placeOf(2.0, 65.0, 6.0), placeOf(2.3, 48.0, 3.0), placeOf(0.4, 20.0, 0.55, -0.02) })
  {
    all.push_back({ place, crestOf(place) });
  }
  const SectionPlace broken = placeOf(2.2, 47.0, 2.9);
  for (const double plunge : { 0.1, 0.35, 0.7, 0.99, 1.0, 4.0 })
  {
    all.push_back({ broken, crestOf(broken, plunge, 2.4) });
  }
  return all;
}

std::vector<std::string> names()
{
  std::vector<std::string> all;
  for (const FormDescription& section : waveSections())
  {
    all.push_back(section.name);
  }
  return all;
}

std::string failure(const std::string& spec)
{
  try
  {
    makeWaveSection(spec);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

}

class EverySection : public testing::TestWithParam<std::string>
{
};

TEST_P(EverySection, derivativesAreThoseOfTheCurve)
{
  const auto section = makeWaveSection(GetParam());
  for (const State& state : states())
  {
    // No phase of a kink.
    for (const double phase : { -2.9, -2.1, -1.1, -0.4, 0.05, 0.11, 0.51, 0.93, 1.3, 1.71, 2.21, 2.9 })
    {
      SectionPlace place = state.place;
      place.phase = phase;
      const SectionPoint here = section->at(state.crest, place);
      place.phase = phase + Step;
      const SectionPoint ahead = section->at(state.crest, place);
      place.phase = phase - Step;
      const SectionPoint behind = section->at(state.crest, place);
      EXPECT_NEAR(here.alongRate, (ahead.along - behind.along) / (2.0 * Step), DifferenceTolerance)
        << phase << " at depth " << place.depth << ", plunge " << state.crest.plunge;
      EXPECT_NEAR(here.upRate, (ahead.up - behind.up) / (2.0 * Step), DifferenceTolerance) << phase;
    }
  }
}

TEST_P(EverySection, wavesMeetInTheTroughWhateverBecomesOfThem)
{
  const auto section = makeWaveSection(GetParam());
  for (const State& state : states())
  {
    SectionPlace behind = state.place;
    behind.phase = -Pi;
    SectionPlace ahead = state.place;
    ahead.phase = Pi;
    const SectionPoint back = section->at(crestOf(state.place), behind);
    for (const State& other : states())
    {
      const SectionPoint front = section->at(other.crest, ahead);
      EXPECT_NEAR(front.along, back.along, 1e-9) << state.place.depth << " " << other.crest.plunge;
      EXPECT_NEAR(front.up, back.up, 1e-9);
    }
  }
}

TEST_P(EverySection, isFlatWithoutHeight)
{
  const auto section = makeWaveSection(GetParam());
  for (double phase = -3.0; phase < 3.1; phase += 0.25)
  {
    SectionPlace place = placeOf(0.0, 50.0, 3.0);
    place.phase = phase;
    EXPECT_NEAR(section->at(crestOf(place), place).up, 0.0, Rounding);
  }
}

TEST_P(EverySection, hasSixteenPointsAWaveOrMore)
{
  EXPECT_GE(makeWaveSection(GetParam())->pointsPerWave(), 16.0);
}

INSTANTIATE_TEST_SUITE_P(WaveSection, EverySection, testing::ValuesIn(names()),
  [](const testing::TestParamInfo<std::string>& each)
  {
    std::string name = each.param;
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    return name;
  });

TEST(WaveSection, namesAreThoseOfThePapers)
{
  EXPECT_THAT(names(),
    testing::ElementsAre(
      "airy", "gerstner", "biesel", "fournier-reeves", "gonzato-lesaec", "peachey", "jeschke", "vortex"));
}

TEST(WaveSection, unknownNamesAndKeysAreAnsweredWithTheNearest)
{
  EXPECT_THAT(failure("gerstne"), testing::HasSubstr("did you mean 'gerstner'?"));
  EXPECT_THAT(failure("vortex:treshold=0.1"), testing::HasSubstr("did you mean 'threshold'?"));
  EXPECT_THAT(failure("vortex:threshold=0"), testing::HasSubstr("threshold"));
  EXPECT_THAT(failure("airy:x=1"), testing::HasSubstr("takes no keys"));
  EXPECT_THAT(failure("jeschke:variation=much"), testing::HasSubstr("variation"));
}

TEST(WaveSection, keysReachTheSection)
{
  EXPECT_EQ(makeWaveSection("jeschke:variation=0.05")->variation(), 0.05);
  const SectionPlace place = placeOf(2.0, 48.0, 3.0);
  const auto with = curveOf(*makeWaveSection("gonzato-lesaec:stretch=0"), place, crestOf(place));
  const auto without = curveOf(*makeWaveSection("gonzato-lesaec"), place, crestOf(place));
  EXPECT_GT(highest(without).x, highest(with).x + 1.0);
}

TEST(AirySection, isTheSineOfTheWave)
{
  const AirySection section;
  SectionPlace place = placeOf(2.0, 100.0, 20.0);
  for (double phase = -3.0; phase < 3.1; phase += 0.5)
  {
    place.phase = phase;
    const SectionPoint point = section.at(crestOf(place), place);
    EXPECT_EQ(point.along, 0.0);
    EXPECT_NEAR(point.up, std::cos(phase), Rounding);
  }
}

TEST(GerstnerSection, circlesHaveTheStatedRadiusAndCentre)
{
  // R = A/2 around z0 = pi A^2/(4 lambda).
  const GerstnerSection section;
  SectionPlace place = placeOf(4.0, 60.0, 100.0);
  const double centre = Pi * 16.0 / (4.0 * 60.0);
  for (double phase = -3.0; phase < 3.1; phase += 0.5)
  {
    place.phase = phase;
    const SectionPoint point = section.at(crestOf(place), place);
    EXPECT_NEAR(std::hypot(point.along, point.up - centre), 2.0, Rounding);
    EXPECT_NEAR(std::atan2(-point.along, point.up - centre), phase, Rounding);
  }
}

TEST(GerstnerSection, stillWaterIsItsMeanLevel)
{
  const GerstnerSection section;
  for (const double height : { 0.5, 4.0, 15.0, 19.0 })
  {
    const SectionPlace place = placeOf(height, 60.0, 100.0);
    EXPECT_NEAR(meanLevel(curveOf(section, place, crestOf(place))), 0.0, AreaTolerance * height);
  }
}

TEST(GerstnerSection, isLimitedToTheDiscAndMakesNoLoops)
{
  // Largest curvature A/lambda = 1/pi.
  const GerstnerSection section;
  const SectionPlace place = placeOf(100.0, 60.0, 100.0);
  const auto curve = curveOf(section, place, crestOf(place));
  EXPECT_NEAR((highest(curve).y - lowest(curve).y) / 60.0, 1.0 / Pi, Rounding);
  EXPECT_LT(overhang(curve), Rounding * 60.0);
  SectionPlace crest = place;
  crest.phase = 0.0;
  EXPECT_NEAR(section.at(crestOf(crest), crest).alongRate + 1.0 / crest.wavenumber, 0.0, Rounding * 60.0); // a cusp
}

TEST(GerstnerSection, crestsAreSharperThanTroughs)
{
  const GerstnerSection section;
  const SectionPlace place = placeOf(12.0, 60.0, 100.0);
  const auto curve = curveOf(section, place, crestOf(place));
  EXPECT_GT(highest(curve).y, -lowest(curve).y);
}

TEST(BieselSection, isGerstnersCircleInDeepWater)
{
  const TiltedOrbit orbit = BieselSection::orbit(placeOf(2.0, 60.0, 200.0));
  EXPECT_NEAR(orbit.majorAxis, 1.0, 1e-8); // coth of 21
  EXPECT_NEAR(orbit.minorAxis, 1.0, Rounding);
  EXPECT_NEAR(orbit.sine, 0.0, 1e-8);
}

TEST(BieselSection, majorAxisComesToLieAlongTheBed)
{
  const double beta = std::atan(0.1);
  double before = 0.0;
  for (const double depth : { 20.0, 5.0, 1.0, 0.01 })
  {
    const TiltedOrbit orbit = BieselSection::orbit(placeOf(0.5 * depth, 60.0, depth, 0.1));
    const double tilt = std::asin(orbit.sine);
    EXPECT_GT(tilt, before);
    EXPECT_LT(tilt, beta);
    EXPECT_GT(orbit.majorAxis, orbit.minorAxis);
    before = tilt;
  }
  EXPECT_NEAR(before, beta, 1e-6); // cosh kh = 1 + 5e-7
}

TEST(BieselSection, wavesLeanForwardOnASlope)
{
  const BieselSection section;
  const auto symmetric = placeOf(2.0, 50.0, 3.0, 0.0);
  const auto rising = placeOf(2.0, 50.0, 3.0, 0.1);
  const auto flat = curveOf(section, symmetric, crestOf(symmetric));
  const auto leaning = curveOf(section, rising, crestOf(rising));
  EXPECT_NEAR(std::abs(highest(flat).x - lowest(flat).x), 25.0, 0.1);
  // Of a wave that leans, less than half lies between its crest and the trough ahead.
  const double ahead = lowest(leaning).x - highest(leaning).x;
  EXPECT_LT(std::fmod(ahead + 50.0, 50.0), 24.0);
}

TEST(TiltedOrbit, troughIsWhereEquation5SaysAsCorrected)
{
  const SectionPlace place = placeOf(2.0, 50.0, 3.0, 0.2);
  const TiltedOrbit orbit = BieselSection::orbit(place);
  const double expected = -std::atan(orbit.sine * orbit.majorAxis / (orbit.cosine * orbit.minorAxis));
  EXPECT_NEAR(orbit.troughPhase(), expected, Rounding);
  EXPECT_NEAR(orbit.at(Dual(Pi + expected, 1.0)).up.rate, 0.0, Rounding);
  EXPECT_LT(orbit.at(Dual(Pi + expected, 1.0)).up.value, orbit.at(Dual(Pi, 1.0)).up.value);
}

TEST(FournierReevesSection, isEquation4)
{
  const FournierReevesSection section({ 0.2, 0.3, 0.25 });
  SectionPlace place = placeOf(1.6, 40.0, 5.0, 0.15);
  const double sx = 1.0 / (1.0 - std::exp(-0.3 * 5.0));
  const double sz = sx * (1.0 - std::exp(-0.25 * 5.0));
  const double alpha = std::asin(std::sin(std::atan(0.15)) * std::exp(-0.2 * 5.0));
  for (double phase = -3.0; phase < 3.1; phase += 0.5)
  {
    place.phase = phase;
    const SectionPoint point = section.at(crestOf(place), place);
    const double phi = phase + Pi; // the paper's has the trough at 0
    EXPECT_NEAR(
      point.along, 0.8 * (std::cos(alpha) * sx * std::sin(phi) + std::sin(alpha) * sz * std::cos(phi)), Rounding);
    EXPECT_NEAR(
      point.up, 0.8 * (-std::cos(alpha) * sz * std::cos(phi) + std::sin(alpha) * sx * std::sin(phi)), Rounding);
  }
}

TEST(FournierReevesSection, makesLoopsInShallowWaterAsThePaperSays)
{
  // K R Sx > 1: there the paper sees loops, "which does not occur in nature".
  const FournierReevesSection section;
  const SectionPlace place = placeOf(0.6, 12.0, 0.8);
  EXPECT_GT(overhang(curveOf(section, place, crestOf(place))), 0.1);
}

TEST(FournierReevesSection, breaksBackwardsWhereTheBedFalls)
{
  const FournierReevesSection section;
  const SectionPlace rising = placeOf(2.0, 50.0, 4.0, 0.2);
  const SectionPlace falling = placeOf(2.0, 50.0, 4.0, -0.2);
  const auto forward = curveOf(section, rising, crestOf(rising));
  const auto backward = curveOf(section, falling, crestOf(falling));
  for (std::size_t i = 0; i < forward.size(); ++i)
  {
    const glm::dvec2& mirrored = backward[forward.size() - 1 - i];
    EXPECT_NEAR(forward[i].x, -mirrored.x, 1e-9);
    EXPECT_NEAR(forward[i].y, mirrored.y, 1e-9);
  }
}
