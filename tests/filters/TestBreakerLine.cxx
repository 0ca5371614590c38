#include "Observers.h"

#include "vtkSwellBreakerLine.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellWaveHeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <functional>
#include <string>

namespace
{

/** Waves onto a plane beach that faces east, 20 degrees from the south of it. */
struct Scene
{
  Scene()
  {
    this->Reader->SetFileName("plane:slope=0.02,x0=-50,y0=-500,x1=950,y1=500");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetDirectionFrom(110.0);
    this->Tracer->SetWaveHeight(1.5);
    this->Tracer->SetSpacing(20.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Lines->SetInputConnection(this->Heights->GetOutputPort());
    this->Lines->SetSeafloorConnection(this->Reader->GetOutputPort());
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellBreakerLine> Lines;
};

double valueOf(vtkPolyData* data, const char* name, vtkIdType i)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetComponent(i, 0) : 0.0;
}

}

TEST(BreakerLine, hasWhatItsClassCommentSays)
{
  Scene scene;
  scene.Lines->Update();
  vtkPolyData* lines = scene.Lines->GetOutput();
  ASSERT_EQ(lines->GetNumberOfLines(), 1);
  EXPECT_EQ(lines->GetCellData()->GetArray("BreakerNumber")->GetComponent(0, 0), 1.0);
  EXPECT_EQ(lines->GetFieldData()->GetArray("Period")->GetComponent(0, 0), 10.0);
  const vtkIdType i = lines->GetNumberOfPoints() / 2;
  const double depth = valueOf(lines, "BreakerDepth", i);
  EXPECT_NEAR(valueOf(lines, "BreakerHeight", i), 0.78 * depth, 1e-9);
  EXPECT_NEAR(lines->GetPoint(i)[0], 50.0 * depth, 1e-6);
  // Up the bed is west; the wave goes west and a little north: to the right, and so does the sand.
  EXPECT_LT(valueOf(lines, "BreakerAngle", i), -5.0);
  EXPECT_GT(valueOf(lines, "BreakerAngle", i), -20.0);
  EXPECT_NEAR(
    valueOf(lines, "PeelAngle", i), -valueOf(lines, "BreakerAngle", i), 0.5); // straight to the eighth of a wave
  EXPECT_LT(valueOf(lines, "LongshoreEnergyFlux", i), 0.0);
  EXPECT_LT(valueOf(lines, "LongshoreTransport", i), 0.0);
  EXPECT_GT(valueOf(lines, "IribarrenNumber", i), valueOf(lines, "BreakerIribarrenNumber", i));
  EXPECT_EQ(valueOf(lines, "BreakerType", i), 1.0);
  EXPECT_EQ(valueOf(lines, "BreakerTypeAtBreaking", i), 1.0);
  EXPECT_TRUE(std::isnan(valueOf(lines, "VortexRatio", i))); // 1:50
  EXPECT_LT(valueOf(lines, "SetDown", i), 0.0);
  EXPECT_GT(valueOf(lines, "SetUp", i), 0.0);
  EXPECT_GT(valueOf(lines, "MaximumSetUp", i), valueOf(lines, "SetUp", i));
}

TEST(BreakerLine, followsTheRuleOfTheHeights)
{
  Scene scene;
  scene.Heights->SetBreakingRuleToBattjesJanssen();
  scene.Lines->Update();
  EXPECT_GT(scene.Lines->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_NE(scene.Heights->GetOutput()->GetPointData()->GetArray("BrokenShare"), nullptr);
  scene.Heights->SetBreakingRuleToNone();
  scene.Lines->Update();
  EXPECT_EQ(scene.Lines->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scene.Heights->GetOutput()->GetPointData()->GetArray("BrokenShare"), nullptr);
}

TEST(BreakerLine, endsAtGaps)
{
  Scene scene;
  scene.Lines->SetMaxGap(10.0);
  scene.Lines->Update();
  EXPECT_EQ(scene.Lines->GetOutput()->GetNumberOfPoints(), 0);
  scene.Lines->MaxGapOfRaysOn();
  scene.Lines->Update();
  EXPECT_GT(scene.Lines->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(BreakerLine, saysWhatIsWrongOnce)
{
  const auto errorOf = [](const std::function<void(Scene&)>& spoil)
  {
    Scene scene;
    vtkNew<Listener> listener;
    listener->listenTo(scene.Lines);
    vtkNew<Listener> quiet;
    quiet->listenTo(scene.Lines->GetExecutive());
    spoil(scene);
    scene.Lines->Update();
    EXPECT_EQ(listener->Errors.size(), 1u);
    EXPECT_EQ(scene.Lines->GetOutput()->GetNumberOfPoints(), 0);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  EXPECT_THAT(errorOf([](Scene& s) { s.Lines->SetMaxGap(-1.0); }), testing::HasSubstr("MaxGap"));
  EXPECT_THAT(errorOf([](Scene& s) { s.Lines->SetInputConnection(s.Tracer->GetOutputPort()); }),
    testing::HasSubstr("RefractionCoefficient"));
  EXPECT_THAT(errorOf([](Scene& s) { s.Lines->SetInputData(vtkNew<vtkPolyData>()); }), testing::HasSubstr("Period"));
}
