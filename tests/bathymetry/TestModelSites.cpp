#include "SeafloorChecks.h"
#include "TextFiles.h"

#include "sim/SplineSeafloor.h"

#include <glm/vec3.hpp>
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

using namespace swellray;
using namespace swellray::test;
using testing::HasSubstr;

namespace
{

// Real model grids, from the folder SWELLRAY_DATA or the one the build was set up with.
std::string site(const std::string& name)
{
  const char* folder = std::getenv("SWELLRAY_DATA");
  return std::string(folder ? folder : SWELLRAY_DATA_DEFAULT) + "/sites/" + name;
}

class ModelSitesTest : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!std::filesystem::is_directory(site("")))
    {
      GTEST_SKIP() << "no bathymetry at " << site("") << "; set SWELLRAY_DATA";
    }
  }
};

// Elevation of the node nearest to file coordinates.
double at(const Bathymetry& read, double x, double y)
{
  const glm::dvec2 p = (read.georeference.fromFile({ x, y }) - read.grid.origin) / read.grid.spacing;
  return read.grid.at(static_cast<std::size_t>(std::lround(p.x)), static_cast<std::size_t>(std::lround(p.y)));
}

}

TEST_F(ModelSitesTest, HaringvlietBySwan)
{
  const Bathymetry read = readSeafloor(site("haringvliet_nl/f31har01.swn"));
  EXPECT_EQ(read.grid.columns, 88u);
  EXPECT_EQ(read.grid.rows, 117u);
  EXPECT_EQ(read.report.signSource, "SWAN bottom");
  EXPECT_EQ(read.report.lowest, -28.0);
  EXPECT_EQ(at(read, 0.0, 0.0), -22.5) << "the first value of the file lies in the south-west";
  EXPECT_EQ(at(read, 0.0, 250.0), -22.7) << "the first of its second row";
  EXPECT_GT(at(read, 20000.0, 20000.0), 0.0) << "the exception value is land";
  EXPECT_THAT(notesOf(read), HasSubstr("--water-level 0.3"));
  EXPECT_EQ(read.report.noDataShare, 0.0);
}

TEST_F(ModelSitesTest, PipelineByXbeach)
{
  const Bathymetry read = readSeafloor(site("banzai_pipeline_oahu/params.txt"));
  EXPECT_EQ(read.report.signSource, "posdwn = 0");
  ASSERT_TRUE(read.report.soundings);
  EXPECT_THAT(notesOf(read), HasSubstr("for 23681")) << "its 199 x 119 nodes";
  EXPECT_NEAR(read.report.lowest, -80.8, 0.2);
  EXPECT_NEAR(read.report.highest, 8.9, 0.5);
  // The first node of the file, its deepest, is the west corner; land lies in the south-east.
  EXPECT_NEAR(at(read, 594228.8216 + 60.0, 2396295.0), -80.0, 1.0);
  EXPECT_TRUE(std::isnan(at(read, 594300.0, 2399900.0)));
  // The grid file alone is understood as the run that uses it says.
  EXPECT_NEAR(readSeafloor(site("banzai_pipeline_oahu/pipe_waves_refined.grd")).report.lowest, -80.8, 0.2);
}

TEST_F(ModelSitesTest, DuckByStwave)
{
  const Bathymetry read = readSeafloor(site("duck_frf_nc/Regional_17mGrid_50m.sim"));
  EXPECT_EQ(read.report.fileColumns, 94u);
  EXPECT_EQ(read.report.fileRows, 773u);
  EXPECT_EQ(read.report.crsName, "NAD83 / North Carolina");
  // From gdaltransform 3.6.
  const auto lonLat = read.georeference.toLonLat(read.georeference.fromFile({ 894026.0, 259134.0 }));
  ASSERT_TRUE(lonLat);
  EXPECT_NEAR(lonLat->x, -75.8430296185742, 1e-6);
  EXPECT_NEAR(lonLat->y, 36.045155963267, 1e-6);
  // Offshore in the north-east corner the first of the last row of depths: 17 m deep water, land in the south-west.
  EXPECT_LT(at(read, 898385.0 - 100.0, 297003.0 - 200.0), -10.0);
  EXPECT_GT(at(read, 908000.0, 262500.0), 0.0);
}

TEST_F(ModelSitesTest, DuckByStwaveLiesWhereTheSurveySays)
{
  // Soundings of the survey of 2017 beside it, state plane coordinates and elevation, m: every thousandth.
  const glm::dvec3 soundings[] = { { 902489.0, 274193.5, -5.68 }, { 902271.5, 274212.8, -3.83 },
    { 902103.6, 274244.1, -3.05 }, { 903106.0, 274707.8, -11.68 }, { 902094.1, 274533.8, -2.96 },
    { 902535.8, 274790.8, -8.12 }, { 902498.4, 274886.4, -8.00 }, { 902832.6, 275097.2, -10.58 },
    { 901774.6, 274904.6, -1.33 }, { 902168.8, 275142.9, -6.26 }, { 902062.8, 275153.6, -5.35 },
    { 901788.1, 275152.0, -2.95 }, { 901680.1, 275225.3, -2.34 }, { 901789.6, 275457.3, -4.19 } };
  const auto differences = [&](const std::string& path)
  {
    const Bathymetry read = readSeafloor(path);
    const SplineSeafloor bed(read.grid);
    double sum = 0.0;
    double largest = 0.0;
    for (const glm::dvec3& sounding : soundings)
    {
      const double difference = bed.elevation(read.georeference.fromFile({ sounding.x, sounding.y })) - sounding.z;
      sum += difference / static_cast<double>(std::size(soundings));
      largest = std::max(largest, std::abs(difference));
    }
    return std::pair(sum, largest);
  };
  // Its makers gave the grid the azimuth 198.2 and later wrote 200 into the file, which turns it about its offshore
  // corner: at the pier, 23 km along the coast, the shore then lies 700 m too far out. The file is read as it says.
  const std::string path = site("duck_frf_nc/Regional_17mGrid_50m.sim");
  EXPECT_GT(differences(path).first, 5.0);
  const Folder folder;
  std::ifstream stream(path);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  text.replace(text.find("azimuth = 200"), 13, "azimuth = 198.2");
  writeText(folder.file("a.sim"), text);
  std::filesystem::create_symlink(
    site("duck_frf_nc/Regional_17mGrid_50m.dep"), folder.file("Regional_17mGrid_50m.dep"));
  const auto [mean, largest] = differences(folder.file("a.sim"));
  // Over soundings of another year on a grid of 50 m: bars move and are up to 2 m high.
  EXPECT_LT(std::abs(mean), 0.5);
  EXPECT_LT(largest, 2.0);
}

TEST_F(ModelSitesTest, DuckByTablesAndMatrices)
{
  const Bathymetry table = readSeafloor(site("duck_frf_nc/FRF_07Oct1990.grid"));
  EXPECT_EQ(table.grid.columns, 41u);
  EXPECT_EQ(table.grid.rows, 25u);
  EXPECT_NEAR(table.grid.spacing.x, 8.75, Exact);
  EXPECT_EQ(at(table, 50.0, 725.0), 7.48);
  EXPECT_EQ(at(table, 50.0, 748.0), 8.09);

  const Bathymetry pier = readSeafloor(site("duck_frf_nc/frf_pier_1m_x_2m_bathy.txt"));
  EXPECT_EQ(pier.grid.columns, 751u);
  EXPECT_EQ(pier.grid.rows, 301u);
  EXPECT_EQ(pier.grid.spacing, glm::dvec2(1.0, 2.0));
  EXPECT_NEAR(at(pier, 0.0, 0.0), 3.739471, 1e-6);
  EXPECT_NEAR(pier.report.lowest, -8.5422088, 1e-6);

  const Bathymetry delilah = readSeafloor(site("duck_frf_nc/delilah_xbeach_z.dep"));
  EXPECT_NEAR(at(delilah, 0.0, 0.0), -8.0, 0.05);
  EXPECT_GT(at(delilah, 880.0, 1000.0), 2.0) << "x points to the shore";
}

TEST_F(ModelSitesTest, SandEngineByMatricesInLeftHandedOrder)
{
  SeafloorOptions options;
  options.crs = "EPSG:28992";
  const Bathymetry read = readSeafloor(site("sand_engine_nl/z_dl_12.grd"), options);
  EXPECT_EQ(read.report.fileColumns, 136u);
  EXPECT_EQ(read.report.fileRows, 701u);
  EXPECT_NEAR(read.report.fileSpacing.x, 12.0, 1e-6);
  EXPECT_FALSE(read.report.soundings) << "a regular grid, though rotated";
  // The first corner, deep, lies in the west; the hook 2.4 km long in the middle, in front of the shore.
  EXPECT_NEAR(at(read, 69026.4 + 12.0, 449748.985), -11.0, 0.1);
  EXPECT_GT(at(read, 72632.0, 452680.0), 2.0);
  const auto lonLat = read.georeference.toLonLat(read.georeference.fromFile({ 72000.0, 452000.0 }));
  ASSERT_TRUE(lonLat);
  EXPECT_NEAR(lonLat->x, 4.19, 0.03) << "Ter Heijde";
  EXPECT_NEAR(lonLat->y, 52.05, 0.03);
}

TEST_F(ModelSitesTest, EgmondByItsMeshIsEgmondByItsRaster)
{
  const Bathymetry mesh = readSeafloor(site("egmond_nl/UGegm51_net.nc"));
  ASSERT_TRUE(mesh.report.soundings);
  EXPECT_EQ(mesh.report.soundings->count, 4964u);
  EXPECT_EQ(mesh.report.soundings->cells, 4824u);
  // The raster is the linear interpolation of the same mesh.
  const Bathymetry raster = readSeafloor(site("egmond_nl/egmond_10m_epsg28992.tif"));
  double squares = 0.0;
  std::size_t count = 0;
  std::size_t sides = 0;
  for (std::size_t row = 0; row < mesh.grid.rows; ++row)
  {
    for (std::size_t column = 0; column < mesh.grid.columns; ++column)
    {
      const glm::dvec2 place = mesh.georeference.toFile(mesh.grid.node(column, row));
      const glm::dvec2 p = raster.georeference.fromFile(place) - raster.grid.origin;
      if (!raster.grid.bounds().contains(p))
      {
        continue;
      }
      const double a = mesh.grid.at(column, row);
      const double b = at(raster, place.x, place.y);
      if (!std::isnan(a + b))
      {
        squares += (a - b) * (a - b);
        sides += (a < 0.0) != (b < 0.0) ? 1 : 0;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 35000u);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(count)), 0.25) << "the nearest node, up to 7 m away";
  EXPECT_LT(static_cast<double>(sides) / static_cast<double>(count), 0.005) << "the same coast";
}
