#include "Observers.h"

#include "sim/Airy.h"
#include "sim/Angles.h"
#include "sim/Dispersion.h"
#include "vtkSwellMap.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellStations.h"
#include "vtkSwellWaveHeight.h"

#include <gtest/gtest.h>

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
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

// The strip along a fold, and a seafloor whose nodes are a fifth of the Airy length apart, in incident heights of 3.8 at most.
constexpr double FoldTolerance = 2e-2;

// In incident heights, of 2.8 there.
constexpr double CuspTolerance = 0.15;

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

// k^2 falls linearly with x, so that waves at 60 degrees turn at x = 400: the Airy function, on the dark side too.
TEST(Map, OfARegularWaveGoesOnBeyondAFold)
{
  constexpr double length = 400.0;
  const double omega = 2.0 * swellray::Pi / 10.0;
  const double k0 = swellray::solveWavenumber(omega, 4.0);
  const double along = k0 * std::sin(swellray::Pi / 3.0);
  const double mu = (k0 * k0 - along * along) / length;
  vtkNew<vtkImageData> image;
  image->SetOrigin(-40.0, 0.0, 0.0);
  image->SetSpacing(10.0, 40.0, 1.0);
  image->SetDimensions(78, 101, 1);
  vtkNew<vtkDoubleArray> elevation;
  elevation->SetName("Elevation");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double k = std::sqrt(k0 * k0 - mu * image->GetPoint(i)[0]);
    elevation->InsertNextValue(-std::atanh(omega * omega / (9.81 * k)) / k);
  }
  image->GetPointData()->SetScalars(elevation);
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(image);
  tracer->SetPeriod(10.0);
  tracer->SetDirectionFrom(210.0);
  tracer->SetWaveHeight(1.0);
  tracer->SetOffshoreDepth(4.0);
  tracer->UseShoreNormalOn();
  tracer->SetShoreNormal(90.0);
  tracer->SetSpacing(10.0);
  vtkNew<vtkSwellWaveHeight> heights;
  heights->SetInputConnection(tracer->GetOutputPort());
  heights->SetBreakingRuleToNone();
  vtkNew<vtkSwellMap> map;
  map->SetInputConnection(0, heights->GetOutputPort());
  map->SetInputData(1, image);
  map->SetSpacing(20.0);
  map->SetCombineRuleToPhase();
  map->Update();
  const auto speeds = [&](double k)
  {
    const double h = std::atanh(omega * omega / (9.81 * k)) / k;
    return omega / k * (omega / k) * 0.5 * (1.0 + 2.0 * k * h / std::sinh(2.0 * k * h));
  };
  const double scale = std::cbrt(mu);
  const double incident = 2.0 * std::sqrt(swellray::Pi) * std::pow(scale * length, 0.25);
  int dark = 0;
  for (vtkIdType i = 0; i < map->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double* place = map->GetOutput()->GetPoint(i);
    if (place[1] < 2900.0 || place[1] > 3500.0 || place[0] < 200.0 || place[0] > length + 3.0 / scale)
    {
      continue;
    }
    const double k = std::sqrt(k0 * k0 - mu * place[0]);
    const double exact =
      std::abs(incident * swellray::airy(-scale * (length - place[0])).value) * std::sqrt(speeds(k0) / speeds(k));
    ASSERT_NEAR(valueOf(map->GetOutput(), "WaveHeight", i), exact, FoldTolerance) << place[0] << ' ' << place[1];
    dark += valueOf(map->GetOutput(), "RayCount", i) == 0.0 ? 1 : 0;
  }
  EXPECT_GT(dark, 50);
}

// The places where rays touch caustics travel with them: without these there is a sum of rays.
TEST(Map, OfARegularWaveHasBeamsAroundACusp)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName("shoal:kind=poly3,depth=15,height=10.5,radius=250,x0=-500,x1=800,y0=-700,y1=700");
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(reader->GetOutputPort());
  tracer->SetPeriod(8.0);
  tracer->SetDirectionFrom(270.0);
  tracer->SetWaveHeight(1.0);
  tracer->SetOffshoreDepth(15.0);
  tracer->SetSpacing(10.0);
  vtkNew<vtkSwellWaveHeight> heights;
  heights->SetInputConnection(tracer->GetOutputPort());
  heights->SetBreakingRuleToNone();
  heights->Update();
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(heights->GetOutput());
  bare->GetFieldData()->RemoveArray("CausticPoints");
  // |eta| on the axis at x = 125 m, by partial waves of the mild-slope equation.
  constexpr double exact = 2.848;
  for (const bool whole : { true, false })
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(125.0, 0.0, 0.0);
    vtkNew<vtkPolyData> places;
    places->SetPoints(points);
    vtkNew<vtkSwellStations> stations;
    stations->SetInputData(0, whole ? static_cast<vtkPolyData*>(heights->GetOutput()) : bare.GetPointer());
    stations->SetSeafloorConnection(reader->GetOutputPort());
    stations->SetInputData(2, places);
    stations->SetCombineRuleToPhase();
    stations->Update();
    const double error = std::abs(valueOf(stations->GetOutput(), "WaveHeight", 0) - exact);
    EXPECT_EQ(error < CuspTolerance, whole) << error;
  }
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
