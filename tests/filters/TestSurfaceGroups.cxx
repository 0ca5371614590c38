#include "Observers.h"

#include "vtkSwellFoam.h"
#include "vtkSwellFoamMap.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellSpray.h"
#include "vtkSwellSurface.h"
#include "vtkSwellSurfaceProbe.h"
#include "vtkSwellWaveHeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace
{

/** Waves of 2 m straight onto a beach that they break on. */
struct Scene
{
  Scene()
  {
    this->Reader->SetFileName("plane:slope=0.03,x0=-30,x1=300,y0=0,y1=60");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetPeriod(Period);
    this->Tracer->SetDirectionFrom(90.0);
    this->Tracer->SetWaveHeight(2.0);
    this->Tracer->SetSpacing(5.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
  }

  template <typename Filter>
  void join(Filter* filter) const
  {
    filter->SetInputConnection(this->Heights->GetOutputPort());
    filter->SetSeafloorConnection(this->Reader->GetOutputPort());
    filter->SetSection("airy");
    filter->SetGroupWaves(7.0);
    filter->SetGroupLull(0.1);
  }

  static constexpr double Period = 9.0;

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
};

// Places on edges are looked up 1e-10 of the scene beside them, on slopes below 1.
constexpr double Beside = 4e-8;

}

TEST(SurfaceGroups, areTheSameOnTheMeshAndWithoutIt)
{
  Scene scene;
  vtkNew<vtkSwellSurface> surface;
  scene.join(surface.Get());
  vtkNew<vtkSwellFoam> foam;
  foam->SetInputConnection(surface->GetOutputPort());
  for (const double time : { 0.0, 3.5 * Scene::Period, 400.0 })
  {
    surface->SetTime(time);
    foam->Update();
    vtkPolyData* mesh = foam->GetOutput();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    std::vector<vtkIdType> chosen;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 7)
    {
      const double* place = mesh->GetPoint(i);
      if (mesh->GetPointData()->GetArray("Depth")->GetComponent(i, 0) > 1.0 && place[1] > 7.0 && place[1] < 53.0)
      {
        points->InsertNextPoint(place);
        chosen.push_back(i);
      }
    }
    ASSERT_GT(chosen.size(), 50u);
    vtkNew<vtkPolyData> places;
    places->SetPoints(points);
    vtkNew<vtkSwellSurfaceProbe> probe;
    scene.join(probe.Get());
    probe->SetTime(time);
    probe->SetInputData(2, places);
    probe->Update();
    vtkPointData* values = probe->GetOutput()->GetPointData();
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      const auto at = static_cast<vtkIdType>(i);
      EXPECT_NEAR(values->GetArray("SurfaceElevation")->GetComponent(at, 0), mesh->GetPoint(chosen[i])[2], Beside);
      EXPECT_NEAR(values->GetArray("Foam")->GetComponent(at, 0),
        mesh->GetPointData()->GetArray("Foam")->GetComponent(chosen[i], 0), 1e-5);
    }
  }
}

TEST(SurfaceGroups, leaveLessFoamAndSprayBetweenThem)
{
  Scene scene;
  vtkNew<vtkSwellFoamMap> map;
  scene.join(map.Get());
  map->SetSpacing(3.0);
  vtkNew<vtkSwellSpray> spray;
  scene.join(spray.Get());
  double mostFoam = 0.0;
  double leastFoam = 1e9;
  vtkIdType mostSpray = 0;
  vtkIdType leastSpray = VTK_ID_MAX;
  for (double time = 0.0; time < 7.0 * Scene::Period; time += 4.5)
  {
    map->UpdateTimeStep(time);
    spray->UpdateTimeStep(time);
    vtkDataArray* foam = map->GetOutput()->GetPointData()->GetArray("Foam");
    double sum = 0.0;
    for (vtkIdType i = 0; i < foam->GetNumberOfTuples(); ++i)
    {
      sum += std::isnan(foam->GetComponent(i, 0)) ? 0.0 : foam->GetComponent(i, 0);
    }
    mostFoam = std::max(mostFoam, sum);
    leastFoam = std::min(leastFoam, sum);
    mostSpray = std::max(mostSpray, spray->GetOutput()->GetNumberOfPoints());
    leastSpray = std::min(leastSpray, spray->GetOutput()->GetNumberOfPoints());
  }
  // Waves of a tenth of the height break in a tenth of the surf's width.
  EXPECT_GT(mostFoam, 4.0 * leastFoam);
  EXPECT_GT(mostSpray, 100);
  EXPECT_GT(mostSpray, 10 * leastSpray);
}

TEST(SurfaceGroups, sayWhatIsWrong)
{
  Scene scene;
  vtkNew<vtkSwellSurface> surface;
  scene.join(surface.Get());
  vtkNew<Listener> listener;
  listener->listenTo(surface);
  surface->SetGroupWaves(1.5);
  EXPECT_FALSE(surface->GetExecutive()->Update());
  surface->SetGroupWaves(7.0);
  surface->SetGroupLull(2.0);
  EXPECT_FALSE(surface->GetExecutive()->Update());
  ASSERT_EQ(listener->Errors.size(), 2u);
  EXPECT_THAT(listener->Errors[0], testing::HasSubstr("waves of a group must be 2"));
  EXPECT_THAT(listener->Errors[1], testing::HasSubstr("share of the lowest must be 0 to 1"));
}
