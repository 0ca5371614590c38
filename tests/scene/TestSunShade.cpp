#include "apps/scene/SunShade.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <array>
#include <cmath>

using namespace swellray::scene;

namespace
{

constexpr double Degree = 3.14159265358979323846 / 180.0;

std::array<double, 3> sunAt(double azimuth, double elevation)
{
  const double level = std::cos(elevation * Degree);
  return { level * std::sin(azimuth * Degree), level * std::cos(azimuth * Degree), std::sin(elevation * Degree) };
}

// 200 m by 100 m, and a wall 10 m high across it from x = 100 to 104.
vtkSmartPointer<vtkImageData> walledPlain()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(401, 201, 1);
  image->SetSpacing(0.5, 0.5, 1.0);
  vtkNew<vtkDoubleArray> elevation;
  elevation->SetName("Elevation");
  for (int j = 0; j < 201; ++j)
  {
    for (int i = 0; i < 401; ++i)
    {
      elevation->InsertNextValue(i >= 200 && i <= 208 ? 10.0 : 0.0);
    }
  }
  image->GetPointData()->AddArray(elevation);
  return image;
}

// A square, level sheet.
vtkSmartPointer<vtkPolyData> sheet(double x0, double x1, double z)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x0, 20.0, z);
  points->InsertNextPoint(x1, 20.0, z);
  points->InsertNextPoint(x1, 80.0, z);
  points->InsertNextPoint(x0, 80.0, z);
  vtkNew<vtkCellArray> cells;
  const vtkIdType triangles[2][3] = { { 0, 1, 2 }, { 0, 2, 3 } };
  cells->InsertNextCell(3, triangles[0]);
  cells->InsertNextCell(3, triangles[1]);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

}

TEST(SunShade, IsAsLongAsAWallIsHighOverTheTangentOfTheSun)
{
  for (const double elevation : { 20.0, 30.0, 45.0, 60.0 })
  {
    const SunShade shade(walledPlain(), sunAt(90.0, elevation)); // the sun in the east
    const double length = 10.0 / std::tan(elevation * Degree);
    // The wall leans over a node of the seafloor, half a metre; the edge is as broad as the sun, and steps are cells.
    const double edge = 0.5 + 2.0 * shade.cell() + 0.05 * length;
    EXPECT_EQ(shade.seenFrom(100.0 - length + edge, 50.0, 0.0), 0.0) << elevation;
    EXPECT_EQ(shade.seenFrom(100.0 - length - edge, 50.0, 0.0), 1.0) << elevation;
    EXPECT_EQ(shade.seenFrom(98.0, 50.0, 0.0), 0.0);
    EXPECT_EQ(shade.seenFrom(106.0, 50.0, 0.0), 1.0);  // before the wall
    EXPECT_EQ(shade.seenFrom(102.0, 50.0, 10.0), 1.0); // on it
    EXPECT_EQ(shade.seenFrom(98.0, 50.0, 10.5), 1.0);  // and higher
    EXPECT_EQ(shade.seenFrom(-500.0, 50.0, 0.0), 1.0); // far away from all
  }
}

TEST(SunShade, LiesAwayFromTheSun)
{
  EXPECT_EQ(SunShade(walledPlain(), sunAt(270.0, 30.0)).seenFrom(98.0, 50.0, 0.0), 1.0);
  EXPECT_EQ(SunShade(walledPlain(), sunAt(270.0, 30.0)).seenFrom(106.0, 50.0, 0.0), 0.0);
  EXPECT_EQ(SunShade(walledPlain(), sunAt(0.0, 30.0)).seenFrom(98.0, 50.0, 0.0), 1.0); // along the wall
  EXPECT_EQ(SunShade(walledPlain(), sunAt(90.0, 90.0)).seenFrom(99.0, 50.0, 0.0), 1.0);
}

TEST(SunShade, IsThrownByWavesToo)
{
  SunShade shade(walledPlain(), sunAt(90.0, 45.0));
  EXPECT_EQ(shade.seenFrom(40.0, 50.0, 0.0), 1.0);
  shade.setWaves(sheet(44.0, 50.0, 6.0));
  EXPECT_EQ(shade.seenFrom(40.0, 50.0, 0.0), 0.0); // 4 m from a sheet 6 m high, at 45 degrees
  EXPECT_EQ(shade.seenFrom(36.0, 50.0, 0.0), 1.0); // 8 m
  EXPECT_EQ(shade.seenFrom(47.0, 50.0, 6.0), 1.0); // on it: no shadow of its own
  EXPECT_EQ(shade.seenFrom(40.0, 10.0, 0.0), 1.0); // beside it
  shade.setWaves(sheet(44.0, 50.0, 0.0));
  EXPECT_EQ(shade.seenFrom(40.0, 50.0, 0.0), 1.0);
  EXPECT_EQ(shade.seenFrom(95.0, 50.0, 0.0), 0.0); // the wall is still there

  const auto points = sheet(95.0, 150.0, 0.0);
  shade.addTo(points);
  vtkDataArray* seen = points->GetPointData()->GetArray("SunSeen");
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(seen->GetComponent(0, 0), 0.0);
  EXPECT_EQ(seen->GetComponent(1, 0), 1.0);
}
