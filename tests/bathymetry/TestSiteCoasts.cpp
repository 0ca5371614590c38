// What every seafloor of the data folder is when it is read: its size, its place and how much of it is water. The
// expected numbers were computed from the files by other means: GDAL's and netCDF's arrays as they are, the texts split at
// blanks, meshes and curvilinear grids cell by cell with linear interpolation (numpy 1.24, GDAL 3.6).
#include "SeafloorChecks.h"

#include <cstdlib>
#include <filesystem>

using namespace swellray;
using namespace swellray::test;

namespace
{

// Nodes are kept: what is left is the fourth digit in which the share is written.
constexpr double Kept = 5e-5;

// Resampled from degrees on the largest upright rectangle, which cuts off slivers along the sides, or from a turned
// grid on a box: the coast moves by parts of a cell.
constexpr double Resampled = 5e-3;

// Cells between the nodes gridded by natural neighbours, which bend where straight lines do not.
constexpr double Gridded = 1e-2;

struct Site
{
  const char* name;
  std::size_t columns; ///< of the file
  std::size_t rows;
  Rectangle extent; ///< of the nodes, file coordinates
  double water;     ///< share of what has data
  double tolerance;
  double flat = 0.0; ///< share at just 0 m, which a spline between the nodes puts to either side
};

void PrintTo(const Site& site, std::ostream* out)
{
  *out << site.name;
}

const Site Sites[] = {
  { "banzai_pipeline_oahu/params.txt", 199, 119, { { 594228.82, 2394297.7 }, { 599844.11, 2400203.3 } }, 0.9882,
    Gridded },
  { "duck_frf_nc/FRF_07Oct1990.grid", 41, 25, { { 50, 725 }, { 400, 1300 } }, 0.7961, Gridded },
  { "duck_frf_nc/Regional_17mGrid_50m.sim", 94, 773, { { 894001.04, 259109.33 }, { 911572.59, 296971.86 } }, 0.7919,
    Resampled },
  { "duck_frf_nc/delilah_xbeach_z.dep", 121, 107, { { 0, 0 }, { 885, 2100 } }, 0.9468, Gridded },
  { "duck_frf_nc/frf_pier_1m_x_2m_bathy.txt", 751, 301, { { 0, 0 }, { 750, 600 } }, 0.7431, Kept },
  { "egmond_nl/egmond_10m_epsg28992.tif", 207, 365, { { 101131.368, 511890.531 }, { 103191.368, 515530.531 } }, 0.9011,
    Gridded },
  { "egmond_nl/UGegm51_net.nc", 4964, 4824, { { 101131.368, 511890.531 }, { 103195.134, 515531.062 } }, 0.9010,
    Gridded },
  { "haringvliet_nl/f31har01.swn", 88, 117, { { 0, 0 }, { 21750, 29000 } }, 0.6891, Kept },
  { "haringvliet_nl/f31har04.swn", 88, 117, { { 0, 0 }, { 21750, 29000 } }, 0.6891, Kept },
  { "hawaii_islands/hawaii_etopo1.nc", 299, 209, { { -162.96333, 17.036667 }, { -153.03667, 23.963333 } }, 0.9789,
    Resampled },
  { "hilo_bay_hawaii/hilo_bay_1_3s_epsg4326.tif", 701, 692, { { -155.09972, 19.71 }, { -155.03491, 19.77398 } }, 0.6030,
    Resampled },
  { "hilo_bay_hawaii/hilo_grid_1_3_arcsec_original.tif", 701, 692, { { 204.90028, 19.71 }, { 204.96509, 19.77398 } },
    0.6030, Resampled },
  { "long_island_ny/hudson_canyon_long_branch_3s.tif", 961, 781, { { -74.15, 40 }, { -73.35, 40.65 } }, 0.8189,
    Resampled, 0.0609 },
  { "long_island_ny/montauk_block_island_3s.tif", 1081, 661, { { -72.3, 40.8 }, { -71.4, 41.35 } }, 0.8999, Resampled,
    0.0042 },
  { "long_island_ny/ny_bight_long_island_3s.nc", 4201, 1801, { { -74.5, 40 }, { -71, 41.5 } }, 0.6464, Resampled,
    0.0135 },
  { "sand_engine_nl/z_dl_12.grd", 136, 701, { { 69026.38, 448675.54 }, { 75805.697, 456040.21 } }, 0.7137, Resampled },
  { "wa_reef_au/myalup_bathy.nc", 176, 180, { { 115.59153, -32.648301 }, { 115.62889, -32.610084 } }, 0.8232, Gridded },
  { "wa_reef_au/myalup_bathy.tif", 176, 180, { { 115.59153, -32.648301 }, { 115.62889, -32.610084 } }, 0.8232,
    Gridded },
};

class SiteCoasts : public testing::TestWithParam<Site>
{
};

}

TEST_P(SiteCoasts, AreThoseOfTheFile)
{
  const char* folder = std::getenv("SWELLRAY_DATA");
  const std::string sites = std::string(folder ? folder : SWELLRAY_DATA_DEFAULT) + "/sites/";
  if (!std::filesystem::is_directory(sites))
  {
    GTEST_SKIP() << "no bathymetry at " << sites << "; set SWELLRAY_DATA";
  }
  const Site& site = GetParam();
  const Bathymetry read = readSeafloor(sites + site.name);
  const SeafloorReport& report = read.report;
  if (report.fileColumns > 0)
  {
    EXPECT_EQ(report.fileColumns, site.columns);
    EXPECT_EQ(report.fileRows, site.rows);
  }
  else
  {
    ASSERT_TRUE(report.soundings);
    EXPECT_GT(report.soundings->cells, 0u);
  }
  // As many digits as are written above.
  const double digits = 1e-7 * std::max(std::abs(site.extent.high.x), std::abs(site.extent.high.y)) + 1e-6;
  EXPECT_NEAR(report.fileExtent.low.x, site.extent.low.x, digits);
  EXPECT_NEAR(report.fileExtent.low.y, site.extent.low.y, digits);
  EXPECT_NEAR(report.fileExtent.high.x, site.extent.high.x, digits);
  EXPECT_NEAR(report.fileExtent.high.y, site.extent.high.y, digits);
  const double water = report.waterShare / (1.0 - report.noDataShare);
  EXPECT_GT(water, site.water - site.tolerance);
  EXPECT_LT(water, site.water + site.flat + site.tolerance);
  EXPECT_NEAR(report.waterShare + report.landShare + report.noDataShare, 1.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Sites, SiteCoasts, testing::ValuesIn(Sites),
  [](const auto& tested)
  {
    std::string name = tested.param.name;
    std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
  });
