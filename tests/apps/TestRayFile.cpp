#include "Program.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <vector>

namespace
{

struct Expected
{
  const char* name;
  int type;
  int components;
};

vtkSmartPointer<vtkPolyData> readBack(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

void expectArrays(vtkFieldData* data, const std::vector<Expected>& arrays)
{
  for (const Expected& expected : arrays)
  {
    vtkAbstractArray* array = data->GetAbstractArray(expected.name);
    ASSERT_NE(array, nullptr) << expected.name;
    EXPECT_EQ(array->GetDataType(), expected.type) << expected.name;
    EXPECT_EQ(array->GetNumberOfComponents(), expected.components) << expected.name;
    EXPECT_GT(array->GetNumberOfTuples(), 0) << expected.name;
  }
}

void expectSameValues(vtkFieldData* a, vtkFieldData* b)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* one = a->GetArray(i);
    vtkDataArray* two = b->GetArray(i);
    ASSERT_TRUE(one && two);
    ASSERT_EQ(one->GetNumberOfValues(), two->GetNumberOfValues()) << one->GetName();
    const auto bytes = static_cast<std::size_t>(one->GetNumberOfValues()) * one->GetDataTypeSize();
    EXPECT_EQ(std::memcmp(one->GetVoidPointer(0), two->GetVoidPointer(0), bytes), 0) << one->GetName();
  }
}

const std::string Call = "trace plane --period 8 --direction 60 --height 1 ";

}

TEST(RayFile, HasTheArraysOfTheContract)
{
  const ScratchFolder folder("rays");
  ASSERT_EQ(runSwellray(Call + "-o " + folder / "rays.vtp"), 0);
  const auto rays = readBack(folder / "rays.vtp");
  ASSERT_GE(rays->GetNumberOfCells(), 100);
  EXPECT_EQ(rays->GetNumberOfLines(), rays->GetNumberOfCells());
  EXPECT_EQ(rays->GetPoints()->GetDataType(), VTK_DOUBLE);
  std::vector<Expected> points{ { "Direction", VTK_DOUBLE, 3 }, { "RayDirection", VTK_DOUBLE, 3 },
    { "Caustics", VTK_INT, 1 }, { "Breaking", VTK_UNSIGNED_CHAR, 1 }, { "RayState", VTK_UNSIGNED_CHAR, 1 } };
  for (const char* name : { "Depth", "Phase", "TravelTime", "Wavenumber", "Wavelength", "PhaseSpeed", "GroupSpeed",
         "DirectionFrom", "RefractionCoefficient", "KrSpacing", "KrTube", "TubeWidth", "ShoalingCoefficient",
         "WaveHeight", "EnergyFlux", "OrbitalVelocity" })
  {
    points.push_back({ name, VTK_DOUBLE, 1 });
  }
  expectArrays(rays->GetPointData(), points);
  expectArrays(rays->GetCellData(),
    { { "RayId", VTK_INT, 1 }, { "LaunchParameter", VTK_DOUBLE, 1 }, { "ParentRay", VTK_INT, 1 },
      { "LeeRay", VTK_UNSIGNED_CHAR, 1 }, { "FinalState", VTK_UNSIGNED_CHAR, 1 },
      { "EndReason", VTK_UNSIGNED_CHAR, 1 } });
  expectArrays(rays->GetFieldData(),
    { { "Period", VTK_DOUBLE, 1 }, { "DirectionFrom", VTK_DOUBLE, 1 }, { "WaveHeight", VTK_DOUBLE, 1 },
      { "WaterLevel", VTK_DOUBLE, 1 }, { "OriginX", VTK_DOUBLE, 1 }, { "OriginY", VTK_DOUBLE, 1 },
      { "SwellrayVersion", VTK_STRING, 1 }, { "CommandLine", VTK_STRING, 1 } });
}

TEST(RayFile, KeepsTheCommandLineAndTheWave)
{
  const ScratchFolder folder("line");
  const std::string path = folder / "rays.vtp";
  ASSERT_EQ(runSwellray(Call + "-o " + path), 0);
  const auto rays = readBack(path);
  auto* line = vtkStringArray::SafeDownCast(rays->GetFieldData()->GetAbstractArray("CommandLine"));
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(std::string(line->GetValue(0)), "swellray " + Call + "-o " + path);
  EXPECT_EQ(rays->GetFieldData()->GetArray("Period")->GetComponent(0, 0), 8.0);
  EXPECT_EQ(rays->GetFieldData()->GetArray("DirectionFrom")->GetComponent(0, 0), 60.0);
}

TEST(RayFile, ObeysSnellOnAPlaneBeach)
{
  // The tracer's tolerance is 1e-8 a step; a few hundred steps add up.
  constexpr double SnellTolerance = 1e-6;
  const ScratchFolder folder("snell");
  ASSERT_EQ(runSwellray(Call + "-o " + folder / "rays.vtp"), 0);
  const auto rays = readBack(folder / "rays.vtp");
  vtkDataArray* direction = rays->GetPointData()->GetArray("Direction");
  vtkDataArray* wavenumber = rays->GetPointData()->GetArray("Wavenumber");
  vtkDataArray* state = rays->GetPointData()->GetArray("RayState");
  // Waves from 60 degrees onto a beach that faces east: k sin(theta) = k0 cos(60 deg), going south.
  const double omega = 2.0 * std::acos(-1.0) / 8.0;
  const double along = -omega * omega / 9.81 * 0.5;
  int checked = 0;
  for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
  {
    if (state->GetComponent(i, 0) != 1.0)
    {
      continue;
    }
    EXPECT_NEAR(wavenumber->GetComponent(i, 0) * direction->GetComponent(i, 1), along, SnellTolerance * -along);
    ++checked;
  }
  EXPECT_GT(checked, 1000);
}

TEST(RayFile, IsTheSameForAnyNumberOfThreads)
{
  const ScratchFolder folder("threads");
  const std::string call = "trace island --period 8 --direction 270 --height 1 ";
  ASSERT_EQ(runSwellray(call + "--threads 1 -o " + folder / "one.vtp"), 0);
  ASSERT_EQ(runSwellray(call + "--threads 2 -o " + folder / "two.vtp"), 0);
  const auto one = readBack(folder / "one.vtp");
  const auto two = readBack(folder / "two.vtp");
  ASSERT_EQ(one->GetNumberOfPoints(), two->GetNumberOfPoints());
  expectSameValues(one->GetPointData(), two->GetPointData());
  expectSameValues(one->GetCellData(), two->GetCellData());
}

TEST(RayFile, IsRawAppendedBinary)
{
  const ScratchFolder folder("raw");
  ASSERT_EQ(runSwellray(Call + "-o " + folder / "rays.vtp"), 0);
  std::ifstream file(folder / "rays.vtp", std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_NE(text.find("header_type=\"UInt64\""), std::string::npos);
  EXPECT_NE(text.find("<AppendedData encoding=\"raw\">"), std::string::npos);
  EXPECT_EQ(text.find("compressor="), std::string::npos);
}

TEST(CrestFile, HasNumbersAndHeights)
{
  const ScratchFolder folder("crests");
  ASSERT_EQ(runSwellray(Call + "--crests " + folder / "crests.vtp"), 0);
  const auto crests = readBack(folder / "crests.vtp");
  ASSERT_GT(crests->GetNumberOfCells(), 10);
  expectArrays(crests->GetCellData(), { { "CrestNumber", VTK_INT, 1 } });
  expectArrays(crests->GetPointData(), { { "WaveHeight", VTK_DOUBLE, 1 } });
}

TEST(ContourFile, LiesAtTheDepthsAskedFor)
{
  constexpr double Nearby = 1e-6; // m: the bed is a plane, on which linear crossings are exact
  const ScratchFolder folder("contours");
  ASSERT_EQ(runSwellray("contour plane:slope=0.02 --levels 10,20 -o " + folder / "contours.vtp"), 0);
  const auto contours = readBack(folder / "contours.vtp");
  ASSERT_EQ(contours->GetNumberOfCells(), 2);
  vtkDataArray* depth = contours->GetCellData()->GetArray("Depth");
  ASSERT_NE(depth, nullptr);
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    double bounds[6];
    contours->GetCellBounds(cell, bounds);
    EXPECT_NEAR(bounds[0], depth->GetComponent(cell, 0) / 0.02, Nearby);
    EXPECT_NEAR(bounds[1], depth->GetComponent(cell, 0) / 0.02, Nearby);
  }
}
