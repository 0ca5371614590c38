#include "Observers.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"
#include "vtkSwellMap.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellStations.h"
#include "vtkSwellWaveHeight.h"

#include <gtest/gtest.h>

#include <vtkFieldData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>

namespace
{

// Heights between rays 10 m and fronts an eighth of a wave apart, linear, against the formula: second differences of H
// over such distances, away from the last wavelengths before the shore.
constexpr double HeightTolerance = 1e-3;
constexpr double DirectionTolerance = 0.02; // degrees
constexpr double LengthTolerance = 2e-3;    // relative

/** Oblique waves onto a beach facing west, without breaking. */
struct Scene
{
  Scene()
  {
    this->Reader->SetFileName("plane:slope=0.02,x0=-1000,y0=-600,x1=100,y1=600,facing=270");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetPeriod(8.0);
    this->Tracer->SetDirectionFrom(250.0);
    this->Tracer->SetSpacing(10.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Heights->SetBreakingRuleToNone();
    this->Heights->SetAmplitudeRuleToTube();
    this->Map->SetInputConnection(0, this->Heights->GetOutputPort());
    this->Map->SetSeafloorConnection(this->Reader->GetOutputPort());
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellMap> Map;
};

double valueOf(vtkDataSet* data, const char* name, vtkIdType i)
{
  return data->GetPointData()->GetArray(name)->GetComponent(i, 0);
}

TEST(Map, FollowsSnellOnAPlaneBeach)
{
  const Scene scene;
  scene.Map->SetSpacing(25.0);
  scene.Map->Update();
  vtkImageData* map = scene.Map->GetOutput();
  ASSERT_EQ(map->GetDimensions()[0], 45);
  ASSERT_EQ(map->GetDimensions()[1], 49);
  const double omega = 2.0 * swellray::Pi / 8.0;
  const double deep = swellray::solveWavenumber(omega, HUGE_VAL);
  const double sine = std::sin(swellray::radians(20.0));
  int compared = 0;
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    double place[3];
    map->GetPoint(i, place);
    const double depth = -0.02 * place[0];
    ASSERT_NEAR(valueOf(map, "Depth", i), depth, 1e-12);
    ASSERT_NEAR(valueOf(map, "Elevation", i), -depth, 1e-12);
    if (depth < 2.0 || std::abs(place[1]) > 200.0)
    {
      continue;
    }
    ++compared;
    ASSERT_EQ(valueOf(map, "RayCount", i), 1.0) << place[0] << ' ' << place[1];
    const double k = swellray::solveWavenumber(omega, depth);
    const double theta = std::asin(sine * deep / k);
    const double kr = std::sqrt(std::cos(swellray::radians(20.0)) / std::cos(theta));
    const double ks =
      std::sqrt(swellray::waveSpeeds(deep, HUGE_VAL).groupSpeed / swellray::waveSpeeds(k, depth).groupSpeed);
    ASSERT_NEAR(valueOf(map, "WaveHeight", i), kr * ks, HeightTolerance);
    ASSERT_NEAR(valueOf(map, "DirectionFrom", i), 270.0 - swellray::degrees(theta), DirectionTolerance);
    ASSERT_NEAR(valueOf(map, "Wavelength", i) * k, 2.0 * swellray::Pi, LengthTolerance * 2.0 * swellray::Pi);
    ASSERT_EQ(valueOf(map, "Breaking", i), 0.0);
  }
  EXPECT_GT(compared, 500);
}

TEST(Map, IsEmptyOnLandAndCarriesThePlace)
{
  const Scene scene;
  scene.Map->Update();
  vtkImageData* map = scene.Map->GetOutput();
  vtkImageData* seafloor = scene.Reader->GetOutput();
  EXPECT_EQ(map->GetNumberOfPoints(), seafloor->GetNumberOfPoints());
  ASSERT_TRUE(map->GetFieldData()->GetArray("OriginX"));
  ASSERT_TRUE(map->GetFieldData()->GetArray("Period"));
  int land = 0;
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    if (valueOf(map, "Depth", i) <= 0.0)
    {
      ++land;
      ASSERT_TRUE(std::isnan(valueOf(map, "WaveHeight", i)));
      ASSERT_TRUE(std::isnan(valueOf(map, "DirectionFrom", i)));
      ASSERT_TRUE(std::isnan(valueOf(map, "Wavelength", i)));
      ASSERT_EQ(valueOf(map, "RayCount", i), 0.0);
    }
  }
  EXPECT_GT(land, 0);
}

TEST(Stations, HaveTheValuesOfTheMap)
{
  const Scene scene;
  scene.Map->SetSpacing(100.0);
  scene.Map->SetCombineRuleToPhase();
  scene.Map->Update();
  vtkImageData* map = scene.Map->GetOutput();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(map->GetPoint(i));
  }
  points->InsertNextPoint(1e6, 0.0, 0.0);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkSwellStations> stations;
  stations->SetInputConnection(0, scene.Heights->GetOutputPort());
  stations->SetSeafloorConnection(scene.Reader->GetOutputPort());
  stations->SetInputData(2, places);
  stations->SetCombineRuleToPhase();
  stations->Update();
  vtkPolyData* table = stations->GetOutput();
  ASSERT_EQ(table->GetNumberOfPoints(), map->GetNumberOfPoints() + 1);
  int reached = 0;
  for (const char* name :
    { "Elevation", "Depth", "WaveHeight", "DirectionFrom", "Wavelength", "Breaking", "LeeRay", "RayCount" })
  {
    for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
    {
      const double value = valueOf(map, name, i);
      ASSERT_TRUE(valueOf(table, name, i) == value || (std::isnan(value) && std::isnan(valueOf(table, name, i))))
        << name << ' ' << i;
      reached += valueOf(table, "RayCount", i) > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(reached, 500);
  const vtkIdType outside = map->GetNumberOfPoints();
  EXPECT_TRUE(std::isnan(valueOf(table, "Elevation", outside)));
  EXPECT_TRUE(std::isnan(valueOf(table, "WaveHeight", outside)));
  EXPECT_EQ(valueOf(table, "RayCount", outside), 0.0);
}

TEST(Map, NeedsHeights)
{
  const Scene scene;
  scene.Map->SetInputConnection(0, scene.Tracer->GetOutputPort());
  vtkNew<Listener> listener;
  listener->listenTo(scene.Map);
  scene.Map->Update();
  ASSERT_EQ(listener->Errors.size(), 1u);
  EXPECT_NE(listener->Errors[0].find("WaveHeight"), std::string::npos);
}

TEST(Map, RefusesASpacingThatMakesNoMap)
{
  for (const double spacing : { -1.0, 1e-6, std::nan("") })
  {
    const Scene scene;
    scene.Map->SetSpacing(spacing);
    vtkNew<Listener> listener;
    listener->listenTo(scene.Map);
    // The executive repeats the failure in words of its own.
    listener->listenTo(scene.Map->GetExecutive());
    scene.Map->Update();
    ASSERT_FALSE(listener->Errors.empty()) << spacing;
    EXPECT_NE(listener->Errors[0].find("pacing"), std::string::npos) << listener->Errors[0];
  }
}

}
