#include "bathymetry/SeafloorReader.h"

#include "SeafloorChecks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace swellray;
using namespace swellray::test;
using testing::HasSubstr;

using SeafloorMeaningTest = SeafloorFileTest;

TEST_F(SeafloorMeaningTest, NetcdfSignFollowsItsMetadataNeverTheName)
{
  NetcdfFile file;
  file.x = steps(0.0, 100.0, 20);
  file.y = steps(0.0, 100.0, 20);
  file.xName = "x";
  file.yName = "y";
  file.xUnits = file.yUnits = "m";
  const Bed elevation = waves(1300.0);
  const std::string path = this->Files.file("a.nc");
  const auto readWith = [&](const std::map<std::string, std::string>& attributes, double sign)
  {
    std::filesystem::remove(path);
    file.attributes = attributes;
    file.bed = [=](const glm::dvec2& p) { return sign * elevation(p); };
    file.variables = { "depth" };
    file.write(path);
  };
  readWith({ { "positive", "down" } }, -1.0);
  EXPECT_LT(largestError(readSeafloor(path), elevation), Exact);
  EXPECT_EQ(readSeafloor(path).report.signSource, "positive attribute");

  readWith({ { "standard_name", "sea_floor_depth_below_geoid" } }, -1.0);
  EXPECT_LT(largestError(readSeafloor(path), elevation), Exact);

  readWith({}, 1.0); // called depth, holds elevations
  EXPECT_LT(largestError(readSeafloor(path), elevation), Exact);

  readWith({}, -1.0);
  EXPECT_THAT(errorOf(path), HasSubstr("--positive down"));
  SeafloorOptions down;
  down.positive = Positive::Down;
  EXPECT_LT(largestError(readSeafloor(path, down), elevation), Exact);

  readWith({ { "positive", "up" }, { "standard_name", "sea_floor_depth_below_geoid" } }, -1.0);
  EXPECT_THAT(errorOf(path), HasSubstr("contradict"));
  EXPECT_LT(largestError(readSeafloor(path, down), elevation), Exact);
}

TEST_F(SeafloorMeaningTest, SeveralVariablesAreChosenFrom)
{
  NetcdfFile file;
  file.x = steps(0.0, 100.0, 20);
  file.y = steps(0.0, 100.0, 20);
  file.xUnits = file.yUnits = "m";
  file.xName = "x";
  file.yName = "y";
  file.bed = waves(1300.0);
  file.variables = { "first", "second" };
  const std::string path = this->Files.file("a.nc");
  file.write(path);
  EXPECT_THAT(errorOf(path), HasSubstr("--variable: first, second"));
  SeafloorOptions options;
  options.variable = "second";
  EXPECT_EQ(readSeafloor(path, options).report.variable, "second");
  options.variable = "third";
  EXPECT_THAT(errorOf(path, options), HasSubstr("no variable 'third'"));

  RasterFile bands;
  bands.bands = 2;
  bands.fill(waves(120.0));
  bands.writeGeoTiff(this->Files.file("b.tif"));
  EXPECT_THAT(errorOf(this->Files.file("b.tif")), HasSubstr("several bands"));
  options.variable = "2";
  EXPECT_EQ(readSeafloor(this->Files.file("b.tif"), options).report.variable, "band 2");
}

TEST_F(SeafloorMeaningTest, UnitsScaleAndOffsetAreApplied)
{
  RasterFile file;
  const Bed bed = waves(120.0);
  file.fill([&](const glm::dvec2& p) { return (bed(p) / 0.3048 - 7.0) / 0.5; });
  file.units = "feet";
  file.scale = 0.5;
  file.offset = 7.0;
  file.writeGeoTiff(this->Files.file("a.tif"));
  const Bathymetry read = readSeafloor(this->Files.file("a.tif"));
  EXPECT_LT(largestError(read, bed), Exact);
  EXPECT_EQ(read.report.units, "feet (0.3048 m)");

  file.units = "furlongs";
  file.writeGeoTiff(this->Files.file("b.tif"));
  EXPECT_THAT(notesOf(readSeafloor(this->Files.file("b.tif"))), HasSubstr("unit 'furlongs'"));
}

TEST_F(SeafloorMeaningTest, FurtherMarkForNoData)
{
  RasterFile file;
  file.fill(waves(120.0));
  file.at(7, 7) = -9999.0;
  file.writeGeoTiff(this->Files.file("a.tif"));
  EXPECT_THAT(notesOf(readSeafloor(this->Files.file("a.tif"))), HasSubstr("--nodata -9999"));
  SeafloorOptions options;
  options.nodata = -9999.0;
  EXPECT_EQ(readSeafloor(this->Files.file("a.tif"), options).report.filled, 1u);

  file.at(7, 7) = -32768.0;
  file.writeGeoTiff(this->Files.file("b.tif"));
  EXPECT_THAT(errorOf(this->Files.file("b.tif")), HasSubstr("say --nodata -32768"));
}

TEST_F(SeafloorMeaningTest, ScenesThatCannotBeWorkedWith)
{
  RasterFile land;
  land.fill([](const glm::dvec2&) { return 12.0; });
  land.writeGeoTiff(this->Files.file("land.tif"));
  EXPECT_THAT(errorOf(this->Files.file("land.tif")), HasSubstr("--positive down"));
  SeafloorOptions flood;
  flood.waterLevel = 13.0;
  EXPECT_EQ(errorOf(this->Files.file("land.tif"), flood), "no error");

  land.nodata = 12.0;
  land.writeGeoTiff(this->Files.file("empty.tif"));
  EXPECT_THAT(errorOf(this->Files.file("empty.tif")), HasSubstr("every cell that was read is marked as missing"));

  RasterFile row;
  row.rows = 1;
  row.fill(waves(120.0));
  row.writeGeoTiff(this->Files.file("row.tif"));
  EXPECT_THAT(errorOf(this->Files.file("row.tif")), HasSubstr("40 x 1 cells"));

  RasterFile point;
  point.transform = { 0.0, 0.0, 0.0, 10.0, 0.0, -10.0 };
  point.fill(waves(120.0));
  point.writeAscii(this->Files.file("point.asc"));
  EXPECT_THAT(errorOf(this->Files.file("point.asc")), HasSubstr("no size"));
  NetcdfFile line;
  line.x = steps(7.0, 0.0, 6);
  line.y = steps(0.0, 1.0, 6);
  line.bed = waves(12.0);
  line.write(this->Files.file("line.nc"));
  EXPECT_THAT(errorOf(this->Files.file("line.nc")), HasSubstr("spacing 0"));

  RasterFile far;
  far.crs = "EPSG:4326";
  far.fill(waves(120.0));
  far.writeGeoTiff(this->Files.file("far.tif"));
  EXPECT_THAT(errorOf(this->Files.file("far.tif")), HasSubstr("no longitude and latitude"));

  RasterFile world;
  world.crs = "EPSG:4326";
  world.transform = { -180.0, 9.0, 0.0, 90.0, 0.0, -6.0 };
  world.fill(waves(40.0));
  world.writeGeoTiff(this->Files.file("world.tif"));
  EXPECT_THAT(errorOf(this->Files.file("world.tif")), HasSubstr("use --crop"));

  NetcdfFile uneven;
  uneven.x = { 0.0, 1.0, 2.0, 3.0, 4.5, 6.0 };
  uneven.y = steps(0.0, 1.0, 6);
  uneven.bed = waves(12.0);
  uneven.write(this->Files.file("uneven.nc"));
  EXPECT_THAT(errorOf(this->Files.file("uneven.nc")), HasSubstr("not evenly spaced"));
}

TEST_F(SeafloorMeaningTest, FilesThatCannotBeReadSayWhyInOneLine)
{
  testing::internal::CaptureStderr();
  const std::string missing = errorOf(this->Files.file("missing.tif"));
  EXPECT_THAT(missing, HasSubstr("no such file"));
  EXPECT_THAT(missing, HasSubstr("missing.tif"));
  EXPECT_THAT(errorOf(this->Files.file("")), HasSubstr("folder"));

  std::ofstream(this->Files.file("text.tif")) << "these are words\nnot a raster\n";
  EXPECT_THAT(errorOf(this->Files.file("text.tif")), HasSubstr("not a raster"));
  std::ofstream(this->Files.file("text.nc")) << "these are words\nnot a raster\n";
  EXPECT_THAT(errorOf(this->Files.file("text.nc")), HasSubstr("not a raster"));

  RasterFile file;
  file.fill(waves(120.0));
  file.writeGeoTiff(this->Files.file("whole.tif"));
  file.nodata = -9999.0;
  file.writeAscii(this->Files.file("whole.asc"));
  NetcdfFile grid;
  grid.x = steps(0.0, 1.0, 200);
  grid.y = steps(0.0, 1.0, 200);
  grid.bed = waves(12.0);
  grid.write(this->Files.file("whole.nc"));
  for (const char* name : { "whole.tif", "whole.asc", "whole.nc" })
  {
    const std::string path = this->Files.file(name);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    const std::string said = errorOf(path);
    EXPECT_THAT(said, HasSubstr("read")) << name;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    EXPECT_THAT(said, testing::StartsWith("seafloor '" + path + "': "));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "GDAL printed by itself";
}

TEST_F(SeafloorMeaningTest, ReportIsCompleteAndOneLineEach)
{
  RasterFile file;
  file.crs = "EPSG:32618";
  file.fill([](const glm::dvec2& p) { return p.x - 100.0; });
  file.writeGeoTiff(this->Files.file("a.tif"));
  const Bathymetry read = readSeafloor(this->Files.file("a.tif"));
  std::string all;
  for (const auto& [label, words] : read.report.lines())
  {
    EXPECT_EQ(words.find('\n'), std::string::npos) << label;
    all += label + ": " + words + "\n";
  }
  EXPECT_THAT(all, HasSubstr("CRS: WGS 84 / UTM zone 18N, projected (file)"));
  EXPECT_THAT(all, HasSubstr("Elevation: -95 to 295 m"));
  EXPECT_THAT(all, HasSubstr("Depth: 0 to 95 m"));
  EXPECT_THAT(all, HasSubstr("Water: 25 %"));
  EXPECT_THAT(all, HasSubstr("Land: 75 %"));
  EXPECT_THAT(all, HasSubstr("Values: metres (assumed), elevation, positive up (assumed)"));
}

TEST_F(SeafloorMeaningTest, ProgressCancels)
{
  RasterFile file;
  file.fill(waves(120.0));
  file.writeGeoTiff(this->Files.file("a.tif"));
  Execution execution;
  execution.progress = [](double share) { return share < 0.4; };
  EXPECT_THROW(readSeafloor(this->Files.file("a.tif"), {}, execution), std::runtime_error);
}
