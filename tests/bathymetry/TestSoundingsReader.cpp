#include "SeafloorChecks.h"

#include "bathymetry/SoundingsReader.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <fstream>
#include <memory>
#include <random>

using namespace swellray;
using namespace swellray::test;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

// A survey to be written as NetCDF: variables along one dimension.
struct SurveyFile
{
  struct Variable
  {
    std::string name;
    std::vector<double> values;
    std::map<std::string, std::string> attributes;
  };
  std::vector<Variable> variables;
  std::map<std::string, std::string> attributes;
  double fill = -999.0;

  void write(const std::string& path) const
  {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
    const std::unique_ptr<GDALDataset> dataset(driver->CreateMultiDimensional(path.c_str(), nullptr, nullptr));
    const auto root = dataset->GetRootGroup();
    const auto text = GDALExtendedDataType::CreateString();
    for (const auto& [name, value] : this->attributes)
    {
      root->CreateAttribute(name, {}, text)->Write(value.c_str());
    }
    const std::size_t count = this->variables.front().values.size();
    const auto dimension = root->CreateDimension("time", "", "", count);
    for (const Variable& variable : this->variables)
    {
      const auto array = root->CreateMDArray(variable.name, { dimension }, GDALExtendedDataType::Create(GDT_Float64));
      array->SetNoDataValue(this->fill);
      for (const auto& [name, value] : variable.attributes)
      {
        if (name == "units")
        {
          array->SetUnit(value);
          continue;
        }
        array->CreateAttribute(name, {}, text)->Write(value.c_str());
      }
      const GUInt64 start = 0;
      array->Write(&start, &count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), variable.values.data());
    }
  }
};

class SoundingsReaderTest : public SeafloorFileTest
{
};

SurveyFile survey()
{
  SurveyFile file;
  file.variables = {
    { "time", { 0.0, 1.0, 2.0, 3.0 }, { { "units", "seconds since 1970-01-01" } } },
    { "lat", { 36.1, 36.2, 36.3, 36.1 }, { { "units", "degrees_north" } } },
    { "lon", { -75.1, -75.2, -75.3, -75.3 }, { { "units", "degrees_east" } } },
    { "easting", { 1.0, 2.0, 3.0, 4.0 }, { { "units", "m" } } },
    { "northing", { 1.0, 2.0, 3.0, 4.0 }, { { "units", "m" } } },
    { "elevation", { -5.0, -6.0, -999.0, 1.0 }, { { "units", "m" } } },
    { "Ellipsoid", { -41.0, -42.0, -43.0, -44.0 }, {} },
  };
  file.attributes = { { "geospatial_vertical_positive", "up" } };
  return file;
}

TEST_F(SoundingsReaderTest, NetcdfSurveyWithItsMetadata)
{
  const std::string path = this->Files.file("survey.nc");
  survey().write(path);
  const std::optional<Soundings> soundings = readSoundings(path, {});
  ASSERT_TRUE(soundings);
  EXPECT_THAT(soundings->x, ElementsAre(-75.1, -75.2, -75.3, -75.3));
  EXPECT_THAT(soundings->y, ElementsAre(36.1, 36.2, 36.3, 36.1));
  EXPECT_EQ(soundings->z[1], -6.0);
  EXPECT_TRUE(std::isnan(soundings->z[2]));
  EXPECT_EQ(soundings->variable, "elevation");
  EXPECT_EQ(soundings->crs, "EPSG:4326");
  EXPECT_EQ(soundings->vertical.units, "m");
  EXPECT_EQ(soundings->vertical.rule, "up");

  EXPECT_EQ(readSoundings(path, "Ellipsoid")->z[0], -41.0);
  EXPECT_THROW(readSoundings(path, "depth"), std::runtime_error);
}

TEST_F(SoundingsReaderTest, NetcdfSurveyOfAPlane)
{
  SurveyFile file = survey();
  file.variables.erase(file.variables.begin(), file.variables.begin() + 3);
  file.variables.pop_back();
  file.variables[0].attributes["units"] = "km";
  file.variables[1].attributes["units"] = "km";
  file.variables[2].name = "stuff";
  file.attributes.clear();
  const std::string path = this->Files.file("survey.nc");
  file.write(path);
  const std::optional<Soundings> soundings = readSoundings(path, {});
  ASSERT_TRUE(soundings);
  EXPECT_THAT(soundings->x, ElementsAre(1000.0, 2000.0, 3000.0, 4000.0));
  EXPECT_EQ(soundings->crs, "");
  EXPECT_EQ(soundings->variable, "stuff");
  EXPECT_THAT(soundings->notes[0], HasSubstr("from km to metres"));

  file.variables.push_back({ "other", { 1.0, 2.0, 3.0, 4.0 }, {} });
  file.write(path);
  EXPECT_THROW(readSoundings(path, {}), std::runtime_error);
  file.variables.back().attributes["standard_name"] = "altitude";
  file.write(path);
  EXPECT_EQ(readSoundings(path, {})->variable, "other");
}

TEST_F(SoundingsReaderTest, GridsAreNone)
{
  NetcdfFile grid;
  grid.x = steps(0.0, 0.01, 20);
  grid.y = steps(50.0, 0.01, 10);
  grid.bed = [](const glm::dvec2& p) { return -10.0 - p.x; };
  grid.write(this->Files.file("grid.nc"));
  EXPECT_FALSE(readSoundings(this->Files.file("grid.nc"), {}));
  EXPECT_FALSE(readSoundings(this->Files.file("none.xyz"), {}));
  EXPECT_FALSE(readSoundings(this->Files.file(""), {}));
  // What GDAL reads as a regular grid of x, y and z keeps its nodes.
  std::ofstream regular(this->Files.file("regular.xyz"));
  for (int row = 0; row < 5; ++row)
  {
    for (int column = 0; column < 6; ++column)
    {
      regular << 10 * column << " " << 10 * row << " " << -10 - column << "\n";
    }
  }
  regular.close();
  EXPECT_FALSE(readSoundings(this->Files.file("regular.xyz"), {}));
  const Bathymetry read = readSeafloor(this->Files.file("regular.xyz"));
  EXPECT_EQ(read.grid.columns, 6U);
  EXPECT_FALSE(read.report.soundings);
}

TEST_F(SoundingsReaderTest, AreReadAsASeafloor)
{
  // Feet of depth on a plane, in longitude and latitude.
  const auto bed = [](const glm::dvec2& p) { return -20.0 - 500.0 * (p.x - 115.5) + 300.0 * (p.y + 32.5); };
  std::mt19937 chance;
  const auto draw = [&chance] { return static_cast<double>(chance()) / 4294967296.0; };
  std::ofstream file(this->Files.file("depths.csv"));
  file.precision(17);
  file << "lon,lat,depth (ft)\n";
  for (int i = 0; i < 3000; ++i)
  {
    const double x = 115.5 + 0.02 * draw();
    const glm::dvec2 p(x, -32.5 + 0.02 * draw());
    file << p.x << "," << p.y << "," << -bed(p) / 0.3048 << "\n";
  }
  file.close();

  EXPECT_THAT(errorOf(this->Files.file("depths.csv")), HasSubstr("--positive down"));
  SeafloorOptions options;
  options.positive = Positive::Down;
  const Bathymetry read = readSeafloor(this->Files.file("depths.csv"), options);
  ASSERT_TRUE(read.report.soundings);
  EXPECT_EQ(read.report.soundings->count, 3000U);
  EXPECT_EQ(read.report.kind, GeoreferenceKind::Geographic);
  EXPECT_EQ(read.report.units, "ft (0.3048 m)");
  // 1.9 x 2.2 km over 3000: 37 m.
  EXPECT_NEAR(read.grid.spacing.x, 37.0, 1.5);
  EXPECT_LT(read.report.noDataShare, 0.1);
  // The plane in degrees is one in metres but for the map's scale and convergence over 2 km.
  constexpr double MapError = 2e-3;
  EXPECT_LT(largestError(read, bed), MapError);
  std::string all;
  for (const auto& [label, words] : read.report.lines())
  {
    all += label + ": " + words + "\n";
  }
  EXPECT_THAT(all, HasSubstr("Soundings: 3000 with a value"));
  EXPECT_THAT(all, HasSubstr("about the distance of the soundings"));
}

}
