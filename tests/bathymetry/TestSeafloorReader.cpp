#include "bathymetry/SeafloorReader.h"

#include "SeafloorChecks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace swellray;
using namespace swellray::test;
using testing::HasSubstr;

using SeafloorReaderTest = SeafloorFileTest;

TEST_F(SeafloorReaderTest, NorthUpProjectedKeepsItsNodes)
{
  RasterFile file;
  file.crs = "EPSG:32618";
  file.transform = { 580000.0, 10.0, 0.0, 4480300.0, 0.0, -10.0 };
  const Bed bed = waves(120.0, 580000.0, 4480000.0);
  file.fill(bed);
  file.writeGeoTiff(this->Files.file("a.tif"));
  const Bathymetry read = readSeafloor(this->Files.file("a.tif"));
  EXPECT_EQ(read.grid.columns, 40u);
  EXPECT_EQ(read.grid.rows, 30u);
  EXPECT_EQ(read.grid.spacing, glm::dvec2(10.0));
  EXPECT_EQ(read.grid.origin, glm::dvec2(0.0));
  EXPECT_DOUBLE_EQ(read.georeference.originX(), 580005.0);
  EXPECT_DOUBLE_EQ(read.georeference.originY(), 4480005.0);
  EXPECT_EQ(read.georeference.kind(), GeoreferenceKind::Projected);
  EXPECT_FALSE(read.report.resampled);
  EXPECT_LT(largestError(read, bed), Exact);
  EXPECT_EQ(read.report.waterShare, 1.0);
  EXPECT_EQ(read.report.signSource, "assumed");
}

TEST_F(SeafloorReaderTest, SouthUpAndEastFirstGridsAreTurned)
{
  const Bed bed = waves(120.0, 1000.0, 2000.0);
  for (const std::array<double, 6>& transform : { std::array<double, 6>{ 1000.0, 10.0, 0.0, 2000.0, 0.0, 10.0 },
         std::array<double, 6>{ 1400.0, -10.0, 0.0, 2300.0, 0.0, -10.0 } })
  {
    RasterFile file;
    file.transform = transform;
    file.crs = "EPSG:32618";
    file.fill(bed);
    file.writeGeoTiff(this->Files.file("a.tif"));
    const Bathymetry read = readSeafloor(this->Files.file("a.tif"));
    EXPECT_DOUBLE_EQ(read.georeference.originX(), 1005.0);
    EXPECT_DOUBLE_EQ(read.georeference.originY(), 2005.0);
    EXPECT_LT(largestError(read, bed), Exact);
  }
}

TEST_F(SeafloorReaderTest, RotatedGridIsResampledWhole)
{
  RasterFile file;
  file.columns = 120;
  file.rows = 90;
  file.crs = "EPSG:32618";
  const double turn = 0.4;
  file.transform = { 5000.0, 10.0 * std::cos(turn), 12.0 * std::sin(turn), 7000.0, 10.0 * std::sin(turn),
    -12.0 * std::cos(turn) };
  const Bed bed = waves(140.0);
  file.fill(bed);
  file.writeGeoTiff(this->Files.file("a.tif"));
  const Bathymetry read = readSeafloor(this->Files.file("a.tif"));
  EXPECT_TRUE(read.report.resampled);
  EXPECT_LT(largestError(read, bed), SplineError);
  EXPECT_NEAR(read.grid.spacing.x, 10.0, Rounding);
  EXPECT_NEAR(read.grid.spacing.y, 12.0, Rounding);
  // All of the file's 119 x 89 cells lie in the box around them; the corners that it adds are holes.
  const double nodes = static_cast<double>(read.grid.columns * read.grid.rows);
  const double width = 1190.0 * std::cos(turn) + 1068.0 * std::sin(turn);
  const double height = 1190.0 * std::sin(turn) + 1068.0 * std::cos(turn);
  EXPECT_NEAR(nodes * 120.0, width * height, 0.02 * width * height);
  const double share = 1190.0 * 1068.0 / (width * height);
  EXPECT_NEAR(1.0 - read.report.noDataShare, share, 0.02) << "cells cut by the outline count whole or not";
  EXPECT_THAT(notesOf(read), HasSubstr("rotated"));
}

TEST_F(SeafloorReaderTest, GeographicGridIsResampledToMetres)
{
  RasterFile file;
  file.columns = 100;
  file.rows = 110;
  file.crs = "EPSG:4326";
  file.transform = { -74.0, 0.001, 0.0, 40.11, 0.0, -0.001 };
  const Bed bed = waves(0.013, -74.0, 40.0);
  file.fill(bed);
  file.writeGeoTiff(this->Files.file("a.tif"));
  const Bathymetry read = readSeafloor(this->Files.file("a.tif"));
  EXPECT_EQ(read.georeference.kind(), GeoreferenceKind::Geographic);
  EXPECT_NEAR(read.georeference.originLongitude(), -73.95, Exact);
  EXPECT_NEAR(read.georeference.originLatitude(), 40.055, Exact);
  EXPECT_EQ(read.georeference.originX(), 0.0);
  EXPECT_LT(largestError(read, bed), SplineError);
  // A thousandth of a degree at 40.055 N on WGS 84 (Rapp 1991, Geometric Geodesy I): parallel and meridian.
  constexpr double centimetre = 0.01;
  EXPECT_NEAR(read.grid.spacing.x, 85.325, centimetre);
  EXPECT_NEAR(read.grid.spacing.y, 111.036, centimetre);
  // The parallels and meridians that bound it are bent by less than a cell: nothing is lost but the edge.
  EXPECT_GE(read.grid.columns, 98u);
  EXPECT_GE(read.grid.rows, 108u);
  EXPECT_GT(read.report.scaleError, 0.0);
  EXPECT_LT(read.report.scaleError, 1e-6);
}

TEST_F(SeafloorReaderTest, LongitudesFrom0To360AreTheSame)
{
  const auto make = [this](const char* name, double turn)
  {
    RasterFile file;
    file.crs = "EPSG:4326";
    file.transform = { -155.0 + turn, 0.001, 0.0, 19.8, 0.0, -0.001 };
    file.fill(waves(0.013, -155.0 + turn, 19.7));
    file.writeGeoTiff(this->Files.file(name));
    return readSeafloor(this->Files.file(name));
  };
  const Bathymetry west = make("a.tif", 0.0);
  const Bathymetry east = make("b.tif", 360.0);
  ASSERT_EQ(west.grid.elevation.size(), east.grid.elevation.size());
  EXPECT_NEAR(east.georeference.originLongitude(), west.georeference.originLongitude(), Exact);
  for (std::size_t i = 0; i < west.grid.elevation.size(); ++i)
  {
    ASSERT_NEAR(west.grid.elevation[i], east.grid.elevation[i], Rounding);
  }
  SeafloorOptions crop;
  crop.crop = { -154.99, 19.775, -154.97, 19.795 };
  EXPECT_EQ(readSeafloor(this->Files.file("a.tif"), crop).grid.columns,
    readSeafloor(this->Files.file("b.tif"), crop).grid.columns);
}

TEST_F(SeafloorReaderTest, WithoutCrsSlopeDecides)
{
  RasterFile file;
  file.transform = { 3.0, 0.001, 0.0, 52.0, 0.0, -0.001 };
  file.fill(waves(0.013, 3.0, 52.0));
  file.writeGeoTiff(this->Files.file("degrees.tif"));
  const Bathymetry degrees = readSeafloor(this->Files.file("degrees.tif"));
  EXPECT_EQ(degrees.georeference.kind(), GeoreferenceKind::Geographic);
  EXPECT_THAT(notesOf(degrees), HasSubstr("no CRS: taken as longitude and latitude"));

  // A wave tank: its coordinates would fit longitude and latitude.
  file.transform = { 0.0, 0.5, 0.0, 20.0, 0.0, -0.5 };
  file.fill([](const glm::dvec2& p) { return -0.45 + 0.02 * p.x; });
  file.writeGeoTiff(this->Files.file("tank.tif"));
  const Bathymetry tank = readSeafloor(this->Files.file("tank.tif"));
  EXPECT_EQ(tank.georeference.kind(), GeoreferenceKind::Local);
  EXPECT_DOUBLE_EQ(tank.georeference.originX(), 0.25);
  EXPECT_THAT(notesOf(tank), HasSubstr("no CRS: coordinates taken as metres"));

  SeafloorOptions local;
  local.crs = "local";
  EXPECT_EQ(readSeafloor(this->Files.file("degrees.tif"), local).georeference.kind(), GeoreferenceKind::Local);
  SeafloorOptions wrong;
  wrong.crs = "EPSG:99999999";
  EXPECT_THAT(errorOf(this->Files.file("tank.tif"), wrong), HasSubstr("is not understood"));
}

TEST_F(SeafloorReaderTest, CoordinatesInFeetBecomeMetres)
{
  RasterFile file;
  file.crs = "EPSG:2263"; // New York Long Island, US survey feet
  file.transform = { 980000.0, 100.0, 0.0, 153000.0, 0.0, -100.0 };
  const Bed bed = waves(1300.0);
  file.fill(bed);
  file.writeGeoTiff(this->Files.file("a.tif"));
  const Bathymetry read = readSeafloor(this->Files.file("a.tif"));
  EXPECT_NEAR(read.grid.spacing.x, 100.0 * 1200.0 / 3937.0, Exact);
  EXPECT_DOUBLE_EQ(read.georeference.originX(), 980050.0);
  EXPECT_LT(largestError(read, bed), Exact);
  EXPECT_THAT(notesOf(read), HasSubstr("units of 0.3048"));
}

TEST_F(SeafloorReaderTest, NetcdfAxesInAnyOrder)
{
  const Bed bed = waves(0.013, 115.0, -32.0);
  std::vector<Bathymetry> reads;
  for (int variant = 0; variant < 4; ++variant)
  {
    NetcdfFile file;
    file.bed = bed;
    file.x = steps(115.0, 0.001, 50);
    file.y = variant & 1 ? steps(-31.96, -0.001, 41) : steps(-32.0, 0.001, 41);
    file.xFirst = (variant & 2) != 0;
    const std::string path = this->Files.file("a" + std::to_string(variant) + ".nc");
    file.write(path);
    reads.push_back(readSeafloor(path));
    EXPECT_EQ(reads.back().report.driver, "netCDF");
    EXPECT_EQ(reads.back().report.unitsSource, "units 'm'");
    EXPECT_EQ(reads.back().georeference.kind(), GeoreferenceKind::Geographic);
    EXPECT_LT(largestError(reads.back(), bed), SplineError) << "variant " << variant;
  }
  for (const Bathymetry& read : reads)
  {
    ASSERT_EQ(read.grid.elevation.size(), reads[0].grid.elevation.size());
    for (std::size_t i = 0; i < read.grid.elevation.size(); ++i)
    {
      ASSERT_NEAR(read.grid.elevation[i], reads[0].grid.elevation[i], Rounding);
    }
  }
}

TEST_F(SeafloorReaderTest, NetcdfPackedValuesWithoutCfAxes)
{
  NetcdfFile file;
  file.xName = "x";
  file.yName = "y";
  file.xUnits = file.yUnits = "";
  file.units = "";
  file.packed = true;
  file.scale = 0.01;
  file.offset = -100.0;
  file.nodata = -32768;
  file.x = steps(1000.0, 10.0, 40);
  file.y = steps(5000.0, 20.0, 30);
  file.bed = waves(120.0);
  file.write(this->Files.file("a.nc"));
  const Bathymetry read = readSeafloor(this->Files.file("a.nc"));
  constexpr double packing = 0.0051; // half the scale
  EXPECT_LT(largestError(read, file.bed), packing + Exact);
  EXPECT_EQ(read.georeference.kind(), GeoreferenceKind::Local);
  EXPECT_DOUBLE_EQ(read.georeference.originX(), 1000.0);
  EXPECT_EQ(read.grid.spacing, glm::dvec2(10.0, 20.0));
}

TEST_F(SeafloorReaderTest, AsciiGrid)
{
  RasterFile file;
  file.nodata = -9999.0;
  const Bed bed = waves(120.0);
  file.fill(bed);
  file.at(0, 0) = -9999.0;
  file.writeAscii(this->Files.file("a.asc"));
  const Bathymetry read = readSeafloor(this->Files.file("a.asc"));
  EXPECT_EQ(read.report.filled, 1u);
  EXPECT_EQ(read.report.noDataRead, 1u);
  // GDAL reads text grids in single precision; the filled corner node is off by a bit more.
  constexpr double singlePrecision = 2e-6;
  const glm::dvec2 corner(0.0, 29.0);
  double largest = 0.0;
  for (std::size_t row = 0; row < 30; ++row)
  {
    for (std::size_t column = 0; column < 40; ++column)
    {
      if (glm::dvec2(column, row) != corner)
      {
        const double z = bed(read.georeference.toFile(read.grid.node(column, row)));
        largest = std::max(largest, std::abs(read.grid.at(column, row) - z));
      }
    }
  }
  EXPECT_LT(largest, singlePrecision);
}

TEST_F(SeafloorReaderTest, GapsAreFilledAndHolesKept)
{
  RasterFile file;
  file.nodata = -999.0;
  const Bed plane = [](const glm::dvec2& p) { return -30.0 + 0.05 * p.x + 0.02 * p.y; };
  file.fill(plane);
  for (int row = 8; row < 18; ++row)
  {
    for (int column = 10; column < 22; ++column)
    {
      file.at(column, row) = (row + column) % 2 ? -999.0 : Missing;
    }
  }
  for (int row = 0; row < 12; ++row)
  {
    for (int column = 32; column < 40; ++column)
    {
      file.at(column, row) = -999.0;
    }
  }
  file.writeGeoTiff(this->Files.file("a.tif"));
  const Bathymetry read = readSeafloor(this->Files.file("a.tif"));
  EXPECT_EQ(read.report.filled, 120u);
  EXPECT_EQ(read.report.noDataRead, 120u + 96u);
  EXPECT_DOUBLE_EQ(read.report.noDataShare, 96.0 / 1200.0);
  EXPECT_TRUE(std::isnan(read.grid.at(39, 29)));
  EXPECT_LT(largestError(read, plane), Rounding) << "a plane goes on as a plane";

  SeafloorOptions wide;
  wide.maxGap = 80.0;
  EXPECT_EQ(readSeafloor(this->Files.file("a.tif"), wide).report.noDataShare, 0.0);
  wide.maxGap = 79.0;
  EXPECT_GT(readSeafloor(this->Files.file("a.tif"), wide).report.noDataShare, 0.0);
}

TEST_F(SeafloorReaderTest, HolesSurviveResampling)
{
  RasterFile file;
  file.crs = "EPSG:4326";
  file.transform = { -74.0, 0.001, 0.0, 40.03, 0.0, -0.001 };
  const Bed bed = waves(0.02, -74.0, 40.0);
  file.fill(bed);
  for (int row = 0; row < 12; ++row)
  {
    for (int column = 28; column < 40; ++column)
    {
      file.at(column, row) = Missing;
    }
  }
  file.writeGeoTiff(this->Files.file("a.tif"));
  const Bathymetry read = readSeafloor(this->Files.file("a.tif"));
  // 12 x 12 of 40 x 30 cells, and the cells that touch them.
  EXPECT_GT(read.report.noDataShare, 0.11);
  EXPECT_LT(read.report.noDataShare, 0.15);
  EXPECT_LT(largestError(read, bed), SplineError);
}

TEST_F(SeafloorReaderTest, CropReadsTheNodesInside)
{
  RasterFile file;
  const Bed bed = waves(120.0);
  file.fill(bed);
  file.writeGeoTiff(this->Files.file("a.tif"));
  SeafloorOptions options;
  options.crop = { 95.0, 44.0, 251.0, 166.0 }; // nodes at 95 ... 245 and 45 ... 165
  const Bathymetry read = readSeafloor(this->Files.file("a.tif"), options);
  EXPECT_EQ(read.grid.columns, 16u);
  EXPECT_EQ(read.grid.rows, 13u);
  EXPECT_DOUBLE_EQ(read.georeference.originX(), 95.0);
  EXPECT_DOUBLE_EQ(read.georeference.originY(), 45.0);
  EXPECT_LT(largestError(read, bed), Exact);

  options.crop = { 1000.0, 1000.0, 2000.0, 2000.0 };
  EXPECT_THAT(errorOf(this->Files.file("a.tif"), options), HasSubstr("its extent is 5,5,395,295"));
  options.crop = { 100.0, 0.0, 50.0, 10.0 };
  EXPECT_THROW(readSeafloor(this->Files.file("a.tif"), options), std::invalid_argument);
}

TEST_F(SeafloorReaderTest, ResampleAndSmooth)
{
  RasterFile file;
  file.columns = 120;
  file.rows = 100;
  file.transform = { 0.0, 10.0, 0.0, 1000.0, 0.0, -10.0 };
  const double length = 60.0;
  file.fill([=](const glm::dvec2& p) { return -20.0 + 5.0 * std::sin(p.x / length); });
  file.writeGeoTiff(this->Files.file("a.tif"));
  SeafloorOptions options;
  options.resample = 7.0;
  const Bathymetry fine = readSeafloor(this->Files.file("a.tif"), options);
  EXPECT_EQ(fine.grid.spacing, glm::dvec2(7.0));
  EXPECT_EQ(fine.grid.columns, 171u);
  EXPECT_TRUE(fine.report.resampled);
  // 6 nodes a radian: the spline's (1/6)^4 / 384 of 5 m inside, more at the edges.
  EXPECT_LT(largestError(fine, [=](const glm::dvec2& p) { return -20.0 + 5.0 * std::sin(p.x / length); }), 5e-3);

  options.resample.reset();
  options.smooth = 30.0;
  const Bathymetry smooth = readSeafloor(this->Files.file("a.tif"), options);
  // A Gaussian lowers a sine of wavenumber k by exp(-(k sigma)^2/2); cut off at 4 sigma: 6e-5 of it.
  const double lowered = std::exp(-0.5 * (30.0 / length) * (30.0 / length));
  const std::size_t row = 50;
  for (std::size_t column = 12; column < 108; ++column)
  {
    const double x = smooth.georeference.toFile(smooth.grid.node(column, row)).x;
    ASSERT_NEAR(smooth.grid.at(column, row), -20.0 + 5.0 * lowered * std::sin(x / length), 2e-3);
  }

  options.resample = 500.0;
  EXPECT_THAT(errorOf(this->Files.file("a.tif"), options), HasSubstr("fewer than 4 x 4 nodes"));
  options.resample = 1e-3;
  EXPECT_THAT(errorOf(this->Files.file("a.tif"), options), HasSubstr("100 million"));
  options.resample = -1.0;
  EXPECT_THROW(readSeafloor(this->Files.file("a.tif"), options), std::invalid_argument);
}
