#include "Observers.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"
#include "vtkSwellContours.h"
#include "vtkSwellMap.h"
#include "vtkSwellMildSlope.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellWaveHeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

namespace
{

// An ocean from 170 to 200 degrees east and 40 south to 5 north, 6 km deep, with an island.
class EllipsoidTracer : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Path = this->Folder.file("ocean.asc");
    std::ofstream file(this->Path);
    file << "ncols 61\nnrows 91\nxllcenter 170\nyllcenter -40\ncellsize 0.5\nNODATA_value -9999\n";
    for (int row = 0; row < 91; ++row)
    {
      for (int column = 0; column < 61; ++column)
      {
        const double r2 = (column - 15) * (column - 15) + (row - 30) * (row - 30);
        file << (this->Island ? -6000.0 + 7000.0 * std::exp(-r2 / 9.0) : -6000.0) << ' ';
      }
      file << '\n';
    }
    file.close();
    this->Reader->SetFileName(this->Path.c_str());
    this->Reader->SetCRS("EPSG:4326");
    this->Reader->SetEarthToEllipsoid();
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetPeriod(16.0);
    this->Tracer->SetDirectionFrom(200.0);
    this->Tracer->SetSpacing(40000.0);
    this->Tracer->SetStepsPerWave(0.02);
    this->Tracer->SetEdgeToNone();
  }

  bool Island = false;
  TemporaryFolder Folder;
  std::string Path;
  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
};

class EllipsoidIsland : public EllipsoidTracer
{
protected:
  EllipsoidIsland() { this->Island = true; }
};

double at(vtkDataSetAttributes* data, const char* name, vtkIdType i)
{
  return data->GetArray(name)->GetComponent(i, 0);
}

}

TEST_F(EllipsoidTracer, RaysKeepClairautsConstantAndAzimuths)
{
  this->Tracer->Update();
  vtkPolyData* rays = this->Tracer->GetOutput();
  ASSERT_GT(rays->GetNumberOfCells(), 80);
  vtkPointData* points = rays->GetPointData();
  constexpr double e2 = 0.0066943799901413165; // WGS 84
  const double k = swellray::solveWavenumber(2.0 * swellray::Pi / 16.0, 6000.0);
  bool crosses = false;
  for (vtkIdType ray = 0; ray < rays->GetNumberOfCells(); ++ray)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    rays->GetCellPoints(ray, count, ids);
    const auto clairaut = [&](vtkIdType i)
    {
      const double latitude = swellray::radians(at(points, "Latitude", i));
      const double azimuth = swellray::radians(at(points, "DirectionFrom", i) - 180.0);
      const double sine = std::sin(latitude);
      return 6378137.0 / std::sqrt(1.0 - e2 * sine * sine) * std::cos(latitude) * std::sin(azimuth);
    };
    // Coordinates of 1e-8 of a wavelength and headings of 1e-8: centimetres on the Earth's radius.
    constexpr double clairautError = 0.1;
    for (vtkIdType i = 0; i < count; ++i)
    {
      EXPECT_NEAR(clairaut(ids[i]), clairaut(ids[0]), clairautError);
      EXPECT_NEAR(at(points, "Wavenumber", ids[i]), k, 1e-9 * k);
      EXPECT_LE(std::abs(at(points, "Longitude", ids[i])), 180.0);
      const double longitude = at(points, "Longitude", ids[i]);
      crosses = crosses || (i > 0 && std::abs(longitude - at(points, "Longitude", ids[i - 1])) > 300.0);
    }
    EXPECT_NEAR(at(points, "DirectionFrom", ids[0]), 200.0, 1e-9);
    // Time is the way over the group speed, phase the way times k.
    EXPECT_NEAR(at(points, "Phase", ids[count - 1]) - at(points, "Phase", ids[0]),
      at(points, "TravelTime", ids[count - 1]) * at(points, "GroupSpeed", ids[0]) * k, 1e-3);
  }
  EXPECT_TRUE(crosses) << "no ray crosses the antimeridian";
  EXPECT_FALSE(rays->GetFieldData()->HasArray("GeographicElevation"));
  EXPECT_FALSE(rays->GetFieldData()->HasArray("GeographicGrid"));
  auto* earth = vtkStringArray::SafeDownCast(rays->GetFieldData()->GetAbstractArray("EarthModel"));
  ASSERT_TRUE(earth);
  EXPECT_EQ(earth->GetValue(0), "ellipsoid");
}

TEST_F(EllipsoidTracer, WidthsOfTubesAndOfSpacingsAreTrueOnes)
{
  this->Tracer->SetSpacing(10000.0);
  this->Tracer->Update();
  vtkPolyData* rays = this->Tracer->GetOutput();
  vtkPointData* points = rays->GetPointData();
  constexpr double e2 = 0.0066943799901413165;
  const auto parallel = [](double latitude)
  {
    const double sine = std::sin(latitude);
    return 6378137.0 / std::sqrt(1.0 - e2 * sine * sine) * std::cos(latitude);
  };
  int fromSouth = 0;
  double worst = 0.0;
  for (vtkIdType ray = 0; ray < rays->GetNumberOfCells(); ++ray)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    rays->GetCellPoints(ray, count, ids);
    if (at(points, "Latitude", ids[0]) > -40.0 + 1e-9)
    {
      continue; // only from the southern edge are rays one ray moved in longitude
    }
    ++fromSouth;
    const auto width = [&](vtkIdType i)
    {
      return parallel(swellray::radians(at(points, "Latitude", i))) *
        std::cos(swellray::radians(at(points, "DirectionFrom", i) - 180.0));
    };
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double exact = std::sqrt(width(ids[0]) / width(ids[i]));
      EXPECT_NEAR(at(points, "KrTube", ids[i]), exact, 1e-7 * exact);
      const double spacing = at(points, "KrSpacing", ids[i]);
      // Next to the ray from the corner neighbours are of another family; those have been left out with their edge.
      worst = i + 1 < count && ray % 50 == 25 ? std::max(worst, std::abs(spacing / exact - 1.0)) : worst;
    }
  }
  EXPECT_GT(fromSouth, 200);
  EXPECT_LT(worst, 2e-4); // second order in the spacing over the Earth's radius, and the ends of rows
}

TEST_F(EllipsoidIsland, HeightsMapsAndContoursFollow)
{
  vtkNew<vtkSwellWaveHeight> heights;
  heights->SetInputConnection(this->Tracer->GetOutputPort());
  vtkNew<vtkSwellMap> map;
  map->SetInputConnection(0, heights->GetOutputPort());
  map->SetInputConnection(1, this->Reader->GetOutputPort());
  map->Update();
  vtkImageData* image = map->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], 61);
  vtkPointData* values = image->GetPointData();
  int covered = 0;
  int wet = 0;
  int land = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    land += at(values, "Depth", i) <= 0.0 ? 1 : 0;
    wet += at(values, "Depth", i) > 0.0 ? 1 : 0;
    covered += std::isfinite(at(values, "WaveHeight", i)) ? 1 : 0;
  }
  EXPECT_GT(land, 2);
  EXPECT_GT(covered, 0.85 * wet);
  EXPECT_FALSE(image->GetFieldData()->HasArray("GeographicElevation"));

  vtkNew<vtkSwellContours> contours;
  contours->SetInputConnection(this->Reader->GetOutputPort());
  contours->AddLevel(0.0);
  contours->Update();
  ASSERT_GT(contours->GetOutput()->GetNumberOfPoints(), 3);
  EXPECT_FALSE(contours->GetOutput()->GetFieldData()->HasArray("GeographicElevation"));
  vtkDataArray* latitude = contours->GetOutput()->GetPointData()->GetArray("Latitude");
  double range[2];
  latitude->GetRange(range);
  EXPECT_NEAR(0.5 * (range[0] + range[1]), -10.0, 0.2); // row 30 from the north
}

TEST_F(EllipsoidIsland, AnImageFileKeepsTheGrid)
{
  this->Reader->Update();
  const std::string path = this->Folder.file("ocean.vti");
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputConnection(this->Reader->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->Write();
  vtkNew<vtkSwellSeafloorReader> again;
  again->SetFileName(path.c_str());
  this->Tracer->Update();
  vtkNew<vtkPolyData> first;
  first->DeepCopy(this->Tracer->GetOutput());
  this->Tracer->SetInputConnection(again->GetOutputPort());
  this->Tracer->Update();
  vtkPolyData* second = this->Tracer->GetOutput();
  ASSERT_EQ(second->GetNumberOfPoints(), first->GetNumberOfPoints());
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(at(second->GetPointData(), "Depth", i), at(first->GetPointData(), "Depth", i));
  }
}

TEST_F(EllipsoidTracer, TheMildSlopeEquationRefusesIt)
{
  vtkNew<vtkSwellMildSlope> filter;
  filter->SetInputConnection(this->Reader->GetOutputPort());
  vtkNew<Listener> listener;
  listener->listenTo(filter);
  filter->Update();
  EXPECT_THAT(listener->Errors, testing::ElementsAre(testing::HasSubstr("solved on a plane")));
}

TEST_F(EllipsoidTracer, RefusesTheSnellScheme)
{
  vtkNew<Listener> listener;
  listener->listenTo(this->Tracer);
  this->Tracer->SetSchemeToSnell();
  this->Tracer->Update();
  EXPECT_THAT(listener->Errors, testing::ElementsAre(testing::HasSubstr("snell scheme knows no ellipsoid")));
  EXPECT_EQ(this->Tracer->GetOutput()->GetNumberOfPoints(), 0);
}
