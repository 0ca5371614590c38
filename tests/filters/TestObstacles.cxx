// Obstacles from file to map: standing waves before a wall, crests that end at it, and what the filters say.
#include "Observers.h"

#include "vtkSwellCrests.h"
#include "vtkSwellMap.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellStations.h"
#include "vtkSwellWaveHeight.h"

#include "sim/Obstacles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace
{

using testing::HasSubstr;

constexpr double Depth = 15.0;
constexpr double Period = 8.0;

// Of 2 m: heights and phases of plane waves are linear over the sheets of rays, but places are looked at 0.12 mm (a
// ten-millionth of the scene) inwards, 2 k times that.
constexpr double StandingTolerance = 3e-5;

double wavenumber()
{
  const double omega = 2.0 * M_PI / Period;
  double k = omega * omega / 9.81;
  for (int i = 0; i < 200; ++i)
  {
    k = 0.5 * (k + omega * omega / (9.81 * std::tanh(k * Depth)));
  }
  return k;
}

std::string lineFile(
  const TemporaryFolder& folder, const std::string& coordinates, const std::string& type = "LineString")
{
  return folder.write("wall.geojson",
    R"({"type":"Feature","properties":{},"geometry":{"type":")" + type + R"(","coordinates":)" + coordinates + "}}");
}

/** A basin of 1000 m x 600 m of one depth, with a wall in it. */
class Basin : public testing::Test
{
protected:
  Basin()
  {
    this->Seafloor = elevationImage(51, 31, 20.0, [](double, double) { return -Depth; });
    this->Tracer->SetInputData(this->Seafloor);
    this->Tracer->SetPeriod(Period);
    this->Tracer->SetWaveHeight(1.0);
    this->Tracer->SetDirectionFrom(270.0);
    this->Tracer->SetOffshoreDepth(Depth);
    this->Tracer->SetEdgeToNone();
    this->Tracer->SetSpacing(5.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Heights->SetBreakingRuleToNone();
  }

  TemporaryFolder Folder;
  vtkSmartPointer<vtkImageData> Seafloor;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
};

}

TEST_F(Basin, standsInWavesBeforeAWallThatReflectsAll)
{
  this->Tracer->SetObstacles(lineFile(this->Folder, "[[800,-10],[800,610]]").c_str());
  const double k = wavenumber();
  for (const double share : { 1.0, 0.4 })
  {
    this->Tracer->SetReflection(share);
    for (const bool phase : { true, false })
    {
      vtkNew<vtkSwellMap> map;
      map->SetInputConnection(0, this->Heights->GetOutputPort());
      map->SetInputData(1, this->Seafloor);
      map->SetSpacing(7.0);
      map->SetCombineRule(phase ? vtkSwellMap::PHASE : vtkSwellMap::ENERGY);
      map->Update();
      vtkImageData* output = map->GetOutput();
      vtkDataArray* height = output->GetPointData()->GetArray("WaveHeight");
      int compared = 0;
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        double place[3];
        output->GetPoint(i, place);
        if (place[1] < 10.0 || place[1] > 590.0)
        {
          continue; // beyond the outermost rays
        }
        if (place[0] > 800.0)
        {
          EXPECT_TRUE(std::isnan(height->GetComponent(i, 0))) << place[0] << " lies behind the wall";
          continue;
        }
        const double way = k * (800.0 - place[0]);
        const double exact = phase ? std::hypot((1.0 + share) * std::cos(way), (1.0 - share) * std::sin(way))
                                   : std::sqrt(1.0 + share * share);
        EXPECT_NEAR(height->GetComponent(i, 0), exact, StandingTolerance) << place[0] << " " << place[1];
        ++compared;
      }
      EXPECT_GT(compared, 9000);
    }
  }
}

TEST_F(Basin, standsInCrossedWavesBeforeAWallMetObliquely)
{
  this->Tracer->SetObstacles(lineFile(this->Folder, "[[700,-500],[700,1100]]").c_str());
  this->Tracer->SetReflection(1.0);
  this->Tracer->SetDirectionFrom(270.0 + 35.0);
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (int i = 0; i < 200; ++i)
  {
    // Where the incident wave and its reflection both come.
    places->InsertNextPoint(400.0 + 1.5 * i, 90.0 + 0.5 * i, 0.0);
  }
  vtkNew<vtkPolyData> stations;
  stations->SetPoints(places);
  vtkNew<vtkSwellStations> filter;
  filter->SetInputConnection(0, this->Heights->GetOutputPort());
  filter->SetInputData(1, this->Seafloor);
  filter->SetInputData(2, stations);
  filter->SetCombineRule(vtkSwellStations::PHASE);
  filter->Update();
  vtkDataArray* height = filter->GetOutput()->GetPointData()->GetArray("WaveHeight");
  vtkDataArray* count = filter->GetOutput()->GetPointData()->GetArray("RayCount");
  const double kx = wavenumber() * std::cos(35.0 * M_PI / 180.0);
  for (vtkIdType i = 0; i < 200; ++i)
  {
    EXPECT_EQ(count->GetComponent(i, 0), 2.0) << i;
    EXPECT_NEAR(
      height->GetComponent(i, 0), 2.0 * std::abs(std::cos(kx * (700.0 - places->GetPoint(i)[0]))), StandingTolerance)
      << i;
  }
}

TEST_F(Basin, isLandInsideAPolygonAndHasNoCrestsAcrossIt)
{
  this->Tracer->SetObstacles(
    lineFile(this->Folder, "[[[400,250],[600,250],[600,350],[400,350],[400,250]]]", "Polygon").c_str());
  vtkNew<vtkSwellMap> map;
  map->SetInputConnection(0, this->Heights->GetOutputPort());
  map->SetInputData(1, this->Seafloor);
  map->SetSpacing(10.0);
  map->Update();
  vtkDataArray* height = map->GetOutput()->GetPointData()->GetArray("WaveHeight");
  for (vtkIdType i = 0; i < map->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double place[3];
    map->GetOutput()->GetPoint(i, place);
    const bool above = place[1] > 352.0 && place[1] < 590.0;
    const bool before = place[0] < 399.0 && place[1] > 10.0 && place[1] < 590.0;
    const bool shadow = place[0] > 401.0 && place[1] > 260.0 && place[1] < 340.0;
    if (above || before)
    {
      EXPECT_NEAR(height->GetComponent(i, 0), 1.0, StandingTolerance) << place[0] << " " << place[1];
    }
    else if (shadow)
    {
      EXPECT_TRUE(std::isnan(height->GetComponent(i, 0))) << place[0] << " " << place[1];
    }
  }

  vtkNew<vtkSwellCrests> crests;
  crests->SetInputConnection(this->Heights->GetOutputPort());
  crests->Update();
  vtkPolyData* lines = crests->GetOutput();
  int parted = 0;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    lines->GetCellBounds(cell, bounds);
    if (bounds[0] > 405.0)
    {
      EXPECT_TRUE(bounds[3] <= 250.0 || bounds[2] >= 350.0) << "a crest at x = " << bounds[0];
      ++parted;
    }
  }
  EXPECT_GT(parted, 10);
}

TEST_F(Basin, keepsObstaclesWithItsRays)
{
  this->Tracer->SetObstacles(lineFile(this->Folder, "[[800,-10],[800,610]]").c_str());
  this->Tracer->SetReflection(0.5);
  this->Tracer->Update();
  vtkPolyData* rays = this->Tracer->GetOutput();
  vtkFieldData* fields = rays->GetFieldData();
  ASSERT_TRUE(fields->GetArray("ObstaclePoints"));
  EXPECT_EQ(fields->GetArray("ObstaclePoints")->GetNumberOfTuples(), 2);
  EXPECT_EQ(fields->GetArray("ObstaclePoints")->GetComponent(1, 1), 610.0);
  EXPECT_EQ(fields->GetArray("ObstacleOffsets")->GetNumberOfTuples(), 2);
  EXPECT_EQ(fields->GetArray("ObstacleReflection")->GetComponent(0, 0), 0.5);
  double range[2];
  rays->GetCellData()->GetArray("Reflections")->GetRange(range);
  EXPECT_EQ(range[1], 1.0);
  rays->GetCellData()->GetArray("ReflectionCoefficient")->GetRange(range);
  EXPECT_EQ(range[0], 0.5);
  EXPECT_EQ(range[1], 1.0);

  this->Tracer->SetObstacles(nullptr);
  this->Tracer->Update();
  EXPECT_FALSE(this->Tracer->GetOutput()->GetFieldData()->GetArray("ObstaclePoints"));
  EXPECT_FALSE(this->Tracer->GetOutput()->GetCellData()->GetArray("Reflections"));
}

TEST_F(Basin, saysWhatIsWrongWithObstacles)
{
  vtkNew<Listener> listener;
  vtkNew<Listener> quiet;
  listener->listenTo(this->Tracer);
  quiet->listenTo(this->Tracer->GetExecutive());
  this->Tracer->SetObstacles("none.geojson");
  this->Tracer->Update();
  ASSERT_EQ(listener->Errors.size(), 1u);
  EXPECT_THAT(listener->Errors[0], HasSubstr("obstacles 'none.geojson': no such file"));
  EXPECT_EQ(this->Tracer->GetOutput()->GetNumberOfPoints(), 0);

  listener->Errors.clear();
  this->Tracer->SetObstacles(lineFile(this->Folder, "[[800,-10],[800,610]]").c_str());
  this->Tracer->SetReflection(1.5);
  this->Tracer->Update();
  ASSERT_EQ(listener->Errors.size(), 1u);
  EXPECT_THAT(listener->Errors[0], HasSubstr("reflection must be 0 to 1, not 1.5"));

  listener->Errors.clear();
  this->Tracer->SetReflection(1.0);
  this->Tracer->SetMaximumReflections(-1);
  this->Tracer->Update();
  ASSERT_EQ(listener->Errors.size(), 1u);
  EXPECT_THAT(listener->Errors[0], HasSubstr("the cap on reflections must be 0 or more, not -1"));
}

TEST(ObstacleSites, noRayEntersTheBreakwaterOfHilo)
{
  const char* set = std::getenv("SWELLRAY_DATA");
  const std::filesystem::path sites = std::filesystem::path(set ? set : SWELLRAY_DATA_DEFAULT) / "sites";
  const std::string seafloor = sites / "hilo_bay_hawaii/hilo_bay_1_3s_epsg4326.tif";
  const std::string land = sites / "_shorelines/hilo_land_polygons.geojson";
  if (!std::filesystem::exists(seafloor) || !std::filesystem::exists(land))
  {
    GTEST_SKIP() << "no " << seafloor << " or " << land;
  }
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(seafloor.c_str());
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(reader->GetOutputPort());
  tracer->SetPeriod(12.0);
  tracer->SetDirectionFrom(20.0);
  tracer->SetWaveHeight(2.0);
  // At high water, so that the beach before the wall does not stop them all.
  tracer->SetWaterLevel(3.0);
  tracer->SetObstacles(land.c_str());
  tracer->SetReflection(0.5);
  tracer->Update();
  vtkPolyData* rays = tracer->GetOutput();
  vtkFieldData* fields = rays->GetFieldData();
  vtkDataArray* points = fields->GetArray("ObstaclePoints");
  vtkDataArray* offsets = fields->GetArray("ObstacleOffsets");
  std::vector<swellray::Obstacle> obstacles(static_cast<std::size_t>(offsets->GetNumberOfTuples() - 1));
  for (std::size_t i = 0; i < obstacles.size(); ++i)
  {
    obstacles[i].closed = true;
    const auto end = static_cast<vtkIdType>(offsets->GetComponent(static_cast<vtkIdType>(i) + 1, 0));
    for (auto p = static_cast<vtkIdType>(offsets->GetComponent(static_cast<vtkIdType>(i), 0)); p < end; ++p)
    {
      obstacles[i].points.emplace_back(points->GetComponent(p, 0), points->GetComponent(p, 1));
    }
  }
  const swellray::Obstacles walls(obstacles);
  vtkDataArray* reason = rays->GetCellData()->GetArray("EndReason");
  vtkDataArray* state = rays->GetPointData()->GetArray("RayState");
  int stopped = 0;
  for (vtkIdType ray = 0; ray < rays->GetNumberOfCells(); ++ray)
  {
    stopped += reason->GetComponent(ray, 0) == 7.0 ? 1 : 0;
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    rays->GetCellPoints(ray, size, ids);
    // The ends may lie on a wall, and a ray along the shore follows the depth, not the polygons.
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      double place[3];
      rays->GetPoint(ids[i], place);
      if (state->GetComponent(ids[i - 1], 0) != 3.0 && state->GetComponent(ids[i], 0) != 3.0)
      {
        ASSERT_FALSE(walls.inside({ place[0], place[1] })) << "ray " << ray << " at " << place[0] << " " << place[1];
      }
    }
  }
  EXPECT_GT(stopped, 100);
}
