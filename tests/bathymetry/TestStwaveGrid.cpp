#include "SeafloorChecks.h"
#include "TextFiles.h"

#include "bathymetry/StwaveGrid.h"

#include <gmock/gmock.h>

using namespace swellray;
using namespace swellray::test;
using testing::HasSubstr;

namespace
{

std::string sim(const std::string& more = "", const std::string& azimuth = "0.0")
{
  return "# STWAVE_SIM_FILE\n&std_parms\n  iplane = 1,\n/\n&spatial_grid_parms\n  x0 = 1000.0,\n  y0 = 2000.0,\n"
         "  azimuth = " +
    azimuth +
    ",\n  dx = 10.0,\n  dy = 8.0,\n  n_cell_i = 5,\n  n_cell_j = 4\n/\n&input_files\n  DEP = \"a.dep\",\n/\n" + more;
}

std::string dep(const std::string& values, const std::string& dims = "NI = 5,\n NJ = 4,")
{
  return "#STWAVE_SPATIAL_DATASET\n&DataDims\n DataType = 0,\n NumRecs = 1,\n NumFlds = 1,\n " + dims +
    "\n/\n&Dataset\n FldName(1) = \"Depth\",\n FldUnits(1) = \"ft\",\n/\nIDD 201609070000\n" + values;
}

// Depths that name their cell; the last j comes first in the file.
std::string values()
{
  return lines(1, 20, [](int, int n) { return 10.0 * (n % 5 + 1) + (3 - n / 5); });
}

ModelGrid read(const std::string& simText, const std::string& depText)
{
  const TextFiles files{ { { "a.dep", depText } } };
  return readStwaveGrid(simText, files.open());
}

}

TEST(StwaveGrid, CellsLieInTheMiddleAndTheLastRowComesFirst)
{
  const ModelGrid grid = read(sim(), dep(values()));
  ASSERT_EQ(grid.columns, 5u);
  ASSERT_EQ(grid.rows, 4u);
  for (std::size_t n = 0; n < 20; ++n)
  {
    EXPECT_EQ(grid.values[n], 10.0 * static_cast<double>(n % 5 + 1) + static_cast<double>(n / 5));
  }
  EXPECT_EQ(grid.first, glm::dvec2(1005.0, 2004.0));
  EXPECT_EQ(grid.columnStep, glm::dvec2(10.0, 0.0));
  EXPECT_EQ(grid.rowStep, glm::dvec2(0.0, 8.0));
  EXPECT_EQ(grid.vertical.rule, "down");
  EXPECT_EQ(grid.vertical.units, "ft");
  std::string unsaid = dep(values());
  unsaid.erase(unsaid.find("\"ft\"") + 1, 2);
  EXPECT_EQ(read(sim(), unsaid).vertical.units, "m");
  EXPECT_EQ(read(sim(), unsaid).vertical.unitsSource, "STWAVE's unit");
  EXPECT_EQ(grid.crs, "");
}

TEST(StwaveGrid, AzimuthTurnsItAnticlockwiseAboutItsCorner)
{
  const ModelGrid grid = read(sim("", "90."), dep(values()));
  EXPECT_EQ(grid.columnStep, glm::dvec2(0.0, 10.0));
  EXPECT_EQ(grid.rowStep, glm::dvec2(-8.0, 0.0));
  EXPECT_EQ(grid.first, glm::dvec2(996.0, 2005.0));
  const ModelGrid turned = read(sim("", "200"), dep(values()));
  EXPECT_NEAR(turned.columnStep.x, -9.396926207859083, Exact); // 10 cos 200
  EXPECT_NEAR(turned.columnStep.y, -3.420201433256687, Exact);
}

TEST(StwaveGrid, ItsCoordinateSystemIsKnown)
{
  const ModelGrid plane = read(sim("coord_sys = 'STATEPLANE',\nspzone = 3200,\n"), dep(values()));
  EXPECT_THAT(plane.crs, HasSubstr("NAD83 / North Carolina"));
  EXPECT_THAT(plane.crsSource, HasSubstr("NAD 83 assumed"));
  const ModelGrid zone = read(sim("coord_sys = 'UTM',\nspzone = 18,\n"), dep(values()));
  EXPECT_THAT(zone.crs, HasSubstr("\"UTM zone 18N\""));
  EXPECT_EQ(read(sim("coord_sys = 'LOCAL',\n"), dep(values())).crs, "");
  for (const std::string unknown : { "coord_sys = 'STATEPLANE',\nspzone = 9999,\n",
         "coord_sys = 'UTM',\nspzone = 61,\n", "coord_sys = 'UTM',\nspzone = -4,\n", "coord_sys = 'MOON',\n" })
  {
    const ModelGrid grid = read(sim(unknown), dep(values()));
    EXPECT_EQ(grid.crs, "") << unknown;
    ASSERT_EQ(grid.notes.size(), 1u);
    EXPECT_THAT(grid.notes[0], HasSubstr("is not known; --crs gives it"));
  }
}

TEST(StwaveGrid, WhatCannotBeReadSaysWhy)
{
  const std::string good = dep(values());
  const std::tuple<std::string, std::string, std::string> cases[] = {
    { "", good, "does not set DEP" },
    { "DEP = 'a.dep'", good, "does not set n_cell_i" },
    { sim("n_cell_i = 0"), good, "n_cell_i must be a whole number of 1" },
    { sim("n_cell_i = 99999999\nn_cell_j=99999999"), dep("1", "NI = 99999999,\nNJ = 99999999,"),
      "limit is 100 million" },
    { sim("n_cell_i = 6"), good, "'a.dep' has ni = 5, the .sim file 6" },
    { sim("dx = -10"), good, "dx and dy must be above 0" },
    { sim("dx = wide"), good, "its setting dx = wide is no number" },
    { sim("DEP = b.dep"), good, "'b.dep' is missing" },
    { sim("idep_opt = 1"), good, "not one of a file" },
    { sim(), "1 2 3", "has no record" },
    { sim(), "", "has no record" },
    { sim(), dep("1 2 3"), "ends after 3 of 20 values" },
    { sim(), dep(values(), "NI = 5,\nNJ = 4,\nNumFlds = 2,"), "several fields" },
  };
  for (const auto& [simText, depText, message] : cases)
  {
    EXPECT_THAT(failureOf([&, s = simText, d = depText] { read(s, d); }), HasSubstr(message)) << simText;
  }
}

using StwaveFileTest = SeafloorFileTest;

TEST_F(StwaveFileTest, RotatedGridIsTurnedNorthUp)
{
  const Bed bed = waves(140.0, 1000.0, 2000.0);
  const double turn = 200.0 * 3.14159265358979323846 / 180.0;
  const glm::dvec2 along(std::cos(turn), std::sin(turn));
  const glm::dvec2 across(-along.y, along.x);
  std::string depths;
  for (int j = 59; j >= 0; --j)
  {
    depths += lines(80, 1,
      [&](int i, int)
      { return -bed(glm::dvec2(1000.0, 2000.0) + (i + 0.5) * 10.0 * along + (j + 0.5) * 8.0 * across); });
  }
  writeText(this->Files.file("a.sim"), sim("n_cell_i = 80\nn_cell_j = 60\n", "200"));
  writeText(this->Files.file("a.dep"), "IDD 1\n" + depths);
  const Bathymetry read = readSeafloor(this->Files.file("a.sim"));
  EXPECT_TRUE(read.report.resampled);
  EXPECT_LT(largestError(read, bed), SplineError);
  EXPECT_GT(read.report.noDataShare, 0.3) << "the corners of the box around it are holes";
  EXPECT_LT(read.report.noDataShare, 0.5);
}
