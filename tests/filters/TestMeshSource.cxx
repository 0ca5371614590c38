#include "Observers.h"

#include "bathymetry/SeafloorReport.h"
#include "vtkSwellSeafloorReader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLStructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cmath>

namespace
{

// Planes are kept by splines and by natural neighbours.
constexpr double Exact = 1e-9;

double plane(double x, double y)
{
  return -20.0 + 0.1 * x - 0.2 * y;
}

void addCrs(vtkDataObject* data)
{
  vtkNew<vtkStringArray> crs;
  crs->SetName("CRS");
  crs->InsertNextValue("EPSG:32618");
  data->GetFieldData()->AddArray(crs);
  for (const auto& [name, value] : { std::pair("OriginX", 500000.0), std::pair("OriginY", 4000000.0) })
  {
    vtkNew<vtkDoubleArray> number;
    number->SetName(name);
    number->InsertNextValue(value);
    data->GetFieldData()->AddArray(number);
  }
}

// 12 x 10 nodes; `stretch` makes their distances uneven.
vtkSmartPointer<vtkStructuredGrid> structured(double stretch, bool named)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(12, 10, 1);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> elevation;
  elevation->SetName("Elevation");
  for (int j = 0; j < 10; ++j)
  {
    for (int i = 0; i < 12; ++i)
    {
      const double x = 10.0 * i + stretch * i * i;
      const double y = 10.0 * j;
      points->InsertNextPoint(x, y, named ? 0.0 : plane(x, y));
      elevation->InsertNextValue(plane(x, y));
    }
  }
  grid->SetPoints(points);
  if (named)
  {
    grid->GetPointData()->AddArray(elevation);
  }
  addCrs(grid);
  return grid;
}

template <typename Writer, typename Data>
void write(const std::string& path, Data* data)
{
  vtkNew<Writer> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  ASSERT_EQ(writer->Write(), 1);
}

void expectPlane(vtkImageData* image)
{
  vtkDataArray* elevation = image->GetPointData()->GetArray("Elevation");
  ASSERT_TRUE(elevation);
  vtkIdType known = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double z = elevation->GetTuple1(i);
    if (!std::isnan(z))
    {
      const double* p = image->GetPoint(i);
      EXPECT_NEAR(z, plane(p[0], p[1]), Exact);
      ++known;
    }
  }
  EXPECT_GT(known, 50);
  EXPECT_NEAR(image->GetFieldData()->GetArray("OriginX")->GetComponent(0, 0), 500000.0, Exact);
  EXPECT_NEAR(image->GetFieldData()->GetArray("OriginY")->GetComponent(0, 0), 4000000.0, Exact);
}

std::string failureOf(const std::string& path)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  vtkNew<Listener> listener;
  listener->listenTo(reader);
  vtkNew<Listener> quiet;
  quiet->listenTo(reader->GetExecutive());
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileFormatError)) << path;
  return listener->Errors.empty() ? "no error" : listener->Errors.front();
}

}

TEST(MeshSource, structuredGridsRegularOrNot)
{
  const TemporaryFolder folder;
  for (const double stretch : { 0.0, 0.3 })
  {
    for (const bool named : { false, true })
    {
      const std::string path = folder.file("a.vts");
      write<vtkXMLStructuredGridWriter>(path, structured(stretch, named).Get());
      vtkNew<vtkSwellSeafloorReader> reader;
      reader->SetFileName(path.c_str());
      reader->Update();
      ASSERT_TRUE(reader->GetReport());
      EXPECT_EQ(reader->GetReport()->driver, "VTK structured grid");
      EXPECT_EQ(reader->GetReport()->soundings.has_value(), stretch > 0.0);
      EXPECT_EQ(reader->GetReport()->kind, swellray::GeoreferenceKind::Projected);
      expectPlane(reader->GetOutput());
    }
  }
}

TEST(MeshSource, unstructuredGridsWithAndWithoutCells)
{
  const TemporaryFolder folder;
  for (const bool cells : { true, false })
  {
    vtkNew<vtkUnstructuredGrid> mesh;
    mesh->SetPoints(structured(0.0, false)->GetPoints());
    addCrs(mesh);
    for (vtkIdType j = 0; cells && j < 9; ++j)
    {
      for (vtkIdType i = 0; i < 11; ++i)
      {
        const vtkIdType a = 12 * j + i;
        const vtkIdType around[] = { a, a + 1, a + 13, a + 12 };
        const vtkIdType rows[] = { a, a + 1, a + 12, a + 13 };
        const vtkIdType other[] = { a, a + 13, a + 12 };
        if (i == 5 && j == 4)
        {
          continue; // an island
        }
        if (i % 3 == 0)
        {
          mesh->InsertNextCell(VTK_QUAD, 4, around);
        }
        else if (i % 3 == 1)
        {
          mesh->InsertNextCell(VTK_PIXEL, 4, rows);
        }
        else
        {
          mesh->InsertNextCell(VTK_TRIANGLE, 3, around);
          mesh->InsertNextCell(VTK_TRIANGLE, 3, other);
        }
      }
    }
    const std::string path = folder.file("a.vtu");
    write<vtkXMLUnstructuredGridWriter>(path, mesh.Get());
    vtkNew<vtkSwellSeafloorReader> reader;
    reader->SetFileName(path.c_str());
    reader->SetResample(2.5);
    reader->Update();
    ASSERT_TRUE(reader->GetReport());
    expectPlane(reader->GetOutput());
    int size[3];
    reader->GetOutput()->GetDimensions(size);
    EXPECT_EQ(size[0], 45);
    EXPECT_EQ(size[1], 37);
    int holes = 0;
    vtkDataArray* elevation = reader->GetOutput()->GetPointData()->GetArray("Elevation");
    for (vtkIdType i = 0; i < elevation->GetNumberOfTuples(); ++i)
    {
      holes += std::isnan(elevation->GetTuple1(i)) ? 1 : 0;
    }
    EXPECT_EQ(holes, cells ? 9 : 0) << "the nodes inside of the square without a cell";
  }
}

TEST(MeshSource, damagedFilesAreOneError)
{
  const TemporaryFolder folder;
  EXPECT_THAT(failureOf(folder.write("words.vts", "no grid\n")), testing::HasSubstr("not a VTK structured grid"));
  EXPECT_THAT(failureOf(folder.write("words.vtu", "no mesh\n")), testing::HasSubstr("not a VTK unstructured grid"));
  vtkNew<vtkStructuredGrid> deep;
  deep->SetDimensions(4, 4, 2);
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 32; ++i)
  {
    points->InsertNextPoint(i % 4, i / 4 % 4, -1.0);
  }
  deep->SetPoints(points);
  write<vtkXMLStructuredGridWriter>(folder.file("deep.vts"), deep.Get());
  EXPECT_THAT(failureOf(folder.file("deep.vts")), testing::HasSubstr("4 x 4 x 2 nodes; a seafloor is one layer"));
  vtkNew<vtkUnstructuredGrid> empty;
  vtkNew<vtkPoints> none;
  empty->SetPoints(none);
  write<vtkXMLUnstructuredGridWriter>(folder.file("empty.vtu"), empty.Get());
  EXPECT_THAT(failureOf(folder.file("empty.vtu")), testing::HasSubstr("damaged or empty"));

  const std::string header = "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\">\n"
                             "<ImageData WholeExtent=\"0 999999 0 999999 0 0\" Origin=\"0 0 0\" Spacing=\"1 1 1\">"
                             "<Piece Extent=\"0 999999 0 999999 0 0\"><PointData><DataArray type=\"Float64\" "
                             "Name=\"Elevation\" format=\"ascii\">-1 -2</DataArray></PointData></Piece>"
                             "</ImageData></VTKFile>\n";
  EXPECT_THAT(failureOf(folder.write("giant.vti", header)), testing::HasSubstr("it has 1e+12 nodes, above the limit"));
}
