#include "Observers.h"

#include "vtkSwellFoam.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellSpray.h"
#include "vtkSwellSurface.h"
#include "vtkSwellSurfaceProbe.h"
#include "vtkSwellWaveHeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

/** Waves of 2 m aslant onto a beach that they break on. */
struct Scene
{
  Scene()
  {
    this->Reader->SetFileName("plane:slope=0.03,x0=-30,x1=300,y0=0,y1=60");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetPeriod(9.0);
    this->Tracer->SetDirectionFrom(80.0);
    this->Tracer->SetWaveHeight(2.0);
    this->Tracer->SetSpacing(5.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Surface->SetInputConnection(this->Heights->GetOutputPort());
    this->Surface->SetSeafloorConnection(this->Reader->GetOutputPort());
    this->Spray->SetInputConnection(this->Heights->GetOutputPort());
    this->Spray->SetSeafloorConnection(this->Reader->GetOutputPort());
    this->Foam->SetInputConnection(this->Surface->GetOutputPort());
    this->Probe->SetInputConnection(this->Heights->GetOutputPort());
    this->Probe->SetSeafloorConnection(this->Reader->GetOutputPort());
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellSurface> Surface;
  vtkNew<vtkSwellFoam> Foam;
  vtkNew<vtkSwellSpray> Spray;
  vtkNew<vtkSwellSurfaceProbe> Probe;
};

// Depth of breaking of this wave, H = 0.78 h, with some height to spare.
constexpr double DeepestSpray = 4.0;

}

TEST(Spray, hasTheArraysThatItPromisesWhereWavesBreak)
{
  Scene scene;
  scene.Spray->SetTime(5.0);
  scene.Spray->Update();
  vtkPolyData* spray = scene.Spray->GetOutput();
  ASSERT_GT(spray->GetNumberOfPoints(), 100);
  EXPECT_EQ(spray->GetNumberOfVerts(), spray->GetNumberOfPoints());
  vtkPointData* arrays = spray->GetPointData();
  ASSERT_NE(arrays->GetArray("Velocity"), nullptr);
  EXPECT_EQ(arrays->GetArray("Velocity")->GetNumberOfComponents(), 3);
  EXPECT_STREQ(arrays->GetVectors()->GetName(), "Velocity");
  EXPECT_EQ(arrays->GetArray("Source")->GetRange()[1], 0.0); // no obstacles
  EXPECT_GE(arrays->GetArray("Age")->GetRange()[0], 0.0);
  for (const char* name : { "Period", "OriginX", "Section", "Time", "Seed" })
  {
    EXPECT_NE(spray->GetFieldData()->GetAbstractArray(name), nullptr) << name;
  }
  for (vtkIdType i = 0; i < spray->GetNumberOfPoints(); ++i)
  {
    // Thrown shorewards, that is to -x, from where the bed is at -0.03 x.
    const double start = spray->GetPoint(i)[0] -
      arrays->GetArray("Age")->GetComponent(i, 0) * arrays->GetArray("Velocity")->GetComponent(i, 0);
    ASSERT_LT(0.03 * start, DeepestSpray);
  }
}

TEST(Spray, playsInThePipelineAndRepeats)
{
  Scene scene;
  scene.Spray->SetTimeRange(1.0, 2.0);
  scene.Spray->SetTimeStep(0.25);
  scene.Spray->UpdateInformation();
  EXPECT_EQ(scene.Spray->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 5);
  vtkNew<Listener> listener;
  listener->listenTo(scene.Tracer);
  scene.Spray->UpdateTimeStep(1.5);
  const vtkIdType first = scene.Spray->GetOutput()->GetNumberOfPoints();
  const double place = scene.Spray->GetOutput()->GetPoint(0)[0];
  scene.Spray->UpdateTimeStep(1.75);
  EXPECT_NE(place, scene.Spray->GetOutput()->GetPoint(0)[0]);
  scene.Spray->UpdateTimeStep(1.5);
  EXPECT_EQ(first, scene.Spray->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(place, scene.Spray->GetOutput()->GetPoint(0)[0]);
  EXPECT_EQ(listener->Runs, 1);
  scene.Spray->SetRate(0.0);
  scene.Spray->UpdateTimeStep(1.5);
  EXPECT_EQ(scene.Spray->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(Spray, saysWhatIsWrong)
{
  const auto errorOf = [](const auto& change)
  {
    Scene scene;
    change(scene);
    vtkNew<Listener> listener;
    listener->listenTo(scene.Spray);
    EXPECT_FALSE(scene.Spray->GetExecutive()->Update());
    EXPECT_EQ(listener->Errors.size(), 1u);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Spray->SetRate(-1.0); }), testing::HasSubstr("the rate"));
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Spray->SetSection("x"); }), testing::HasSubstr("unknown wave section"));
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Spray->SetTimeStep(0.0); }), testing::HasSubstr("TimeStep"));
}

TEST(Spray, isThrownByEveryWaveAndRaisedByTheOthers)
{
  Scene scene;
  scene.Spray->SetSection("airy");
  scene.Spray->SetTime(5.0);
  scene.Spray->Update();
  vtkNew<vtkPolyData> alone;
  alone->DeepCopy(scene.Spray->GetOutput());
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(scene.Reader->GetOutputPort());
  tracer->SetPeriod(7.0);
  tracer->SetDirectionFrom(100.0);
  tracer->SetWaveHeight(1.5);
  tracer->SetSpacing(5.0);
  vtkNew<vtkSwellWaveHeight> heights;
  heights->SetInputConnection(tracer->GetOutputPort());
  scene.Spray->AddInputConnection(0, heights->GetOutputPort());
  scene.Spray->Update();
  vtkPolyData* both = scene.Spray->GetOutput();
  ASSERT_GT(both->GetNumberOfPoints(), alone->GetNumberOfPoints() + 50);

  // The first wave's come first; each by the height of the second where it was thrown.
  vtkNew<vtkPoints> starts;
  starts->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  for (vtkIdType i = 0; i < alone->GetNumberOfPoints(); ++i)
  {
    const double age = alone->GetPointData()->GetArray("Age")->GetComponent(i, 0);
    const double* point = alone->GetPoint(i);
    const double* velocity = alone->GetPointData()->GetArray("Velocity")->GetTuple(i);
    starts->InsertNextPoint(point[0] - age * velocity[0], point[1] - age * velocity[1], 0.0);
    times->InsertNextValue(5.0 - age);
  }
  vtkNew<vtkPolyData> asked;
  asked->SetPoints(starts);
  asked->GetPointData()->AddArray(times);
  scene.Probe->SetInputConnection(0, heights->GetOutputPort());
  scene.Probe->SetSection("airy");
  scene.Probe->SetInputData(2, asked);
  scene.Probe->Update();
  vtkDataArray* elevation = scene.Probe->GetOutput()->GetPointData()->GetArray("SurfaceElevation");
  int raised = 0;
  for (vtkIdType i = 0; i < alone->GetNumberOfPoints(); ++i)
  {
    const double second = std::isfinite(elevation->GetComponent(i, 0)) ? elevation->GetComponent(i, 0) : 0.0;
    // Ages and velocities are floats.
    EXPECT_NEAR(both->GetPoint(i)[2], alone->GetPoint(i)[2] + second, 1e-4);
    raised += std::abs(second) > 0.05 ? 1 : 0;
  }
  EXPECT_GT(raised, 50);
}

TEST(SurfaceProbe, meetsThePointsOfTheSurface)
{
  Scene scene;
  for (const std::string section : { "airy", "jeschke" })
  {
    scene.Surface->SetSection(section);
    scene.Surface->SetTime(3.0);
    scene.Foam->Update();
    vtkPolyData* surface = scene.Foam->GetOutput();
    vtkNew<vtkPolyData> points;
    points->SetPoints(surface->GetPoints());
    scene.Probe->SetSection(section);
    scene.Probe->SetTime(3.0);
    scene.Probe->SetInputData(2, points);
    scene.Probe->Update();
    vtkPointData* values = scene.Probe->GetOutput()->GetPointData();
    int inside = 0;
    int equal = 0;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double z = surface->GetPoint(i)[2];
      const double found = values->GetArray("SurfaceElevation")->GetComponent(i, 0);
      if (!std::isfinite(found) || values->GetArray("Waves")->GetComponent(i, 0) != 1.0 ||
        surface->GetPointData()->GetArray("RayState")->GetComponent(i, 0) != 1.0)
      {
        continue; // at the edges and on the shore
      }
      ++inside;
      // Found by their place: slopes of up to 1 times a millimetre; places between the rays have bent ones around.
      equal += std::abs(found - z) < 1e-3 ? 1 : 0;
    }
    EXPECT_GT(inside, 0.8 * static_cast<double>(surface->GetNumberOfPoints())) << section;
    EXPECT_GT(equal, (section == "airy" ? 0.99 : 0.7) * inside) << section;
  }
}

TEST(SurfaceProbe, takesTheTimeOfEachPointAndLeavesDryOnesEmpty)
{
  Scene scene;
  scene.Probe->SetSection("airy");
  vtkNew<vtkPolyData> asked;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  for (const double time : { 0.0, 4.5, 9.0 })
  {
    points->InsertNextPoint(200.0, 30.0, 77.0);
    times->InsertNextValue(time);
  }
  points->InsertNextPoint(-20.0, 30.0, 0.0); // on land
  times->InsertNextValue(0.0);
  asked->SetPoints(points);
  asked->GetPointData()->AddArray(times);
  scene.Probe->SetInputData(2, asked);
  scene.Probe->Update();
  vtkDataArray* elevation = scene.Probe->GetOutput()->GetPointData()->GetArray("SurfaceElevation");
  ASSERT_EQ(elevation->GetNumberOfTuples(), 4);
  // A period later the same, half a period later the opposite.
  EXPECT_NEAR(elevation->GetComponent(0, 0), elevation->GetComponent(2, 0), 1e-9);
  EXPECT_NEAR(elevation->GetComponent(0, 0), -elevation->GetComponent(1, 0), 1e-9);
  EXPECT_GT(std::abs(elevation->GetComponent(0, 0)), 0.05);
  EXPECT_TRUE(std::isnan(elevation->GetComponent(3, 0)));
  EXPECT_EQ(scene.Probe->GetOutput()->GetPoint(0)[2], points->GetPoint(0)[2]);

  scene.Probe->SetFoamLife(-1.0);
  vtkNew<Listener> listener;
  listener->listenTo(scene.Probe);
  EXPECT_FALSE(scene.Probe->GetExecutive()->Update());
  ASSERT_EQ(listener->Errors.size(), 1u);
  EXPECT_THAT(listener->Errors.front(), testing::HasSubstr("life"));
}

TEST(SurfaceProbe, playsWherePointsHaveNoTime)
{
  Scene scene;
  scene.Probe->SetSection("airy");
  vtkNew<vtkPolyData> asked;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(200.0, 30.0, 0.0);
  asked->SetPoints(points);
  scene.Probe->SetInputData(2, asked);
  const auto elevationAt = [&](double time)
  {
    scene.Probe->UpdateTimeStep(time);
    return scene.Probe->GetOutput()->GetPointData()->GetArray("SurfaceElevation")->GetComponent(0, 0);
  };
  // The period is 9 s.
  const double first = elevationAt(0.0);
  EXPECT_NEAR(elevationAt(4.5), -first, 1e-9);
  EXPECT_NEAR(elevationAt(9.0), first, 1e-9);
  EXPECT_GT(std::abs(first), 0.05);
}

TEST(Surface, addsTheHeightsOfOtherWaves)
{
  Scene scene;
  vtkNew<vtkSwellRayTracer> tracer;
  vtkNew<vtkSwellWaveHeight> heights;
  tracer->SetInputConnection(scene.Reader->GetOutputPort());
  tracer->SetPeriod(4.0);
  tracer->SetDirectionFrom(95.0);
  tracer->SetWaveHeight(0.2);
  tracer->SetSpacing(2.0);
  heights->SetInputConnection(tracer->GetOutputPort());
  scene.Surface->SetSection("airy");
  scene.Surface->SetTime(3.0);
  scene.Surface->SetPointsPerWave(48.0);
  scene.Tracer->SetSpacing(2.0);
  scene.Surface->Update();
  vtkNew<vtkPolyData> alone;
  alone->DeepCopy(scene.Surface->GetOutput());
  scene.Surface->AddInputConnection(0, heights->GetOutputPort());
  scene.Surface->Update();
  vtkPolyData* both = scene.Surface->GetOutput();
  ASSERT_EQ(both->GetNumberOfPoints(), alone->GetNumberOfPoints());

  scene.Probe->AddInputConnection(0, heights->GetOutputPort());
  vtkNew<vtkPolyData> points;
  points->SetPoints(alone->GetPoints());
  scene.Probe->SetSection("airy");
  scene.Probe->SetPointsPerWave(48.0);
  scene.Probe->SetTime(3.0);
  scene.Probe->SetInputData(2, points);
  scene.Probe->Update();
  vtkDataArray* elevation = scene.Probe->GetOutput()->GetPointData()->GetArray("SurfaceElevation");
  vtkDataArray* waves = scene.Probe->GetOutput()->GetPointData()->GetArray("Waves");
  int compared = 0;
  double changed = 0.0;
  for (vtkIdType i = 0; i < both->GetNumberOfPoints(); ++i)
  {
    changed = std::max(changed, std::abs(both->GetPoint(i)[2] - alone->GetPoint(i)[2]));
    // In deep water the points resolve the wave of 4 s, 25 m long, but for long triangles along the sides.
    const double y = both->GetPoint(i)[1];
    if (waves->GetComponent(i, 0) == 2.0 && both->GetPoint(i)[0] > 200.0 && y > 10.0 && y < 50.0)
    {
      ASSERT_NEAR(both->GetPoint(i)[2], elevation->GetComponent(i, 0), 1e-3) << both->GetPoint(i)[0] << " " << y;
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(changed, 0.08);
  EXPECT_LT(changed, 0.2);
}
