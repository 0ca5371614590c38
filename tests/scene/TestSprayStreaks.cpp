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

vtkSmartPointer<vtkPolyData> droplet(double vx, double vy, double vz, double age = 0.0)
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
  vtkNew<vtkFloatArray> ages;
  ages->SetName("Age");
  ages->InsertNextValue(static_cast<float>(age));
  spray->GetPointData()->AddArray(ages);
  return spray;
}

// Breadth across its way, which is upwards.
double breadthOf(vtkPolyData* streak)
{
  double bounds[6];
  streak->GetBounds(bounds);
  return bounds[1] - bounds[0];
}

double valueOf(vtkPolyData* streak, const char* name)
{
  return streak->GetPointData()->GetArray(name)->GetComponent(0, 0);
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

TEST(SprayStreaks, AreWispsInPartWhichSpreadAndFade)
{
  StreakView view = fromSouth(10.0);
  view.exposure = 1e-3;
  view.wisp = 0.2;
  constexpr int Particles = 400;
  int wisps = 0;
  for (int i = 0; i < Particles; ++i)
  {
    // The horizontal velocity stays with a particle, the other changes as it falls.
    const double own = 1e-4 * (i + 1);
    const auto young = streaksOf(droplet(own, 0.0, 5.0, 0.0), view);
    const auto old = streaksOf(droplet(own, 0.0, 1.0, 0.4), view);
    const bool wisp = breadthOf(young) > 0.1;
    EXPECT_EQ(breadthOf(old) > 0.1, wisp) << i;
    wisps += wisp;
    if (wisp)
    {
      EXPECT_GT(breadthOf(old), 1.2 * breadthOf(young)) << i;
      EXPECT_LT(valueOf(old, "Opacity"), 0.7 * valueOf(young, "Opacity")) << i;
      EXPECT_LT(breadthOf(young), 2.9 * view.wisp) << i;
    }
  }
  // Half of them, within five standard deviations.
  EXPECT_NEAR(wisps, Particles / 2, 50);
}

TEST(SprayStreaks, AreDarkerWhereTheyFall)
{
  const StreakView view = fromSouth(10.0);
  EXPECT_NEAR(valueOf(streaksOf(droplet(1.0, 0.0, 3.0), view), "Shade"), 1.0, Single);
  const double slow = valueOf(streaksOf(droplet(1.0, 0.0, -1.0), view), "Shade");
  const double fast = valueOf(streaksOf(droplet(1.0, 0.0, -3.0), view), "Shade");
  EXPECT_LT(slow, 0.99);
  EXPECT_LT(fast, slow - 0.1);
  EXPECT_GT(fast, 0.5);
}
