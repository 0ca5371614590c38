#include "Observers.h"

#include "bathymetry/Geodesics.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace
{

constexpr double StormLongitude = 170.0; // in the Southern Ocean
constexpr double StormLatitude = -50.0;

double fieldOf(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

std::string hawaii()
{
  const char* folder = std::getenv("SWELLRAY_DATA");
  return std::string(folder ? folder : SWELLRAY_DATA_DEFAULT) + "/sites/hawaii_islands/hawaii_etopo1.nc";
}

}

TEST(RayTracerSource, OneStormComesToHawaiiFromManyDirections)
{
  if (!std::filesystem::exists(hawaii()))
  {
    GTEST_SKIP() << "no bathymetry at " << hawaii() << "; set SWELLRAY_DATA";
  }
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(hawaii().c_str());
  reader->SetEarthToEllipsoid();
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(reader->GetOutputPort());
  tracer->SetPeriod(16.0);
  tracer->SetSourceToStorm();
  tracer->SetSourcePosition(StormLongitude, StormLatitude);
  tracer->SetEdgeToNone();
  tracer->SetSpacing(20000.0);
  tracer->SetStepsPerWave(0.05);
  tracer->LeeRaysOff();
  tracer->SetInsertionToNone();
  tracer->Update();
  vtkPolyData* rays = tracer->GetOutput();
  ASSERT_GT(rays->GetNumberOfCells(), 50);
  const swellray::Geodesics earth;
  const double distance = fieldOf(rays, "SourceDistance");
  vtkPointData* points = rays->GetPointData();
  double low = 360.0;
  double high = 0.0;
  double scale = 0.0;
  double narrowest = 2.0;
  for (vtkIdType ray = 0; ray < rays->GetNumberOfCells(); ++ray)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    rays->GetCellPoints(ray, count, ids);
    const auto at = [&](const char* name) { return points->GetArray(name)->GetComponent(ids[0], 0); };
    const swellray::Geodesic way =
      earth.inverse({ StormLongitude, StormLatitude }, { at("Longitude"), at("Latitude") });
    const double from = at("DirectionFrom");
    EXPECT_NEAR(std::remainder(from - way.azimuthTo - 180.0, 360.0), 0.0, 1e-9);
    low = std::min(low, from);
    high = std::max(high, from);
    EXPECT_GE(way.length, distance - 1.0);
    // The edges of this grid are in the deep but for some banks, which a swell of 16 s feels: there the phase is
    // another by the waves that they shorten, up to the next place of the edge on the storm's side.
    EXPECT_NEAR(at("Phase") / at("Wavenumber") / (way.length - distance + 1.0), 1.0, 0.01);
    // The tube is that of the storm's reduced length, 1 wide where the wave first arrives.
    scale = ray == 0 ? at("TubeWidth") / way.reducedLength : scale;
    EXPECT_NEAR(at("TubeWidth"), scale * way.reducedLength, 1e-9);
    narrowest = std::min(narrowest, at("TubeWidth"));
  }
  // 198 degrees in the west of the grid and 204 in its east, by the geodesics to its south-western and eastern corners.
  EXPECT_NEAR(low, 197.5, 0.3);
  EXPECT_NEAR(high, 203.8, 0.3);
  EXPECT_NEAR(fieldOf(rays, "DirectionFrom"), 198.1, 0.1);
  EXPECT_NEAR(narrowest, 1.0, 1e-3);
}

TEST(RayTracerSource, APointOfThePlaneIsInTheCoordinatesOfTheFile)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("basin.asc");
  std::ofstream file(path);
  file << "ncols 12\nnrows 12\nxllcenter 5000\nyllcenter 7000\ncellsize 10\n";
  for (int i = 0; i < 144; ++i)
  {
    file << "-50 ";
  }
  file.close();
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(reader->GetOutputPort());
  tracer->SetPeriod(3.0);
  tracer->SetOffshoreDepth(50.0);
  tracer->SetSourceToPoint();
  tracer->SetSourcePosition(4970.0, 7055.0);
  tracer->Update();
  vtkPolyData* rays = tracer->GetOutput();
  ASSERT_GT(rays->GetNumberOfPoints(), 100);
  EXPECT_NEAR(fieldOf(rays, "SourceDistance"), 30.0, 0.01);
  const double x = fieldOf(rays, "OriginX");
  const double y = fieldOf(rays, "OriginY");
  for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
  {
    const double* p = rays->GetPoint(i);
    const double r = std::hypot(p[0] + x - 4970.0, p[1] + y - 7055.0);
    EXPECT_NEAR(
      rays->GetPointData()->GetArray("TubeWidth")->GetComponent(i, 0), r / fieldOf(rays, "SourceDistance"), 1e-7);
  }

  // A file that does not say where it lies has no geodesics.
  tracer->SetSourcePosition(StormLongitude, StormLatitude);
  vtkNew<Listener> listener;
  listener->listenTo(tracer);
  tracer->SetSourceToStorm();
  tracer->Update();
  EXPECT_THAT(listener->Errors, testing::ElementsAre(testing::HasSubstr("says where on Earth it lies")));
  EXPECT_EQ(tracer->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(RayTracerSource, LongitudesTakeAStormAndNoPoint)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("bay.asc");
  std::ofstream file(path);
  file << "ncols 12\nnrows 12\nxllcenter 200\nyllcenter 20\ncellsize 0.01\n";
  for (int i = 0; i < 144; ++i)
  {
    file << "-3000 ";
  }
  file.close();
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetCRS("EPSG:4326");
  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputConnection(reader->GetOutputPort());
  tracer->SetPeriod(16.0);
  tracer->SetSourceToStorm();
  tracer->SetSourcePosition(StormLongitude, StormLatitude);
  tracer->Update();
  // On a plane map of 12 km the rays of the storm, 8,000 km away, are nearly parallel: as wide as at first.
  vtkPolyData* rays = tracer->GetOutput();
  ASSERT_GT(rays->GetNumberOfPoints(), 100);
  const double* range = rays->GetPointData()->GetArray("TubeWidth")->GetRange();
  EXPECT_NEAR(range[0], 1.0, 2e-3);
  EXPECT_NEAR(range[1], 1.0, 2e-3);
  const swellray::Geodesics earth;
  const double direction = earth.inverse({ StormLongitude, StormLatitude }, { 200.055, 20.055 }).azimuthTo + 180.0;
  EXPECT_NEAR(fieldOf(rays, "DirectionFrom"), direction, 0.1);

  vtkNew<Listener> listener;
  listener->listenTo(tracer);
  tracer->SetSourceToPoint();
  tracer->Update();
  EXPECT_THAT(listener->Errors, testing::ElementsAre(testing::HasSubstr("need a plane")));
}
