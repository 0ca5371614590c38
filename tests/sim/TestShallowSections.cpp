// The sections of Gonzato and Le Saec, and of Peachey.
#include "SectionChecks.h"

#include "sim/sections/GonzatoLeSaecSection.h"
#include "sim/sections/PeacheySection.h"

#include <gtest/gtest.h>

using namespace swellray;

namespace
{

constexpr double Rounding = 1e-12;

// Of the tabulated mean of the asymmetric cosine: linear between 256 entries, curvature below 3.
constexpr double MeanTolerance = 1e-5;

GonzatoLeSaecSection gonzato(double stretch, double ks, double kd)
{
  GonzatoLeSaecSection::Parameters parameters;
  parameters.stretch = stretch;
  parameters.stretchDepth = ks;
  parameters.displacementDepth = kd;
  return GonzatoLeSaecSection(parameters);
}

// exp(-kd h) of nothing.
constexpr double Never = 100.0;

SectionPoint at(const WaveSection& section, SectionPlace place, double phase)
{
  place.phase = phase;
  return section.at(crestOf(place), place);
}

}

TEST(GonzatoLeSaecSection, ellipsesStayInTheDisc)
{
  const GonzatoLeSaecSection section{ {} };
  bool limited = false;
  for (const double depth : { 20.0, 4.0, 1.0, 0.2, 0.01 })
  {
    const SectionPlace place = placeOf(0.78 * depth, 2.0 * Pi * std::sqrt(depth), depth);
    const TiltedOrbit orbit = section.orbit(place);
    EXPECT_LE(orbit.majorAxis * place.wavenumber, 1.0 + Rounding);
    EXPECT_LT(orbit.minorAxis, orbit.majorAxis);
    limited = limited || orbit.majorAxis * place.wavenumber > 1.0 - Rounding;
  }
  EXPECT_TRUE(limited);
}

TEST(GonzatoLeSaecSection, withoutItsThreeFunctionsItIsFournierAndReevesInDeeperWater)
{
  const GonzatoLeSaecSection section = gonzato(0.0, 0.18, Never);
  const FournierReevesSection base;
  const SectionPlace place = placeOf(2.0, 100.0, 12.0, 0.05);
  for (double phase = -3.0; phase < 3.1; phase += 0.5)
  {
    EXPECT_NEAR(at(section, place, phase).along, at(base, place, phase).along, Rounding);
    EXPECT_NEAR(at(section, place, phase).up, at(base, place, phase).up, Rounding);
  }
}

TEST(GonzatoLeSaecSection, withoutThemItsAmplitudeDecreasesNearTheShoreAndNothingPlunges)
{
  const GonzatoLeSaecSection section = gonzato(0.0, 0.18, Never);
  double before = 1.0;
  for (const double depth : { 1.0, 0.5, 0.2, 0.1 })
  {
    const SectionPlace place = placeOf(0.78 * depth, 10.0 * std::sqrt(depth), depth, 0.0);
    const auto curve = curveOf(section, place, crestOf(place));
    const double share = (highest(curve).y - lowest(curve).y) / place.height;
    EXPECT_LT(share, before);
    EXPECT_LT(overhang(curve), 1e-9);
    before = share;
  }
  EXPECT_LT(before, 0.3);
}

TEST(GonzatoLeSaecSection, crestsOnSteepBedsRiseNoHigherThanBreakersDo)
{
  const GonzatoLeSaecSection section{ {} };
  // A wave at its limit of 0.78 h: H/2 by either axis of the ellipse and by the stretch, and less than 0.36 H sin(beta) on the
  // way of the displacement down from the slope of the bed.
  constexpr double Highest = 1.6;
  for (const double depth : { 3.0, 1.3, 0.5, 0.1 })
  {
    for (const double slope : { 0.1, 0.3, 0.6, 1.0, 3.0 })
    {
      const SectionPlace place = placeOf(0.78 * depth, 6.0 * std::sqrt(9.81 * depth), depth, slope);
      const TiltedOrbit orbit = section.orbit(place);
      EXPECT_LE(orbit.majorAxis * orbit.sine, 0.5 * place.height * (1.0 + Rounding)) << depth << " " << slope;
      EXPECT_LT(highest(curveOf(section, place, crestOf(place))).y, Highest * place.height) << depth << " " << slope;
    }
  }
}

TEST(GonzatoLeSaecSection, stretchIsAParabolaThatLeavesTheTrough)
{
  // Eq. 6: St_max at the crest, 0 at the trough, along the major axis, times exp(-Ks h), Ks = 0.4/H.
  const GonzatoLeSaecSection with = gonzato(3.0, 0.4, Never);
  const GonzatoLeSaecSection without = gonzato(0.0, 0.4, Never);
  const SectionPlace place = placeOf(2.0, 60.0, 5.0, 0.1);
  const TiltedOrbit orbit = with.orbit(place);
  for (const double psi : { -Pi, -2.0, -0.5, 0.0, 1.0, 3.0 })
  {
    const double phase = psi + orbit.troughPhase() + Pi; // of the wave ahead, where it is beyond pi
    const SectionPoint a = at(with, place, phase);
    const SectionPoint b = at(without, place, phase);
    const double expected = 6.0 * std::exp(-1.0) * psi * psi / (Pi * Pi);
    EXPECT_NEAR(a.along - b.along, expected * orbit.cosine, Rounding * 10.0) << psi;
    EXPECT_NEAR(a.up - b.up, expected * orbit.sine, Rounding * 10.0) << psi;
  }
}

TEST(GonzatoLeSaecSection, displacementHasThreeParts)
{
  const auto share = [](double psi) { return GonzatoLeSaecSection::displacementShare(Dual(psi, 1.0)).value; };
  EXPECT_NEAR(share(-Pi), 1.0, Rounding);
  EXPECT_NEAR(share(-2.0 * Pi / 3.0), 0.5, Rounding);
  EXPECT_NEAR(share(-Pi / 3.0), 0.0, Rounding);
  EXPECT_EQ(share(0.0), 0.0);
  EXPECT_NEAR(share(7.0 * Pi / 8.0), 0.0, Rounding);
  EXPECT_NEAR(share(15.0 * Pi / 16.0), 0.5, Rounding);
  EXPECT_NEAR(share(Pi), 1.0, Rounding);
}

TEST(GonzatoLeSaecSection, crestsFallByTheHeightInTheDirectionOfMinus45Degrees)
{
  const GonzatoLeSaecSection with = gonzato(0.0, 0.2, 0.6);
  const GonzatoLeSaecSection without = gonzato(0.0, 0.2, Never);
  const SectionPlace place = placeOf(2.0, 60.0, 5.0, 0.1);
  const double crest = with.orbit(place).troughPhase();
  const double size = 2.0 * std::exp(-1.5);
  EXPECT_NEAR(at(with, place, crest).along - at(without, place, crest).along, size / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(at(with, place, crest).up - at(without, place, crest).up, -size / std::sqrt(2.0), 1e-9);
  // Half way down the front: half as far, in the direction half way to that of the bed.
  const double middle = crest + Pi / 3.0;
  const double direction = 0.5 * (std::atan(0.1) - Pi / 4.0);
  EXPECT_NEAR(at(with, place, middle).along - at(without, place, middle).along, 0.5 * size * std::cos(direction), 1e-9);
  EXPECT_NEAR(at(with, place, middle).up - at(without, place, middle).up, 0.5 * size * std::sin(direction), 1e-9);
}

TEST(GonzatoLeSaecSection, whereTheBedFallsItIsTakenAsLevel)
{
  const GonzatoLeSaecSection section{ {} };
  const SectionPlace falling = placeOf(2.0, 50.0, 4.0, -0.2);
  const SectionPlace level = placeOf(2.0, 50.0, 4.0, 0.0);
  for (double phase = -3.0; phase < 3.1; phase += 0.5)
  {
    EXPECT_EQ(at(section, falling, phase).along, at(section, level, phase).along);
    EXPECT_EQ(at(section, falling, phase).up, at(section, level, phase).up);
  }
}

TEST(GonzatoLeSaecSection, plungesInShallowWaterAndNotInDeep)
{
  const GonzatoLeSaecSection section{ {} };
  const SectionPlace deep = placeOf(2.0, 80.0, 10.0);
  EXPECT_EQ(overhang(curveOf(section, deep, crestOf(deep))), 0.0);
  const SectionPlace shallow = placeOf(2.3, 48.0, 3.0);
  const auto breaker = curveOf(section, shallow, crestOf(shallow));
  EXPECT_GT(overhang(breaker), 0.5);
  // The lip does not touch the trough.
  EXPECT_GT(breaker[breaker.size() / 2].y, lowest(breaker).y + 0.3);
}

TEST(PeacheySection, isASineWhereFlatAndSharpWhereSteep)
{
  const PeacheySection section{ {} };
  for (double u = 0.0; u < 1.0; u += 0.05)
  {
    EXPECT_NEAR(section.profile(Dual(u), 0.0, 1.0).value, std::cos(2.0 * Pi * u), Rounding);
    // 8 |u - 1/2|^2 - 1, raised by its mean of -1/3.
    EXPECT_NEAR(section.profile(Dual(u), 1.0, 1.0).value, 8.0 * (u - 0.5) * (u - 0.5) - 1.0 + 1.0 / 3.0, Rounding);
    EXPECT_NEAR(section.profile(Dual(u), 0.25, 1.0).value,
      0.75 * section.profile(Dual(u), 0.0, 1.0).value + 0.25 * section.profile(Dual(u), 1.0, 1.0).value, Rounding);
  }
  const SectionPlace steep = placeOf(10.0, 100.0, 200.0);
  EXPECT_NEAR(at(section, steep, 0.0).up, 5.0 * 4.0 / 3.0, 1e-9);
  const SectionPlace flat = placeOf(0.001, 100.0, 200.0);
  EXPECT_NEAR(at(section, flat, 0.0).up, 0.0005, 1e-7);
}

TEST(PeacheySection, stillWaterIsItsMeanLevel)
{
  const PeacheySection section{ {} };
  for (const double sharpness : { 0.0, 0.4, 1.0 })
  {
    for (const double power : { 1.0, 1.317, 1.75, 2.0 })
    {
      constexpr int intervals = 20000;
      double sum = 0.0;
      for (int i = 0; i < intervals; ++i)
      {
        sum += section.profile(Dual((i + 0.5) / intervals), sharpness, power).value;
      }
      EXPECT_NEAR(sum / intervals, 0.0, MeanTolerance) << sharpness << " " << power;
    }
  }
}

TEST(PeacheySection, frontsSteepenAndBacksStretchInShallowWaterOnly)
{
  const PeacheySection section{ {} };
  const SectionPlace deep = placeOf(2.0, 100.0, 100.0);
  const auto symmetric = curveOf(section, deep, crestOf(deep));
  for (std::size_t i = 0; i < symmetric.size(); ++i)
  {
    EXPECT_NEAR(symmetric[i].y, symmetric[symmetric.size() - 1 - i].y, 1e-9);
  }
  const SectionPlace shallow = placeOf(2.0, 60.0, 3.0);
  const auto curve = curveOf(section, shallow, crestOf(shallow));
  const double frontLength = lowest(curve).x - highest(curve).x;
  EXPECT_GT(frontLength, 0.0);
  EXPECT_LT(frontLength, 0.35 * 60.0);
  double front = 0.0;
  double back = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    const double slope = (curve[i].y - curve[i - 1].y) / (curve[i].x - curve[i - 1].x);
    front = std::max(front, -slope);
    back = std::max(back, slope);
  }
  EXPECT_GT(front, 1.3 * back);
  EXPECT_EQ(overhang(curve), 0.0); // one height a place
}

TEST(PeacheySection, asymmetryFollowsTheDepthOverTheDeepWaterLength)
{
  const PeacheySection section{ {} };
  EXPECT_EQ(section.power(0.25), 1.0);
  EXPECT_EQ(section.power(3.0), 1.0);
  EXPECT_NEAR(section.power(0.15), 1.5, Rounding);
  EXPECT_EQ(section.power(0.05), 2.0);
  EXPECT_EQ(section.power(0.0), 2.0);
}

TEST(PeacheySection, neverGoesBeyondTheDepth)
{
  const PeacheySection section{ {} };
  for (const double depth : { 5.0, 1.0, 0.3, 0.05 })
  {
    const SectionPlace place = placeOf(4.0, 30.0, depth);
    const auto curve = curveOf(section, place, crestOf(place));
    EXPECT_GE(lowest(curve).y, -depth);
    EXPECT_LE(highest(curve).y, depth);
  }
  // Where there is water enough the amplitude is H/2.
  const SectionPlace place = placeOf(4.0, 200.0, 100.0);
  const auto curve = curveOf(section, place, crestOf(place));
  EXPECT_NEAR(highest(curve).y - lowest(curve).y, 4.0, 1e-5);
}
