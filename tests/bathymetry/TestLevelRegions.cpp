#include "bathymetry/LevelRegions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace swellray;

namespace
{

constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

ElevationGrid gridOf(std::size_t columns, std::vector<double> values)
{
  ElevationGrid grid;
  grid.columns = columns;
  grid.rows = values.size() / columns;
  grid.elevation = std::move(values);
  return grid;
}

using Sides = std::vector<std::uint8_t>;

}

TEST(LevelRegions, compareWithTheLevelWhereNothingIsFlat)
{
  const ElevationGrid grid = gridOf(4, { -3.0, -1.0, 0.0, 2.0, -2.0, NoValue, 1.0, 3.0 });
  EXPECT_EQ(sidesOfLevel(grid, 0.0, 0.0), (Sides{ 0, 0, 1, 1, 0, 0, 1, 1 }));
  EXPECT_EQ(sidesOfLevel(grid, 1.5, 0.1), (Sides{ 0, 0, 0, 1, 0, 0, 0, 1 }));
}

TEST(LevelRegions, aFlatWithRingsBelongsToTheLandItLiesAt)
{
  // Water, a flat of alternating hairs' breadths, land.
  const ElevationGrid grid = gridOf(7,
    { -5.0, -3.0, 0.001, -0.002, 0.0, 0.003, 4.0, //
      -5.0, -2.0, 0.002, 0.001, -0.001, -0.001, 5.0 });
  EXPECT_EQ(sidesOfLevel(grid, 0.0, 0.0), (Sides{ 0, 0, 1, 0, 1, 1, 1, 0, 0, 1, 1, 0, 0, 1 }));
  EXPECT_EQ(sidesOfLevel(grid, 0.0, 0.02), (Sides{ 0, 0, 1, 1, 1, 1, 1, 0, 0, 1, 1, 1, 1, 1 }));
}

TEST(LevelRegions, aSpeckOfNoiseInWaterIsWater)
{
  const ElevationGrid grid = gridOf(4, { -5.0, -4.0, -3.0, -4.0, -5.0, 0.01, 0.001, -4.0, -5.0, -4.0, -3.0, -4.0 });
  EXPECT_EQ(sidesOfLevel(grid, 0.0, 0.02), Sides(12, 0));
  // Once it stands up, it is an islet, all of it.
  ElevationGrid islet = grid;
  islet.elevation[5] = 0.03;
  EXPECT_EQ(sidesOfLevel(islet, 0.0, 0.02), (Sides{ 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0 }));
}

TEST(LevelRegions, aPuddleOnLandIsLand)
{
  ElevationGrid grid = gridOf(3, { 2.0, 2.0, 2.0, 2.0, -0.01, 2.0, 2.0, 2.0, 2.0 });
  EXPECT_EQ(sidesOfLevel(grid, 0.0, 0.02), Sides(9, 1));
  grid.elevation[4] = -0.03;
  EXPECT_EQ(sidesOfLevel(grid, 0.0, 0.02)[4], 0);
}

TEST(LevelRegions, nodesWithoutDataTouchNothing)
{
  // Noise between water and a hole: no land comes up to it.
  const ElevationGrid grid = gridOf(5, { -3.0, 0.01, NoValue, 4.0, 5.0 });
  EXPECT_EQ(sidesOfLevel(grid, 0.0, 0.02), (Sides{ 0, 0, 0, 1, 1 }));
  EXPECT_EQ(sidesOfLevel(gridOf(2, { 0.0, 0.0, 0.0, 0.0 }), 0.0, 0.02), Sides(4, 0)) << "a flat alone has no shore";
}
