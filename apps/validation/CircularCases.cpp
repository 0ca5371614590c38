// Circular shoals and islands: Bouguer's law for the ray, Munk and Arthur's equation for its tube.
#include "Caustics.h"
#include "Families.h"
#include "GridRun.h"
#include "Problems.h"

#include "sim/BuiltinSeafloor.h"

#include <algorithm>
#include <cmath>

namespace swellray::validation
{

namespace
{

using reference::Place;

constexpr const char* Scene = ",x0=-9000,x1=9000,y0=-9000,y1=9000";
constexpr double AgroundDepth = 0.3;
// Steps of the exact side a length over which the bed changes: with order 4 its own error is below 1e-10 at the shore of an island, too.
constexpr double ReferenceSteps = 800.0;

Place beginning(const Circular& c, double b)
{
  Place start;
  start.x = c.x0;
  start.y = b;
  return start;
}

RayScene sceneOf(const Circular& c, const Seafloor& seafloor)
{
  RayScene scene;
  scene.seafloor = &seafloor;
  scene.period = c.period;
  scene.agroundDepth = AgroundDepth;
  scene.map = true;
  scene.depth = [&c](const Place& place) { return static_cast<double>(c.form.depth(std::hypot(place.x, place.y))); };
  return scene;
}

GridPlan gridPlan(const Circular& c)
{
  // The third derivative of the polynomial shoal jumps at its rim: that leaves the orders of a smooth bed.
  const bool island = c.form.depth(0.0L) <= 0.0L;
  GridPlan plan = planFor(island ? GridOrder::Kinked : GridOrder::Curved);
  plan.turn = 0.3;
  for (const double nodes : { 4.0, 8.0, 16.0, 32.0 })
  {
    plan.spacings.push_back(c.form.feature / nodes * (island ? 2.0 : 1.0));
  }
  return plan;
}

/** Places by Bouguer's law on the way in, and out again where the ray does not run ashore. */
std::vector<Place> bouguerPlaces(const Circular& c, double omega, double b)
{
  const reference::CircularRay exact(c.form.depth, omega, c.x0, b, c.form.rim);
  const double far = std::hypot(c.x0, b);
  double near = std::max(exact.nearest(), 1.0);
  const bool ashore = c.form.depth(near) < 1.1 * AgroundDepth;
  while (c.form.depth(near) < 1.1 * AgroundDepth)
  {
    near += 1e-3 * far;
  }
  constexpr int count = 12;
  std::vector<Place> places;
  for (int i = 1; i <= (ashore ? count : 2 * count); ++i)
  {
    const double share = 1.0 - static_cast<double>(i) / count;
    places.push_back(exact.at(near + (far - near) * share * share, i > count));
  }
  return places;
}

}

Outcome runCircular(const Circular& c, const Setting& setting)
{
  const auto seafloor = makeBuiltinSeafloor(c.form.spec + Scene);
  const double omega = 2.0 * Pi / c.period;
  RayScene scene = sceneOf(c, *seafloor);
  RayScene bouguer = scene;
  for (const double b : c.b)
  {
    Track track;
    track.start = [&c, b](const RayMedium& medium) {
      return reference::startHeading(medium, { c.x0, b }, 0.0, { 0.0, 1.0 });
    };
    track.places = bouguerPlaces(c, omega, b);
    // The tube's equation is followed as far as the ray goes.
    const bool ashore = track.places.size() < 20;
    const double end = ashore ? track.places.back().length : -2.2 * c.x0;
    std::vector<double> lengths;
    for (int i = 1; i <= 40; ++i)
    {
      lengths.push_back(end * i / 40.0);
    }
    bouguer.tracks.push_back(track);
    track.places = traceMunkArthur(c.form.formula(), omega, beginning(c, b), lengths, c.form.feature / ReferenceSteps);
    scene.tracks.push_back(track);
  }
  RayLimits limits;
  limits.position = 5e-9;
  limits.relative = 3e-10;
  limits.positionReason = "steps right to 1e-12 of a wavelength near 100 m; passing a cusp magnifies some tenfold";
  Outcome outcome = compareRays(scene, limits, setting);
  const reference::RayErrors errors = rayErrors(bouguer, setting, FineTolerance);
  addPathChecks(errors, limits, ", Bouguer", outcome.checks);
  const GridPlan plan = gridPlan(c);
  // Close to the shore a ray that comes in elsewhere may be ashore.
  for (Track& track : scene.tracks)
  {
    while (scene.depth(track.places.back()) < 0.05 * scene.depth(track.places.front()))
    {
      track.places.pop_back();
    }
  }
  addGridConvergence(scene, plan, setting, outcome);
  return outcome;
}

Outcome runCircularCaustic(const Circular& c, const Setting& setting)
{
  const auto seafloor = makeBuiltinSeafloor(c.form.spec + Scene);
  std::vector<CausticRay> rays;
  const double half = c.form.rim > 0.0 ? 0.72 * c.form.rim : 1.5 * c.form.feature;
  const int count = setting.quick ? 7 : 25;
  for (int i = 0; i < count; ++i)
  {
    // Beside the axis, on which the cusp is.
    const double b = half * (2.0 * (i + 0.4) / count - 1.0);
    rays.push_back({ beginning(c, b), -3.0 * c.x0 });
  }
  return compareCaustics(sceneOf(c, *seafloor), c.form.formula(), rays, c.form.feature / ReferenceSteps, c.form.feature,
    gridPlan(c), setting);
}

std::vector<Case> circularCases()
{
  const std::string how =
    " Rays along +x. Bouguer's law k r sin(alpha) = const by quadrature in long double, the tube by the "
    "equations of Munk and Arthur 1952 in arc length, with their jump at a kink of the bed.";
  std::vector<Case> cases;
  for (const Circular& c :
    { Circular{ "c4_shoal_gauss", "Gaussian shoal", "h = 20 - 14 exp(-r^2/(2 300^2)), T = 10 s.",
        reference::gaussianShoal(20.0, 14.0, 300.0), 10.0, -1800.0, { -180.0, 30.0, 150.0, 300.0, 600.0 } },
      Circular{ "c4_shoal_poly3", "Polynomial shoal", "h = 15 - 10.5 (1 - (r/250)^2)^3, T = 8 s.",
        reference::polynomialShoal(15.0, 10.5, 250.0), 8.0, -300.0, { -200.0, 12.5, 100.0, 240.0 } },
      Circular{ "c4_island_cone", "Conical island", "h = 0.05 (r - 200) to r = 1000 m, T = 12 s.",
        reference::conicalIsland(0.05, 200.0, 1000.0), 12.0, -1500.0, { 20.0, 400.0, 800.0, 970.0 } },
      Circular{ "c4_island_parabolic", "Parabolic island", "h = 30 (r/1200)^2 to r = 1200 m, T = 14 s.",
        reference::parabolicIsland(30.0, 1200.0), 14.0, -1800.0, { 24.0, 400.0, 900.0, 1150.0 } } })
  {
    cases.push_back(
      { c.name, c.title, c.formula + how, [c](const Setting& setting) { return runCircular(c, setting); } });
    if (c.name.find("shoal") != std::string::npos)
    {
      cases.push_back({ c.name + "_caustic", c.title + ": its caustic",
        c.formula + (" Where the tube's width passes 0, by the equations of Munk and Arthur 1952."),
        [c](const Setting& setting) { return runCircularCaustic(c, setting); } });
    }
  }
  return cases;
}

}
