#include "Scene.h"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

using namespace swellray::view;

namespace
{

const WaveControls BayWave{ 3.0, 90.0, 0.4, 0.0 };

bool waitUntilRefined(WaveModel& model)
{
  return waitUntil(
    [&]
    {
      model.poll();
      return model.isRefined();
    });
}

void expectSameValues(vtkPolyData* a, vtkPolyData* b, const char* name)
{
  vtkDataArray* of = a->GetPointData()->GetArray(name);
  vtkDataArray* as = b->GetPointData()->GetArray(name);
  ASSERT_NE(of, nullptr);
  ASSERT_NE(as, nullptr);
  ASSERT_EQ(of->GetNumberOfTuples(), as->GetNumberOfTuples());
  for (vtkIdType i = 0; i < of->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(of->GetComponent(i, 0), as->GetComponent(i, 0)) << name << " of point " << i;
  }
}

}

TEST(WaveModel, EndsWithTheRaysThatTraceMakes)
{
  const Scene scene("bay");
  WaveModel model(scene.setup());
  model.setControls(BayWave);
  ASSERT_TRUE(waitUntilRefined(model));
  EXPECT_EQ(model.waves().controls, BayWave);
  EXPECT_EQ(model.waves().failure, "");

  vtkNew<vtkSwellRayTracer> tracer;
  tracer->SetInputData(scene.setup().seafloor);
  tracer->SetPeriod(3.0);
  tracer->SetDirectionFrom(90.0);
  tracer->SetWaveHeight(0.4);
  vtkNew<vtkSwellWaveHeight> heights;
  heights->SetInputConnection(tracer->GetOutputPort());
  heights->Update();
  ASSERT_EQ(model.waves().rays->GetNumberOfCells(), heights->GetOutput()->GetNumberOfCells());
  expectSameValues(model.waves().rays, heights->GetOutput(), "WaveHeight");
  expectSameValues(model.waves().rays, heights->GetOutput(), "Phase");
  EXPECT_GT(model.waves().crests->GetNumberOfCells(), 5);
}

TEST(WaveModel, ShowsCoarseRaysFirst)
{
  const Scene scene("bay");
  WaveModel model(scene.setup());
  model.setControls(BayWave);
  // The first trace of all is coarse, since nothing is known of how long it will take.
  ASSERT_TRUE(waitUntil([&] { return model.poll().waves; }));
  const vtkIdType first = model.waves().rays->GetNumberOfCells();
  ASSERT_TRUE(waitUntilRefined(model));
  EXPECT_LT(2 * first, model.waves().rays->GetNumberOfCells());
}

TEST(WaveModel, FollowsASliderThatMoves)
{
  const Scene scene("bay");
  auto setup = scene.setup();
  setup.frame = 1e-6; // every trace is too slow: each setting is traced coarsely and given up for the next
  WaveModel model(setup);
  WaveControls controls = BayWave;
  int seen = 0;
  for (int i = 0; i < 20; ++i)
  {
    controls.directionFrom = 80.0 + i;
    model.setControls(controls);
    // One of the settings is seen before the next but one.
    ASSERT_TRUE(waitUntil([&] { return model.poll().waves; }));
    seen += model.waves().controls == controls ? 1 : 0;
  }
  EXPECT_GE(seen, 10);
  ASSERT_TRUE(waitUntilRefined(model));
  EXPECT_EQ(model.waves().controls, controls);
}

TEST(WaveModel, RemembersWhatWasTraced)
{
  const Scene scene("bay");
  auto setup = scene.setup();
  setup.frame = 1e-6; // new settings are traced coarsely first
  WaveModel model(setup);
  model.setControls(BayWave);
  ASSERT_TRUE(waitUntilRefined(model));
  const auto rays = model.waves().rays;
  WaveControls other = BayWave;
  other.period = 4.0;
  model.setControls(other);
  ASSERT_TRUE(waitUntilRefined(model));
  model.setControls(BayWave);
  ASSERT_TRUE(waitUntil([&] { return model.poll().waves; }));
  EXPECT_EQ(model.waves().coarseness, 1); // at once
  EXPECT_EQ(model.waves().rays, rays);
}

TEST(WaveModel, SaysWhyThereAreNoWaves)
{
  const Scene scene("bay"); // open to the east
  WaveModel model(scene.setup());
  WaveControls controls = BayWave;
  controls.directionFrom = 270.0;
  model.setControls(controls);
  ASSERT_TRUE(waitUntilRefined(model));
  EXPECT_EQ(model.waves().rays, nullptr);
  EXPECT_NE(model.waves().failure.find("comes in nowhere over water"), std::string::npos) << model.waves().failure;
  model.requestSurface(0.0);
  ASSERT_TRUE(waitUntil([&] { return model.poll().surface; }));
  EXPECT_EQ(model.surface().surface, nullptr);
  // And goes on with the next wave.
  model.setControls(BayWave);
  ASSERT_TRUE(waitUntilRefined(model));
  EXPECT_NE(model.waves().rays, nullptr);
}

TEST(WaveModel, TideMovesTheShore)
{
  const Scene scene("plane:facing=270,slope=0.02");
  WaveModel model(scene.setup());
  double reach[2] = { 0.0, 0.0 };
  for (int i = 0; i < 2; ++i)
  {
    model.setControls({ 6.0, 270.0, 0.5, static_cast<double>(i) });
    ASSERT_TRUE(waitUntilRefined(model));
    double bounds[6];
    model.waves().rays->GetBounds(bounds);
    reach[i] = bounds[1];
  }
  // A metre of tide floods 50 m of a beach of 1 in 50; rays end between its last nodes.
  EXPECT_NEAR(reach[1] - reach[0], 50.0, 5.0);
}

TEST(WaveModel, MovesTheSea)
{
  const Scene scene("bay");
  WaveModel model(scene.setup());
  model.setControls(BayWave);
  ASSERT_TRUE(waitUntilRefined(model));
  double highest[2] = { 0.0, 0.0 };
  double first[2][3];
  for (int i = 0; i < 2; ++i)
  {
    model.requestSurface(0.5 * i);
    ASSERT_TRUE(waitUntil([&] { return model.poll().surface; }));
    ASSERT_NE(model.surface().surface, nullptr) << model.surface().failure;
    EXPECT_EQ(model.surface().time, 0.5 * i);
    EXPECT_NE(model.surface().surface->GetPointData()->GetArray("Foam"), nullptr);
    double bounds[6];
    model.surface().surface->GetBounds(bounds);
    highest[i] = bounds[5];
    model.surface().surface->GetPoint(0, first[i]);
  }
  EXPECT_GT(highest[0], 0.15); // crests of waves 0.4 m high
  EXPECT_NE(first[0][2], first[1][2]);
}

TEST(WaveModel, RefusesASeaThatIsTooLarge)
{
  const Scene scene("bay");
  auto setup = scene.setup();
  setup.mostSurfacePoints = 100;
  WaveModel model(setup);
  model.setControls(BayWave);
  ASSERT_TRUE(waitUntilRefined(model));
  model.requestSurface(0.0);
  ASSERT_TRUE(waitUntil([&] { return model.poll().surface; }));
  EXPECT_EQ(model.surface().surface, nullptr);
  EXPECT_NE(model.surface().failure.find("--crop"), std::string::npos);
}

TEST(WaveModel, TellsTheWavesAtAPlace)
{
  // A beach of 1 in 50 that faces west: 10 m deep 500 m from the shore at x = 0.
  const Scene scene("plane:facing=270,slope=0.02");
  WaveModel model(scene.setup());
  model.setControls({ 6.0, 270.0, 0.5, 0.0 });
  ASSERT_TRUE(waitUntilRefined(model));
  double bounds[6];
  scene.setup().seafloor->GetBounds(bounds);
  const double y = 0.5 * (bounds[2] + bounds[3]);
  model.requestWavesAt(-200.0, y);
  ASSERT_TRUE(waitUntil([&] { return model.poll().wavesAt; }));
  const WavesAt at = *model.wavesAt();
  constexpr double Exact = 1e-6; // a plane is its own spline
  EXPECT_NEAR(at.depth, 4.0, Exact);
  EXPECT_NEAR(at.elevation, -4.0, Exact);
  EXPECT_EQ(at.period, 6.0);
  constexpr double BetweenRays = 0.05; // m, degrees: linear between fronts an eighth of a wave apart
  EXPECT_NEAR(at.directionFrom, 270.0, BetweenRays);
  ASSERT_GE(at.ray, 0);
  // Waves straight onto a beach are not refracted, and their height is the offshore one times the shoaling.
  EXPECT_NEAR(at.refraction, 1.0, 1e-6);
  EXPECT_NEAR(at.height, 0.5 * at.shoaling, BetweenRays);
  double ray[6];
  model.waves().rays->GetCellBounds(at.ray, ray);
  EXPECT_LT(std::abs(ray[2] - y), 30.0);

  model.requestWavesAt(50.0, y); // on land
  ASSERT_TRUE(waitUntil([&] { return model.poll().wavesAt; }));
  EXPECT_TRUE(std::isnan(model.wavesAt()->height));
  EXPECT_EQ(model.wavesAt()->ray, -1);
}

TEST(WaveModel, EndsInTheMiddleOfItsWork)
{
  const Scene scene("island");
  WaveModel model(scene.setup());
  model.setControls({ 8.0, 270.0, 1.0, 0.0 });
  model.requestSurface(1.0);
  model.requestWavesAt(0.0, 0.0);
  SUCCEED(); // destroying it must neither hang nor crash
}
