#include "Observers.h"

#include "vtkSwellFoam.h"
#include "vtkSwellFoamMap.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellSurface.h"
#include "vtkSwellWaveHeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>
#include <vector>

namespace
{

/** Waves of 2 m straight onto a beach that they break on. */
struct Scene
{
  Scene()
  {
    this->Reader->SetFileName("plane:slope=0.03,x0=-30,x1=300,y0=0,y1=60");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetPeriod(9.0);
    this->Tracer->SetDirectionFrom(90.0);
    this->Tracer->SetWaveHeight(2.0);
    this->Tracer->SetSpacing(5.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Map->SetInputConnection(this->Heights->GetOutputPort());
    this->Map->SetSeafloorConnection(this->Reader->GetOutputPort());
    this->Map->SetSpacing(1.0);
  }

  std::vector<double> foam(double time)
  {
    this->Map->UpdateTimeStep(time);
    vtkDataArray* array = this->Map->GetOutput()->GetPointData()->GetArray("Foam");
    std::vector<double> values;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i, 0));
    }
    return values;
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellFoamMap> Map;
};

// Nodes lie between the points of the surface, whose foam changes by 1 over a sixteenth of a wave where it sets in.
constexpr double BetweenPoints = 0.02;

}

TEST(FoamMap, isTheFoamOfTheStillSurface)
{
  Scene scene;
  const auto foam = scene.foam(7.0);
  vtkImageData* map = scene.Map->GetOutput();
  EXPECT_EQ(map->GetDimensions()[0], 331);
  EXPECT_EQ(map->GetDimensions()[1], 61);
  EXPECT_STREQ(map->GetPointData()->GetScalars()->GetName(), "Foam");
  for (const char* name : { "Period", "OriginX", "Section", "Time", "Seed" })
  {
    EXPECT_NE(map->GetFieldData()->GetAbstractArray(name), nullptr) << name;
  }
  vtkNew<vtkSwellSurface> surface;
  surface->SetInputConnection(scene.Heights->GetOutputPort());
  surface->SetSeafloorConnection(scene.Reader->GetOutputPort());
  surface->SetTime(7.0);
  surface->StillOn();
  vtkNew<vtkSwellFoam> onSurface;
  onSurface->SetInputConnection(surface->GetOutputPort());
  onSurface->Update();
  vtkPolyData* points = onSurface->GetOutput();
  vtkDataArray* expected = points->GetPointData()->GetArray("Foam");
  int compared = 0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    // The columns of nodes to either side of a point; a wave that comes, and one that has just passed, differ by 1.
    const double x = points->GetPoint(i)[0] - map->GetOrigin()[0];
    const double y = points->GetPoint(i)[1] - map->GetOrigin()[1];
    if (x < 0.0 || y < 0.0 || x >= 330.0 || y > 60.0)
    {
      continue;
    }
    const auto west = static_cast<std::size_t>(std::lround(y) * 331 + std::floor(x));
    const double a = foam[west];
    const double b = foam[west + 1];
    const double between = a + (x - std::floor(x)) * (b - a);
    const double here = expected->GetComponent(i, 0);
    if (here > 0.05 && here < 0.9 && std::abs(a - b) < 0.1)
    {
      EXPECT_NEAR(between, here, BetweenPoints) << points->GetPoint(i)[0];
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(FoamMap, playsWithoutTracingAgainAndFramesStandAlone)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  Scene scene;
  scene.Map->SetTimeRange(1.0, 2.0);
  scene.Map->SetTimeStep(0.25);
  scene.Map->UpdateInformation();
  EXPECT_EQ(scene.Map->GetOutputInformation(0)->Length(Pipeline::TIME_STEPS()), 5);
  vtkNew<Listener> listener;
  listener->listenTo(scene.Tracer);
  const auto first = scene.foam(1.5);
  const auto second = scene.foam(4.0);
  EXPECT_EQ(listener->Runs, 1);
  Scene alone;
  const auto expected = alone.foam(4.0);
  ASSERT_EQ(second.size(), expected.size());
  int differ = 0;
  for (std::size_t i = 0; i < second.size(); ++i)
  {
    ASSERT_TRUE(second[i] == expected[i] || (std::isnan(second[i]) && std::isnan(expected[i])));
    differ += first[i] != second[i] && !std::isnan(first[i]) ? 1 : 0;
  }
  EXPECT_GT(differ, 100);
}

TEST(FoamMap, followsItsGridAndItsWaves)
{
  Scene scene;
  const auto fine = scene.foam(7.0);
  scene.Map->SetSpacing(2.0);
  const auto coarse = scene.foam(7.0);
  ASSERT_EQ(coarse.size(), 166u * 31u);
  EXPECT_EQ(coarse[15 * 166 + 50], fine[30 * 331 + 100]);
  scene.Map->SetFoamLife(2.0);
  const auto brief = scene.foam(7.0);
  double more = 0.0;
  double less = 0.0;
  for (std::size_t i = 0; i < coarse.size(); ++i)
  {
    more += std::isnan(coarse[i]) ? 0.0 : coarse[i];
    less += std::isnan(brief[i]) ? 0.0 : brief[i];
  }
  EXPECT_GT(more, 2.0 * less);
  // Another wave, from further to the right: the most foam counts.
  vtkNew<vtkSwellRayTracer> other;
  other->SetInputConnection(scene.Reader->GetOutputPort());
  other->SetPeriod(7.0);
  other->SetDirectionFrom(80.0);
  other->SetWaveHeight(3.0);
  other->SetSpacing(5.0);
  vtkNew<vtkSwellWaveHeight> heights;
  heights->SetInputConnection(other->GetOutputPort());
  scene.Map->AddInputConnection(0, heights->GetOutputPort());
  const auto both = scene.foam(7.0);
  int grown = 0;
  for (std::size_t i = 0; i < both.size(); ++i)
  {
    ASSERT_FALSE(both[i] < brief[i]);
    grown += both[i] > brief[i] ? 1 : 0;
  }
  EXPECT_GT(grown, 50);
}

TEST(FoamMap, saysWhatIsWrong)
{
  const auto errorOf = [](const auto& change)
  {
    Scene scene;
    change(scene);
    vtkNew<Listener> listener;
    listener->listenTo(scene.Map);
    EXPECT_FALSE(scene.Map->GetExecutive()->Update());
    EXPECT_EQ(listener->Errors.size(), 1u);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Map->SetFoamLife(0.0); }), testing::HasSubstr("FoamLife is 0"));
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Map->SetSection("vortx"); }), testing::HasSubstr("did you mean"));
  EXPECT_THAT(
    errorOf([](Scene& scene) { scene.Map->SetPointsPerWave(3.0); }), testing::HasSubstr("PointsPerWave is 3"));
  EXPECT_THAT(errorOf([](Scene& scene) { scene.Map->SetInputConnection(scene.Tracer->GetOutputPort()); }),
    testing::HasSubstr("WaveHeight"));
}
