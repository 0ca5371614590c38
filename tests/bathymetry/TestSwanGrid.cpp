#include "SeafloorChecks.h"
#include "TextFiles.h"

#include <gmock/gmock.h>

using namespace swellray;
using namespace swellray::test;
using testing::HasSubstr;

namespace
{

// 5 x 4 nodes of which each depth names its column and row.
double depthAt(int column, int row)
{
  return 10.0 * (column + 1) + row;
}

const std::string Regular = "INPGRID BOTTOM 100. 200. 0. 4 3 50. 25.\n";

ModelGrid read(const std::string& commands, const std::string& bottom)
{
  const TextFiles files{ { { "a.bot", bottom } } };
  return readSwanGrid(commands, files.open());
}

void expectDepths(const ModelGrid& grid, double factor = 1.0)
{
  ASSERT_EQ(grid.columns, 5u);
  ASSERT_EQ(grid.rows, 4u);
  ASSERT_EQ(grid.values.size(), 20u);
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 5; ++column)
    {
      EXPECT_EQ(grid.values[static_cast<std::size_t>(5 * row + column)], factor * depthAt(column, row));
    }
  }
}

}

TEST(SwanGrid, AllLayoutsGiveTheSameBottom)
{
  const auto upward = [](int column, int row) { return depthAt(column, row); };
  const auto downward = [](int column, int row) { return depthAt(column, 3 - row); };
  const auto byColumn = [](int row, int column) { return depthAt(column, row); };
  const auto layout = [](int idla)
  { return Regular + "READINP BOTTOM 1. 'a.bot' " + std::to_string(idla) + " 0 FREE\n"; };
  const auto onOneLine = [](std::string text)
  {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  };
  expectDepths(read(layout(1), lines(5, 4, downward)));
  expectDepths(read(layout(2), onOneLine(lines(5, 4, downward))));
  expectDepths(read(layout(3), lines(5, 4, upward)));
  expectDepths(read(layout(4), onOneLine(lines(5, 4, upward))));
  expectDepths(read(layout(5), lines(4, 5, byColumn)));
  expectDepths(read(layout(6), onOneLine(lines(4, 5, byColumn))));
  expectDepths(read(Regular + "READ BOT 'a.bot'\n", lines(5, 4, downward))); // all left to the defaults
}

TEST(SwanGrid, OddLayoutsBeginEachRowOnALineOfItsOwn)
{
  // Three values a line; the fourth, on the second line of each row, is one too many.
  std::string text;
  for (int row = 0; row < 4; ++row)
  {
    text += lines(3, 1, [row](int column, int) { return depthAt(column, row); });
    text += lines(3, 1, [row](int column, int) { return depthAt(column + 3, row); });
  }
  expectDepths(read(Regular + "READINP BOTTOM 1. 'a.bot' 3 0 FREE\n", text));
}

TEST(SwanGrid, CommandsAsTheManualAllowsThem)
{
  const std::string commands = "$ a remark\nPROJ 'a $ b' '01' ! INPGRID BOTTOM 9 9 9 9 9 9 9\n"
                               "INPGRID WIND 0. 0. 0. 1 1 5. 5.\nREADINP WIND 1. 'w.wnd' 3 0 FREE\n"
                               "inp $ here $ bot reg xpinp=100., ypinp=200. &\n  0. 4 3 _\n  dxinp=50. 25. exc -99.\n"
                               "read bottom -2. 'a.bot' idla=3 nhedf=2 free\nCOORD SPHER CCM\nSET LEVEL 0.3\n";
  const ModelGrid grid = read(commands, "first head\nsecond head\n" + lines(5, 4, depthAt));
  expectDepths(grid, -2.0);
  EXPECT_EQ(grid.first, glm::dvec2(100.0, 200.0));
  EXPECT_EQ(grid.columnStep, glm::dvec2(50.0, 0.0));
  EXPECT_EQ(grid.rowStep, glm::dvec2(0.0, 25.0));
  EXPECT_EQ(grid.crs, "EPSG:4326");
  EXPECT_EQ(grid.vertical.rule, "down");
  ASSERT_EQ(grid.notes.size(), 1u);
  EXPECT_THAT(grid.notes[0], HasSubstr("--water-level 0.3"));
}

TEST(SwanGrid, ExceptionsAreLand)
{
  const auto depth = [](int column, int row) { return column == 4 ? -99.0 : depthAt(column, row); };
  const std::string commands = "INPGRID BOTTOM 0 0 0 4 3 50 25 EXC -99\nREADINP BOTTOM 1 'a.bot' 3 0 FREE\n";
  const ModelGrid low = read(commands, lines(5, 4, depth));
  EXPECT_EQ(low.values[4], -5.0);
  EXPECT_EQ(low.values[0], 10.0);
  ASSERT_EQ(low.notes.size(), 1u);
  EXPECT_EQ(low.notes[0], "4 nodes with the exception value -99 are land of no known height: taken 5 m high");
  // Land that is there already is not overtopped, and [fac] holds for what is no exception.
  const auto cliff = [depth](int column, int row) { return column == 3 ? 7.0 : depth(column, row); };
  const std::string turned = "INPGRID BOTTOM 0 0 0 4 3 50 25 EXC -99\nREADINP BOTTOM -1 'a.bot' 3 0 FREE\n";
  EXPECT_EQ(read(turned, lines(5, 4, cliff)).values[4], -33.0); // as high as column 2, row 3
}

TEST(SwanGrid, RotatedGrid)
{
  const ModelGrid grid =
    read("INPGRID BOTTOM 100. 200. 30. 4 3 50. 25.\nREADINP BOTTOM 1. 'a.bot' 3 0 FREE\n", lines(5, 4, depthAt));
  EXPECT_NEAR(grid.columnStep.x, 50.0 * std::sqrt(0.75), Exact);
  EXPECT_NEAR(grid.columnStep.y, 25.0, Exact);
  EXPECT_NEAR(grid.rowStep.x, -12.5, Exact);
  EXPECT_NEAR(grid.rowStep.y, 25.0 * std::sqrt(0.75), Exact);
}

TEST(SwanGrid, CurvilinearGridHasThePlacesOfReadgrid)
{
  std::string places = "head\n" + lines(5, 4, [](int column, int) { return column == 4 ? -9.0 : 1.0 + column; });
  places += lines(5, 4, [](int column, int row) { return column == 4 ? -9.0 : 2.0 + row * row; });
  const TextFiles files{ { { "a.bot", lines(5, 4, depthAt) }, { "a.grd", places } } };
  const std::string commands =
    "CGRID CURV 4 3 EXC -9. -9. CIRCLE 36 0.05 1. 31\nREADGRID COOR 10. 'a.grd' 3 1 0 FREE\n";
  const std::string bottom = "READINP BOTTOM 1. 'a.bot' 3 0 FREE\n";
  for (const std::string input : { "INPGRID BOTTOM CURV 0. 0. 4 3\n", "INPGRID BOTTOM CURV\n" })
  {
    const ModelGrid grid = readSwanGrid(commands + input + bottom, files.open());
    expectDepths(grid);
    ASSERT_EQ(grid.places.size(), 20u);
    EXPECT_EQ(grid.places[0], glm::dvec2(10.0, 20.0));
    EXPECT_EQ(grid.places[17], glm::dvec2(30.0, 110.0));
    EXPECT_TRUE(std::isnan(grid.places[4].x));
  }
  EXPECT_THAT(failureOf([&] { readSwanGrid("INPGRID BOTTOM CURV\n" + bottom, files.open()); }),
    HasSubstr("do not give the places"));
  EXPECT_THAT(failureOf([&] { readSwanGrid(commands + "INPGRID BOTTOM CURV 0. 0. 3 3\n" + bottom, files.open()); }),
    HasSubstr("another number of meshes"));
}

TEST(SwanGrid, WhatCannotBeReadSaysWhy)
{
  const std::string bottom = lines(5, 4, depthAt);
  const std::string input = "READINP BOTTOM 1. 'a.bot' 3 0 FREE\n";
  const std::pair<std::string, std::string> cases[] = {
    { "", "no commands INPGRID BOTTOM and READINP BOTTOM" },
    { Regular, "no commands INPGRID BOTTOM and READINP BOTTOM" },
    { "INPGRID BOTTOM UNSTRUC\n" + input, "unstructured" },
    { "INPGRID BOTTOM 0 0 0 4 3 50\n" + input, "[dyinp] is missing" },
    { "INPGRID BOTTOM 0 0 0 4 3 50 0\n" + input, "must be above 0" },
    { "INPGRID BOTTOM 0 0 0 4 3 nan 1\n" + input, "[dxinp] is missing" },
    { "INPGRID BOTTOM 0 0 0 4.5 3 50 25\n" + input, "[mxinp] must be a whole number" },
    { "INPGRID BOTTOM 0 0 0 4 0 50 25\n" + input, "[myinp] must be a whole number of 1" },
    { "INPGRID BOTTOM 0 0 0 1000000000 1000000000 50 25\n" + input,
      "[mxinp] must be a whole number of 1 to 100000000" },
    { "INPGRID BOTTOM 0 0 0 99999999 99999999 50 25\n" + input, "the limit is 100 million" },
    // A row on two lines leaves the second row its rest.
    { "INPGRID BOTTOM 0 0 0 5 3 50 25\n" + input, "it ends after 12 of 24 values of depth in 'a.bot'" },
    { "INPGRID BOTTOM 0 0 0 4 3 50 25 NONSTAT 1 1 HR 2\n" + input, "changes in time" },
    { Regular + "READINP BOTTOM 1. SERIES 'a.bot' 3 0 FREE\n", "a series in time is not read" },
    { Regular + "READINP BOTTOM 1. 'a.bot' 3 0 FORMAT '(10F8.0)'\n", "only FREE format is read" },
    { Regular + "READINP BOTTOM 1. 'a.bot' 7 0 FREE\n", "[idla] must be 1 to 6" },
    { Regular + "READINP BOTTOM 1. 'a.bot' 3 -2 FREE\n", "[nhedf] must be 0 or more" },
    { Regular + "READINP BOTTOM 0. 'a.bot' 3 0 FREE\n", "[fac] must not be 0" },
    { Regular + "READINP BOTTOM 1. a.bot 3 0 FREE\n", "names no file in quotes" },
    { Regular + "READINP BOTTOM 1. 'b.bot' 3 0 FREE\n", "'b.bot' is missing" }, { "&\n&\n_\n", "no commands INPGRID" },
    { "CGRID\f\n\f\n\v \r\n'' \"\n", "no commands INPGRID" }, // found by fuzzing, 2026-11-22
  };
  for (const auto& [commands, message] : cases)
  {
    EXPECT_THAT(failureOf([&, c = commands] { read(c, bottom); }), HasSubstr(message)) << commands;
  }
}

using SwanFileTest = SeafloorFileTest;

TEST_F(SwanFileTest, IsASeafloorByItsCommandFile)
{
  const Bed bed = waves(140.0, 1000.0, 2000.0);
  const auto depth = [&bed](int column, int row) { return -bed({ 1000.0 + 10.0 * column, 2000.0 + 8.0 * row }); };
  writeText(
    this->Files.file("a.swn"), "INPGRID BOTTOM 1000 2000 0 39 29 10 8\nREADINP BOTTOM 1 '.\\in\\Bed.bot' 3 0 FREE\n");
  EXPECT_THAT(errorOf(this->Files.file("a.swn")), HasSubstr("Bed.bot' is missing"));
  writeText(this->Files.file("Bed.bot"), lines(40, 30, depth));
  const Bathymetry read = readSeafloor(this->Files.file("a.swn"));
  EXPECT_EQ(read.report.driver, "SWAN");
  EXPECT_EQ(read.report.signSource, "SWAN bottom");
  EXPECT_EQ(read.report.unitsSource, "SWAN's unit");
  EXPECT_EQ(read.grid.columns, 40u);
  EXPECT_EQ(read.grid.rows, 30u);
  constexpr double printed = 1e-6; // six decimals in the file
  EXPECT_LT(largestError(read, bed), printed);
  SeafloorOptions up;
  up.positive = Positive::Up;
  EXPECT_THAT(errorOf(this->Files.file("a.swn"), up), HasSubstr("--positive down")) << "all of it is then land";
  EXPECT_THAT(errorOf(this->Files.file("Bed.bot")), HasSubstr("name the file that has these"));
}
