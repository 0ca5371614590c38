#include "Observers.h"

#include "vtkSwellFoam.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellSurface.h"
#include "vtkSwellWaveHeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

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
    this->Surface->SetSection("jeschke");
    this->Foam->SetInputConnection(this->Surface->GetOutputPort());
  }

  std::vector<double> positions(double time)
  {
    this->Surface->UpdateTimeStep(time);
    return copy(this->Surface->GetOutput()->GetPoints()->GetData());
  }

  static std::vector<double> copy(vtkDataArray* array)
  {
    std::vector<double> values;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        values.push_back(array->GetComponent(i, c));
      }
    }
    return values;
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellSurface> Surface;
  vtkNew<vtkSwellFoam> Foam;
};

}

TEST(Surface, hasTheArraysThatItPromises)
{
  Scene scene;
  scene.Foam->Update();
  vtkPolyData* surface = scene.Foam->GetOutput();
  ASSERT_GT(surface->GetNumberOfPoints(), 1000);
  EXPECT_EQ(surface->GetNumberOfCells(), surface->GetPolys()->GetNumberOfCells());
  EXPECT_EQ(surface->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkPointData* arrays = surface->GetPointData();
  const auto expectArray = [&](const char* name, int type, int components)
  {
    vtkDataArray* array = arrays->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetDataType(), type) << name;
    EXPECT_EQ(array->GetNumberOfComponents(), components) << name;
    EXPECT_EQ(array->GetNumberOfTuples(), surface->GetNumberOfPoints()) << name;
  };
  expectArray("Normals", VTK_FLOAT, 3);
  expectArray("Velocity", VTK_FLOAT, 3);
  expectArray("TextureCoordinates", VTK_FLOAT, 2);
  expectArray("Depth", VTK_DOUBLE, 1);
  expectArray("Phase", VTK_DOUBLE, 1);
  expectArray("RayPhase", VTK_DOUBLE, 1);
  expectArray("BreakingPhase", VTK_DOUBLE, 1);
  expectArray("LaunchParameter", VTK_DOUBLE, 1);
  expectArray("WaveHeight", VTK_DOUBLE, 1);
  expectArray("Breaking", VTK_UNSIGNED_CHAR, 1);
  expectArray("RayState", VTK_UNSIGNED_CHAR, 1);
  expectArray("Foam", VTK_FLOAT, 1);
  EXPECT_STREQ(arrays->GetNormals()->GetName(), "Normals");
  EXPECT_STREQ(arrays->GetTCoords()->GetName(), "TextureCoordinates");
  EXPECT_STREQ(arrays->GetScalars()->GetName(), "Foam");
  EXPECT_EQ(arrays->GetArray("Breaking")->GetRange()[1], 1.0);
  for (const char* name : { "Period", "OriginX", "OriginY", "Section", "Time", "WaterLevel" })
  {
    EXPECT_NE(surface->GetFieldData()->GetAbstractArray(name), nullptr) << name;
  }
}

TEST(Surface, playsInThePipelineWithoutTracingAgain)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  Scene scene;
  scene.Surface->SetTimeRange(1.0, 2.0);
  scene.Surface->SetTimeStep(0.25);
  scene.Surface->UpdateInformation();
  vtkInformation* info = scene.Surface->GetOutputInformation(0);
  ASSERT_TRUE(info->Has(Pipeline::TIME_STEPS()));
  ASSERT_EQ(info->Length(Pipeline::TIME_STEPS()), 5);
  EXPECT_EQ(info->Get(Pipeline::TIME_STEPS(), 4), 2.0);
  EXPECT_EQ(info->Get(Pipeline::TIME_RANGE(), 0), 1.0);

  vtkNew<Listener> listener;
  listener->listenTo(scene.Tracer);
  const auto first = scene.positions(1.5);
  EXPECT_EQ(scene.Surface->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 1.5);
  const auto second = scene.positions(1.75);
  EXPECT_NE(first, second);
  EXPECT_EQ(first, scene.positions(1.5));
  EXPECT_EQ(listener->Runs, 1);

  // What another pipeline makes of the same frame without the one before.
  Scene alone;
  EXPECT_EQ(second, alone.positions(1.75));
}

TEST(Surface, takesItsOwnTimeWhereThePipelineAsksForNone)
{
  Scene asked;
  const auto expected = asked.positions(4.0);
  Scene scene;
  scene.Surface->SetTime(4.0);
  scene.Surface->Update();
  EXPECT_EQ(expected, Scene::copy(scene.Surface->GetOutput()->GetPoints()->GetData()));
}

TEST(Surface, isTheSameForAnyNumberOfThreads)
{
  std::vector<double> expected;
  std::vector<double> foam;
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::Initialize(threads);
    Scene scene;
    scene.Surface->SetTime(3.0);
    scene.Foam->Update();
    const auto positions = Scene::copy(scene.Foam->GetOutput()->GetPoints()->GetData());
    const auto foamNow = Scene::copy(scene.Foam->GetOutput()->GetPointData()->GetArray("Foam"));
    if (expected.empty())
    {
      expected = positions;
      foam = foamNow;
    }
    EXPECT_EQ(expected, positions) << threads;
    EXPECT_EQ(foam, foamNow) << threads;
  }
  vtkSMPTools::Initialize(0);
}

TEST(Surface, looksUpWhereItIsStillAndOverhangsWhereItBreaks)
{
  Scene scene;
  const auto down = [&]
  {
    vtkPolyData* surface = scene.Surface->GetOutput();
    vtkIdType count = 0;
    for (vtkIdType i = 0; i < surface->GetPolys()->GetNumberOfCells(); ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      surface->GetPolys()->GetCellAtId(i, size, corners);
      double a[3], b[3], c[3];
      surface->GetPoint(corners[0], a);
      surface->GetPoint(corners[1], b);
      surface->GetPoint(corners[2], c);
      count += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < -1e-9 ? 1 : 0;
    }
    return count;
  };
  scene.Surface->StillOn();
  scene.Surface->Update();
  EXPECT_EQ(down(), 0);
  scene.Surface->StillOff();
  scene.Surface->SetTime(3.0);
  scene.Surface->Update();
  EXPECT_GT(down(), 0);
}

TEST(Surface, staysAboveTheGround)
{
  Scene scene;
  for (const char* section : { "gonzato-lesaec", "jeschke", "fournier-reeves" })
  {
    scene.Surface->SetSection(section);
    scene.Surface->Update();
    vtkPolyData* surface = scene.Surface->GetOutput();
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double point[3];
      surface->GetPoint(i, point);
      ASSERT_GE(point[2], -0.03 * point[0] - 1e-6) << section;
    }
  }
}

TEST(Surface, reachesTheBeachWithoutAGapAndCarriesNothingPastIt)
{
  Scene scene;
  scene.Reader->SetFileName("bay");
  scene.Tracer->SetPeriod(3.0);
  scene.Tracer->SetDirectionFrom(90.0);
  scene.Tracer->SetWaveHeight(0.5);
  scene.Tracer->SetSpacing(1.0);
  scene.Surface->SetTime(3.0);
  scene.Surface->Update();
  vtkPolyData* surface = scene.Surface->GetOutput();
  vtkDataArray* depth = surface->GetPointData()->GetArray("Depth");
  vtkDataArray* state = surface->GetPointData()->GetArray("RayState");
  constexpr double aground = 0.05 * 0.5;
  constexpr double tolerance = 1e-4; // of the depth contour that rays follow
  std::map<std::pair<vtkIdType, vtkIdType>, int> uses;
  for (vtkIdType i = 0; i < surface->GetPolys()->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    surface->GetPolys()->GetCellAtId(i, size, corners);
    for (int c = 0; c < 3; ++c)
    {
      ++uses[std::minmax(corners[c], corners[(c + 1) % 3])];
    }
  }
  const auto onShore = [&](vtkIdType i) { return std::abs(depth->GetComponent(i, 0) - aground) < tolerance; };
  int beach = 0;
  int open = 0;
  for (const auto& [edge, count] : uses)
  {
    open += count == 1 && onShore(edge.first) && onShore(edge.second) && state->GetComponent(edge.first, 0) != 1.0 &&
        state->GetComponent(edge.second, 0) != 1.0
      ? 1
      : 0;
    beach += depth->GetComponent(edge.first, 0) < 0.0 && depth->GetComponent(edge.second, 0) < 0.0 ? 1 : 0;
  }
  EXPECT_GT(beach, 100);
  EXPECT_LE(open, 2); // where the scene ends beside the beach
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    if (depth->GetComponent(i, 0) > 0.0)
    {
      // A bed that bends over the few metres to the shore: a fifth of the depth.
      ASSERT_GT(depth->GetComponent(i, 0), 0.8 * aground);
    }
  }
}

TEST(Surface, straightPhaseIsAnOption)
{
  Scene scene;
  scene.Surface->SetSection("airy");
  scene.Surface->Update();
  const auto traced = Scene::copy(scene.Surface->GetOutput()->GetPointData()->GetArray("RayPhase"));
  const auto height = Scene::copy(scene.Surface->GetOutput()->GetPointData()->GetArray("WaveHeight"));
  scene.Surface->SetPhaseRuleToStraight();
  scene.Foam->Update();
  vtkPolyData* surface = scene.Foam->GetOutput();
  const auto straight = Scene::copy(surface->GetPointData()->GetArray("RayPhase"));
  EXPECT_NE(traced, straight);
  vtkDataArray* depth = surface->GetPointData()->GetArray("Depth");
  for (std::size_t i = 0; i < straight.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    if (depth->GetComponent(id, 0) > 2.0)
    {
      // A crest stands where it is a multiple of 2 pi; positions are doubles.
      ASSERT_NEAR(surface->GetPoint(id)[2], 0.5 * height[i] * std::cos(straight[i]), 1e-9);
    }
  }
}

TEST(Surface, pointsPerWaveFollowTheSectionOrTheSetting)
{
  Scene scene;
  scene.Surface->SetSection("airy");
  scene.Surface->Update();
  const vtkIdType sixteen = scene.Surface->GetOutput()->GetNumberOfPoints();
  scene.Surface->SetPointsPerWave(32.0);
  scene.Surface->Update();
  EXPECT_GT(scene.Surface->GetOutput()->GetNumberOfPoints(), 1.5 * sixteen);
  scene.Surface->SetPointsPerWave(0.0);
  scene.Surface->SetSection("jeschke");
  scene.Surface->Update();
  EXPECT_GT(scene.Surface->GetOutput()->GetNumberOfPoints(), 2.0 * sixteen);
}

TEST(Surface, parametersOfTheSectionMayStandApart)
{
  Scene scene;
  const auto pointsWith = [&](const char* section, const char* parameters)
  {
    scene.Surface->SetSection(section);
    scene.Surface->SetSectionParameters(parameters);
    scene.Surface->Update();
    return Scene::copy(scene.Surface->GetOutput()->GetPoints()->GetData());
  };
  const auto together = pointsWith("vortex:steepness=0.3", "");
  EXPECT_EQ(pointsWith("vortex", "steepness=0.3"), together);
  EXPECT_NE(pointsWith("vortex", ""), together);
}

TEST(Surface, saysWhatIsWrong)
{
  const auto errorOf = [](const auto& change)
  {
    Scene scene;
    change(scene);
    vtkNew<Listener> listener;
    listener->listenTo(scene.Surface);
    EXPECT_FALSE(scene.Surface->GetExecutive()->Update());
    EXPECT_EQ(listener->Errors.size(), 1u);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  EXPECT_THAT(
    errorOf([](Scene& scene) { scene.Surface->SetSection("jeshke"); }), testing::HasSubstr("did you mean 'jeschke'"));
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Surface->SetPointsPerWave(8.0); }), testing::HasSubstr("16 or more"));
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Surface->SetTimeStep(0.0); }), testing::HasSubstr("TimeStep"));
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Surface->SetTimeRange(2.0, 1.0); }), testing::HasSubstr("TimeRange"));
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Surface->SetTextureSize(0.0); }), testing::HasSubstr("TextureSize"));
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Surface->SetInputConnection(scene.Tracer->GetOutputPort()); }),
    testing::HasSubstr("WaveHeight"));
}

TEST(Foam, liesWhereWavesHaveBrokenAndNowhereElse)
{
  Scene scene;
  scene.Surface->SetTime(5.0);
  scene.Foam->Update();
  vtkPolyData* surface = scene.Foam->GetOutput();
  vtkDataArray* foam = surface->GetPointData()->GetArray("Foam");
  vtkDataArray* began = surface->GetPointData()->GetArray("BreakingPhase");
  vtkDataArray* phase = surface->GetPointData()->GetArray("RayPhase");
  vtkIdType foamy = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    ASSERT_GE(foam->GetComponent(i, 0), 0.0);
    ASSERT_LE(foam->GetComponent(i, 0), 1.0);
    if (!(phase->GetComponent(i, 0) >= began->GetComponent(i, 0)))
    {
      ASSERT_EQ(foam->GetComponent(i, 0), 0.0);
    }
    foamy += foam->GetComponent(i, 0) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(foamy, surface->GetNumberOfPoints() / 20);
}

TEST(Foam, isTheSameOnStillWater)
{
  Scene scene;
  scene.Surface->SetTime(5.0);
  scene.Foam->Update();
  const auto moved = Scene::copy(scene.Foam->GetOutput()->GetPointData()->GetArray("Foam"));
  scene.Surface->StillOn();
  scene.Foam->Update();
  EXPECT_EQ(moved, Scene::copy(scene.Foam->GetOutput()->GetPointData()->GetArray("Foam")));
}

TEST(Foam, saysWhatIsWrong)
{
  Scene scene;
  scene.Foam->SetInputConnection(scene.Heights->GetOutputPort());
  vtkNew<Listener> listener;
  listener->listenTo(scene.Foam);
  EXPECT_FALSE(scene.Foam->GetExecutive()->Update());
  ASSERT_EQ(listener->Errors.size(), 1u);
  EXPECT_THAT(listener->Errors.front(), testing::HasSubstr("vtkSwellSurface"));
  scene.Foam->SetInputConnection(scene.Surface->GetOutputPort());
  scene.Foam->SetLife(0.0);
  EXPECT_FALSE(scene.Foam->GetExecutive()->Update());
}
