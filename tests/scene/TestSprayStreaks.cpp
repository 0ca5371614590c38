#include "apps/scene/SprayStreaks.h"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

using namespace swellray::scene;

namespace
{

// Places are kept in single precision.
constexpr double Single = 1e-5;

vtkSmartPointer<vtkPolyData> droplet(double vx, double vy, double vz)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  velocity->InsertNextTuple3(vx, vy, vz);
  auto spray = vtkSmartPointer<vtkPolyData>::New();
  spray->SetPoints(points);
  spray->GetPointData()->AddArray(velocity);
  return spray;
}

StreakView fromSouth(double distance)
{
  StreakView view;
  view.eye = { 0.0, -distance, 0.0 };
  view.exposure = 0.1;
  view.radius = 0.01;
  view.pixel = 1e-6;
  return view;
}

}

TEST(SprayStreaks, AreAsLongAsTheWayInTheTime)
{
  double bounds[6];
  const auto streaks = streaksOf(droplet(3.0, 0.0, 4.0), fromSouth(10.0));
  ASSERT_EQ(streaks->GetNumberOfPoints(), 4);
  ASSERT_EQ(streaks->GetNumberOfCells(), 1);
  streaks->GetBounds(bounds);
  // 5 m/s in 0.1 s, and a radius at each end; 0.02 m broad across (0.8, -0.6).
  EXPECT_NEAR(bounds[1] - bounds[0], 0.52 * 0.6 + 0.02 * 0.8, Single);
  EXPECT_NEAR(bounds[5] - bounds[4], 0.52 * 0.8 + 0.02 * 0.6, Single);
  EXPECT_NEAR(bounds[3] - bounds[2], 0.0, Single); // turned to the eye
  EXPECT_NEAR(streaks->GetPointData()->GetNormals()->GetComponent(0, 1), -1.0, Single);
}

TEST(SprayStreaks, ThatComeTowardsTheEyeAreDots)
{
  double bounds[6];
  streaksOf(droplet(0.0, -20.0, 0.0), fromSouth(10.0))->GetBounds(bounds);
  EXPECT_NEAR(bounds[1] - bounds[0], 0.02, Single);
  EXPECT_NEAR(bounds[5] - bounds[4], 0.02, Single);
}

TEST(SprayStreaks, AreNeverThinnerThanAPixelButFainter)
{
  StreakView view = fromSouth(10.0);
  const auto near = streaksOf(droplet(0.0, 0.0, 0.0), view);
  view.pixel = 3e-3; // 0.03 m there
  const auto far = streaksOf(droplet(0.0, 0.0, 0.0), view);
  double bounds[6];
  far->GetBounds(bounds);
  EXPECT_NEAR(bounds[5] - bounds[4], 0.03, Single);
  EXPECT_LT(far->GetPointData()->GetArray("Opacity")->GetComponent(0, 0),
    0.7 * near->GetPointData()->GetArray("Opacity")->GetComponent(0, 0));
}

TEST(SprayStreaks, OfNothingAreNone)
{
  vtkNew<vtkPolyData> none;
  EXPECT_EQ(streaksOf(none, fromSouth(10.0))->GetNumberOfCells(), 0);
}
