#include "Observers.h"

#include "bathymetry/Georeference.h"
#include "vtkSwellPlaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <cmath>
#include <vector>

namespace
{

// Rounding of coordinates of some hundred kilometres.
constexpr double Rounding = 1e-9;

/** A scene that has nothing but its place. */
vtkSmartPointer<vtkPolyData> sceneAt(const std::string& crs, const std::vector<std::pair<const char*, double>>& origin)
{
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  for (const auto& [name, value] : origin)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    scene->GetFieldData()->AddArray(array);
  }
  if (!crs.empty())
  {
    vtkNew<vtkStringArray> words;
    words->SetName("CRS");
    words->InsertNextValue(swellray::crsToWkt(crs));
    scene->GetFieldData()->AddArray(words);
  }
  return scene;
}

vtkSmartPointer<vtkPolyData> pointsAt(const std::vector<std::array<double, 3>>& places)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> number;
  number->SetName("Number");
  for (const auto& place : places)
  {
    number->InsertNextValue(static_cast<double>(points->InsertNextPoint(place.data())));
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(number);
  return data;
}

TEST(Places, ofAProjectedFileAreShiftedByTheOrigin)
{
  vtkNew<vtkSwellPlaces> places;
  places->SetInputData(0, pointsAt({ { 100500.0, 502000.0, 7.0 } }));
  places->SetInputData(1, sceneAt("EPSG:28992", { { "OriginX", 100000.0 }, { "OriginY", 500000.0 } }));
  places->Update();
  vtkPointSet* found = places->GetPolyDataOutput();
  ASSERT_EQ(found->GetNumberOfPoints(), 1);
  EXPECT_NEAR(found->GetPoint(0)[0], 500.0, Rounding);
  EXPECT_NEAR(found->GetPoint(0)[1], 2000.0, Rounding);
  EXPECT_EQ(found->GetPoint(0)[2], 7.0);
  EXPECT_NE(found->GetPointData()->GetArray("Number"), nullptr);
  EXPECT_EQ(found->GetFieldData()->GetArray("OriginX")->GetComponent(0, 0), 100000.0);
}

TEST(Places, ofLongitudeAndLatitudeGoThereAndBack)
{
  const auto scene = sceneAt("EPSG:4326", { { "OriginLongitude", -73.0 }, { "OriginLatitude", 40.0 } });
  vtkNew<vtkSwellPlaces> there;
  there->SetInputData(0, pointsAt({ { -73.0, 40.0, 0.0 }, { -73.0, 40.0 + 1.0 / 60.0, 0.0 } }));
  there->SetInputData(1, scene);
  vtkNew<vtkSwellPlaces> back;
  back->SetInputConnection(0, there->GetOutputPort());
  back->SetInputData(1, scene);
  back->SetWayToFile();
  back->Update();
  // A minute of arc on the meridian at 40 degrees: 1850.5 m on WGS 84 (Snyder 1987, eq. 4-19: M = 6,361,816 m).
  EXPECT_NEAR(there->GetPolyDataOutput()->GetPoint(1)[1], 6361816.0 * std::acos(-1.0) / 180.0 / 60.0, 0.5);
  EXPECT_NEAR(back->GetPolyDataOutput()->GetPoint(1)[0], -73.0, Rounding);
  EXPECT_NEAR(back->GetPolyDataOutput()->GetPoint(1)[1], 40.0 + 1.0 / 60.0, Rounding);
}

TEST(Places, sayWhatIsWrongOnce)
{
  const auto errorOf = [](double x, double y)
  {
    vtkNew<vtkSwellPlaces> places;
    vtkNew<Listener> listener;
    listener->listenTo(places);
    vtkNew<Listener> quiet;
    quiet->listenTo(places->GetExecutive());
    places->SetInputData(0, pointsAt({ { -73.0, 40.0, 0.0 }, { x, y, 0.0 } }));
    places->SetInputData(1, sceneAt("EPSG:4326", { { "OriginLongitude", -73.0 }, { "OriginLatitude", 40.0 } }));
    places->Update();
    EXPECT_EQ(listener->Errors.size(), 1u);
    EXPECT_EQ(places->GetPolyDataOutput()->GetNumberOfPoints(), 0);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  EXPECT_THAT(errorOf(40.0, -93.0), testing::HasSubstr("point 1 of 2 has the latitude -93"));
  EXPECT_THAT(errorOf(NAN, 40.0), testing::HasSubstr("no number"));
}

}
