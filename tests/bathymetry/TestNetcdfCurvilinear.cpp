#include "SeafloorChecks.h"
#include "TextFiles.h"

#include "bathymetry/NetcdfCurvilinear.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <memory>

using namespace swellray;
using namespace swellray::test;
using testing::HasSubstr;

namespace
{

using Place = std::function<glm::dvec2(int i, int j)>;

/** A file whose variables lie on rows j of nodes i, each at a place of its own. */
struct CurvilinearFile
{
  int columns = 24;
  int rows = 16;
  Place place;
  std::string xName = "lon_rho";
  std::string yName = "lat_rho";
  std::string xUnits = "degrees_east";
  std::string yUnits = "degrees_north";
  bool named = true;        ///< the values have an attribute coordinates
  bool counted = false;     ///< dimensions have variables of their own, 0, 1, 2, ...
  bool alsoRegular = false; ///< and these are coordinates x and y of a plane, evenly spaced
  bool turned = false;      ///< the coordinates' dimensions are in the other order than the values'
  bool oneTime = false;     ///< a first dimension of one time
  bool packed = false;
  std::vector<std::string> variables{ "h" };
  std::map<std::string, std::string> attributes{ { "standard_name", "sea_floor_depth_below_geoid" } };
  Bed bed;               ///< of the places, elevation
  glm::ivec2 none{ -1 }; ///< a node without a place

  void write(const std::string& path) const
  {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
    const std::unique_ptr<GDALDataset> dataset(driver->CreateMultiDimensional(path.c_str(), nullptr, nullptr));
    const auto root = dataset->GetRootGroup();
    const auto words = GDALExtendedDataType::CreateString();
    const auto real = GDALExtendedDataType::Create(GDT_Float64);
    const auto time = this->oneTime ? root->CreateDimension("time", "", "", 1) : nullptr;
    const auto eta = root->CreateDimension("eta", "", "", static_cast<GUInt64>(this->rows));
    const auto xi = root->CreateDimension("xi", "", "", static_cast<GUInt64>(this->columns));
    if (this->counted || this->alsoRegular)
    {
      for (const auto& dimension : { eta, xi })
      {
        const auto array = root->CreateMDArray(dimension->GetName(), { dimension }, real);
        const std::vector<double> count =
          steps(0.0, this->alsoRegular ? 50.0 : 1.0, static_cast<int>(dimension->GetSize()));
        const GUInt64 start = 0;
        const std::size_t size = count.size();
        array->Write(&start, &size, nullptr, nullptr, real, count.data());
        if (this->alsoRegular)
        {
          array->SetUnit("m");
          array->CreateAttribute("axis", {}, words)->Write(dimension == eta ? "Y" : "X");
        }
      }
    }
    const auto put = [&](const std::string& name, bool other, bool small, const std::function<double(int, int)>& value)
    {
      std::vector<std::shared_ptr<GDALDimension>> dimensions = other ? std::vector{ xi, eta } : std::vector{ eta, xi };
      const bool timed = this->oneTime && small;
      if (timed)
      {
        dimensions.insert(dimensions.begin(), time);
      }
      const auto array = root->CreateMDArray(
        name, dimensions, GDALExtendedDataType::Create(small && this->packed ? GDT_Int16 : GDT_Float64));
      array->SetNoDataValue(-32000.0);
      const bool pack = small && this->packed;
      if (pack)
      {
        array->SetScale(0.01);
        array->SetOffset(10.0);
      }
      std::vector<double> values;
      for (int outer = 0; outer < (other ? this->columns : this->rows); ++outer)
      {
        for (int inner = 0; inner < (other ? this->rows : this->columns); ++inner)
        {
          const double v = other ? value(outer, inner) : value(inner, outer);
          values.push_back(std::isnan(v) ? -32000.0 : pack ? (v - 10.0) / 0.01 : v);
        }
      }
      const GUInt64 start[] = { 0, 0, 0 };
      std::vector<std::size_t> count;
      for (const auto& dimension : dimensions)
      {
        count.push_back(dimension->GetSize());
      }
      array->Write(start, count.data(), nullptr, nullptr, real, values.data());
      return array;
    };
    const auto isNone = [this](int i, int j) { return this->none == glm::ivec2(i, j); };
    const auto x =
      put(this->xName, this->turned, false, [&](int i, int j) { return isNone(i, j) ? Missing : this->place(i, j).x; });
    const auto y =
      put(this->yName, this->turned, false, [&](int i, int j) { return isNone(i, j) ? Missing : this->place(i, j).y; });
    x->SetUnit(this->xUnits);
    y->SetUnit(this->yUnits);
    for (const std::string& name : this->variables)
    {
      const auto h = put(name, false, true, [&](int i, int j) { return -this->bed(this->place(i, j)); });
      h->SetUnit("m");
      for (const auto& [key, value] : this->attributes)
      {
        h->CreateAttribute(key, {}, words)->Write(value.c_str());
      }
      if (this->named)
      {
        h->CreateAttribute("coordinates", {}, words)->Write((this->xName + " " + this->yName).c_str());
      }
    }
  }
};

// Rows bend and drift apart; steps of about 100 m and 80 m, rows to the east and columns to the north, turned by half.
glm::dvec2 bent(int i, int j)
{
  const double x = 100.0 * i + 0.6 * i * j;
  const double y = 80.0 * j + 1.5 * i * i / 10.0;
  return { 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y };
}

glm::dvec2 bentInDegrees(int i, int j)
{
  return glm::dvec2(4.0, 52.0) + bent(i, j) * glm::dvec2(1.5e-5, 9e-6);
}

// Natural neighbours keep planes.
double plane(const glm::dvec2& p)
{
  return -30.0 + 0.004 * p.x - 0.003 * p.y;
}

double planeInDegrees(const glm::dvec2& p)
{
  return -30.0 + 200.0 * (p.x - 4.0) - 100.0 * (p.y - 52.0);
}

CurvilinearFile inMetres()
{
  CurvilinearFile file;
  file.xName = "globalx";
  file.yName = "globaly";
  file.xUnits = file.yUnits = "m";
  file.place = bent;
  file.bed = plane;
  return file;
}

CurvilinearFile inDegrees()
{
  CurvilinearFile file;
  file.place = bentInDegrees;
  file.bed = planeInDegrees;
  return file;
}

class CurvilinearFileTest : public SeafloorFileTest
{
protected:
  std::string write(const CurvilinearFile& file)
  {
    const std::string path = this->Files.file("a.nc");
    std::filesystem::remove(path);
    file.write(path);
    return path;
  }
};

}

TEST_F(CurvilinearFileTest, NodesLieWhereTheirCoordinatesSay)
{
  const CurvilinearFile file = inMetres();
  const Bathymetry read = readSeafloor(write(file));
  EXPECT_EQ(read.report.driver, "netCDF, curvilinear");
  EXPECT_EQ(read.report.variable, "h");
  EXPECT_EQ(read.report.signSource, "standard name sea_floor_depth_below_geoid");
  ASSERT_TRUE(read.report.soundings);
  EXPECT_EQ(read.report.soundings->count, 24u * 16u);
  EXPECT_EQ(read.report.soundings->cells, 23u * 15u);
  EXPECT_NEAR(read.report.soundings->spacing, 80.0, 8.0);
  EXPECT_LT(largestError(read, file.bed), Rounding);
  // What no cell covers is a hole: the corners of the box around a grid that is turned.
  EXPECT_TRUE(std::isnan(read.grid.at(0, 0)));
  EXPECT_NEAR(read.report.noDataShare, 0.5, 0.1);
}

TEST_F(CurvilinearFileTest, LongitudesAndLatitudesInAnyOrder)
{
  // Natural neighbours work in metres, where the plane in degrees bends by the convergence of the meridians: over 3 km
  // the relative change of a degree is 3 km tan(52)/R = 6e-4 of the 10 m that the plane spans.
  constexpr double convergence = 6e-3;
  for (const bool named : { true, false })
  {
    for (const bool turned : { true, false })
    {
      CurvilinearFile file = inDegrees();
      file.named = named;
      file.turned = turned;
      file.oneTime = turned;
      file.counted = named;
      const Bathymetry read = readSeafloor(write(file));
      EXPECT_EQ(read.georeference.kind(), GeoreferenceKind::Geographic);
      EXPECT_EQ(read.report.crsSource, "coordinates in degrees");
      EXPECT_LT(largestError(read, file.bed), convergence) << named << turned;
    }
  }
  // The other hand, and packed values: 0.01 m.
  CurvilinearFile file = inDegrees();
  file.place = [](int i, int j) { return bentInDegrees(i, 15 - j); };
  file.packed = true;
  EXPECT_LT(largestError(readSeafloor(write(file)), file.bed), convergence + 0.01);
}

TEST_F(CurvilinearFileTest, WhatIsRegularAfterAllIsARaster)
{
  CurvilinearFile file = inMetres();
  file.place = [](int i, int j) { return glm::dvec2(1000.0 + 50.0 * i, 2000.0 + 40.0 * j); };
  const Bathymetry read = readSeafloor(write(file));
  EXPECT_FALSE(read.report.soundings);
  EXPECT_EQ(read.grid.columns, 24u);
  EXPECT_EQ(read.grid.spacing, glm::dvec2(50.0, 40.0));
  EXPECT_LT(largestError(read, file.bed), Exact);
  // Coordinates of a plane along the dimensions go before longitudes and latitudes of its nodes.
  CurvilinearFile both = inDegrees();
  both.alsoRegular = true;
  const std::string path = write(both);
  EXPECT_FALSE(readNetcdfCurvilinear(path, "h"));
  EXPECT_EQ(readSeafloor(path,
              []
              {
                SeafloorOptions o;
                o.variable = "h";
                return o;
              }())
              .grid.spacing,
    glm::dvec2(50.0));
}

TEST_F(CurvilinearFileTest, PlacesThatAreMissingAndLongitudesThatJump)
{
  CurvilinearFile file = inMetres();
  file.none = { 10, 7 };
  const Bathymetry holed = readSeafloor(write(file));
  EXPECT_EQ(holed.report.soundings->cells, 23u * 15u - 4u);
  EXPECT_LT(largestError(holed, file.bed), Rounding);
  EXPECT_TRUE(std::isnan(
    holed.grid.at(static_cast<std::size_t>((bent(10, 7).x - holed.georeference.originX()) / holed.grid.spacing.x + 0.5),
      static_cast<std::size_t>((bent(10, 7).y - holed.georeference.originY()) / holed.grid.spacing.y + 0.5))));

  CurvilinearFile far = inDegrees();
  far.place = [](int i, int j)
  {
    const glm::dvec2 p = bentInDegrees(i, j) + glm::dvec2(175.99, -52.0);
    return glm::dvec2(p.x > 180.0 ? p.x - 360.0 : p.x, p.y);
  };
  far.bed = [](const glm::dvec2& p) { return -30.0 + 200.0 * std::remainder(p.x - 180.0, 360.0); };
  const Bathymetry read = readSeafloor(write(far));
  EXPECT_LT(read.grid.bounds().size().x, 5000.0) << "one patch, not the whole way round";
  EXPECT_LT(largestError(read, far.bed), 6e-3);
}

TEST_F(CurvilinearFileTest, WhatCannotBeReadSaysWhy)
{
  CurvilinearFile several = inMetres();
  several.variables = { "h", "hraw" };
  const std::string path = write(several);
  EXPECT_THAT(
    errorOf(path), HasSubstr("several variables on its curvilinear grid; choose one with --variable: h, hraw"));
  SeafloorOptions options;
  options.variable = "h";
  EXPECT_EQ(errorOf(path, options), "no error");
  options.variable = "mask";
  EXPECT_THAT(errorOf(path, options), HasSubstr("no variable 'mask' on its curvilinear grid; there are: h, hraw"));
  CurvilinearFile placeless = inMetres();
  placeless.xName = "first";
  placeless.yName = "second";
  EXPECT_FALSE(readNetcdfCurvilinear(write(placeless), ""));
  EXPECT_THAT(errorOf(this->Files.file("a.nc")), HasSubstr("no variable on a regular grid"));
  CurvilinearFile nowhere = inMetres();
  nowhere.place = [](int, int) { return glm::dvec2(3.0, 4.0); };
  EXPECT_THAT(errorOf(write(nowhere)), HasSubstr("its cells have no size"));
  writeText(this->Files.file("text.nc"), "no NetCDF");
  EXPECT_FALSE(readNetcdfCurvilinear(this->Files.file("text.nc"), ""));
}
