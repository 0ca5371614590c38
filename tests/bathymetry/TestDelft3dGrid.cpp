#include "SeafloorChecks.h"
#include "TextFiles.h"

#include "bathymetry/Delft3dGrid.h"
#include "bathymetry/ModelFiles.h"
#include "bathymetry/XbeachGrid.h"

#include <gmock/gmock.h>

using namespace swellray;
using namespace swellray::test;
using testing::HasSubstr;

namespace
{

// 5 x 4 nodes on quarter rings, node (4, 3) missing.
glm::dvec2 placeOf(int column, int row)
{
  if (column == 4 && row == 3)
  {
    return glm::dvec2(0.0);
  }
  const double angle = 0.3 * column;
  return (100.0 + 10.0 * row) * glm::dvec2(std::cos(angle), std::sin(angle));
}

std::string grd(const std::string& header = "Coordinate System = Cartesian\n", const std::string& size = "5 4",
  const std::string& missing = "")
{
  std::string text = "* made by a test\n*\n" + header + missing + "  " + size + "\n 0 0 0\n";
  for (const bool northward : { false, true })
  {
    for (int row = 0; row < 4; ++row)
    {
      text += " ETA=    " + std::to_string(row + 1);
      for (int column = 0; column < 5; ++column)
      {
        const glm::dvec2 place = placeOf(column, row);
        text += (column == 3 ? "\n    " : " ") + std::to_string(northward ? place.y : place.x);
      }
      text += "\n";
    }
  }
  return text;
}

// A row and a column more than the grid, of the mark for no depth.
std::string dep()
{
  return lines(6, 5, [](int column, int row) { return column == 5 || row == 4 ? -999.0 : 10.0 * (column + 1) + row; });
}

void expectGrid(const ModelGrid& grid)
{
  ASSERT_EQ(grid.columns, 5u);
  ASSERT_EQ(grid.rows, 4u);
  ASSERT_EQ(grid.places.size(), 20u);
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 5; ++column)
    {
      const auto n = static_cast<std::size_t>(5 * row + column);
      EXPECT_EQ(grid.values[n], 10.0 * (column + 1) + row);
      if (n != 19)
      {
        EXPECT_NEAR(grid.places[n].x, placeOf(column, row).x, Rounding);
        EXPECT_NEAR(grid.places[n].y, placeOf(column, row).y, Rounding);
      }
    }
  }
  EXPECT_TRUE(std::isnan(grid.places[19].x)) << "the node at the missing value is none";
}

}

TEST(Delft3dGrid, PlacesAndDepthsOfTheCorners)
{
  const ModelGrid grid = readDelft3dGrid(grd(), dep());
  expectGrid(grid);
  EXPECT_EQ(grid.crs, "");
  EXPECT_EQ(grid.vertical.rule, "down");
  expectGrid(readDelft3dGrid(grd(""), dep())); // an old file
  EXPECT_EQ(readDelft3dGrid(grd("Coordinate System = Spherical\n"), dep()).crs, "EPSG:4326");
  // Depths without the further row and column.
  expectGrid(readDelft3dGrid(grd(), lines(5, 4, [](int column, int row) { return 10.0 * (column + 1) + row; })));
  // Another value for what is missing: then 0, 0 is a place.
  EXPECT_EQ(readDelft3dGrid(grd("", "5 4", "Missing Value = -9.99D+02\n"), dep()).places[19], glm::dvec2(0.0));
  // A depth of -999 is none.
  const std::string holed = lines(5, 4, [](int column, int row) { return column == 2 && row == 1 ? -999.0 : 3.0; });
  EXPECT_TRUE(std::isnan(readDelft3dGrid(grd(), holed).values[7]));
}

TEST(Delft3dGrid, WhatCannotBeReadSaysWhy)
{
  const std::tuple<std::string, std::string, std::string> cases[] = {
    { "", dep(), "does not give the size" },
    { grd("", "0 4"), dep(), "number of its columns must be a whole number" },
    { grd("", "1e9 1e9"), dep(), "number of its columns must be a whole number of 1 to 100000000" },
    { grd("", "99999999 99999999"), dep(), "above the limit of 100 million" },
    { grd("", "6 4"), dep(), "its row 1 of x has 5 of 6 values" },
    { grd("", "5 5"), dep(), "its row 5 of 5 of x does not begin with ETA= and its number" },
    { grd("", "4 4"), dep(), "does not begin with ETA=" },
    { grd("", "5 4", "Missing Value = none\n"), dep(), "its missing value" },
    { grd(), "1 2 3", "its depth file has 3 values" },
    { grd(), "1 2 x", "is no number" },
    { grd().substr(0, 300), dep(), "its row" },
  };
  for (const auto& [grid, depths, message] : cases)
  {
    EXPECT_THAT(failureOf([&, g = grid, d = depths] { readDelft3dGrid(g, d); }), HasSubstr(message)) << grid;
  }
}

TEST(XbeachGrid, EqualStepsTurnedAndMoved)
{
  const TextFiles files{
    { { "bed.dep", lines(5, 4, [](int column, int row) { return 10.0 * (column + 1) + row; }) } }
  };
  const std::string params =
    "%%% remark = 1 %%%\ndepfile = bed.dep\nnx = 4\nny = 3\ndx = 10\ndy = 8\nxori = 1000\nyori = 2000\n";
  const ModelGrid grid = readXbeachGrid(params, files.open());
  EXPECT_EQ(grid.columns, 5u);
  EXPECT_EQ(grid.rows, 4u);
  EXPECT_EQ(grid.values[7], 31.0);
  EXPECT_EQ(grid.first, glm::dvec2(1000.0, 2000.0));
  EXPECT_EQ(grid.columnStep, glm::dvec2(10.0, 0.0));
  EXPECT_EQ(grid.rowStep, glm::dvec2(0.0, 8.0));
  EXPECT_TRUE(grid.places.empty());
  EXPECT_EQ(grid.vertical.rule, "down") << "unless set";
  EXPECT_EQ(grid.vertical.unitsSource, "XBeach's unit");
  EXPECT_EQ(readXbeachGrid(params + "posdwn = 1\n", files.open()).vertical.rule, "down");
  EXPECT_EQ(readXbeachGrid(params + "posdwn = 0\n", files.open()).vertical.rule, "up");
  EXPECT_EQ(readXbeachGrid(params + "posdwn = -1\n", files.open()).vertical.rule, "up");
  const ModelGrid turned = readXbeachGrid(params + "alfa = 90\n", files.open());
  EXPECT_EQ(turned.columnStep, glm::dvec2(0.0, 10.0));
  EXPECT_EQ(turned.rowStep, glm::dvec2(-8.0, 0.0));
}

TEST(XbeachGrid, PlacesFromFiles)
{
  const TextFiles files{ { { "bed.dep", lines(5, 4, [](int column, int row) { return 10.0 * (column + 1) + row; }) },
    { "x.grd", lines(5, 4, [](int column, int) { return 1.0 * column * column; }) },
    { "y.grd", lines(5, 4, [](int, int row) { return 5.0 * row; }) }, { "a.grd", grd() }, { "a.dep", dep() } } };
  const std::string params = "depfile = bed.dep\nxfile = x.grd\nyfile = y.grd\nnx = 4\nny = 3\nvardx = 1\n";
  const ModelGrid grid = readXbeachGrid(params + "xori = 100\nalfa = 180\n", files.open());
  ASSERT_EQ(grid.places.size(), 20u);
  EXPECT_EQ(grid.places[13], glm::dvec2(91.0, -10.0));
  expectGrid(readXbeachGrid("gridform = delft3d\nxyfile = a.grd\ndepfile = a.dep\n", files.open()));
}

TEST(XbeachGrid, WhatCannotBeReadSaysWhy)
{
  const TextFiles files{ { { "bed.dep", "1 2 3\n4 5 6\n" } } };
  const std::pair<std::string, std::string> cases[] = {
    { "", "does not set depfile" },
    { "depfile = bed.dep", "does not set nx" },
    { "depfile = bed.dep\nnx = 4\nny=3", "does not set dx" },
    { "depfile = bed.dep\nnx = 4\nny=3\ndx=0\ndy=1", "must be above 0" },
    { "depfile = bed.dep\nnx = 4\nny=3\ndx=1\ndy=1", "'3'" },
    { "depfile = bed.dep\nnx = 4\nny=3\nvardx=1", "does not set xfile" },
    { "depfile = bed.dep\nnx = 1000000000\nny=3\ndx=1\ndy=1", "nx must be a whole number of 1 to 100000000" },
    { "depfile = bed.dep\nnx = 99999999\nny=99999999\ndx=1\ndy=1", "limit is 100 million" },
    { "depfile = bed.dep\ngridform = round", "neither xbeach nor delft3d" },
    { "depfile = bed.dep\ngridform = delft3d", "does not set xyfile" },
    { "depfile = none.dep\nnx = 4\nny=3\ndx=1\ndy=1", "'none.dep' is missing" },
  };
  for (const auto& [params, message] : cases)
  {
    const std::string said = failureOf([&, p = params] { readXbeachGrid(p, files.open()); });
    EXPECT_THAT(said, testing::AnyOf(HasSubstr(message), HasSubstr("it ends after"))) << params;
    EXPECT_NE(said, "no error");
  }
}

using Delft3dFileTest = SeafloorFileTest;

TEST_F(Delft3dFileTest, CurvilinearGridIsGriddedWhereItHasCells)
{
  // Half a ring, 10 m along the radius and up to 16 m along the circle; its fifth part beside (0, 140) is cut out.
  const int columns = 60;
  const int rows = 30;
  const auto place = [](int column, int row)
  {
    const double angle = 3.14159265358979323846 * (column + 0.5) / columns;
    return (100.0 + 10.0 * row) * glm::dvec2(std::cos(angle), std::sin(angle));
  };
  const Bed bed = waves(200.0);
  const auto isCut = [](int column, int row) { return std::abs(column - 30) < 6 && row < 10; };
  const auto coordinate = [&](bool northward)
  {
    std::string text;
    for (int row = 0; row < rows; ++row)
    {
      text += "ETA= " + std::to_string(row + 1) + " " +
        lines(columns, 1,
          [&](int column, int)
          {
            const glm::dvec2 p = place(column, row);
            return isCut(column, row) ? 0.0 : northward ? p.y : p.x;
          });
    }
    return text;
  };
  writeText(this->Files.file("a.grd"), "60 30\n0 0 0\n" + coordinate(false) + coordinate(true));
  writeText(this->Files.file("a.dep"),
    lines(columns + 1, rows + 1,
      [&](int column, int row) { return column == columns || row == rows ? -999.0 : -bed(place(column, row)); }));
  const Bathymetry read = readSeafloor(this->Files.file("a.grd"));
  ASSERT_TRUE(read.report.soundings);
  // Natural neighbours are linear in between: 20 m waves of 200 m a radian, 16 m apart.
  constexpr double gridded = 0.05;
  EXPECT_LT(largestError(read, bed), gridded);
  std::size_t wrong = 0;
  for (std::size_t row = 0; row < read.grid.rows; ++row)
  {
    for (std::size_t column = 0; column < read.grid.columns; ++column)
    {
      const glm::dvec2 p = read.georeference.toFile(read.grid.node(column, row));
      const double radius = std::hypot(p.x, p.y);
      const double angle = std::atan2(p.y, p.x) / 3.14159265358979323846 * columns - 0.5;
      // Clear of the rim, which is a polygon.
      const bool inside = radius > 101.0 && radius < 388.0 && angle > 0.05 && angle < 58.95;
      const bool outside = radius < 98.0 || radius > 391.0 || angle < -0.05 || angle > 59.05;
      const bool cut = radius < 199.0 && std::abs(angle - 30.0) < 5.9;
      const bool nearCut = radius < 201.0 && std::abs(angle - 30.0) < 6.1;
      const bool hole = std::isnan(read.grid.at(column, row));
      wrong += (hole && inside && !nearCut) || (!hole && (outside || (cut && inside))) ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0u) << "holes are where the grid has no cells, and nowhere else";
}

TEST_F(Delft3dFileTest, DepthsAreFoundBesideTheGrid)
{
  const auto file = [this](const std::string& name) { return this->Files.file(name); };
  writeText(file("a.grd"), grd());
  EXPECT_THAT(failureOf([&] { readModelGrid(file("a.grd")); }), HasSubstr("which of 0 .dep files"));
  writeText(file("bed.dep"), dep());
  expectGrid(*readModelGrid(file("a.grd")));
  writeText(file("other.dep"), "1 2 3");
  EXPECT_THAT(failureOf([&] { readModelGrid(file("a.grd")); }), HasSubstr("which of 2 .dep files"));
  writeText(file("run.mdf"), "Ident = #Delft3D-FLOW 3#\nFilcco = #a.grd#\nFildep = #bed.dep#\n");
  expectGrid(*readModelGrid(file("run.mdf")));
  writeText(file("a.dep"), dep());
  expectGrid(*readModelGrid(file("a.grd")));
  EXPECT_THAT(failureOf([&] { readModelGrid(file("a.dep")); }), HasSubstr("name the file that has these"));
  writeText(file("run.mdf"), "Filcco = #a.grd#\nFildep = #bed.dep#\nDpsopt = #DP#\n");
  EXPECT_THAT(failureOf([&] { readModelGrid(file("run.mdf")); }), HasSubstr("cells' centres"));
  EXPECT_FALSE(readModelGrid(file("none.grd")));
  EXPECT_EQ(readModelGrid(file("a.grd"))->vertical.rule, "down");
  writeText(file("params.txt"), "gridform = delft3d\nxyfile = a.grd\ndepfile = bed.dep\nposdwn = 0\n");
  EXPECT_EQ(readModelGrid(file("a.grd"))->vertical.rule, "up") << "as the run says that uses it";
}
