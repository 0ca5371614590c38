#include "SeafloorChecks.h"
#include "TextFiles.h"

#include "bathymetry/MatrixGrid.h"
#include "bathymetry/ModelFiles.h"

#include <gmock/gmock.h>

using namespace swellray;
using namespace swellray::test;
using testing::HasSubstr;

namespace
{

const char* const Configuration = R"({ "WIDTH": 40, "HEIGHT": 30, "dx": 10, "dy": 8.0, "name": "a" })";

// Printed with six decimals.
constexpr double Printed = 1e-5;

}

using MatrixFileTest = SeafloorFileTest;

TEST_F(MatrixFileTest, RegularMatricesInEitherSenseAreRegularGrids)
{
  const Bed bed = waves(140.0, 1000.0, 2000.0);
  // Turned by 40 degrees; the columns run to the right of the rows, then to the left.
  const double turn = 40.0 * 3.14159265358979323846 / 180.0;
  for (const double sense : { -1.0, 1.0 })
  {
    const auto place = [=](int column, int row)
    {
      const glm::dvec2 along(std::cos(turn), std::sin(turn));
      return glm::dvec2(1000.0, 2000.0) + 10.0 * row * along + 8.0 * sense * column * glm::dvec2(-along.y, along.x);
    };
    writeText(this->Files.file("z_a.grd"), lines(60, 80, [&](int c, int r) { return bed(place(c, r)); }));
    writeText(this->Files.file("x_a.grd"), lines(60, 80, [&](int c, int r) { return place(c, r).x; }));
    writeText(this->Files.file("y_a.grd"), lines(60, 80, [&](int c, int r) { return place(c, r).y; }));
    const std::optional<ModelGrid> grid = readModelGrid(this->Files.file("z_a.grd"));
    ASSERT_TRUE(grid);
    EXPECT_TRUE(grid->places.empty()) << "a regular grid stays one";
    const Bathymetry read = readSeafloor(this->Files.file("z_a.grd"));
    EXPECT_LT(largestError(read, bed), SplineError) << "sense " << sense;
    EXPECT_EQ(read.report.signSource, "assumed");
    EXPECT_GT(read.report.noDataShare, 0.3);
  }
}

TEST_F(MatrixFileTest, UprightMatricesKeepTheirNodes)
{
  const Bed bed = waves(140.0);
  // Rows of the file run along y, southwards: turned, not resampled.
  const auto place = [](int column, int row) { return glm::dvec2(10.0 * row, -8.0 * column); };
  writeText(this->Files.file("A_z.dep"), lines(30, 40, [&](int c, int r) { return bed(place(c, r)); }));
  writeText(this->Files.file("A_x.grd"), lines(30, 40, [&](int c, int r) { return place(c, r).x; }));
  writeText(this->Files.file("A_y.grd"), lines(30, 40, [&](int c, int r) { return place(c, r).y; }));
  const Bathymetry read = readSeafloor(this->Files.file("A_z.dep"));
  EXPECT_FALSE(read.report.resampled);
  EXPECT_EQ(read.grid.columns, 40u);
  EXPECT_EQ(read.grid.rows, 30u);
  EXPECT_LT(largestError(read, bed), Printed);
}

TEST_F(MatrixFileTest, MatricesThatDoNotFitEachOther)
{
  writeText(this->Files.file("z_a.grd"), "1 2\n3 4\n");
  EXPECT_FALSE(readModelGrid(this->Files.file("z_a.grd"))) << "no x and y beside it";
  writeText(this->Files.file("x_a.grd"), "1 2\n3 4\n");
  writeText(this->Files.file("y_a.grd"), "1 2 3\n4 5 6\n");
  EXPECT_THAT(
    failureOf([this] { readModelGrid(this->Files.file("z_a.grd")); }), HasSubstr("x 2 x 2, y 3 x 2, z 2 x 2"));
  writeText(this->Files.file("y_a.grd"), "1 2\n3\n");
  EXPECT_THAT(failureOf([this] { readModelGrid(this->Files.file("z_a.grd")); }),
    HasSubstr("its matrix of y: line 2 has 1 numbers"));
}

TEST_F(MatrixFileTest, SurveyTableWithRoundedCoordinates)
{
  // 12.34 apart, written with one decimal, and 23.9 apart, cut to whole metres.
  std::string table = " Dist_X";
  for (int j = 0; j < 6; ++j)
  {
    table += " Y_" + std::to_string(static_cast<int>(725.0 + 23.96 * j));
  }
  table += "\n";
  for (int i = 0; i < 5; ++i)
  {
    char x[16];
    std::snprintf(x, sizeof x, "%.1f", 50.0 + 12.34 * i);
    table += x + lines(6, 1, [i](int j, int) { return -1.0 * i - 0.1 * j; }).insert(0, " ");
  }
  const ModelGrid grid = readFrfTable(table);
  EXPECT_TRUE(isFrfTable(table));
  EXPECT_FALSE(isFrfTable("x y z\n"));
  EXPECT_TRUE(grid.places.empty());
  EXPECT_EQ(grid.first, glm::dvec2(50.0, 725.0));
  EXPECT_NEAR(grid.columnStep.y, 23.8, 1e-9); // (844 - 725) / 5
  EXPECT_NEAR(grid.rowStep.x, 12.35, 1e-9);   // (99.4 - 50) / 4
  writeText(this->Files.file("a.grid"), table);
  const Bathymetry read = readSeafloor(this->Files.file("a.grid"));
  EXPECT_EQ(read.grid.columns, 5u);
  EXPECT_EQ(read.grid.rows, 6u);
  EXPECT_NEAR(read.grid.at(4, 5), -4.5, Exact);
  EXPECT_NEAR(read.grid.at(1, 0), -1.0, Exact);

  std::string uneven = table;
  uneven.replace(uneven.find("Y_796"), 5, "Y_780");
  EXPECT_EQ(readFrfTable(uneven).places.size(), 30u);
  EXPECT_THAT(failureOf([] { readFrfTable("Dist_X Y_1 Y_2 Y_3 Y_4\n1 1 2 3\n2 1 2 3 4\n"); }),
    HasSubstr("line 2 has no number in column 5 of 5"));
  EXPECT_THAT(failureOf([] { readFrfTable("Dist_X Y_1 Y_2 Y_3\n1 1 2 3 4\n"); }), HasSubstr("more numbers than"));
  EXPECT_THAT(failureOf([] { readFrfTable("Dist_X Y_1 Y_ b\n1 1 2 3\n"); }), HasSubstr("is no coordinate"));
  EXPECT_THAT(failureOf([] { readFrfTable("Dist_X Y_1\n1 1\n"); }), HasSubstr("at least 4 x 4"));
}

TEST_F(MatrixFileTest, CelerisMatrixWithTheConfigurationBesideIt)
{
  const Bed bed = waves(140.0);
  writeText(this->Files.file("a_bathy.txt"), lines(40, 30, [&](int c, int r) { return bed({ 10.0 * c, 8.0 * r }); }));
  EXPECT_FALSE(readModelGrid(this->Files.file("a_bathy.txt"))) << "no configuration";
  writeText(this->Files.file("remark.json"), "{}");
  writeText(this->Files.file("broken.json"), "{ \"WIDTH\": 40,");
  writeText(this->Files.file("config.json"), Configuration);
  const Bathymetry read = readSeafloor(this->Files.file("a_bathy.txt"));
  EXPECT_EQ(read.report.driver, "Celeris");
  EXPECT_LT(largestError(read, bed), Printed);
  EXPECT_EQ(read.grid.spacing, glm::dvec2(10.0, 8.0));
  writeText(this->Files.file("again.json"), Configuration);
  EXPECT_THAT(errorOf(this->Files.file("a_bathy.txt")), HasSubstr("several .json files"));
}

TEST(CelerisGrid, ConfigurationThatDoesNotFit)
{
  std::size_t width = 0;
  std::size_t height = 0;
  EXPECT_TRUE(isCelerisConfiguration(Configuration, width, height));
  EXPECT_EQ(width, 40u);
  EXPECT_EQ(height, 30u);
  for (const std::string no : { "", "[]", "7", "{}", "{\"WIDTH\": 1, \"HEIGHT\": 2, \"dx\": 1, \"dy\": \"1\"}" })
  {
    EXPECT_FALSE(isCelerisConfiguration(no, width, height)) << no;
  }
  EXPECT_THAT(failureOf([] { readCelerisGrid("1 2\n3 4\n", "{}"); }), HasSubstr("does not set WIDTH"));
  EXPECT_THAT(failureOf([] { readCelerisGrid("1 2\n3 4\n", Configuration); }),
    HasSubstr("2 x 2 values, its configuration WIDTH x HEIGHT = 40 x 30"));
  EXPECT_THAT(failureOf([] { readCelerisGrid("1 2\n3 4\n", "{\"WIDTH\": 2, \"HEIGHT\": 2, \"dx\": 0, \"dy\": 1}"); }),
    HasSubstr("must be above 0"));
  EXPECT_THAT(failureOf([] { readCelerisGrid("1\n", "{\"WIDTH\": 1e300, \"HEIGHT\": -2, \"dx\": 1, \"dy\": 1}"); }),
    HasSubstr("WIDTH x HEIGHT = 0 x 0"));
}
