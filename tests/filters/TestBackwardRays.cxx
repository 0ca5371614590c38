#include "Observers.h"

#include "vtkSwellBackwardRays.h"
#include "vtkSwellRayTracer.h"
#include "vtkSwellSeafloorReader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>

namespace
{

double cell(vtkPolyData* data, const char* name, vtkIdType i)
{
  return data->GetCellData()->GetArray(name)->GetComponent(i, 0);
}

}

TEST(BackwardRays, ComeToTheSiteByTheWaysOfForwardRays)
{
  vtkNew<vtkSwellSeafloorReader> reader;
  reader->SetFileName("shoal");
  reader->Update();
  const double* bounds = reader->GetOutput()->GetBounds();
  const double site[2] = { 0.75 * bounds[1] + 0.25 * bounds[0], 0.5 * (bounds[2] + bounds[3]) + 150.0 };
  vtkNew<vtkSwellBackwardRays> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetSite(site[0], site[1]);
  filter->SetNumberOfDirections(36);
  filter->Update();
  vtkPolyData* ways = filter->GetOutput();
  ASSERT_EQ(ways->GetNumberOfCells(), 36);
  EXPECT_EQ(ways->GetFieldData()->GetArray("SiteX")->GetComponent(0, 0), site[0]);

  // A ray launched where a way begins, in the way's direction there, passes through the site.
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  int come = 0;
  for (const vtkIdType way : { vtkIdType(25), vtkIdType(27), vtkIdType(28) })
  {
    EXPECT_NEAR(cell(ways, "SiteDirectionFrom", way), 10.0 * static_cast<double>(way), 1e-9);
    ways->GetCellPoints(way, count, ids);
    double first[3];
    double last[3];
    ways->GetPoint(ids[0], first);
    ways->GetPoint(ids[count - 1], last);
    EXPECT_NEAR(std::hypot(last[0] - site[0], last[1] - site[1]), 0.0, 1e-6);
    come += std::isfinite(cell(ways, "OffshoreDirectionFrom", way)) ? 1 : 0;
    const vtkIdType second = ids[1]; // within the scene, where a ray may start
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(ways->GetPoint(second));
    vtkNew<vtkDoubleArray> direction;
    direction->SetName("DirectionFrom");
    direction->InsertNextValue(ways->GetPointData()->GetArray("DirectionFrom")->GetComponent(second, 0));
    vtkNew<vtkPolyData> launch;
    launch->SetPoints(points);
    launch->GetPointData()->AddArray(direction);
    vtkNew<vtkSwellRayTracer> tracer;
    tracer->SetInputConnection(reader->GetOutputPort());
    tracer->SetInputData(1, launch);
    tracer->SetStepsPerWave(40.0);
    tracer->Update();
    vtkPolyData* ray = tracer->GetOutput();
    ASSERT_EQ(ray->GetNumberOfCells(), 1);
    EXPECT_EQ(ray->GetFieldData()->GetArray("LaunchPoints")->GetComponent(0, 0), 1.0);
    double nearest = 1e9;
    for (vtkIdType i = 1; i < ray->GetNumberOfPoints(); ++i)
    {
      double a[3];
      double b[3];
      ray->GetPoint(i - 1, a);
      ray->GetPoint(i, b);
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      const double along = ((site[0] - a[0]) * (b[0] - a[0]) + (site[1] - a[1]) * (b[1] - a[1])) / length;
      if (along >= 0.0 && along <= length)
      {
        nearest =
          std::min(nearest, std::abs((site[0] - a[0]) * (b[1] - a[1]) - (site[1] - a[1]) * (b[0] - a[0])) / length);
      }
    }
    // Chords of 1/40 of a wave, bent by a tenth of a degree: tenths of a millimetre; rays of 1e-8 a step.
    EXPECT_LT(nearest, 0.01) << way;
  }
  EXPECT_GT(come, 0);

  vtkNew<Listener> listener;
  listener->listenTo(filter);
  filter->SetSite(bounds[0] - 10.0, 0.0);
  filter->Update();
  EXPECT_THAT(listener->Errors, testing::ElementsAre(testing::HasSubstr("it must lie within the scene")));
  EXPECT_EQ(ways->GetNumberOfPoints(), 0);
}
