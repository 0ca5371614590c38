#include "bathymetry/MapWriter.h"

#include "bathymetry/QuietGdal.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>

namespace
{

using namespace swellray;

// 32-bit floating point of numbers up to some hundreds.
constexpr double FloatRounding = 1e-4;

// A place on Earth by two ways of computing the projection, degrees: a tenth of a millimetre.
constexpr double PlaceTolerance = 1e-9;

class MapFile : public testing::Test
{
protected:
  MapFile()
  {
    std::string name = (std::filesystem::temp_directory_path() / "swellray-map-XXXXXX").string();
    this->Folder = mkdtemp(name.data());
    for (int i = 0; i < 12; ++i)
    {
      this->Heights.push_back(i + 0.25);
      this->Counts.push_back(i);
      this->Flags.push_back(static_cast<std::uint8_t>(i % 2));
    }
    this->Heights[5] = std::numeric_limits<double>::quiet_NaN();
    this->Map.columns = 4;
    this->Map.rows = 3;
    this->Map.origin = { 10.0, 20.0 };
    this->Map.spacing = { 5.0, 2.0 };
    this->Map.source = "Swellray";
    this->Map.history = "swellray trace";
    MapVariable height{ "WaveHeight", "height of the wave", "m", "", "", this->Heights.data() };
    MapVariable count{ "RayCount", "sheets", "1", "", "" };
    count.integers = this->Counts.data();
    MapVariable flag{ "Breaking", "breaking", "1", "", "not_breaking breaking" };
    flag.bytes = this->Flags.data();
    MapVariable direction = height;
    direction.name = "DirectionFrom";
    direction.standardName = "sea_surface_wave_from_direction";
    this->Map.variables = { height, count, flag, direction };
  }

  ~MapFile() override
  {
    std::error_code none;
    std::filesystem::remove_all(this->Folder, none);
  }

  std::string file(const std::string& name) const { return (this->Folder / name).string(); }

  std::filesystem::path Folder;
  std::vector<double> Heights;
  std::vector<std::int32_t> Counts;
  std::vector<std::uint8_t> Flags;
  MapImage Map;
};

std::unique_ptr<GDALDataset> openRaster(const std::string& name)
{
  const QuietGdal quiet;
  return std::unique_ptr<GDALDataset>(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER));
}

// Value at a column and a row counted from the south.
double valueAt(GDALRasterBand* band, int column, int rowFromSouth)
{
  double value = -1.0;
  const int row = band->GetYSize() - 1 - rowFromSouth;
  EXPECT_EQ(band->RasterIO(GF_Read, column, row, 1, 1, &value, 1, 1, GDT_Float64, 0, 0, nullptr), CE_None);
  return value;
}

void expectHeights(GDALRasterBand* band)
{
  for (int i = 0; i < 12; ++i)
  {
    const double value = valueAt(band, i % 4, i / 4);
    if (i == 5)
    {
      EXPECT_TRUE(std::isnan(value));
    }
    else
    {
      EXPECT_NEAR(value, i + 0.25, FloatRounding);
    }
  }
}

// Longitude and latitude of the south-west node by what the file says of itself.
glm::dvec2 southWest(GDALDataset& raster)
{
  double transform[6];
  EXPECT_EQ(raster.GetGeoTransform(transform), CE_None);
  double x = transform[0] + 0.5 * transform[1];
  double y = transform[3] + (raster.GetRasterYSize() - 0.5) * transform[5];
  OGRSpatialReference wgs84;
  wgs84.SetWellKnownGeogCS("WGS84");
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const OGRSpatialReference* crs = raster.GetSpatialRef();
  EXPECT_TRUE(crs);
  if (crs)
  {
    std::unique_ptr<OGRCoordinateTransformation> way(OGRCreateCoordinateTransformation(crs, &wgs84));
    EXPECT_TRUE(way && way->Transform(1, &x, &y));
  }
  return { x, y };
}

TEST_F(MapFile, TiffHoldsNamedBandsNorthUp)
{
  writeGeoTiff(this->file("m"), this->Map);
  const auto raster = openRaster(this->file("m"));
  ASSERT_TRUE(raster);
  ASSERT_EQ(raster->GetRasterCount(), 4);
  EXPECT_STREQ(raster->GetRasterBand(1)->GetDescription(), "WaveHeight");
  EXPECT_STREQ(raster->GetRasterBand(1)->GetUnitType(), "m");
  EXPECT_STREQ(raster->GetRasterBand(3)->GetDescription(), "Breaking");
  expectHeights(raster->GetRasterBand(1));
  EXPECT_EQ(valueAt(raster->GetRasterBand(2), 3, 2), 11.0);
  double transform[6];
  ASSERT_EQ(raster->GetGeoTransform(transform), CE_None);
  EXPECT_DOUBLE_EQ(transform[0], 7.5);
  EXPECT_DOUBLE_EQ(transform[1], 5.0);
  EXPECT_DOUBLE_EQ(transform[3], 25.0);
  EXPECT_DOUBLE_EQ(transform[5], -2.0);
  EXPECT_EQ(raster->GetSpatialRef(), nullptr);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(this->Folder), {}), 1) << "side-car files";
}

TEST_F(MapFile, LiesWhereTheSceneLies)
{
  const Georeference geographic("EPSG:4326", { -158.0, 21.0 }, { 0.0, 0.0 });
  const Georeference projected("EPSG:28992", { 0.0, 0.0 }, { 100000.0, 400000.0 });
  const Georeference feet("EPSG:2263", { 0.0, 0.0 }, { 980000.0, 150000.0 });
  for (const Georeference& place : { geographic, projected, feet })
  {
    this->Map.place = place;
    const glm::dvec2 expected = *place.toLonLat(this->Map.origin);
    writeGeoTiff(this->file("m"), this->Map);
    writeNetcdf(this->file("n"), this->Map);
    for (const std::string& name : { this->file("m"), "NETCDF:\"" + this->file("n") + "\":WaveHeight" })
    {
      const auto raster = openRaster(name);
      ASSERT_TRUE(raster) << name;
      const glm::dvec2 found = southWest(*raster);
      EXPECT_NEAR(found.x, expected.x, PlaceTolerance) << place.crsName() << ' ' << name;
      EXPECT_NEAR(found.y, expected.y, PlaceTolerance) << place.crsName() << ' ' << name;
      expectHeights(raster->GetRasterBand(1));
    }
  }
}

TEST_F(MapFile, NetcdfFollowsTheCfConventions)
{
  this->Map.place = Georeference("EPSG:4326", { -158.0, 21.0 }, { 0.0, 0.0 });
  writeNetcdf(this->file("n.nc"), this->Map);
  const QuietGdal quiet;
  const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(this->file("n.nc").c_str(), GDAL_OF_MULTIDIM_RASTER));
  ASSERT_TRUE(dataset);
  const auto root = dataset->GetRootGroup();
  const auto textOf = [](const auto& object, const char* name)
  {
    const auto attribute = object->GetAttribute(name);
    return attribute ? std::string(attribute->ReadAsString()) : std::string();
  };
  EXPECT_EQ(textOf(root, "Conventions"), "CF-1.8");
  EXPECT_EQ(textOf(root, "history"), "swellray trace");
  const auto heights = root->OpenMDArray("WaveHeight");
  ASSERT_TRUE(heights);
  EXPECT_EQ(heights->GetUnit(), "m");
  EXPECT_EQ(textOf(heights, "long_name"), "height of the wave");
  EXPECT_EQ(textOf(heights, "standard_name"), "");
  EXPECT_TRUE(heights->GetSpatialRef());
  const auto direction = root->OpenMDArray("DirectionFrom");
  ASSERT_TRUE(direction);
  EXPECT_EQ(textOf(direction, "standard_name"), "sea_surface_wave_from_direction");
  const auto flags = root->OpenMDArray("Breaking");
  ASSERT_TRUE(flags);
  EXPECT_EQ(textOf(flags, "flag_meanings"), "not_breaking breaking");
  const auto x = root->OpenMDArray("x");
  ASSERT_TRUE(x);
  EXPECT_EQ(textOf(x, "standard_name"), "projection_x_coordinate");
  EXPECT_EQ(x->GetUnit(), "m");
}

TEST_F(MapFile, WithoutACrsClaimsNoProjection)
{
  writeNetcdf(this->file("n.nc"), this->Map);
  const QuietGdal quiet;
  const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(this->file("n.nc").c_str(), GDAL_OF_MULTIDIM_RASTER));
  ASSERT_TRUE(dataset);
  const auto x = dataset->GetRootGroup()->OpenMDArray("x");
  ASSERT_TRUE(x);
  EXPECT_FALSE(x->GetAttribute("standard_name"));
}

TEST_F(MapFile, CannotBeWrittenIntoNoFolder)
{
  const std::string path = this->file("none/m");
  EXPECT_THROW(writeGeoTiff(path, this->Map), std::runtime_error);
  EXPECT_THROW(writeNetcdf(path, this->Map), std::runtime_error);
}

}
