#include "sim/RayMap.h"

#include "sim/Angles.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace
{

using namespace swellray;

// Phases of some units, heights about 1: only rounding is left.
constexpr double Rounding = 1e-11;

TEST(CombineSheets, TakesTheHighestWhereOppositeWavesHaveNoMeanDirection)
{
  std::vector<WaveSheet> sheets(2);
  sheets[0].height = sheets[1].height = 1.0;
  sheets[0].wavenumber = { 0.5, 0.0 };
  sheets[1].wavenumber = { -0.5, 0.0 };
  const CombinedWave wave = combineSheets(sheets.data(), 2, CombineRule::Energy);
  EXPECT_DOUBLE_EQ(wave.directionFrom, 270.0);
  EXPECT_DOUBLE_EQ(wave.height, std::sqrt(2.0));
}

TEST(CombineSheets, ShiftsByAQuarterWaveACaustic)
{
  std::vector<WaveSheet> sheets(2);
  for (WaveSheet& sheet : sheets)
  {
    sheet.height = sheet.branch = 1.0;
    sheet.wavenumber = { 0.5, 0.0 };
    sheet.phase = 3.0;
  }
  sheets[1].caustics = 1;
  EXPECT_NEAR(combineSheets(sheets.data(), 2, CombineRule::Phase).height, std::sqrt(2.0), Rounding);
  sheets[1].caustics = 2;
  EXPECT_NEAR(combineSheets(sheets.data(), 2, CombineRule::Phase).height, 0.0, Rounding);
}

// Triangles next to a fold, too coarse for a tube that closes, once gave a height of 20 here.
TEST(CombineSheets, BranchesOfAFoldAreEquallyHighOnIt)
{
  std::array<WaveSheet, 2> sheets;
  for (WaveSheet& sheet : sheets)
  {
    sheet.wavenumber = { 0.1, 0.0 };
  }
  sheets[0].height = 2.45;
  sheets[0].branch = 2.29;
  sheets[0].phase = 97.1367;
  sheets[1].height = 2.44;
  sheets[1].branch = 12.9;
  sheets[1].phase = 97.1368;
  sheets[1].caustics = 1;
  // Two branches as high as their moduli make 2 Ai(0)/(Ai(0)^2 + Bi(0)^2)^(1/2) = 1 of one of them on the caustic itself.
  const double height = combineSheets(sheets.data(), 2, CombineRule::Phase).height;
  EXPECT_GT(height, 1.5);
  EXPECT_LT(height, 3.0);
}

TEST(CombineSheets, BeamsTakeThePlaceOfAllByTheirWeight)
{
  WaveSheet sheet;
  sheet.wavenumber = { 0.1, 0.0 };
  sheet.height = sheet.branch = 1.0;
  sheet.phase = 0.0;
  BeamShare beams;
  beams.wave = { 0.0, 3.0 };
  beams.wavenumber = { 0.0, 0.2 };
  for (const double weight : { 0.0, 0.25, 1.0 })
  {
    beams.weight = weight;
    const CombinedWave wave = combineSheets(&sheet, 1, CombineRule::Phase, nullptr, 0, &beams);
    EXPECT_NEAR(wave.height, std::hypot(1.0 - weight, 3.0 * weight), Rounding);
    EXPECT_EQ(wave.count, 1);
    EXPECT_EQ(combineSheets(&sheet, 1, CombineRule::Energy, nullptr, 0, &beams).height, 1.0);
  }
  // On the dark side they are all there is.
  const CombinedWave dark = combineSheets(nullptr, 0, CombineRule::Phase, nullptr, 0, &beams);
  EXPECT_NEAR(dark.height, 3.0, Rounding);
  EXPECT_NEAR(dark.directionFrom, 180.0, Rounding);
  EXPECT_NEAR(dark.wavelength, 10.0 * Pi, Rounding);
  EXPECT_EQ(dark.count, 0);
  EXPECT_TRUE(std::isnan(combineSheets(nullptr, 0, CombineRule::Energy, nullptr, 0, &beams).height));
}

TEST(CombineSheets, AStripTakesThePlaceOfItsTwoBranches)
{
  std::vector<WaveSheet> sheets(3);
  for (WaveSheet& sheet : sheets)
  {
    sheet.height = sheet.branch = 1.0;
    sheet.wavenumber = { 0.5, 0.0 };
    sheet.phase = 3.0;
  }
  sheets[1].caustics = 1;
  sheets[1].phase = 3.4;
  sheets[2].phase = 20.0; // another wave
  FoldShare fold;
  fold.wave = std::polar(2.0, 20.0);
  fold.number = 1;
  fold.middle = 3.2;
  fold.half = 0.2;
  const auto height = [&](double weight)
  {
    fold.weight = fold.hides = weight;
    return combineSheets(sheets.data(), 3, CombineRule::Phase, &fold, 1).height;
  };
  EXPECT_NEAR(height(0.0), combineSheets(sheets.data(), 3, CombineRule::Phase).height, Rounding);
  EXPECT_NEAR(height(1.0), 3.0, Rounding);
  // Far into the dark sheets of its phase are others, which it once put out.
  fold.hides = 0.0;
  fold.wave = 0.0;
  EXPECT_NEAR(combineSheets(sheets.data(), 3, CombineRule::Phase, &fold, 1).height,
    combineSheets(sheets.data(), 3, CombineRule::Phase).height, Rounding);
  fold.wave = std::polar(2.0, 20.0);
  // With energies it has no part.
  EXPECT_NEAR(combineSheets(sheets.data(), 3, CombineRule::Energy, &fold, 1).height, std::sqrt(3.0), Rounding);
  // On the dark side it is alone.
  fold.wavenumber = { 0.0, 0.5 };
  const CombinedWave dark = combineSheets(nullptr, 0, CombineRule::Phase, &fold, 1);
  EXPECT_NEAR(dark.height, 2.0, Rounding);
  EXPECT_NEAR(dark.directionFrom, 180.0, Rounding);
  EXPECT_EQ(dark.count, 0);
  EXPECT_TRUE(std::isnan(combineSheets(nullptr, 0, CombineRule::Energy, &fold, 1).height));
}

}
