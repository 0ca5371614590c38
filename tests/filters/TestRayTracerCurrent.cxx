// Rays on a current through the filter.
#include "Observers.h"

#include "sim/BuiltinCurrent.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/WaveTracer.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace
{

constexpr const char* Seafloor = "shoal:kind=gauss";
constexpr const char* Eddy = "eddy:U0=1.5,R=400";

struct Scene
{
  Scene()
  {
    this->Reader->SetFileName(Seafloor);
    this->Tracer->SetInputConnection(this->Reader->GetOutputPort());
    this->Tracer->SetSpacing(60.0);
    this->Tracer->SetCurrent(Eddy);
  }

  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellRayTracer> Tracer;
};

}

TEST(RayTracerCurrent, isThatOfTheCore)
{
  Scene scene;
  scene.Tracer->Update();
  vtkPolyData* rays = scene.Tracer->GetOutput();
  const auto seafloor = swellray::makeBuiltinSeafloor(Seafloor);
  const auto current = swellray::makeBuiltinCurrent(Eddy);
  swellray::TraceOptions options;
  options.spacing = 60.0;
  options.current = current.get();
  const swellray::RayField field = swellray::traceWaves(*seafloor, {}, options);
  ASSERT_EQ(rays->GetNumberOfPoints(), static_cast<vtkIdType>(field.points.size()));
  vtkDataArray* velocity = rays->GetPointData()->GetArray("Current");
  ASSERT_NE(velocity, nullptr);
  ASSERT_EQ(velocity->GetNumberOfComponents(), 3);
  for (vtkIdType i = 0; i < rays->GetNumberOfPoints(); ++i)
  {
    const swellray::RayPoint& point = field.points[static_cast<std::size_t>(i)];
    ASSERT_EQ(rays->GetPoint(i)[0], point.position.x);
    ASSERT_EQ(rays->GetPoint(i)[1], point.position.y);
    ASSERT_EQ(velocity->GetComponent(i, 0), point.current.x);
    ASSERT_EQ(velocity->GetComponent(i, 1), point.current.y);
  }
}

TEST(RayTracerCurrent, tracesAgainWhenItChanges)
{
  Scene scene;
  scene.Tracer->Update();
  const vtkIdType points = scene.Tracer->GetOutput()->GetNumberOfPoints();
  scene.Tracer->SetCurrent(nullptr);
  scene.Tracer->Update();
  EXPECT_NE(scene.Tracer->GetOutput()->GetNumberOfPoints(), points);
  EXPECT_EQ(scene.Tracer->GetOutput()->GetPointData()->GetArray("Current"), nullptr);
}

TEST(RayTracerCurrent, saysWhatIsWrongWithIt)
{
  Scene scene;
  vtkNew<Listener> listener;
  listener->listenTo(scene.Tracer);
  scene.Tracer->SetCurrent("nothing_there.nc");
  scene.Tracer->Update();
  EXPECT_EQ(scene.Tracer->GetOutput()->GetNumberOfPoints(), 0);
  scene.Tracer->SetCurrent(Eddy);
  scene.Tracer->SetSchemeToSnell();
  scene.Tracer->Update();
  EXPECT_EQ(scene.Tracer->GetOutput()->GetNumberOfPoints(), 0);
  ASSERT_EQ(listener->Errors.size(), 2u);
  EXPECT_THAT(listener->Errors[0], ::testing::HasSubstr("no such file"));
  EXPECT_THAT(listener->Errors[1], ::testing::HasSubstr("snell scheme knows no current"));
}
