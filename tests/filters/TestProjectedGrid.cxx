#include "Observers.h"

#include "vtkSwellProjectedGrid.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellSurfaceProbe.h"
#include "vtkSwellWaveHeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <string>

namespace
{

/** Waves of 2 m straight onto a beach that they break on, seen from the beach. */
struct Scene
{
  explicit Scene(const std::string& seafloor = "plane:slope=0.03,x0=-30,x1=300,y0=0,y1=60")
  {
    this->Reader->SetFileName(seafloor.c_str());
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetPeriod(9.0);
    this->Tracer->SetDirectionFrom(90.0);
    this->Tracer->SetWaveHeight(2.0);
    this->Tracer->SetSpacing(5.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Grid->SetInputConnection(this->Heights->GetOutputPort());
    this->Grid->SetSeafloorConnection(this->Reader->GetOutputPort());
    this->Grid->SetSection("airy");
    this->Grid->SetCameraPosition(-10.0, 30.0, 15.0);
    this->Grid->SetCameraFocalPoint(60.0, 30.0, 0.0);
    this->Grid->SetImageSize(320, 240);
    this->Grid->SetPixelStep(4);
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellProjectedGrid> Grid;
};

// Points are floats of metres along the way, no more than some units.
constexpr double Near = 1e-5;

}

TEST(ProjectedGridFilter, isTheSurfaceAtItsPoints)
{
  Scene scene;
  scene.Grid->SetTime(4.0);
  scene.Grid->Update();
  vtkPolyData* grid = scene.Grid->GetOutput();
  ASSERT_GT(grid->GetNumberOfPoints(), 1000);
  ASSERT_GT(grid->GetNumberOfPolys(), 1500);
  vtkPointData* arrays = grid->GetPointData();
  EXPECT_STREQ(arrays->GetNormals()->GetName(), "Normals");
  EXPECT_STREQ(arrays->GetScalars()->GetName(), "Foam");
  EXPECT_STREQ(arrays->GetTCoords()->GetName(), "TextureCoordinates");
  for (const char* name : { "Period", "OriginX", "Section", "Time", "Seed" })
  {
    EXPECT_NE(grid->GetFieldData()->GetAbstractArray(name), nullptr) << name;
  }
  vtkNew<vtkSwellSurfaceProbe> probe;
  probe->SetInputConnection(scene.Heights->GetOutputPort());
  probe->SetSeafloorConnection(scene.Reader->GetOutputPort());
  probe->SetInputData(2, grid);
  probe->SetSection("airy");
  probe->SetTime(4.0);
  probe->Update();
  vtkPointData* expected = probe->GetOutput()->GetPointData();
  vtkIdType compared = 0;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    // Further away its samples resolve the waves no longer.
    if (expected->GetArray("Depth")->GetComponent(i, 0) > 0.5 && grid->GetPoint(i)[0] < 100.0)
    {
      ASSERT_NEAR(grid->GetPoint(i)[2], expected->GetArray("SurfaceElevation")->GetComponent(i, 0), Near);
      ASSERT_NEAR(arrays->GetArray("Foam")->GetComponent(i, 0), expected->GetArray("Foam")->GetComponent(i, 0), Near);
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(
          arrays->GetArray("Normals")->GetComponent(i, c), expected->GetArray("Normals")->GetComponent(i, c), Near);
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(ProjectedGridFilter, hasNoMorePointsOfALargerScene)
{
  Scene small("plane:slope=0.03,x0=-30,x1=600,y0=-100,y1=160");
  small.Grid->Update();
  Scene large("plane:slope=0.03,x0=-30,x1=600,y0=-1000,y1=1060");
  large.Grid->SetInputConnection(large.Heights->GetOutputPort());
  large.Grid->Update();
  // (320 + 2 64)/4 + 1 by (240 + 2 64)/4 + 1 samples at most.
  EXPECT_LE(large.Grid->GetOutput()->GetNumberOfPoints(), 113 * 93);
  EXPECT_GE(large.Grid->GetOutput()->GetNumberOfPoints(), small.Grid->GetOutput()->GetNumberOfPoints());
  EXPECT_LE(static_cast<double>(large.Grid->GetOutput()->GetNumberOfPoints()),
    1.3 * static_cast<double>(small.Grid->GetOutput()->GetNumberOfPoints()));
}

TEST(ProjectedGridFilter, playsWithoutTracingAgain)
{
  Scene scene;
  vtkNew<Listener> listener;
  listener->listenTo(scene.Tracer);
  scene.Grid->UpdateTimeStep(1.5);
  const double before = scene.Grid->GetOutput()->GetPoint(500)[2];
  scene.Grid->UpdateTimeStep(3.0);
  EXPECT_NE(before, scene.Grid->GetOutput()->GetPoint(500)[2]);
  EXPECT_EQ(listener->Runs, 1);
}

TEST(ProjectedGridFilter, saysWhatIsWrong)
{
  const auto errorOf = [](const auto& change)
  {
    Scene scene;
    change(scene.Grid.Get());
    vtkNew<Listener> listener;
    listener->listenTo(scene.Grid);
    EXPECT_FALSE(scene.Grid->GetExecutive()->Update());
    EXPECT_EQ(listener->Errors.size(), 1u);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  using Grid = vtkSwellProjectedGrid;
  EXPECT_THAT(
    errorOf([](Grid* grid) { grid->SetCameraPosition(0.0, 0.0, -1.0); }), testing::HasSubstr("above the water"));
  EXPECT_THAT(errorOf([](Grid* grid) { grid->SetPixelStep(0); }), testing::HasSubstr("the step must be 1"));
  EXPECT_THAT(errorOf([](Grid* grid) { grid->SetViewAngle(0.0); }), testing::HasSubstr("angle of view"));
  EXPECT_THAT(errorOf([](Grid* grid) { grid->SetCameraViewUp(0.0, 0.0, 0.0); }), testing::HasSubstr("not along up"));
  EXPECT_THAT(errorOf([](Grid* grid) { grid->SetTextureSize(0.0); }), testing::HasSubstr("TextureSize"));
  EXPECT_THAT(errorOf([](Grid* grid) { grid->SetFoamLife(-1.0); }), testing::HasSubstr("FoamLife"));
  EXPECT_THAT(errorOf([](Grid* grid) { grid->SetSection("x"); }), testing::HasSubstr("unknown wave section"));
}
