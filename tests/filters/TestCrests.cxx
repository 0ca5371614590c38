#include "Observers.h"

#include "sim/Angles.h"
#include "vtkSwellCrests.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"
#include "vtkSwellWaveHeight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <initializer_list>
#include <string>

namespace
{

// A phase interpolated between the two points it was looked for between: rounding of a phase of a hundred.
constexpr double PhaseTolerance = 1e-10;

// Crests of waves straight onto a plane beach are straight: linear interpolation of points on parallel rays.
constexpr double StraightTolerance = 1e-6;

/** Waves straight onto a beach facing east. */
struct Scene
{
  Scene()
  {
    this->Reader->SetFileName("plane:slope=0.02,x0=-50,y0=-500,x1=950,y1=500,facing=90");
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetDirectionFrom(90.0);
    this->Tracer->SetSpacing(20.0);
    this->Heights->SetInputConnection(this->Tracer->GetOutputPort());
    this->Crests->SetInputConnection(this->Heights->GetOutputPort());
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellCrests> Crests;
};

/** Two rays going east, two points each, one metre apart, one wavelength long, with the arrays that crests need. */
vtkSmartPointer<vtkPolyData> twoRays()
{
  auto rays = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> phase;
  phase->SetName("Phase");
  vtkNew<vtkDoubleArray> parameter;
  parameter->SetName("LaunchParameter");
  vtkNew<vtkIntArray> segment;
  segment->SetName("LaunchSegment");
  for (int ray = 0; ray < 2; ++ray)
  {
    const vtkIdType first = points->InsertNextPoint(0.0, ray, 0.0);
    lines->InsertNextCell({ first, points->InsertNextPoint(10.0, ray, 0.0) });
    phase->InsertNextValue(swellray::Pi);
    phase->InsertNextValue(swellray::Pi * 5.0);
    parameter->InsertNextValue(ray);
    segment->InsertNextValue(0);
  }
  rays->SetPoints(points);
  rays->SetLines(lines);
  rays->GetPointData()->AddArray(phase);
  rays->GetCellData()->AddArray(parameter);
  rays->GetCellData()->AddArray(segment);
  return rays;
}

void addPointArray(vtkPolyData* data, const char* name, std::initializer_list<double> values, int components = 1)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetPointData()->AddArray(array);
}

}

TEST(Crests, ofWavesStraightOntoABeachAreStraight)
{
  Scene scene;
  scene.Crests->Update();
  vtkPolyData* crests = scene.Crests->GetOutput();
  ASSERT_GT(crests->GetNumberOfLines(), 5);
  ASSERT_EQ(crests->GetNumberOfCells(), crests->GetNumberOfLines());
  EXPECT_EQ(crests->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkDataArray* number = crests->GetCellData()->GetArray("CrestNumber");
  ASSERT_NE(number, nullptr);
  EXPECT_EQ(number->GetDataType(), VTK_INT);
  vtkDataArray* phase = crests->GetPointData()->GetArray("Phase");
  for (vtkIdType crest = 0; crest < crests->GetNumberOfLines(); ++crest)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    crests->GetLines()->GetCellAtId(crest, size, points);
    ASSERT_GT(size, 10);
    for (vtkIdType i = 0; i < size; ++i)
    {
      EXPECT_NEAR(
        phase->GetComponent(points[i], 0), 2.0 * swellray::Pi * number->GetComponent(crest, 0), PhaseTolerance);
      EXPECT_NEAR(crests->GetPoint(points[i])[0], crests->GetPoint(points[0])[0], StraightTolerance);
    }
  }
}

TEST(Crests, carryTheArraysOfTheRays)
{
  Scene scene;
  scene.Crests->Update();
  vtkPointData* in = scene.Heights->GetOutput()->GetPointData();
  vtkPolyData* crests = scene.Crests->GetOutput();
  for (int i = 0; i < in->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* found = crests->GetPointData()->GetArray(in->GetArrayName(i));
    ASSERT_NE(found, nullptr) << in->GetArrayName(i);
    EXPECT_EQ(found->GetDataType(), in->GetArray(i)->GetDataType()) << in->GetArrayName(i);
    EXPECT_EQ(found->GetNumberOfTuples(), crests->GetNumberOfPoints()) << in->GetArrayName(i);
  }
  EXPECT_EQ(crests->GetFieldData()->GetArray("Period")->GetComponent(0, 0), 10.0);
}

TEST(Crests, interpolateAnglesTheShortWayRound)
{
  // Phase pi to 5 pi: crest 1 at a quarter of the way, crest 2 at three quarters.
  const vtkSmartPointer<vtkPolyData> rays = twoRays();
  addPointArray(rays, "DirectionFrom", { 350.0, 10.0, 10.0, 350.0 });
  addPointArray(rays, "Longitude", { 179.8, -179.8, -179.8, 179.8 });
  addPointArray(rays, "WaveHeight", { 1.0, 3.0, 2.0, 2.0 });
  addPointArray(rays, "Direction", { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0 }, 3);
  vtkNew<vtkSwellCrests> crests;
  crests->SetInputData(rays);
  crests->Update();
  vtkPolyData* lines = crests->GetOutput();
  ASSERT_EQ(lines->GetNumberOfLines(), 2);
  ASSERT_EQ(lines->GetNumberOfPoints(), 4);
  const auto value = [&](const char* name, vtkIdType i)
  { return lines->GetPointData()->GetArray(name)->GetComponent(i, 0); };
  constexpr double rounding = 1e-12;
  EXPECT_NEAR(lines->GetPoint(0)[0], 2.5, rounding);
  EXPECT_NEAR(value("DirectionFrom", 0), 355.0, 360.0 * rounding);
  EXPECT_NEAR(value("DirectionFrom", 1), 5.0, 360.0 * rounding);
  EXPECT_NEAR(value("DirectionFrom", 2), 5.0, 360.0 * rounding);
  EXPECT_NEAR(value("DirectionFrom", 3), 355.0, 360.0 * rounding);
  EXPECT_NEAR(value("Longitude", 0), 179.9, 360.0 * rounding);
  EXPECT_NEAR(value("Longitude", 1), -179.9, 360.0 * rounding);
  EXPECT_NEAR(value("WaveHeight", 0), 1.5, rounding);
  EXPECT_NEAR(value("WaveHeight", 2), 2.5, rounding);
  double direction[3];
  lines->GetPointData()->GetArray("Direction")->GetTuple(0, direction);
  EXPECT_NEAR(std::hypot(direction[0], direction[1]), 1.0, rounding);
  EXPECT_NEAR(direction[1] / direction[0], 1.0 / 3.0, rounding);
}

TEST(Crests, breakAtWideGaps)
{
  vtkNew<vtkSwellCrests> crests;
  crests->SetInputData(twoRays());
  crests->Update();
  EXPECT_EQ(crests->GetOutput()->GetNumberOfLines(), 2);
  crests->SetMaxGap(0.5);
  crests->Update();
  EXPECT_EQ(crests->GetOutput()->GetNumberOfLines(), 0);
}

TEST(Crests, breakAtTwiceTheDistanceAtWhichRaysWereInserted)
{
  const auto linesOf = [](double maxSpacing)
  {
    const vtkSmartPointer<vtkPolyData> rays = twoRays();
    vtkNew<vtkDoubleArray> field;
    field->SetName("MaxSpacing");
    field->InsertNextValue(maxSpacing);
    rays->GetFieldData()->AddArray(field);
    vtkNew<vtkSwellCrests> crests;
    crests->SetInputData(rays);
    crests->MaxGapOfRaysOn();
    crests->Update();
    return crests->GetOutput()->GetNumberOfLines();
  };
  EXPECT_EQ(linesOf(0.51), 2); // the rays are 1 m apart
  EXPECT_EQ(linesOf(0.49), 0);
}

TEST(Crests, ofRaysReadBackFromAFileAreTheSame)
{
  Scene scene;
  scene.Crests->Update();
  const TemporaryFolder folder;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(scene.Tracer->GetOutputPort());
  writer->SetFileName(folder.file("rays.vtp").c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("rays.vtp").c_str());
  vtkNew<vtkSwellWaveHeight> heights;
  heights->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkSwellCrests> crests;
  crests->SetInputConnection(heights->GetOutputPort());
  crests->Update();
  vtkPolyData* expected = scene.Crests->GetOutput();
  vtkPolyData* found = crests->GetOutput();
  ASSERT_GT(expected->GetNumberOfPoints(), 0);
  ASSERT_EQ(found->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(found->GetPoint(i)[0], expected->GetPoint(i)[0]);
    EXPECT_EQ(found->GetPointData()->GetArray("WaveHeight")->GetComponent(i, 0),
      expected->GetPointData()->GetArray("WaveHeight")->GetComponent(i, 0));
  }
}

TEST(Crests, sayWhatIsWrongOnce)
{
  const auto errorOf = [](vtkPolyData* rays, double maxGap)
  {
    vtkNew<vtkSwellCrests> crests;
    vtkNew<Listener> listener;
    listener->listenTo(crests);
    vtkNew<Listener> quiet;
    quiet->listenTo(crests->GetExecutive());
    crests->SetInputData(rays);
    crests->SetMaxGap(maxGap);
    crests->Update();
    EXPECT_EQ(listener->Errors.size(), 1u);
    EXPECT_EQ(crests->GetOutput()->GetNumberOfCells(), 0);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  EXPECT_THAT(errorOf(twoRays(), -1.0), testing::HasSubstr("MaxGap"));
  EXPECT_THAT(errorOf(vtkNew<vtkPolyData>(), 0.0), testing::HasSubstr("Phase"));
  const vtkSmartPointer<vtkPolyData> rays = twoRays();
  rays->GetCellData()->RemoveArray("LaunchSegment");
  EXPECT_THAT(errorOf(rays, 0.0), testing::HasSubstr("LaunchSegment"));
}
