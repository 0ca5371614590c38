#include "SeafloorChecks.h"
#include "TextFiles.h"

#include "bathymetry/UgridMesh.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>

using namespace swellray;
using namespace swellray::test;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

/** A mesh of 8 x 6 squares, each second one cut into triangles, but for one square. */
struct MeshFile
{
  double startIndex = 1.0;
  bool degrees = false;
  bool turned = false;
  std::map<std::string, std::string> topology{ { "cf_role", "mesh_topology" }, { "node_coordinates", "nx ny" },
    { "face_node_connectivity", "faces" } };
  std::vector<std::string> variables{ "z" };
  std::vector<std::string> faceVariables;
  bool faceCoordinates = false; ///< values of faces lie at their first corners
  std::string standardName = "altitude";
  double scale = 10.0;

  static constexpr int Columns = 9;
  static constexpr int Rows = 7;
  static constexpr double None = -999.0;

  glm::dvec2 node(int i) const { return this->scale * glm::dvec2(i % Columns, i / Columns); }

  std::vector<std::array<double, 4>> faces() const
  {
    std::vector<std::array<double, 4>> result;
    for (int row = 0; row + 1 < Rows; ++row)
    {
      for (int column = 0; column + 1 < Columns; ++column)
      {
        const double a = this->startIndex + row * Columns + column;
        const std::array<double, 4> square{ a, a + 1.0, a + Columns + 1.0, a + Columns };
        if (column == 4 && row == 2)
        {
          continue;
        }
        if ((column + row) % 2 == 0)
        {
          result.push_back(square);
        }
        else
        {
          result.push_back({ square[0], square[1], square[2], None });
          result.push_back({ square[0], square[2], square[3], None });
        }
      }
    }
    return result;
  }

  // Values of the faces, and where they lie.
  void writeFaces(GDALGroup& root, const std::shared_ptr<GDALDimension>& cells,
    const std::vector<std::array<double, 4>>& all, const Bed& bed) const;

  void write(const std::string& path, const Bed& bed) const
  {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("netCDF");
    const std::unique_ptr<GDALDataset> dataset(driver->CreateMultiDimensional(path.c_str(), nullptr, nullptr));
    const auto root = dataset->GetRootGroup();
    const auto real = GDALExtendedDataType::Create(GDT_Float64);
    const auto words = GDALExtendedDataType::CreateString();
    const auto all = faces();
    const auto nodes = root->CreateDimension("nodes", "", "", Columns * Rows);
    const auto cells = root->CreateDimension("cells", "", "", all.size());
    const auto corners = root->CreateDimension("corners", "", "", 4);

    const auto mesh = root->CreateMDArray("mesh", {}, GDALExtendedDataType::Create(GDT_Int32));
    for (const auto& [key, value] : this->topology)
    {
      mesh->CreateAttribute(key, {}, words)->Write(value.c_str());
    }
    const int flat = 2;
    mesh->CreateAttribute("topology_dimension", {}, GDALExtendedDataType::Create(GDT_Int32))->Write(flat);

    const auto onNodes = [&](const std::string& name, const std::function<double(const glm::dvec2&)>& value)
    {
      const auto array = root->CreateMDArray(name, { nodes }, real);
      std::vector<double> values;
      for (int i = 0; i < Columns * Rows; ++i)
      {
        values.push_back(value(node(i)));
      }
      const GUInt64 start = 0;
      const size_t count = values.size();
      array->Write(&start, &count, nullptr, nullptr, real, values.data());
      return array;
    };
    onNodes("nx", [](const glm::dvec2& p) { return p.x; })->SetUnit(this->degrees ? "degrees_east" : "m");
    onNodes("ny", [](const glm::dvec2& p) { return p.y; })->SetUnit(this->degrees ? "degrees_north" : "m");
    for (const std::string& name : this->variables)
    {
      const auto array = onNodes(name, bed);
      array->SetUnit("m");
      if (!this->standardName.empty())
      {
        array->CreateAttribute("standard_name", {}, words)->Write(this->standardName.c_str());
      }
    }
    const auto table =
      root->CreateMDArray("faces", this->turned ? std::vector{ corners, cells } : std::vector{ cells, corners },
        GDALExtendedDataType::Create(GDT_Int32));
    table->CreateAttribute("start_index", {}, GDALExtendedDataType::Create(GDT_Int32))
      ->Write(static_cast<int>(this->startIndex));
    std::vector<double> values;
    for (std::size_t i = 0; i < 4 * all.size(); ++i)
    {
      values.push_back(this->turned ? all[i % all.size()][i / all.size()] : all[i / 4][i % 4]);
    }
    writeFaces(*root, cells, all, bed);
    const GUInt64 start[] = { 0, 0 };
    const size_t count[] = { this->turned ? 4 : all.size(), this->turned ? all.size() : 4 };
    table->Write(start, count, nullptr, nullptr, real, values.data());
  }
};

// Middle of a square; of a triangle a third of its corners.
glm::dvec2 middleOf(const MeshFile& mesh, const std::array<double, 4>& face)
{
  glm::dvec2 sum(0.0);
  double count = 0.0;
  for (const double node : face)
  {
    if (node != MeshFile::None)
    {
      sum += mesh.node(static_cast<int>(node - mesh.startIndex));
      count += 1.0;
    }
  }
  return sum / count;
}

void MeshFile::writeFaces(GDALGroup& root, const std::shared_ptr<GDALDimension>& cells,
  const std::vector<std::array<double, 4>>& all, const Bed& bed) const
{
  const auto place = [this](const std::array<double, 4>& face)
  { return this->faceCoordinates ? node(static_cast<int>(face[0] - this->startIndex)) : middleOf(*this, face); };
  const auto put = [&](const std::string& name, const std::function<double(const glm::dvec2&)>& value)
  {
    const auto real = GDALExtendedDataType::Create(GDT_Float64);
    const auto array = root.CreateMDArray(name, { cells }, real);
    std::vector<double> values;
    for (const auto& face : all)
    {
      values.push_back(value(place(face)));
    }
    const GUInt64 start = 0;
    const size_t count = values.size();
    array->Write(&start, &count, nullptr, nullptr, real, values.data());
    return array;
  };
  if (this->faceCoordinates)
  {
    put("fx", [](const glm::dvec2& p) { return p.x; })->SetUnit("m");
    put("fy", [](const glm::dvec2& p) { return p.y; })->SetUnit("m");
  }
  for (const std::string& name : this->faceVariables)
  {
    put(name, bed)->SetUnit("m");
  }
}

class UgridFileTest : public SeafloorFileTest
{
protected:
  std::string write(const MeshFile& mesh, const Bed& bed = waves(100.0))
  {
    const std::string path = this->Files.file("mesh.nc");
    mesh.write(path, bed);
    return path;
  }
};

}

TEST_F(UgridFileTest, NodesAndFacesOfAnyShape)
{
  for (const double startIndex : { 0.0, 1.0 })
  {
    for (const bool turned : { false, true })
    {
      MeshFile mesh;
      mesh.startIndex = startIndex;
      mesh.turned = turned;
      mesh.topology["face_dimension"] = "cells";
      const std::optional<Soundings> read = readUgridMesh(write(mesh), "");
      ASSERT_TRUE(read);
      EXPECT_EQ(read->size(), 63u);
      EXPECT_EQ(read->x[10], 10.0);
      EXPECT_EQ(read->y[10], 10.0);
      EXPECT_EQ(read->cellOffsets.size(), mesh.faces().size() + 1);
      EXPECT_EQ(read->cellOffsets[1], 4u);
      EXPECT_EQ(read->cellOffsets[2], 7u);
      EXPECT_THAT(std::vector<std::uint32_t>(read->cellNodes.begin(), read->cellNodes.begin() + 7),
        ElementsAre(0, 1, 10, 9, 1, 2, 11));
      EXPECT_EQ(*read->spacing, 10.0);
      EXPECT_EQ(read->vertical.standardName, "altitude");
    }
  }
}

TEST_F(UgridFileTest, IsASeafloorWithAHoleWhereItHasNoFace)
{
  const Bed bed = [](const glm::dvec2& p) { return -20.0 + 0.1 * p.x - 0.2 * p.y; };
  SeafloorOptions fine;
  fine.resample = 2.0;
  const Bathymetry read = readSeafloor(write(MeshFile(), bed), fine);
  EXPECT_EQ(read.report.driver, "UGRID mesh");
  EXPECT_EQ(read.report.signSource, "standard name altitude");
  EXPECT_LT(largestError(read, bed), Exact) << "natural neighbours keep planes";
  std::size_t holes = 0;
  for (const double z : read.grid.elevation)
  {
    holes += std::isnan(z) ? 1 : 0;
  }
  EXPECT_EQ(holes, 16u) << "the nodes 2 m apart inside of a square of 10 m";
  EXPECT_TRUE(std::isnan(read.grid.at(22, 12)));
}

TEST_F(UgridFileTest, DegreesMissingValuesAndSign)
{
  MeshFile mesh;
  mesh.degrees = true;
  mesh.scale = 1e-4;
  mesh.standardName = "sea_floor_depth_below_geoid";
  const Bathymetry read = readSeafloor(write(mesh, [](const glm::dvec2&) { return 7.0; }));
  EXPECT_EQ(read.georeference.kind(), GeoreferenceKind::Geographic);
  EXPECT_EQ(read.report.crsSource, "nodes in degrees");
  EXPECT_NEAR(read.grid.at(3, 3), -7.0, Exact);
  EXPECT_NEAR(read.grid.spacing.x, 11.0, 0.2); // 1e-4 degrees, to two digits
}

TEST_F(UgridFileTest, ValuesOfFacesLieInTheirMiddle)
{
  const Bed bed = [](const glm::dvec2& p) { return -20.0 + 0.1 * p.x - 0.2 * p.y; };
  SeafloorOptions fine;
  fine.resample = 2.0;
  MeshFile mesh;
  mesh.variables.clear();
  mesh.faceVariables = { "bed" };
  const std::optional<Soundings> read = readUgridMesh(write(mesh, bed), "");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), mesh.faces().size());
  EXPECT_EQ(read->x[0], 5.0);
  EXPECT_NEAR(read->x[1], 10.0 + 20.0 / 3.0, Exact);
  EXPECT_NEAR(read->y[1], 10.0 / 3.0, Exact);
  EXPECT_EQ(*read->spacing, 10.0);
  const Bathymetry seafloor = readSeafloor(this->Files.file("mesh.nc"), fine);
  EXPECT_LT(largestError(seafloor, bed), Exact) << "natural neighbours keep planes";
  // Its grid spans the middles of the faces, and has no node in the square that is no face.
  EXPECT_LT(seafloor.grid.bounds().size().x, 80.0 - 20.0 / 3.0 + Exact);
  const glm::dvec2 origin(seafloor.georeference.originX(), seafloor.georeference.originY());
  for (std::size_t row = 0; row < seafloor.grid.rows; ++row)
  {
    for (std::size_t column = 0; column < seafloor.grid.columns; ++column)
    {
      const glm::dvec2 p = seafloor.grid.node(column, row) + origin;
      const bool cut = p.x > 40.0 + Exact && p.x < 50.0 - Exact && p.y > 20.0 + Exact && p.y < 30.0 - Exact;
      const bool inner = p.x > 10.0 && p.x < 70.0 && p.y > 10.0 && p.y < 50.0;
      if (cut || inner)
      {
        EXPECT_EQ(std::isnan(seafloor.grid.at(column, row)), cut) << p.x << ' ' << p.y;
      }
    }
  }
  // A mark of missing data takes its face away.
  fine.nodata = bed({ 15.0, 15.0 });
  const Bathymetry holed = readSeafloor(this->Files.file("mesh.nc"), fine);
  EXPECT_GT(holed.report.noDataShare, seafloor.report.noDataShare);

  // Where the file says the places of its values, they lie there.
  mesh.faceCoordinates = true;
  mesh.topology["face_coordinates"] = "fx fy";
  const std::optional<Soundings> placed = readUgridMesh(write(mesh, bed), "");
  ASSERT_TRUE(placed);
  EXPECT_EQ(placed->x[0], 0.0);
  EXPECT_EQ(placed->z[0], -20.0);
  EXPECT_EQ(placed->variable, "bed");
  mesh.topology["face_coordinates"] = "nx ny";
  EXPECT_THAT(failureOf([&] { readUgridMesh(write(mesh, bed), "bed"); }), HasSubstr("not as many as its faces"));

  // The values of the nodes are meant where there are both.
  mesh.topology.erase("face_coordinates");
  mesh.variables = { "z" };
  mesh.standardName.clear();
  EXPECT_EQ(readUgridMesh(write(mesh, bed), "")->variable, "z");
  EXPECT_EQ(readUgridMesh(this->Files.file("mesh.nc"), "bed")->variable, "bed");
}

TEST_F(UgridFileTest, WhatCannotBeReadSaysWhy)
{
  const auto said = [this](const MeshFile& mesh, const std::string& variable = "")
  {
    const std::string path = write(mesh);
    return failureOf([&] { readUgridMesh(path, variable); });
  };
  MeshFile several;
  several.variables = { "z", "roughness" };
  EXPECT_THAT(said(several), HasSubstr("Choose with --variable: z, roughness"));
  EXPECT_EQ(said(several, "z"), "no error");
  EXPECT_THAT(said(several, "depth"), HasSubstr("there are: z, roughness"));
  MeshFile none;
  none.variables.clear();
  EXPECT_THAT(said(none), HasSubstr("none"));
  MeshFile places;
  places.topology["node_coordinates"] = "nx";
  EXPECT_THAT(said(places), HasSubstr("names a variable '' that is not there"));
  places.topology["node_coordinates"] = "nx faces";
  EXPECT_THAT(said(places), HasSubstr("no two coordinates"));
  MeshFile faces;
  faces.topology["face_node_connectivity"] = "z";
  EXPECT_THAT(said(faces), HasSubstr("no table of faces"));
  MeshFile far;
  far.startIndex = 1000.0;
  const std::string path = write(far);
  EXPECT_EQ(failureOf([&] { readUgridMesh(path, ""); }), "no error") << "written so, read so";
  MeshFile other;
  other.topology["cf_role"] = "timeseries_id";
  EXPECT_FALSE(readUgridMesh(write(other), ""));
  EXPECT_FALSE(readUgridMesh(this->Files.file("none.nc"), ""));
  writeText(this->Files.file("text.nc"), "no NetCDF");
  EXPECT_FALSE(readUgridMesh(this->Files.file("text.nc"), ""));
}
