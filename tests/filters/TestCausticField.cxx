#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellWaveHeight.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

/** Rays over a round shoal, which cross behind it. */
struct Shoal
{
  Shoal()
  {
    this->Reader->SetFileName("shoal:kind=poly3");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetPeriod(8.0);
    this->Tracer->SetDirectionFrom(270.0);
    this->Tracer->SetOffshoreDepth(15.0);
    this->Tracer->SetSpacing(10.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Heights->SetBreakingRuleToNone();
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
};

vtkDataArray* causticsOf(vtkPolyData* rays)
{
  return rays->GetFieldData()->GetArray("CausticPoints");
}

std::vector<double> refractions(vtkPolyData* rays)
{
  vtkNew<vtkSwellWaveHeight> heights;
  heights->SetInputData(rays);
  heights->SetBreakingRuleToNone();
  heights->Update();
  auto* array = vtkDoubleArray::SafeDownCast(heights->GetOutput()->GetPointData()->GetArray("RefractionCoefficient"));
  EXPECT_TRUE(array);
  return { array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues() };
}

}

TEST(CausticField, comesBackFromAFile)
{
  Shoal shoal;
  shoal.Tracer->Update();
  vtkPolyData* rays = shoal.Tracer->GetOutput();
  vtkDataArray* before = causticsOf(rays);
  ASSERT_TRUE(before);
  ASSERT_GT(before->GetNumberOfTuples(), 10);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(rays);
  writer->WriteToOutputStringOn();
  writer->Write();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  vtkDataArray* after = causticsOf(reader->GetOutput());
  ASSERT_TRUE(after);
  ASSERT_EQ(after->GetNumberOfTuples(), before->GetNumberOfTuples());
  ASSERT_EQ(after->GetNumberOfComponents(), before->GetNumberOfComponents());
  EXPECT_STREQ(after->GetComponentName(11), "WidthRate");
  for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < before->GetNumberOfComponents(); ++c)
    {
      const double a = before->GetComponent(i, c);
      const double b = after->GetComponent(i, c);
      ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << a << ", " << b;
    }
  }
  EXPECT_EQ(refractions(reader->GetOutput()), refractions(rays));
}

TEST(CausticField, followsItsRaysByTheirIdentity)
{
  Shoal shoal;
  shoal.Tracer->Update();
  vtkNew<vtkPolyData> rays;
  rays->DeepCopy(shoal.Tracer->GetOutput());
  const std::vector<double> expected = refractions(rays);
  auto* id = vtkIntArray::SafeDownCast(rays->GetCellData()->GetArray("RayId"));
  vtkDataArray* caustics = causticsOf(rays);
  ASSERT_TRUE(id && caustics);
  for (vtkIdType ray = 0; ray < id->GetNumberOfValues(); ++ray)
  {
    id->SetValue(ray, id->GetValue(ray) + 1000);
  }
  EXPECT_NE(refractions(rays), expected); // nobody's caustics: capped
  for (vtkIdType i = 0; i < caustics->GetNumberOfTuples(); ++i)
  {
    caustics->SetComponent(i, 0, caustics->GetComponent(i, 0) + 1000.0);
  }
  EXPECT_EQ(refractions(rays), expected);
}

TEST(CausticField, isNotThereWithoutCaustics)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName("plane:slope=0.02,x0=-50,y0=-300,x1=450,y1=300");
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(reader->GetOutputPort());
  tracer->SetDirectionFrom(90.0);
  tracer->Update();
  EXPECT_FALSE(causticsOf(tracer->GetOutput()));
}

TEST(CausticField, decidesWhatHappensToHeights)
{
  for (const int amplitude : { vtkSwellWaveHeight::SPACING, vtkSwellWaveHeight::TUBE })
  {
    Shoal shoal;
    shoal.Heights->SetAmplitudeRule(amplitude);
    // Rays that touch a caustic; others leave the scene on their way to one, and are capped.
    const auto highest = [&]
    {
      shoal.Heights->Update();
      vtkPolyData* rays = shoal.Heights->GetOutput();
      vtkDataArray* values = rays->GetPointData()->GetArray("RefractionCoefficient");
      vtkDataArray* caustics = rays->GetPointData()->GetArray("Caustics");
      double most = 0.0;
      for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
      {
        most = caustics->GetComponent(i, 0) > 0.0 ? std::max(most, values->GetComponent(i, 0)) : most;
      }
      return most;
    };
    shoal.Heights->SetCausticRuleToGeometric();
    EXPECT_GT(highest(), 5.0);
    shoal.Heights->SetCausticRuleToCap();
    EXPECT_EQ(highest(), 3.0);
    shoal.Heights->SetCausticRuleToUniform();
    const double uniform = highest();
    // Highest in the cusp: 1.601 (k/l2)^(1/4) of roundedCurvature(), k = 0.089 rad/m, l2 = 0.0079 1/m.
    EXPECT_NEAR(uniform, 2.93, 0.02);
    shoal.Heights->SetMaxRefraction(1.5);
    EXPECT_NEAR(highest(), uniform, 1e-12); // its own peak is its limit
  }
}
