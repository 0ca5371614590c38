// The sections that break: Jeschke et al. 2003 and Lake et al. 2005.
#include "SectionChecks.h"

#include "sim/sections/JeschkeSection.h"
#include "sim/sections/VortexSection.h"

#include <gtest/gtest.h>

using namespace swellray;

namespace
{

constexpr double Rounding = 1e-12;

// The lip is a corner between two of 2000 points.
constexpr double CornerTolerance = 0.02;

// Trapezoids over 2000 intervals.
constexpr double AreaTolerance = 1e-5;

const SectionPlace Breaker = placeOf(2.2, 47.0, 2.82);

glm::dvec2 paper(const JeschkeSection::Shape& shape, double s)
{
  const Displacement point = JeschkeSection::curve(shape, Dual(s, 1.0));
  return { point.along.value, point.up.value };
}

}

TEST(JeschkeSection, isRoundBeforeItBreaks)
{
  // k1 1, k2 1/4, k3 0, k5 0: (1 + cos)/8 over the length 1, times k7 = 4t/5.
  const JeschkeSection::Shape shape = JeschkeSection::round(0.5);
  EXPECT_NEAR(shape.k7, 0.4, Rounding);
  for (double s = 0.0; s <= 1.0; s += 0.1)
  {
    EXPECT_NEAR(paper(shape, s).x, s, Rounding);
    EXPECT_NEAR(paper(shape, s).y, 0.125 * (1.0 + std::cos(2.0 * Pi * (s - 0.5))), Rounding);
  }
}

TEST(JeschkeSection, constantsAreThoseOfTable1)
{
  const double t = 0.4;
  const JeschkeSection::Shape breaking = JeschkeSection::breaking(t);
  EXPECT_NEAR(breaking.front.k2, (1.0 - std::pow(t, 0.85)) / 4.0, Rounding);
  EXPECT_NEAR(breaking.front.k3, std::pow(t, 0.85) / 4.0, Rounding);
  EXPECT_EQ(breaking.front.k4, 4.0);
  EXPECT_NEAR(breaking.front.k5, std::pow(t, 1.5), Rounding); // corrected
  EXPECT_EQ(breaking.front.k6, 16.0);
  EXPECT_EQ(breaking.back.k2, 0.25);
  EXPECT_EQ(breaking.back.k3, 0.0);
  EXPECT_EQ(breaking.back.k6, 4.0);
  EXPECT_NEAR(breaking.k7, (4.0 + t) / 5.0, Rounding);
  const JeschkeSection::Shape collapsing = JeschkeSection::collapsing(t);
  EXPECT_EQ(collapsing.front.k1, 2.0);
  EXPECT_EQ(collapsing.front.k2, 0.0);
  EXPECT_NEAR(collapsing.front.k3, (1.0 - t) / 4.0, Rounding);
  EXPECT_EQ(collapsing.back.k2, 0.25);
  EXPECT_NEAR(collapsing.back.k3, std::pow(t, 0.7) / 2.0, Rounding);
  EXPECT_EQ(collapsing.back.k4, 40.0);
  EXPECT_EQ(collapsing.back.k5, 1.0);
  EXPECT_NEAR(collapsing.k7, 1.0 - t, Rounding);
  EXPECT_EQ(JeschkeSection::breaking(1.0).front.k1, 2.0);
  EXPECT_NEAR(JeschkeSection::breaking(1.0).back.k1, 0.7, Rounding);
  EXPECT_NEAR(JeschkeSection::collapsing(1.0).back.k1, 0.5, Rounding);
}

TEST(JeschkeSection, phasesFollowOnEachOtherWithoutAJump)
{
  for (double s = 0.0; s <= 1.0; s += 0.01)
  {
    const glm::dvec2 before = paper(JeschkeSection::round(1.0), s);
    const glm::dvec2 begun = paper(JeschkeSection::breaking(0.0), s);
    EXPECT_NEAR(before.x, begun.x, Rounding);
    EXPECT_NEAR(before.y, begun.y, Rounding);
    const glm::dvec2 fallen = paper(JeschkeSection::breaking(1.0), s);
    const glm::dvec2 after = paper(JeschkeSection::collapsing(0.0), s);
    EXPECT_NEAR(fallen.x, after.x, Rounding);
    EXPECT_NEAR(fallen.y, after.y, Rounding);
  }
  EXPECT_NEAR(JeschkeSection::round(1.0).k7, JeschkeSection::breaking(0.0).k7, Rounding);
  EXPECT_NEAR(JeschkeSection::breaking(1.0).k7, JeschkeSection::collapsing(0.0).k7, Rounding);
}

TEST(JeschkeSection, theLipFallsOntoTheWaterAheadAndClosesATube)
{
  // Turned by 90 degrees about the middle, the lip of height 1/4 lands 1/4 ahead of it.
  const glm::dvec2 lip = paper(JeschkeSection::breaking(1.0), 0.5);
  EXPECT_NEAR(lip.x, 0.75, Rounding);
  EXPECT_NEAR(lip.y, 0.0, Rounding);
  // From the front it is the same point: a tube, closed.
  const glm::dvec2 front = paper(JeschkeSection::breaking(1.0), 0.5 + 1e-12);
  EXPECT_NEAR(front.x, 0.75, 1e-6);
  EXPECT_NEAR(front.y, 0.0, 1e-6);
}

TEST(JeschkeSection, whileCollapsingTheHalvesOfTheLipLieApartOnTheWater)
{
  const double t = 0.5;
  const JeschkeSection::Shape shape = JeschkeSection::collapsing(t);
  const glm::dvec2 back = paper(shape, 0.5);
  const glm::dvec2 front = paper(shape, 0.5 + 1e-13);
  EXPECT_NEAR(back.x, 0.75 + 0.5 * std::pow(t, 0.7), Rounding);
  EXPECT_NEAR(front.x, 0.5 + 0.25 * (1.0 - t), 1e-5); // of the exponents 2 and 16
  EXPECT_NEAR(back.y, 0.0, Rounding);
  EXPECT_NEAR(front.y, 0.0, 1e-5);
}

TEST(JeschkeSection, hasTheTracedHeightThroughAllPhases)
{
  const JeschkeSection section(0.0);
  for (const SectionPlace& place : { placeOf(2.0, 117.0, 30.0), placeOf(2.2, 54.0, 4.0), Breaker })
  {
    const auto curve = curveOf(section, place, crestOf(place));
    EXPECT_NEAR(highest(curve).y - lowest(curve).y, place.height, 1e-3);
  }
  // While the lip falls only the back keeps it.
  const auto falling = curveOf(section, Breaker, crestOf(Breaker, 0.5));
  EXPECT_NEAR(highest(falling).y - lowest(falling).y, Breaker.height, 0.1 * Breaker.height);
  for (const double left : { 0.9, 0.5, 0.1, 0.0 })
  {
    const SectionPlace place = placeOf(2.2 * left, 30.0, 2.82 * left + 1e-6);
    const auto curve = curveOf(section, place, crestOf(place, 3.0, 2.2));
    EXPECT_NEAR(highest(curve).y - lowest(curve).y, place.height, 0.1 * place.height) << left;
  }
}

TEST(JeschkeSection, isASineFarFromBreakingAndAHumpOfFiveHeightsWhereItBreaks)
{
  const JeschkeSection section(0.0);
  SectionPlace swell = placeOf(1.0, 150.0, 1e4);
  for (const double phase : { -2.5, -1.0, 0.5, 3.0 })
  {
    swell.phase = phase;
    const SectionPoint point = section.at(crestOf(swell), swell);
    EXPECT_NEAR(point.up, 0.5 * std::cos(phase), 0.01);
    EXPECT_NEAR(point.along, 0.0, 0.2);
  }
  EXPECT_NEAR(JeschkeSection::humpWidth(2.0, 0.1, 1.0), 10.0, Rounding);
  EXPECT_NEAR(JeschkeSection::humpWidth(2.0, 0.1, 0.0), 2.0 * Pi / 0.1, 1e-9);
}

TEST(JeschkeSection, roundWavesKeepTheMeanLevel)
{
  const JeschkeSection section(0.0);
  for (const SectionPlace& place : { placeOf(2.0, 117.0, 30.0), placeOf(2.2, 54.0, 4.0), Breaker })
  {
    EXPECT_NEAR(meanLevel(curveOf(section, place, crestOf(place))), 0.0, AreaTolerance * place.height);
  }
}

TEST(JeschkeSection, overhangsWhileItBreaksAndNotBefore)
{
  const JeschkeSection section(0.0);
  EXPECT_LT(overhang(curveOf(section, Breaker, crestOf(Breaker))), 1e-9);
  double before = 0.0;
  for (const double t : { 0.4, 0.6, 0.8, 1.0 })
  {
    const double now = overhang(curveOf(section, Breaker, crestOf(Breaker, t, 2.2)));
    EXPECT_GT(now, before);
    before = now;
  }
  EXPECT_GT(before, 0.5);
}

TEST(VortexSection, keepsTheColumnOfWaterUntilItCurls)
{
  const VortexSection section{ {} };
  for (const SectionPlace& place : { placeOf(2.0, 117.0, 30.0), placeOf(2.2, 54.0, 4.0), Breaker })
  {
    const auto curve = curveOf(section, place, crestOf(place));
    EXPECT_NEAR(meanLevel(curve), 0.0, AreaTolerance * place.height);
    EXPECT_NEAR(highest(curve).y - lowest(curve).y, place.height, 1e-9);
    EXPECT_LT(overhang(curve), 1e-9);
  }
}

TEST(VortexSection, deepWavesAreSinesAndSteepenAsTheyShoal)
{
  const VortexSection section{ {} };
  SectionPlace deep = placeOf(2.0, 150.0, 1000.0);
  for (const double phase : { -2.0, 0.0, 1.0 })
  {
    deep.phase = phase;
    EXPECT_NEAR(section.at(crestOf(deep), deep).up, std::cos(phase), 1e-4);
    EXPECT_NEAR(section.at(crestOf(deep), deep).along, 0.0, 1e-2);
  }
  // Shoaled crests are higher above still water than their troughs below it.
  double before = 0.5;
  for (const SectionPlace& place : { placeOf(2.0, 65.0, 6.0), placeOf(2.2, 54.0, 4.0), Breaker })
  {
    const double share = highest(curveOf(section, place, crestOf(place))).y / place.height;
    EXPECT_GT(share, before);
    before = share;
  }
}

TEST(VortexSection, curlsWhereTheTraceSaysThatItBreaks)
{
  const VortexSection section{ {} };
  EXPECT_EQ(section.vortex(crestOf(Breaker)).curl, 0.0);
  double before = 0.0;
  for (const double plunge : { 0.5, 0.75, 1.0 })
  {
    const auto curve = curveOf(section, Breaker, crestOf(Breaker, plunge, 2.2));
    EXPECT_GT(overhang(curve), before);
    before = overhang(curve);
  }
  EXPECT_GT(before, 0.8);
}

TEST(VortexSection, curlsBeyondAHeightOfASeventhOfTheLengthOrTheThresholdSet)
{
  const VortexSection section{ {} };
  EXPECT_EQ(section.vortex(crestOf(placeOf(9.9, 70.0, 500.0))).curl, 0.0);
  EXPECT_GT(section.vortex(crestOf(placeOf(10.1, 70.0, 500.0))).curl, 0.0);
  VortexSection::Parameters parameters;
  parameters.threshold = 0.2;
  EXPECT_EQ(VortexSection(parameters).vortex(crestOf(placeOf(13.0, 70.0, 500.0))).curl, 0.0);
  EXPECT_GT(VortexSection(parameters).vortex(crestOf(placeOf(15.0, 70.0, 500.0))).curl, 0.0);
}

TEST(VortexSection, vortexIsAsLongForItsWidthAsTheBedAsks)
{
  EXPECT_NEAR(VortexSection::lengthToWidth(1.0 / 20.0), 0.065 * 20.0 + 0.821, Rounding);
  EXPECT_EQ(VortexSection::lengthToWidth(0.5), 1.73);
  EXPECT_EQ(VortexSection::lengthToWidth(0.001), 4.43);
  EXPECT_EQ(VortexSection::lengthToWidth(-0.1), 4.43);
  const VortexSection section{ {} };
  const VortexSection::Vortex vortex = section.vortex(crestOf(placeOf(2.2, 47.0, 2.82, 1.0 / 20.0), 1.0, 2.2));
  EXPECT_NEAR(vortex.length / vortex.width, 0.065 * 20.0 + 0.821, 1e-9);
}

TEST(VortexSection, vortexSinksAndShrinksTowardsTheShore)
{
  const VortexSection section{ {} };
  VortexSection::Vortex before = section.vortex(crestOf(Breaker, 1.0, 2.2));
  EXPECT_LT(before.up, Breaker.height);
  for (const double left : { 0.8, 0.5, 0.2, 0.05 })
  {
    const SectionPlace place = placeOf(2.2 * left, 47.0 * std::sqrt(left), 2.82 * left);
    const VortexSection::Vortex vortex = section.vortex(crestOf(place, 2.0, 2.2));
    EXPECT_LT(vortex.up, before.up);
    EXPECT_LT(vortex.length, before.length);
    EXPECT_LT(vortex.width, before.width);
    before = vortex;
  }
}

TEST(VortexSection, sortsPointsIntoParts)
{
  using Part = VortexSection::Part;
  EXPECT_EQ(VortexSection::part(-Pi), Part::Flat);
  EXPECT_EQ(VortexSection::part(-1.0), Part::Back);
  EXPECT_EQ(VortexSection::part(0.0), Part::Top);
  EXPECT_EQ(VortexSection::part(1.0), Part::Front);
  EXPECT_EQ(VortexSection::part(Pi), Part::Flat);
}

TEST(VortexSection, everyPartDoesWhatTheSlidesSay)
{
  const VortexSection section{ {} };
  const CrestState whole = crestOf(Breaker);
  const CrestState curled = crestOf(Breaker, 1.0, 2.2);
  const VortexSection::Vortex vortex = section.vortex(curled);
  const auto at = [&](const CrestState& crest, double phase)
  {
    SectionPlace place = Breaker;
    place.phase = phase;
    const SectionPoint point = section.at(crest, place);
    return glm::dvec2(phase / place.wavenumber + point.along, point.up);
  };
  // FLAT behind stays.
  EXPECT_EQ(at(curled, -0.8 * Pi), at(whole, -0.8 * Pi));
  // TOP goes ahead, its tip down over the hollow.
  EXPECT_GT(at(curled, 0.2 * Pi).x, vortex.forward);
  EXPECT_LT(at(curled, 0.2 * Pi).y, at(curled, 0.0).y - 0.5);
  // FRONT lies on the vortex: no point within it, and the hollow's back is behind its middle.
  const double trough = at(whole, Pi).y;
  for (double phase = 0.21 * Pi; phase < 0.6 * Pi; phase += 0.05)
  {
    const glm::dvec2 point = at(curled, phase) - glm::dvec2(vortex.forward, vortex.up + trough);
    EXPECT_GE(std::hypot(point.x, point.y), 0.5 * vortex.width * (1.0 - 1e-9));
    EXPECT_LE(std::hypot(point.x, point.y), 0.5 * vortex.length * (1.0 + 1e-9));
  }
  EXPECT_LT(at(curled, 0.4 * Pi).x, vortex.forward);
  // BACK follows so that no gap opens at the crest.
  EXPECT_NEAR(at(curled, -1e-9).x, at(curled, 1e-9).x, CornerTolerance);
  EXPECT_NEAR(at(curled, -1e-9).y, at(curled, 1e-9).y, CornerTolerance);
}
