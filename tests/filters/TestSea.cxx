// The sea filter: its mesh, its images, its times and its implicit function are one surface.
#include "Observers.h"

#include "vtkSwellSea.h"
#include "vtkSwellSeaFunction.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>

namespace
{

vtkNew<vtkSwellSea> smallSea()
{
  vtkNew<vtkSwellSea> sea;
  sea->SetSignificantHeight(1.0);
  sea->SetPeakPeriod(5.0);
  sea->SetDirectionFrom(240.0);
  sea->SetComponents(64);
  sea->SetSize(150.0);
  sea->SetSpacing(5.0);
  sea->SetTime(3.0);
  return sea;
}

double heightOf(vtkDataSet* data, vtkIdType i)
{
  return data->GetPointData()->GetArray("SurfaceHeight")->GetComponent(i, 0);
}

TEST(Sea, meshLooksUpAndStandsAtTheHeightsItTells)
{
  const auto sea = smallSea();
  sea->SetCorner(10.0, -20.0);
  sea->Update();
  vtkPolyData* mesh = sea->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfPoints(), 31 * 31);
  ASSERT_EQ(mesh->GetNumberOfPolys(), 2 * 30 * 30);
  double p[3];
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 7)
  {
    mesh->GetPoint(i, p);
    EXPECT_DOUBLE_EQ(p[0], 10.0 + 5.0 * static_cast<double>(i % 31));
    EXPECT_DOUBLE_EQ(p[1], -20.0 + 5.0 * static_cast<double>(i / 31));
    EXPECT_EQ(p[2], heightOf(mesh, i));
    EXPECT_GT(mesh->GetPointData()->GetNormals()->GetComponent(i, 2), 0.5);
  }
  vtkIdType count = 0;
  const vtkIdType* nodes = nullptr;
  mesh->GetPolys()->GetCellAtId(5, count, nodes);
  double a[3];
  double b[3];
  double c[3];
  mesh->GetPoint(nodes[0], a);
  mesh->GetPoint(nodes[1], b);
  mesh->GetPoint(nodes[2], c);
  EXPECT_GT((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0.0);
  vtkFieldData* fields = mesh->GetFieldData();
  EXPECT_NEAR(fields->GetArray("SignificantWaveHeight")->GetComponent(0, 0), 1.0, 1e-9);
  EXPECT_NEAR(fields->GetArray("PeakPeriod")->GetComponent(0, 0), 5.0, 1e-6);
  EXPECT_EQ(fields->GetArray("Time")->GetComponent(0, 0), 3.0);
  EXPECT_GT(fields->GetArray("TurbulenceAmplitude")->GetComponent(0, 0), 0.0);
  EXPECT_EQ(vtkImageData::SafeDownCast(sea->GetOutputDataObject(1))->GetNumberOfPoints(), 0);
}

TEST(Sea, imagesTile)
{
  const auto sea = smallSea();
  sea->SetTile(true);
  sea->SetImagePixels(32);
  sea->Update();
  vtkImageData* image = vtkImageData::SafeDownCast(sea->GetOutputDataObject(1));
  ASSERT_EQ(image->GetNumberOfPoints(), 32 * 32);
  EXPECT_NEAR(image->GetSpacing()[0] * 32.0, 150.0, 1e-12);
  // A patch further on is the same one.
  const auto next = smallSea();
  next->SetTile(true);
  next->SetImagePixels(32);
  next->SetCorner(150.0, -300.0);
  next->Update();
  vtkImageData* other = vtkImageData::SafeDownCast(next->GetOutputDataObject(1));
  for (vtkIdType i = 0; i < 32 * 32; i += 5)
  {
    EXPECT_NEAR(heightOf(image, i), heightOf(other, i), 1e-6); // single precision
    for (int component = 0; component < 3; ++component)
    {
      EXPECT_NEAR(image->GetPointData()->GetArray("Normals")->GetComponent(i, component),
        other->GetPointData()->GetArray("Normals")->GetComponent(i, component), 1e-5);
    }
  }
  sea->SetTile(false);
  sea->Update();
  EXPECT_NE(heightOf(image, 5), heightOf(other, 5));
}

TEST(Sea, functionIsTheSurface)
{
  const auto sea = smallSea();
  sea->Update();
  vtkSwellSeaFunction* function = sea->GetFunction();
  function->SetFootprint(5.0);
  vtkPolyData* mesh = sea->GetOutput();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 11)
  {
    double p[3];
    mesh->GetPoint(i, p);
    EXPECT_NEAR(function->EvaluateFunction(p), 0.0, 1e-9);
    p[2] += 2.0;
    EXPECT_NEAR(function->EvaluateFunction(p), 2.0, 1e-9);
  }
  double gradient[3];
  double place[3] = { 20.0, 30.0, 0.0 };
  function->EvaluateGradient(place, gradient);
  EXPECT_EQ(gradient[2], 1.0);
  const double low[3] = { 17.5, 30.0, 0.0 };
  const double high[3] = { 22.5, 30.0, 0.0 };
  double a[3] = { low[0], low[1], 0.0 };
  double b[3] = { high[0], high[1], 0.0 };
  EXPECT_NEAR(gradient[0], (function->EvaluateFunction(b) - function->EvaluateFunction(a)) / 5.0, 1e-9);

  const double eye[3] = { 0.0, 0.0, 30.0 };
  const double down[3] = { 0.0, 0.0, -3.0 };
  double foot[3] = { 0.0, 0.0, 0.0 };
  function->SetFootprint(0.0);
  EXPECT_NEAR(function->March(eye, down, 100.0, 0.0), 30.0 + function->EvaluateFunction(foot), 2e-3);
  EXPECT_LT(function->March(eye, eye, 100.0, 0.0), 0.0);

  // As VTK's own filters call it: all points at once.
  vtkNew<vtkDoubleArray> values;
  function->SetFootprint(5.0);
  function->FunctionValue(mesh->GetPoints()->GetData(), values);
  ASSERT_EQ(values->GetNumberOfTuples(), mesh->GetNumberOfPoints());
  EXPECT_NEAR(values->GetValue(40), 0.0, 1e-9);
}

TEST(Sea, goesWithTheTimesOfThePipeline)
{
  const auto sea = smallSea();
  sea->SetTimeRange(0.0, 2.0);
  sea->SetTimeStep(0.5);
  sea->UpdateInformation();
  vtkInformation* info = sea->GetOutputInformation(0);
  EXPECT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 5);
  sea->UpdateTimeStep(1.5);
  const double asked = heightOf(sea->GetOutput(), 40);
  EXPECT_EQ(sea->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 1.5);
  const auto other = smallSea();
  other->SetTime(1.5);
  other->Update();
  EXPECT_EQ(heightOf(other->GetOutput(), 40), asked);
}

TEST(Sea, isTheSameForAnyNumberOfThreads)
{
  const auto sea = smallSea();
  vtkSMPTools::Initialize(1);
  sea->Update();
  const double alone = heightOf(sea->GetOutput(), 77);
  vtkSMPTools::Initialize(2);
  sea->Modified();
  sea->Update();
  EXPECT_EQ(heightOf(sea->GetOutput(), 77), alone);
  vtkSMPTools::Initialize();
}

TEST(Sea, saysWhatIsWrong)
{
  const auto sea = smallSea();
  vtkNew<Listener> listener;
  listener->listenTo(sea);
  const auto expect = [&](const char* words)
  {
    listener->Errors.clear();
    sea->Update();
    ASSERT_FALSE(listener->Errors.empty()) << words;
    EXPECT_NE(listener->Errors.front().find(words), std::string::npos) << listener->Errors.front();
    EXPECT_EQ(sea->GetOutput()->GetNumberOfPoints(), 0);
  };
  sea->SetSize(-1.0);
  expect("Size");
  sea->SetSize(150.0);
  sea->SetSpacing(200.0);
  expect("Spacing");
  sea->SetSpacing(5.0);
  sea->SetComponents(0);
  expect("Components");
  sea->SetComponents(64);
  sea->SetImagePixels(1);
  expect("ImagePixels");
  sea->SetImagePixels(0);
  sea->SetTile(true);
  sea->SetSize(40.0);
  expect("too small");
}

}
