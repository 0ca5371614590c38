#include "SeafloorChecks.h"
#include "TextFiles.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>

using namespace swellray;
using namespace swellray::test;
using testing::AnyOf;
using testing::HasSubstr;

namespace
{

// No refusal takes longer, and none takes memory that the machine may not have.
constexpr auto AtOnce = std::chrono::seconds(5);

// Bytes that the process may have allocated at most, beyond what it had: none of the files needs more.
std::size_t peakMemory()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  std::size_t kilobytes = 0;
  while (status >> word)
  {
    if (word == "VmHWM:")
    {
      status >> kilobytes;
    }
  }
  return kilobytes * 1024;
}

class HostileFileTest : public SeafloorFileTest
{
protected:
  std::string refusal(const std::string& name, const SeafloorOptions& options = {})
  {
    const auto begin = std::chrono::steady_clock::now();
    const std::string said = errorOf(this->Files.file(name), options);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, AtOnce);
    EXPECT_NE(said, "no error") << name;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    EXPECT_THAT(said, testing::StartsWith("seafloor '" + this->Files.file(name) + "': "));
    return said;
  }
};

// Seafloor whose depth and place belong together: a plane through longitudes that are counted on across the line.
double planeOver(double longitude, double latitude)
{
  return -100.0 + 20.0 * longitude - 30.0 * latitude;
}

}

TEST_F(HostileFileTest, Truncated)
{
  // A file for each reader of our own, cut at every length.
  const std::pair<std::string, std::string> files[] = {
    { "a.swn", "INPGRID BOTTOM 0 0 0 4 3 50 25\nREADINP BOTTOM 1 'a.bot' 3 0 FREE\n" },
    { "a.sim", "x0 = 0\ny0 = 0\nazimuth = 0\ndx = 10\ndy = 10\nn_cell_i = 4\nn_cell_j = 4\nDEP = 's.dep'\n" },
    { "a.grid", "Dist_X Y_1 Y_2 Y_3 Y_4\n1 -1 -1 -1 -1\n2 -1 -1 -1 -1\n3 -1 -1 -1 -1\n4 -1 -1 -1 -1\n" },
    { "params.txt", "nx = 3\nny = 3\ndx = 10\ndy = 10\ndepfile = a.bot\n" },
  };
  writeText(this->Files.file("a.bot"), lines(5, 4, [](int column, int) { return 5.0 + column; }));
  writeText(this->Files.file("s.dep"), "IDD 1\n" + lines(4, 4, [](int column, int) { return 5.0 + column; }));
  for (const auto& [name, text] : files)
  {
    writeText(this->Files.file(name), text);
    EXPECT_EQ(errorOf(this->Files.file(name)), "no error") << name;
    for (std::size_t length = 0; length < text.size(); ++length)
    {
      writeText(this->Files.file(name), text.substr(0, length));
      const std::string said = errorOf(this->Files.file(name));
      EXPECT_TRUE(said == "no error" || said.find("seafloor '") == 0) << said;
    }
    writeText(this->Files.file(name), text.substr(0, text.size() / 2));
    refusal(name);
  }
}

TEST_F(HostileFileTest, Contradictory)
{
  writeText(this->Files.file("a.sim"), "x0=0\ny0=0\ndx=10\ndy=10\nn_cell_i=4\nn_cell_j=4\nDEP='s.dep'\n");
  writeText(
    this->Files.file("s.dep"), "&DataDims\nNI = 5,\nNJ = 4,\n/\nIDD 1\n" + lines(1, 20, [](int, int) { return 1; }));
  EXPECT_THAT(refusal("a.sim"), HasSubstr("ni = 5, the .sim file 4"));

  NetcdfFile file;
  file.x = steps(0.0, 0.001, 20);
  file.y = steps(0.0, 0.001, 20);
  file.bed = waves(0.012);
  file.attributes = { { "positive", "down" }, { "standard_name", "altitude" } };
  file.write(this->Files.file("a.nc"));
  EXPECT_THAT(refusal("a.nc"), HasSubstr("say --positive up or down"));
}

TEST_F(HostileFileTest, GiganticHeadersTakeNoMemory)
{
  const std::size_t before = peakMemory();
  writeText(
    this->Files.file("a.asc"), "ncols 1000000000\nnrows 1000000000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n");
  refusal("a.asc");
  writeText(this->Files.file("b.asc"), "ncols 200000\nnrows 200000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n");
  refusal("b.asc");
  writeText(
    this->Files.file("a.swn"), "INPGRID BOTTOM 0 0 0 1000000000 1000000000 50 25\nREADINP BOTTOM 1 'a.bot' 3 0 FREE\n");
  writeText(this->Files.file("a.bot"), "1 2 3\n");
  EXPECT_THAT(refusal("a.swn"), HasSubstr("[mxinp] must be"));
  writeText(this->Files.file("b.swn"), "INPGRID BOTTOM 0 0 0 9998 9998 50 25\nREADINP BOTTOM 1 'a.bot' 4 0 FREE\n");
  EXPECT_THAT(refusal("b.swn"), HasSubstr("ends after 3 of 99980001 values"));
  writeText(this->Files.file("c.bot"), "99999999*1.0 100000000000000000000*1\n");
  writeText(this->Files.file("c.swn"), "INPGRID BOTTOM 0 0 0 9998 9998 50 25\nREADINP BOTTOM 1 'c.bot' 4 0 FREE\n");
  EXPECT_THAT(refusal("c.swn"), HasSubstr("repeats a number 99999999 times"));
  writeText(this->Files.file("a.grd"), "1000000000 1000000000\n0 0 0\nETA= 1 1 2 3\n");
  writeText(this->Files.file("a.dep"), "1 2 3\n");
  EXPECT_THAT(refusal("a.grd"), HasSubstr("must be a whole number of 1 to"));
  GDALAllRegister();
  const char* const options[] = { "SPARSE_OK=YES", "TILED=YES", nullptr };
  GDALClose(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
    this->Files.file("a.tif").c_str(), 200000, 200000, 1, GDT_Float32, const_cast<CSLConstList>(options)));
  EXPECT_THAT(refusal("a.tif"), HasSubstr("above the limit of 100 million; read a part of it with --crop"));
  constexpr std::size_t little = 200000000; // bytes: GDAL's own tables, far below the 320 TB that are claimed
  EXPECT_LT(peakMemory() - before, little);
}

TEST_F(HostileFileTest, FilledWithNaN)
{
  RasterFile file;
  file.fill([](const glm::dvec2&) { return Missing; });
  file.writeGeoTiff(this->Files.file("a.tif"));
  EXPECT_THAT(refusal("a.tif"), HasSubstr("it has no data"));
  writeText(this->Files.file("a.bot"), lines(5, 4, [](int, int) { return Missing; }));
  writeText(this->Files.file("a.swn"), "INPGRID BOTTOM 0 0 0 4 3 50 25\nREADINP BOTTOM 1 'a.bot' 3 0 FREE\n");
  EXPECT_THAT(refusal("a.swn"), HasSubstr("it has no data"));
  // Of a curvilinear grid, values and places.
  const auto x = [](int column, int row) { return 1.0 * column * column + row; };
  const auto y = [](int, int row) { return 5.0 * row; };
  const auto nan = [](int, int) { return Missing; };
  writeText(this->Files.file("z_a.grd"), lines(5, 5, nan));
  writeText(this->Files.file("x_a.grd"), lines(5, 5, x));
  writeText(this->Files.file("y_a.grd"), lines(5, 5, y));
  EXPECT_THAT(refusal("z_a.grd"), AnyOf(HasSubstr("no"), HasSubstr("without a value")));
  writeText(this->Files.file("z_a.grd"), lines(5, 5, [](int, int) { return -5.0; }));
  writeText(this->Files.file("x_a.grd"), lines(5, 5, nan));
  EXPECT_THAT(refusal("z_a.grd"), HasSubstr("no cell with four nodes"));
}

TEST_F(HostileFileTest, OneRowOrColumn)
{
  writeText(this->Files.file("a.asc"), "ncols 6\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n-1 -2 -3 -4 -5 -6\n");
  EXPECT_THAT(refusal("a.asc"), HasSubstr("6 x 1 cells; a seafloor needs at least 4 x 4"));
  writeText(this->Files.file("params.txt"), "nx = 5\nny = 0\ndx = 10\ndy = 10\ndepfile = a.bot\n");
  writeText(this->Files.file("a.bot"), "1 2 3 4 5 6\n");
  EXPECT_THAT(refusal("params.txt"), HasSubstr("6 x 1 cells; a seafloor needs at least 4 x 4"));
  writeText(this->Files.file("z_a.grd"), "-1 -2 -3 -4 -5\n");
  writeText(this->Files.file("x_a.grd"), "1 2 3 4 5\n");
  writeText(this->Files.file("y_a.grd"), "1 2 3 4 5\n");
  EXPECT_THAT(refusal("z_a.grd"), HasSubstr("no cell with four nodes"));
}

TEST_F(HostileFileTest, ZeroSpacing)
{
  writeText(this->Files.file("a.asc"),
    "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 0\n" + lines(4, 4, [](int, int) { return -1.0; }));
  refusal("a.asc");
  writeText(this->Files.file("a.sim"), "x0=0\ny0=0\ndx=0\ndy=10\nn_cell_i=4\nn_cell_j=4\nDEP='s.dep'\n");
  EXPECT_THAT(refusal("a.sim"), HasSubstr("dx and dy must be above 0"));
  const auto same = [](int, int) { return 3.0; };
  for (const char* name : { "z_a.grd", "x_a.grd", "y_a.grd" })
  {
    writeText(this->Files.file(name), lines(5, 5, same));
  }
  EXPECT_THAT(refusal("z_a.grd"), AnyOf(HasSubstr("no cell with four nodes"), HasSubstr("no size")));
}

TEST_F(HostileFileTest, AcrossTheAntimeridian)
{
  // Longitudes counted on, and longitudes that jump from 180 to -180.
  for (const bool jumps : { false, true })
  {
    for (const bool descending : { false, true })
    {
      NetcdfFile file;
      file.x = descending ? steps(180.1, -0.005, 40) : steps(179.9, 0.005, 40);
      for (double& longitude : file.x)
      {
        longitude -= jumps && longitude >= 180.0 ? 360.0 : 0.0;
      }
      file.y = steps(-17.0, 0.005, 30);
      file.bed = [](const glm::dvec2& p) { return planeOver(p.x < 0.0 ? p.x + 180.0 : p.x - 180.0, p.y + 17.0); };
      file.write(this->Files.file("a.nc"));
      const Bathymetry read = readSeafloor(this->Files.file("a.nc"));
      EXPECT_NEAR(std::abs(read.georeference.originLongitude()), 180.0, 0.01);
      EXPECT_NEAR(read.grid.bounds().size().x, 0.195 * 106500.0, 600.0) << "one strip, not the whole way round";
      for (const double x : { -5000.0, 0.0, 5000.0 })
      {
        const glm::dvec2 place = read.georeference.toFile({ x, 0.0 });
        const double longitude = std::remainder(place.x - 180.0, 360.0);
        const glm::dvec2 node = (glm::dvec2(x, 0.0) - read.grid.origin) / read.grid.spacing;
        const auto column = static_cast<std::size_t>(std::lround(node.x));
        const auto row = static_cast<std::size_t>(std::lround(node.y));
        constexpr double cell = 0.3; // m: half a cell of the plane's slope
        EXPECT_NEAR(read.grid.at(column, row), planeOver(longitude, place.y + 17.0), cell);
      }
    }
  }
}

TEST_F(HostileFileTest, AtThePole)
{
  NetcdfFile file;
  file.x = steps(-20.0, 1.0, 41);
  file.y = steps(86.0, 0.1, 41); // to 90 degrees
  file.bed = [](const glm::dvec2& p) { return -4000.0 + 100.0 * (p.y - 86.0); };
  file.write(this->Files.file("a.nc"));
  const Bathymetry read = readSeafloor(this->Files.file("a.nc"));
  constexpr double spline = 1.0; // m: a cone at the pole, which no spline is
  EXPECT_LT(largestError(read, file.bed), spline);
  EXPECT_LT(read.report.scaleError, 1e-3);
  file.y = steps(88.0, 0.1, 41); // over it: no latitudes
  file.write(this->Files.file("b.nc"));
  EXPECT_THAT(refusal("b.nc"), HasSubstr("are no longitude and latitude"));
  // All the way round the pole is no plane map.
  file.x = steps(-180.0, 10.0, 37);
  file.y = steps(80.0, 0.2, 41);
  file.write(this->Files.file("c.nc"));
  EXPECT_THAT(refusal("c.nc"), HasSubstr("span more than 60 degrees"));
  // On a polar projection it is.
  RasterFile plane;
  plane.crs = "EPSG:3995";
  plane.transform = { -20000.0, 1000.0, 0.0, 15000.0, 0.0, -1000.0 };
  plane.fill(waves(12000.0));
  plane.writeGeoTiff(this->Files.file("a.tif"));
  const Bathymetry polar = readSeafloor(this->Files.file("a.tif"));
  EXPECT_LT(largestError(polar, waves(12000.0)), Exact);
  const auto lonLat = polar.georeference.toLonLat(polar.georeference.fromFile({ 0.0, -5000.0 }));
  ASSERT_TRUE(lonLat);
  EXPECT_NEAR(lonLat->x, 0.0, 1e-9);
  EXPECT_GT(lonLat->y, 89.9);
}
