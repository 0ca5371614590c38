#include "SeafloorChecks.h"
#include "TextFiles.h"

#include "bathymetry/EvenCells.h"

#include <gmock/gmock.h>

using namespace swellray;
using namespace swellray::test;

namespace
{

// 30 x 12 nodes, 4 to 8 m apart along the columns and 40 m along the rows: a bar runs along y.
double eastOf(int column)
{
  return 4.0 * column + 0.07 * column * column;
}

double barAt(double x)
{
  return -6.0 + 3.0 * std::exp(-std::pow((x - 90.0) / 20.0, 2));
}

ModelGrid grid()
{
  ModelGrid made;
  made.columns = 30;
  made.rows = 12;
  for (int row = 0; row < 12; ++row)
  {
    for (int column = 0; column < 30; ++column)
    {
      made.places.emplace_back(eastOf(column), 40.0 * row);
      made.values.push_back(barAt(eastOf(column)));
    }
  }
  return made;
}

}

TEST(EvenCells, NodesArePutWhereCellsAreLong)
{
  ModelGrid fine = grid();
  evenCells(fine, {});
  EXPECT_EQ(fine.columns, 30u);
  EXPECT_EQ(fine.rows, 11u * 8u + 1u);
  ASSERT_EQ(fine.places.size(), fine.columns * fine.rows);
  for (std::size_t row = 0; row < fine.rows; ++row)
  {
    for (std::size_t column = 0; column < 30; ++column)
    {
      const std::size_t i = row * 30 + column;
      EXPECT_NEAR(fine.places[i].x, eastOf(static_cast<int>(column)), Exact);
      EXPECT_NEAR(fine.places[i].y, 5.0 * static_cast<double>(row), Exact);
      EXPECT_NEAR(fine.values[i], barAt(eastOf(static_cast<int>(column))), Exact);
    }
  }
  EXPECT_EQ(fine.notes.size(), 1u);
  EXPECT_EQ(*fine.spacing, *soundingsOf(grid()).spacing);

  // Squares stay.
  ModelGrid square = grid();
  for (glm::dvec2& place : square.places)
  {
    place.y /= 6.5;
  }
  evenCells(square, {});
  EXPECT_EQ(square.places.size(), 360u);
  EXPECT_TRUE(square.notes.empty());
}

TEST(EvenCells, MissingNodesStayMissingWithTheirCells)
{
  ModelGrid holed = grid();
  holed.values[5 * 30 + 7] = -999.0;
  evenCells(holed, -999.0);
  for (std::size_t row = 0; row < holed.rows; ++row)
  {
    const bool near = row > 32 && row < 48; // between the rows of nodes before and behind, 8 to each
    EXPECT_EQ(std::isnan(holed.values[row * 30 + 7]), near) << row;
    EXPECT_FALSE(std::isnan(holed.values[row * 30 + 6]));
  }
}

using EvenCellsFileTest = SeafloorFileTest;

TEST_F(EvenCellsFileTest, ABarAlongLongCellsStaysABar)
{
  const ModelGrid given = grid();
  const auto write = [&](const char* name, const auto& value)
  {
    writeText(this->Files.file(name),
      lines(30, 12, [&](int column, int row) { return value(static_cast<std::size_t>(row * 30 + column)); }));
  };
  write("z_a.grd", [&](std::size_t i) { return given.values[i]; });
  write("x_a.grd", [&](std::size_t i) { return given.places[i].x; });
  write("y_a.grd", [&](std::size_t i) { return given.places[i].y; });
  const Bathymetry read = readSeafloor(this->Files.file("z_a.grd"));
  double most = 0.0;
  for (std::size_t column = 0; column < read.grid.columns; ++column)
  {
    double low = 0.0;
    double high = -100.0;
    for (std::size_t row = 0; row < read.grid.rows; ++row)
    {
      low = std::min(low, read.grid.at(column, row));
      high = std::max(high, read.grid.at(column, row));
    }
    most = std::max(most, high - low);
  }
  // Along the bar nothing changes; without nodes in between it would by 0.43 m.
  constexpr double beads = 0.01;
  EXPECT_LT(most, beads);
}
