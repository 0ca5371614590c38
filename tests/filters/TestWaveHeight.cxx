#include "Observers.h"

#include "sim/WaveHeight.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellWaveHeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace
{

/** A beach, its rays and their heights. */
struct Scene
{
  Scene()
  {
    this->Reader->SetFileName("plane:slope=0.02,x0=-50,y0=-500,x1=950,y1=500");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetDirectionFrom(60.0);
    this->Tracer->SetWaveHeight(1.5);
    this->Tracer->SetSpacing(20.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
};

double* valuesOf(vtkPolyData* data, const char* name)
{
  auto* array = vtkDoubleArray::SafeDownCast(data->GetPointData()->GetArray(name));
  return array ? array->GetPointer(0) : nullptr;
}

unsigned char* bytesOf(vtkPolyData* data, const char* name)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetArray(name));
  return array ? array->GetPointer(0) : nullptr;
}

}

TEST(WaveHeight, isThatOfTheCoreAlongEachRay)
{
  Scene scene;
  scene.Heights->Update();
  vtkPolyData* data = scene.Heights->GetOutput();
  swellray::IncidentWave wave;
  wave.period = 10.0;
  wave.directionFrom = 60.0;
  wave.height = 1.5;
  const double* refraction = valuesOf(data, "RefractionCoefficient");
  const double* height = valuesOf(data, "WaveHeight");
  const double* energyFlux = valuesOf(data, "EnergyFlux");
  const double* orbitalVelocity = valuesOf(data, "OrbitalVelocity");
  const unsigned char* breaking = bytesOf(data, "Breaking");
  ASSERT_TRUE(refraction && height && energyFlux && orbitalVelocity && breaking);
  vtkIdType broken = 0;
  for (vtkIdType ray = 0; ray < data->GetNumberOfLines(); ++ray)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    data->GetLines()->GetCellAtId(ray, size, points);
    const vtkIdType first = points[0];
    swellray::RayProfile profile;
    profile.count = static_cast<std::size_t>(size);
    profile.position = vtkDoubleArray::SafeDownCast(data->GetPoints()->GetData())->GetPointer(0) + 3 * first;
    profile.travelTime = valuesOf(data, "TravelTime") + first;
    profile.depth = valuesOf(data, "Depth") + first;
    profile.wavenumber = valuesOf(data, "Wavenumber") + first;
    profile.groupSpeed = valuesOf(data, "GroupSpeed") + first;
    profile.shoaling = valuesOf(data, "ShoalingCoefficient") + first;
    profile.krSpacing = valuesOf(data, "KrSpacing") + first;
    profile.krTube = valuesOf(data, "KrTube") + first;
    profile.state = bytesOf(data, "RayState") + first;
    swellray::RayHeights expected;
    swellray::computeHeights(profile, wave, {}, expected);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      ASSERT_EQ(refraction[first + i], expected.refraction[at]);
      ASSERT_EQ(height[first + i], expected.height[at]);
      ASSERT_EQ(energyFlux[first + i], expected.energyFlux[at]);
      ASSERT_EQ(orbitalVelocity[first + i], expected.orbitalVelocity[at]);
      ASSERT_EQ(breaking[first + i], expected.breaking[at]);
      broken += breaking[first + i];
    }
  }
  EXPECT_GT(broken, 0);
}

TEST(WaveHeight, sharesTheRaysAndLeavesThemAlone)
{
  Scene scene;
  scene.Heights->Update();
  vtkPolyData* rays = scene.Tracer->GetOutput();
  vtkPolyData* data = scene.Heights->GetOutput();
  EXPECT_EQ(data->GetPoints(), rays->GetPoints());
  EXPECT_EQ(data->GetPointData()->GetArray("Phase"), rays->GetPointData()->GetArray("Phase"));
  EXPECT_EQ(rays->GetPointData()->GetArray("WaveHeight"), nullptr);
  EXPECT_EQ(data->GetFieldData()->GetArray("Period")->GetComponent(0, 0), 10.0);
}

TEST(WaveHeight, optionsDoNotTraceAgain)
{
  Scene scene;
  vtkNew<Listener> ofTracer;
  ofTracer->listenTo(scene.Tracer);
  vtkNew<Listener> ofHeights;
  ofHeights->listenTo(scene.Heights);
  scene.Heights->Update();
  scene.Heights->SetGamma(0.5);
  scene.Heights->Update();
  scene.Heights->SetBreakingRuleToNone();
  scene.Heights->Update();
  EXPECT_EQ(ofTracer->Runs, 1);
  EXPECT_EQ(ofHeights->Runs, 3);
  // Rays aground have the height their depth allows, whatever the rule.
  vtkPolyData* data = scene.Heights->GetOutput();
  const unsigned char* breaking = bytesOf(data, "Breaking");
  const unsigned char* state = bytesOf(data, "RayState");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    ASSERT_FALSE(breaking[i] && state[i] == static_cast<unsigned char>(swellray::RayState::Alive)) << i;
  }
  scene.Tracer->SetPeriod(7.0);
  scene.Heights->Update();
  EXPECT_EQ(ofTracer->Runs, 2);
  EXPECT_EQ(ofHeights->Runs, 4);
}

TEST(WaveHeight, takesTheRuleThatIsAskedFor)
{
  Scene scene;
  scene.Heights->SetAmplitudeRuleToTube();
  scene.Heights->Update();
  vtkPolyData* data = scene.Heights->GetOutput();
  EXPECT_EQ(valuesOf(data, "RefractionCoefficient")[5], valuesOf(data, "KrTube")[5]);
  const double tube = valuesOf(data, "KrTube")[5];
  scene.Heights->SetMaxRefraction(0.5 * tube);
  scene.Heights->Update();
  EXPECT_EQ(valuesOf(scene.Heights->GetOutput(), "RefractionCoefficient")[5], 0.5 * tube);
}

TEST(WaveHeight, isTheSameOnOneThreadAndOnTwo)
{
  std::vector<double> heights[2];
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        Scene scene;
        scene.Heights->Update();
        const double* values = valuesOf(scene.Heights->GetOutput(), "WaveHeight");
        heights[threads - 1].assign(values, values + scene.Heights->GetOutput()->GetNumberOfPoints());
      });
  }
  EXPECT_EQ(heights[0], heights[1]);
}

TEST(WaveHeight, insertedRaysBeginWithTheLossesOfTheirParents)
{
  Scene scene;
  scene.Reader->SetFileName("shoal");
  scene.Tracer->SetDirectionFrom(270.0);
  scene.Tracer->SetSpacing(100.0);
  scene.Tracer->SetMaxSpacing(110.0);
  scene.Heights->SetBreakingRuleToNone();
  scene.Heights->SetFriction(0.5);
  scene.Heights->Update();
  vtkPolyData* data = scene.Heights->GetOutput();
  const double* friction = valuesOf(data, "FrictionCoefficient");
  const double* phase = valuesOf(data, "Phase");
  ASSERT_TRUE(friction && phase);
  vtkDataArray* parents = data->GetCellData()->GetArray("ParentRay");
  int inserted = 0;
  for (vtkIdType ray = 0; ray < data->GetNumberOfLines(); ++ray)
  {
    const auto parent = static_cast<vtkIdType>(parents->GetComponent(ray, 0));
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    data->GetLines()->GetCellAtId(ray, size, points);
    const vtkIdType first = points[0];
    if (parent < 0)
    {
      ASSERT_EQ(friction[first], 1.0);
      continue;
    }
    data->GetLines()->GetCellAtId(parent, size, points);
    const vtkIdType* beside =
      std::find_if(points, points + size, [&](vtkIdType i) { return std::abs(phase[i] - phase[first]) < 1e-6; });
    ASSERT_NE(beside, points + size) << ray;
    ASSERT_EQ(friction[first], friction[*beside]) << ray;
    inserted += friction[first] < 0.9999 ? 1 : 0;
  }
  EXPECT_GT(inserted, 0);
}

TEST(WaveHeight, isThatOfNeighboursWhereTheSheetFolds)
{
  // Two folds of this beach run on between rays that touch them and rays that reach the beach beside them.
  Scene scene;
  scene.Reader->SetFileName("babbage");
  scene.Tracer->SetPeriod(6.0);
  scene.Tracer->SetDirectionFrom(0.0);
  scene.Tracer->SetWaveHeight(1.0);
  scene.Tracer->SetSpacing(10.0);
  scene.Heights->Update();
  vtkPolyData* data = scene.Heights->GetOutput();
  const double* phase = valuesOf(data, "Phase");
  const double* refraction = valuesOf(data, "RefractionCoefficient");
  const double* tube = valuesOf(data, "KrTube");
  const unsigned char* state = bytesOf(data, "RayState");
  vtkDataArray* touched = data->GetPointData()->GetArray("Caustics");
  vtkDataArray* parameter = data->GetCellData()->GetArray("LaunchParameter");
  std::vector<vtkIdType> row(static_cast<std::size_t>(data->GetNumberOfLines()));
  std::iota(row.begin(), row.end(), 0);
  std::sort(row.begin(), row.end(),
    [&](vtkIdType a, vtkIdType b) { return parameter->GetComponent(a, 0) < parameter->GetComponent(b, 0); });
  double largest = 1.0;
  double ofTubes = 1.0;
  for (std::size_t i = 1; i < row.size(); ++i)
  {
    vtkIdType sizeA = 0;
    vtkIdType sizeB = 0;
    const vtkIdType* pointsA = nullptr;
    const vtkIdType* pointsB = nullptr;
    data->GetLines()->GetCellAtId(row[i - 1], sizeA, pointsA);
    const std::vector<vtkIdType> a(pointsA, pointsA + sizeA);
    data->GetLines()->GetCellAtId(row[i], sizeB, pointsB);
    for (vtkIdType j = 0; j < sizeB; ++j)
    {
      const vtkIdType b = pointsB[j];
      const auto found =
        std::find_if(a.begin(), a.end(), [&](vtkIdType p) { return std::abs(phase[p] - phase[b]) < 1e-6; });
      if (found == a.end() || state[*found] != 1 || state[b] != 1 ||
        touched->GetComponent(*found, 0) == touched->GetComponent(b, 0))
      {
        continue;
      }
      const double ratio = refraction[*found] / refraction[b];
      largest = std::max({ largest, ratio, 1.0 / ratio });
      ofTubes = std::max({ ofTubes, tube[*found], tube[b] });
    }
  }
  // Rays are about half a wavelength apart there. Without the folds beside them some are twice as high as the next.
  EXPECT_LT(largest, 1.5);
  EXPECT_GT(ofTubes, 2.0);
}

TEST(WaveHeight, stopsWhenAsked)
{
  Scene scene;
  vtkNew<Listener> listener;
  listener->AbortAt = 0.0;
  listener->listenTo(scene.Heights);
  scene.Heights->Update();
  EXPECT_TRUE(listener->Errors.empty());
  EXPECT_EQ(scene.Heights->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(WaveHeight, ofNoRaysIsNothing)
{
  Scene scene;
  scene.Tracer->Update();
  vtkNew<vtkPolyData> none;
  none->SetFieldData(scene.Tracer->GetOutput()->GetFieldData());
  for (int i = 0; i < scene.Tracer->GetOutput()->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = scene.Tracer->GetOutput()->GetPointData()->GetArray(i)->NewInstance();
    array->SetName(scene.Tracer->GetOutput()->GetPointData()->GetArrayName(i));
    none->GetPointData()->AddArray(array);
    array->Delete();
  }
  vtkNew<Listener> listener;
  listener->listenTo(scene.Heights);
  scene.Heights->SetInputData(none);
  scene.Heights->Update();
  EXPECT_TRUE(listener->Errors.empty());
  EXPECT_EQ(scene.Heights->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(WaveHeight, saysWhatIsWrongOnce)
{
  const auto errorOf = [](const std::function<void(Scene&)>& spoil)
  {
    Scene scene;
    vtkNew<Listener> listener;
    listener->listenTo(scene.Heights);
    vtkNew<Listener> quiet;
    quiet->listenTo(scene.Heights->GetExecutive());
    spoil(scene);
    scene.Heights->Update();
    EXPECT_EQ(listener->Errors.size(), 1u);
    EXPECT_EQ(scene.Heights->GetOutput()->GetNumberOfPoints(), 0);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  EXPECT_THAT(errorOf([](Scene& s) { s.Heights->SetGamma(-1.0); }), testing::HasSubstr("gamma"));
  EXPECT_THAT(errorOf([](Scene& s) { s.Heights->SetInputData(vtkNew<vtkPolyData>()); }), testing::HasSubstr("Period"));
  const auto spoilCopy = [&](const std::function<void(vtkPolyData*)>& spoil)
  {
    return errorOf(
      [&](Scene& s)
      {
        s.Tracer->Update();
        vtkNew<vtkPolyData> copy;
        copy->ShallowCopy(s.Tracer->GetOutput());
        spoil(copy);
        s.Heights->SetInputData(copy);
      });
  };
  EXPECT_THAT(spoilCopy([](vtkPolyData* d) { d->GetPointData()->RemoveArray("Depth"); }), testing::HasSubstr("Depth"));
  EXPECT_THAT(spoilCopy(
                [](vtkPolyData* d)
                {
                  vtkNew<vtkCellArray> other;
                  other->InsertNextCell({ 1, 0 });
                  d->SetLines(other);
                }),
    testing::HasSubstr("not rays"));
}
