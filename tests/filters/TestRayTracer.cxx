#include "Observers.h"

#include "sim/Angles.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

namespace
{

// Snell's law along rays integrated to 1e-8 a step.
constexpr double SnellTolerance = 1e-6;

// Depths of a formula against the depths of the rays on it: rounding.
constexpr double DepthTolerance = 1e-9;

vtkSmartPointer<vtkSwellSeafloorReader> builtin(const char* spec)
{
  auto reader = vtkSmartPointer<vtkSwellSeafloorReader>::New();
  reader->SetFileName(spec);
  return reader;
}

// A small coast: 1 km of beach facing east.
constexpr const char* Beach = "plane:slope=0.02,x0=-50,y0=-500,x1=950,y1=500";

// As a grid with a hole.
vtkSmartPointer<vtkImageData> griddedBeach(double x0 = -50.0, double y0 = -500.0)
{
  return elevationImage(
    201, 201, 5.0,
    [=](double x, double y)
    { return std::hypot(x - 400.0, y) < 40.0 ? std::nan("") : -0.02 * x - 0.5 * std::sin(0.01 * y); },
    x0, y0);
}

void fromTheEast(vtkSwellRayTracer* tracer)
{
  tracer->SetDirectionFrom(70.0);
  tracer->SetPeriod(8.0);
  tracer->SetSpacing(20.0);
}

double fieldNumber(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

// Every number of the output, bit by bit.
std::map<std::string, std::string> bytesOf(vtkPolyData* data)
{
  std::map<std::string, std::string> result;
  const auto add = [&](const std::string& name, vtkDataArray* array)
  {
    result[name] = std::string(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
  };
  add("points", data->GetPoints()->GetData());
  add("offsets", data->GetLines()->GetOffsetsArray());
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    add(std::string("point ") + data->GetPointData()->GetArrayName(i), data->GetPointData()->GetArray(i));
  }
  for (int i = 0; i < data->GetCellData()->GetNumberOfArrays(); ++i)
  {
    add(std::string("cell ") + data->GetCellData()->GetArrayName(i), data->GetCellData()->GetArray(i));
  }
  return result;
}

}

TEST(RayTracer, takesAnOffshoreDepthOfZeroForDeepWater)
{
  vtkNew<vtkSwellRayTracer> tracer;
  const auto reader = builtin(Beach);
  tracer->SetInputConnection(reader->GetOutputPort());
  fromTheEast(tracer);
  tracer->Update();
  const auto deep = bytesOf(tracer->GetOutput());
  tracer->SetOffshoreDepth(20.0);
  tracer->Update();
  EXPECT_NE(bytesOf(tracer->GetOutput()), deep);
  tracer->SetOffshoreDepth(0.0);
  tracer->Update();
  EXPECT_EQ(bytesOf(tracer->GetOutput()), deep);
  EXPECT_EQ(fieldNumber(tracer->GetOutput(), "OffshoreDepth"), std::numeric_limits<double>::infinity());
}

TEST(RayTracer, givesTheArraysItPromises)
{
  vtkNew<vtkSwellRayTracer> tracer;
  const auto reader = builtin(Beach);
  tracer->SetInputConnection(reader->GetOutputPort());
  fromTheEast(tracer);
  tracer->SetWaterLevel(0.5);
  tracer->Update();
  vtkPolyData* rays = tracer->GetOutput();
  ASSERT_GT(rays->GetNumberOfLines(), 40);
  EXPECT_EQ(rays->GetNumberOfCells(), rays->GetNumberOfLines());
  EXPECT_EQ(rays->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(rays->GetPoint(0)[2], 0.5);

  struct Array
  {
    const char* name;
    int type;
    int components;
  };
  const Array pointArrays[] = { { "Depth", VTK_DOUBLE, 1 }, { "Phase", VTK_DOUBLE, 1 }, { "TravelTime", VTK_DOUBLE, 1 },
    { "Wavenumber", VTK_DOUBLE, 1 }, { "Wavelength", VTK_DOUBLE, 1 }, { "PhaseSpeed", VTK_DOUBLE, 1 },
    { "GroupSpeed", VTK_DOUBLE, 1 }, { "Direction", VTK_DOUBLE, 3 }, { "RayDirection", VTK_DOUBLE, 3 },
    { "DirectionFrom", VTK_DOUBLE, 1 }, { "KrSpacing", VTK_DOUBLE, 1 }, { "KrTube", VTK_DOUBLE, 1 },
    { "TubeWidth", VTK_DOUBLE, 1 }, { "ShoalingCoefficient", VTK_DOUBLE, 1 }, { "Caustics", VTK_INT, 1 },
    { "RayState", VTK_UNSIGNED_CHAR, 1 } };
  EXPECT_EQ(rays->GetPointData()->GetNumberOfArrays(), static_cast<int>(std::size(pointArrays)));
  for (const Array& array : pointArrays)
  {
    vtkDataArray* found = rays->GetPointData()->GetArray(array.name);
    ASSERT_NE(found, nullptr) << array.name;
    EXPECT_EQ(found->GetDataType(), array.type) << array.name;
    EXPECT_EQ(found->GetNumberOfComponents(), array.components) << array.name;
    EXPECT_EQ(found->GetNumberOfTuples(), rays->GetNumberOfPoints()) << array.name;
  }
  const Array cellArrays[] = { { "RayId", VTK_INT, 1 }, { "LaunchParameter", VTK_DOUBLE, 1 },
    { "ParentRay", VTK_INT, 1 }, { "LeeRay", VTK_UNSIGNED_CHAR, 1 }, { "FinalState", VTK_UNSIGNED_CHAR, 1 },
    { "EndReason", VTK_UNSIGNED_CHAR, 1 }, { "LaunchSegment", VTK_INT, 1 } };
  EXPECT_EQ(rays->GetCellData()->GetNumberOfArrays(), static_cast<int>(std::size(cellArrays)));
  for (const Array& array : cellArrays)
  {
    vtkDataArray* found = rays->GetCellData()->GetArray(array.name);
    ASSERT_NE(found, nullptr) << array.name;
    EXPECT_EQ(found->GetDataType(), array.type) << array.name;
    EXPECT_EQ(found->GetNumberOfTuples(), rays->GetNumberOfLines()) << array.name;
  }
  EXPECT_EQ(fieldNumber(rays, "Period"), 8.0);
  EXPECT_EQ(fieldNumber(rays, "DirectionFrom"), 70.0);
  EXPECT_EQ(fieldNumber(rays, "WaveHeight"), 1.0);
  EXPECT_EQ(fieldNumber(rays, "OffshoreDepth"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(fieldNumber(rays, "Gravity"), 9.81);
  EXPECT_EQ(fieldNumber(rays, "WaterLevel"), 0.5);
  EXPECT_EQ(fieldNumber(rays, "LaunchSpacing"), 20.0);
  EXPECT_EQ(fieldNumber(rays, "OriginX"), 0.0);
  EXPECT_NE(rays->GetFieldData()->GetAbstractArray("SwellrayVersion"), nullptr);
  EXPECT_NE(rays->GetFieldData()->GetAbstractArray("SeafloorForm"), nullptr);
  // What the filter adds is not added to its input.
  EXPECT_EQ(reader->GetOutput()->GetFieldData()->GetAbstractArray("Period"), nullptr);
}

TEST(RayTracer, takesTheFormulaOfABuiltinForm)
{
  vtkNew<vtkSwellRayTracer> tracer;
  const auto reader = builtin(Beach);
  tracer->SetInputConnection(reader->GetOutputPort());
  fromTheEast(tracer);
  tracer->LeeRaysOff();
  tracer->SetInsertionToNone();
  tracer->Update();
  vtkPolyData* rays = tracer->GetOutput();
  const double deepSpeed = 9.81 * 8.0 / (2.0 * swellray::Pi);
  vtkPointData* points = rays->GetPointData();
  for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
  {
    if (points->GetArray("RayState")->GetComponent(i, 0) != 1.0)
    {
      continue;
    }
    EXPECT_NEAR(points->GetArray("Depth")->GetComponent(i, 0), 0.02 * rays->GetPoint(i)[0], DepthTolerance);
    // From 20 degrees north of the shore normal, which is east; sin(theta)/C stays that of deep water.
    EXPECT_NEAR(points->GetArray("Direction")->GetComponent(i, 1) / points->GetArray("PhaseSpeed")->GetComponent(i, 0),
      -std::sin(swellray::radians(20.0)) / deepSpeed, SnellTolerance / deepSpeed);
  }
}

TEST(RayTracer, followsTheElevationsWhereTheyAreNotThoseOfTheForm)
{
  const auto reader = builtin(Beach);
  reader->Update();
  vtkNew<vtkImageData> deeper;
  deeper->DeepCopy(reader->GetOutput());
  vtkDataArray* elevation = deeper->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < elevation->GetNumberOfTuples(); ++i)
  {
    elevation->SetComponent(i, 0, elevation->GetComponent(i, 0) - 5.0);
  }
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(deeper);
  fromTheEast(tracer);
  tracer->Update();
  // The east edge lies under 19 m of the form and 24 m of the image.
  EXPECT_NEAR(tracer->GetOutput()->GetPointData()->GetArray("Depth")->GetRange()[1], 24.0, 1e-6);
}

TEST(RayTracer, takesTheFormulaWithinACroppedImage)
{
  const auto reader = builtin(Beach);
  reader->Update();
  vtkNew<vtkImageData> part;
  part->DeepCopy(reader->GetOutput());
  const int cut[6] = { 100, 300, 50, 449, 0, 0 };
  part->Crop(cut);
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(part);
  fromTheEast(tracer);
  tracer->Update();
  const double* box = part->GetBounds();
  vtkPolyData* rays = tracer->GetOutput();
  ASSERT_GT(rays->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
  {
    const double* p = rays->GetPoint(i);
    EXPECT_GE(p[0], box[0] - DepthTolerance);
    EXPECT_LE(p[0], box[1] + DepthTolerance);
    EXPECT_GE(p[1], box[2] - DepthTolerance);
    EXPECT_LE(p[1], box[3] + DepthTolerance);
    EXPECT_NEAR(rays->GetPointData()->GetArray("Depth")->GetComponent(i, 0), 0.02 * p[0], DepthTolerance);
  }
}

TEST(RayTracer, raysAreLinesOverThePointsInTheirOrder)
{
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(griddedBeach());
  fromTheEast(tracer);
  tracer->Update();
  vtkPolyData* rays = tracer->GetOutput();
  vtkIdType next = 0;
  std::set<int> reasons;
  for (vtkIdType ray = 0; ray < rays->GetNumberOfLines(); ++ray)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    rays->GetLines()->GetCellAtId(ray, size, points);
    ASSERT_GE(size, 1) << ray;
    for (vtkIdType i = 0; i < size; ++i)
    {
      ASSERT_EQ(points[i], next++);
    }
    EXPECT_EQ(rays->GetCellData()->GetArray("RayId")->GetComponent(ray, 0), static_cast<double>(ray));
    reasons.insert(static_cast<int>(rays->GetCellData()->GetArray("EndReason")->GetComponent(ray, 0)));
  }
  EXPECT_EQ(next, rays->GetNumberOfPoints());
  EXPECT_TRUE(reasons.count(2)) << "no ray has entered the hole";
}

TEST(RayTracer, tellsLongitudeAndLatitudeWhereTheyAreKnown)
{
  const vtkSmartPointer<vtkImageData> image = griddedBeach();
  const auto add = [&](const char* name, double value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    image->GetFieldData()->AddArray(array);
  };
  vtkNew<vtkStringArray> crs;
  crs->SetName("CRS");
  crs->InsertNextValue("EPSG:32618");
  image->GetFieldData()->AddArray(crs);
  // The origin on the equator and the central meridian of UTM zone 18N: 75 degrees west.
  add("OriginX", 500000.0);
  add("OriginY", 0.0);
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(image);
  fromTheEast(tracer);
  tracer->Update();
  vtkPolyData* rays = tracer->GetOutput();
  vtkDataArray* longitude = rays->GetPointData()->GetArray("Longitude");
  vtkDataArray* latitude = rays->GetPointData()->GetArray("Latitude");
  ASSERT_NE(longitude, nullptr);
  ASSERT_NE(latitude, nullptr);
  // Metres a degree on WGS 84 at the equator, over the scale of 0.9996 on the central meridian of UTM; the scale
  // grows by 1e-8 over the 900 m of the scene, the radius of the meridian by less.
  const double scale = 0.9996;
  const double metresOfLongitude = 111319.4908 * scale;
  const double metresOfLatitude = 110574.2758 * scale;
  for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
  {
    const double* p = rays->GetPoint(i);
    EXPECT_NEAR((longitude->GetComponent(i, 0) + 75.0) * metresOfLongitude, p[0], 1e-3);
    EXPECT_NEAR(latitude->GetComponent(i, 0) * metresOfLatitude, p[1], 1e-3);
  }
  tracer->LongitudeLatitudeOff();
  tracer->Update();
  EXPECT_EQ(tracer->GetOutput()->GetPointData()->GetArray("Longitude"), nullptr);
}

TEST(RayTracer, tracesAgainOnlyWhenItHasTo)
{
  const auto reader = builtin(Beach);
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(reader->GetOutputPort());
  fromTheEast(tracer);
  vtkNew<Listener> ofReader;
  ofReader->listenTo(reader);
  vtkNew<Listener> ofTracer;
  ofTracer->listenTo(tracer);
  tracer->Update();
  tracer->Update();
  EXPECT_EQ(ofReader->Runs, 1);
  EXPECT_EQ(ofTracer->Runs, 1);
  const vtkIdType points = tracer->GetOutput()->GetNumberOfPoints();
  tracer->SetPeriod(tracer->GetPeriod());
  tracer->Update();
  EXPECT_EQ(ofTracer->Runs, 1);
  tracer->SetPeriod(6.0);
  tracer->Update();
  EXPECT_EQ(ofReader->Runs, 1);
  EXPECT_EQ(ofTracer->Runs, 2);
  EXPECT_NE(tracer->GetOutput()->GetNumberOfPoints(), points);
  reader->SetFileName("plane:slope=0.03,x0=-50,y0=-500,x1=950,y1=500");
  tracer->Update();
  EXPECT_EQ(ofReader->Runs, 2);
  EXPECT_EQ(ofTracer->Runs, 3);
  EXPECT_NEAR(tracer->GetOutput()->GetPointData()->GetArray("Depth")->GetRange()[1], 0.03 * 950.0, DepthTolerance);
}

TEST(RayTracer, seesElevationsChangedInPlace)
{
  const vtkSmartPointer<vtkImageData> image = griddedBeach();
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(image);
  fromTheEast(tracer);
  tracer->Update();
  const double deepest = tracer->GetOutput()->GetPointData()->GetArray("Depth")->GetRange()[1];
  vtkDataArray* elevation = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < elevation->GetNumberOfTuples(); ++i)
  {
    elevation->SetComponent(i, 0, elevation->GetComponent(i, 0) - 5.0);
  }
  elevation->Modified();
  tracer->Update();
  EXPECT_GT(tracer->GetOutput()->GetPointData()->GetArray("Depth")->GetRange()[1], deepest + 4.0);
}

TEST(RayTracer, isTheSameOnOneThreadAndOnTwo)
{
  std::map<std::string, std::string> results[2];
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        vtkNew<vtkSwellRayTracer> tracer;
        tracer->SetInputData(griddedBeach());
        fromTheEast(tracer);
        tracer->Update();
        results[threads - 1] = bytesOf(tracer->GetOutput());
      });
  }
  ASSERT_EQ(results[0].size(), results[1].size());
  for (const auto& [name, bytes] : results[0])
  {
    EXPECT_TRUE(results[1][name] == bytes) << name;
  }
}

TEST(RayTracer, reportsItsProgressAndStopsWhenAsked)
{
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(griddedBeach());
  fromTheEast(tracer);
  vtkNew<Listener> listener;
  listener->listenTo(tracer);
  tracer->Update();
  ASSERT_GT(listener->Progress.size(), 3u);
  EXPECT_TRUE(std::is_sorted(listener->Progress.begin(), listener->Progress.end()));
  EXPECT_EQ(listener->Progress.back(), 1.0);
  const vtkIdType points = tracer->GetOutput()->GetNumberOfPoints();

  vtkNew<vtkSwellRayTracer> stopped;
  stopped->SetInputData(griddedBeach());
  fromTheEast(stopped);
  vtkNew<Listener> stopper;
  stopper->AbortAt = 0.2;
  stopper->listenTo(stopped);
  stopped->Update();
  EXPECT_TRUE(stopper->Errors.empty());
  EXPECT_LT(stopped->GetOutput()->GetNumberOfPoints(), points);
  EXPECT_EQ(stopped->GetOutput()->GetCellData()->GetArray("EndReason")->GetRange()[1], 5.0);
}

TEST(RayTracer, saysThatACapWasReached)
{
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(griddedBeach());
  fromTheEast(tracer);
  tracer->SetMaximumNumberOfFronts(5);
  vtkNew<Listener> listener;
  listener->listenTo(tracer);
  tracer->Update();
  ASSERT_EQ(listener->Warnings.size(), 1u);
  EXPECT_THAT(listener->Warnings.front(), testing::HasSubstr("cap of 5 fronts"));
  EXPECT_EQ(fieldNumber(tracer->GetOutput(), "StepCapReached"), 1.0);
  EXPECT_EQ(tracer->GetOutput()->GetCellData()->GetArray("EndReason")->GetRange()[0], 0.0);
}

TEST(RayTracer, saysThatAGridIsCoarse)
{
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(elevationImage(21, 21, 50.0, [](double x, double) { return -2.0 - 0.02 * x; }));
  fromTheEast(tracer);
  tracer->SetSpacing(50.0);
  vtkNew<Listener> listener;
  listener->listenTo(tracer);
  tracer->Update();
  ASSERT_EQ(listener->Warnings.size(), 1u);
  EXPECT_THAT(listener->Warnings.front(), testing::HasSubstr("cells of 50 m"));
}

TEST(RayTracer, saysWhatIsWrongOnce)
{
  const auto errorOf = [](vtkImageData* image, const std::function<void(vtkSwellRayTracer*)>& set)
  {
    vtkNew<vtkSwellRayTracer> tracer;
    vtkNew<Listener> listener;
    listener->listenTo(tracer);
    vtkNew<Listener> quiet;
    quiet->listenTo(tracer->GetExecutive());
    tracer->SetInputData(image);
    fromTheEast(tracer);
    set(tracer);
    tracer->Update();
    EXPECT_EQ(listener->Errors.size(), 1u);
    EXPECT_EQ(tracer->GetOutput()->GetNumberOfPoints(), 0);
    return listener->Errors.empty() ? std::string() : listener->Errors.front();
  };
  const vtkSmartPointer<vtkImageData> beach = griddedBeach();
  using Tracer = vtkSwellRayTracer;
  const auto nothing = [](Tracer*) {};
  EXPECT_THAT(errorOf(beach, [](Tracer* t) { t->SetPeriod(0.0); }), testing::HasSubstr("period"));
  EXPECT_THAT(errorOf(beach, [](Tracer* t) { t->SetDirectionFrom(400.0); }), testing::HasSubstr("400"));
  EXPECT_THAT(errorOf(beach, [](Tracer* t) { t->SetWaveHeight(std::nan("")); }), testing::HasSubstr("height"));
  EXPECT_THAT(errorOf(beach, [](Tracer* t) { t->SetSpacing(-1.0); }), testing::HasSubstr("spacing"));
  EXPECT_THAT(errorOf(beach, [](Tracer* t) { t->SetMaximumNumberOfRays(-1); }), testing::HasSubstr("caps"));
  EXPECT_THAT(errorOf(beach, [](Tracer* t) { t->SetWaterLevel(-500.0); }), testing::HasSubstr("water"));
  EXPECT_THAT(errorOf(vtkNew<vtkImageData>(), nothing), testing::HasSubstr("nodes"));
  const auto flat = [](double, double) { return -5.0; };
  EXPECT_THAT(errorOf(elevationImage(3, 3, 10.0, flat), nothing), testing::HasSubstr("4"));
  const vtkSmartPointer<vtkImageData> unnamed = elevationImage(8, 8, 10.0, flat);
  unnamed->GetPointData()->GetScalars()->SetName("Depth");
  EXPECT_THAT(errorOf(unnamed, nothing), testing::HasSubstr("Elevation"));
  const vtkSmartPointer<vtkImageData> turned = elevationImage(8, 8, 10.0, flat);
  turned->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  EXPECT_THAT(errorOf(turned, nothing), testing::HasSubstr("turned"));
  vtkNew<vtkImageData> solid;
  solid->SetDimensions(5, 5, 5);
  EXPECT_THAT(errorOf(solid, nothing), testing::HasSubstr("5 x 5 x 5"));
  const auto nan = [](double, double) { return std::nan(""); };
  EXPECT_THAT(errorOf(elevationImage(8, 8, 10.0, nan), nothing), testing::HasSubstr("elevation"));
}
