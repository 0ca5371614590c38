#include "bathymetry/SeafloorReader.h"
#include "sim/SplineSeafloor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

using namespace swellray;

namespace
{

// Real files, from the folder SWELLRAY_DATA or the one the build was set up with.
std::string site(const std::string& name)
{
  const char* folder = std::getenv("SWELLRAY_DATA");
  return std::string(folder ? folder : SWELLRAY_DATA_DEFAULT) + "/sites/" + name;
}

class SitesTest : public testing::Test
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

struct Difference
{
  double largest = 0.0;
  double rms = 0.0;
  std::size_t onlyOne = 0; // nodes that have a value in one grid only
};

Difference difference(const ElevationGrid& a, const ElevationGrid& b)
{
  Difference result;
  double squares = 0.0;
  for (std::size_t i = 0; i < a.elevation.size(); ++i)
  {
    const double d = a.elevation[i] - b.elevation[i];
    if (std::isnan(a.elevation[i]) != std::isnan(b.elevation[i]))
    {
      ++result.onlyOne;
    }
    else if (!std::isnan(d))
    {
      result.largest = std::max(result.largest, std::abs(d));
      squares += d * d;
    }
  }
  result.rms = std::sqrt(squares / static_cast<double>(a.elevation.size()));
  return result;
}

// A node's place is where the file says, to a millimetre.
constexpr double Millimetre = 1e-3;

void expectRoundTrip(const Bathymetry& read)
{
  const ElevationGrid& grid = read.grid;
  for (const glm::dvec2& p : { grid.bounds().low, grid.bounds().high, 0.5 * (grid.bounds().low + grid.bounds().high) })
  {
    const glm::dvec2 back = read.georeference.fromFile(read.georeference.toFile(p));
    EXPECT_NEAR(back.x, p.x, Millimetre);
    EXPECT_NEAR(back.y, p.y, Millimetre);
  }
}

}

TEST_F(SitesTest, Hudson)
{
  const Bathymetry read = readSeafloor(site("long_island_ny/hudson_canyon_long_branch_3s.tif"));
  EXPECT_EQ(read.georeference.kind(), GeoreferenceKind::Geographic);
  EXPECT_NEAR(read.georeference.originLongitude(), -73.75, 1e-6);
  EXPECT_NEAR(read.georeference.originLatitude(), 40.325, 1e-6);
  // 961 x 781 cells of 3 seconds, less what the convergence of the meridians takes.
  EXPECT_GT(read.grid.columns, 950u);
  EXPECT_GT(read.grid.rows, 775u);
  EXPECT_NEAR(read.grid.spacing.x, 70.8, 0.1);
  EXPECT_NEAR(read.grid.spacing.y, 92.5, 0.1);
  EXPECT_EQ(read.report.noDataShare, 0.0);
  EXPECT_LT(read.report.scaleError, 2e-5);
  EXPECT_NEAR(read.report.lowest, -86.0, 1.0);
  expectRoundTrip(read);
}

TEST_F(SitesTest, PartOfTheLargeFileIsTheCutFile)
{
  // The .nc is stored to 0.1 m; the cut in single precision.
  SeafloorOptions crop;
  crop.crop = { -74.15, 40.0, -73.35, 40.65 };
  const Bathymetry part = readSeafloor(site("long_island_ny/ny_bight_long_island_3s.nc"), crop);
  const Bathymetry cut = readSeafloor(site("long_island_ny/hudson_canyon_long_branch_3s.tif"));
  EXPECT_EQ(part.report.signSource, "positive attribute");
  ASSERT_EQ(part.grid.elevation.size(), cut.grid.elevation.size());
  EXPECT_LT(difference(part.grid, cut.grid).largest, 0.06);
}

TEST_F(SitesTest, HiloWithAndWithoutCrs)
{
  const Bathymetry original = readSeafloor(site("hilo_bay_hawaii/hilo_grid_1_3_arcsec_original.tif"));
  const Bathymetry tagged = readSeafloor(site("hilo_bay_hawaii/hilo_bay_1_3s_epsg4326.tif"));
  EXPECT_EQ(original.georeference.kind(), GeoreferenceKind::Geographic);
  EXPECT_NEAR(original.georeference.originLongitude(), tagged.georeference.originLongitude(), 1e-9);
  EXPECT_NEAR(original.georeference.originLongitude(), -155.067315, 1e-5);
  ASSERT_EQ(original.grid.columns, tagged.grid.columns);
  ASSERT_EQ(original.grid.rows, tagged.grid.rows);
  // One stores doubles, the other single precision.
  EXPECT_LT(difference(original.grid, tagged.grid).largest, 1e-4);
  ASSERT_FALSE(original.report.notes.empty());
  EXPECT_THAT(original.report.notes[0], testing::HasSubstr("no CRS: taken as longitude and latitude"));
}

TEST_F(SitesTest, WesternAustraliaInTwoFormats)
{
  const Bathymetry tif = readSeafloor(site("wa_reef_au/myalup_bathy.tif")); // south up
  const Bathymetry nc = readSeafloor(site("wa_reef_au/myalup_bathy.nc"));   // x and y without units
  ASSERT_EQ(tif.grid.columns, nc.grid.columns);
  ASSERT_EQ(tif.grid.rows, nc.grid.rows);
  const Difference d = difference(tif.grid, nc.grid);
  EXPECT_LT(d.largest, 1e-6);
  EXPECT_EQ(d.onlyOne, 0u);
  EXPECT_EQ(tif.report.noDataRead, 2275u);
  EXPECT_GT(tif.report.filled, 0u);
  EXPECT_GT(tif.report.noDataShare, 0.0) << "the edge of the land stays a hole";
  // The sea lies in the west: a mirrored grid would have it elsewhere.
  EXPECT_LT(tif.grid.at(5, 90), -10.0);
  EXPECT_GT(tif.grid.at(150, 90), 0.0);
}

TEST_F(SitesTest, WesternAustraliaFromItsSparseSoundings)
{
  // Every other place of the grid, in a table that calls longitude and latitude easting and northing.
  const Bathymetry sparse = readSeafloor(site("wa_reef_au/myalup_bathy.xyz"));
  const Bathymetry full = readSeafloor(site("wa_reef_au/myalup_bathy.tif"));
  ASSERT_TRUE(sparse.report.soundings);
  EXPECT_EQ(sparse.report.soundings->count, 7354u);
  EXPECT_EQ(sparse.georeference.kind(), GeoreferenceKind::Geographic);
  const SplineSeafloor bed(full.grid);
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t row = 0; row < sparse.grid.rows; ++row)
  {
    for (std::size_t column = 0; column < sparse.grid.columns; ++column)
    {
      const glm::dvec2 p = full.georeference.fromFile(sparse.georeference.toFile(sparse.grid.node(column, row)));
      const double z = sparse.grid.at(column, row);
      if (!std::isnan(z) && z < 0.0 && bed.bounds().contains(p) && !bed.isHole(p))
      {
        squares += (z - bed.elevation(p)) * (z - bed.elevation(p));
        count += 1.0;
      }
    }
  }
  EXPECT_GT(count, 5500.0);
  // The dunes are rougher than the seabed, so the error under water is below that of soundings left out anywhere.
  EXPECT_LT(std::sqrt(squares / count), sparse.report.soundings->single.rms);
}

TEST_F(SitesTest, DuckSurveyAlongLines)
{
  const Bathymetry read = readSeafloor(site("duck_frf_nc/FRF_20170518_1134_FRF_NAVD88_LARC_GPS_UTC_v20170525.nc"));
  ASSERT_TRUE(read.report.soundings);
  EXPECT_EQ(read.report.soundings->count, 13654u);
  EXPECT_EQ(read.report.signSource, "attribute geospatial_vertical_positive");
  // The survey's range (its provenance), less what a mean over neighbours takes off.
  EXPECT_NEAR(read.report.lowest, -15.3, 0.1);
  EXPECT_NEAR(read.report.highest, 3.9, 0.2);
  // Lines are 45 m apart and 90 m in places: the gaps between them are no holes. The outline, turned by 18 degrees, with
  // two lines that reach farther out than the others, leaves less than half of the box empty.
  EXPECT_GT(read.report.soundings->maxGap, 45.0);
  EXPECT_GT(read.report.waterShare, 0.5);
  // The sea lies in the east.
  const glm::dvec2 sea = read.georeference.fromFile({ -75.738, 36.1845 });
  const glm::dvec2 index = (sea - read.grid.origin) / read.grid.spacing;
  EXPECT_LT(read.grid.at(static_cast<std::size_t>(index.x), static_cast<std::size_t>(index.y)), -8.0);
}

TEST_F(SitesTest, Hawaii)
{
  const Bathymetry read = readSeafloor(site("hawaii_islands/hawaii_etopo1.nc"));
  EXPECT_EQ(read.report.driver, "netCDF");
  EXPECT_EQ(read.report.signSource, "positive attribute");
  EXPECT_EQ(read.report.unitsSource, "units 'm'");
  EXPECT_NEAR(read.report.scaleError, 0.0032, 2e-4); // x^2/(2 R^2) at 506 km
  // Mauna Kea's grid cell stands where the map says, 19.82 N, 155.47 W.
  const glm::dvec2 summit = read.georeference.fromFile({ -155.47, 19.82 });
  const auto column = static_cast<std::size_t>(std::lround((summit.x - read.grid.origin.x) / read.grid.spacing.x));
  const auto row = static_cast<std::size_t>(std::lround((summit.y - read.grid.origin.y) / read.grid.spacing.y));
  EXPECT_GT(read.grid.at(column, row), 3500.0);
  expectRoundTrip(read);
}

TEST_F(SitesTest, Egmond)
{
  const Bathymetry read = readSeafloor(site("egmond_nl/egmond_10m_epsg28992.tif"));
  EXPECT_EQ(read.georeference.kind(), GeoreferenceKind::Projected);
  EXPECT_EQ(read.grid.columns, 207u);
  EXPECT_EQ(read.grid.rows, 365u);
  EXPECT_NEAR(read.georeference.originX(), 101131.368, 1e-6);
  EXPECT_NEAR(read.georeference.originY(), 511890.531, 1e-6);
  EXPECT_NEAR(read.report.noDataShare, 0.2697, 1e-3) << "outside the mesh";
  // From gdaltransform 3.6, south-west corner of the file; the corner node is half a cell inside. Helmert
  // transformations and the Dutch grid differ by less than half a metre.
  const auto lonLat = read.georeference.toLonLat(glm::dvec2(-5.0, -5.0));
  ASSERT_TRUE(lonLat.has_value());
  constexpr double halfMetre = 5e-6; // degrees
  EXPECT_NEAR(lonLat->x, 4.59216958, halfMetre);
  EXPECT_NEAR(lonLat->y, 52.59187388, halfMetre);
  expectRoundTrip(read);
}
