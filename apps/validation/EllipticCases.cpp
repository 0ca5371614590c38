// The elliptic shoal of Berkhoff, Booij and Radder 1982, with kinks at its rim and at the toe of the slope.
#include "Caustics.h"
#include "Families.h"
#include "GridRun.h"
#include "Problems.h"

#include "sim/BuiltinSeafloor.h"

namespace swellray::validation
{

namespace
{

using reference::Place;

constexpr double Start = -10.0; // m
constexpr double Period = 1.0;  // s
// The scene is some 20 m long. Steps of 5 mm leave the exact side an error of order 4 below 1e-10.
constexpr double ReferenceStep = 5e-3;

RayScene sceneOf(const Seafloor& seafloor, const reference::Formula& formula)
{
  RayScene scene;
  scene.seafloor = &seafloor;
  scene.period = Period;
  scene.map = true;
  scene.depth = [&formula](const Place& place)
  { return formula.depth(reference::Jet(place.x), reference::Jet(place.y), formula.region(place.x, place.y)).value; };
  return scene;
}

GridPlan gridPlan()
{
  GridPlan plan = planFor(GridOrder::Kinked);
  plan.spacings = { 0.4, 0.2, 0.1, 0.05 };
  return plan;
}

Place beginning(double x0, double y0)
{
  Place start;
  start.x = x0;
  start.y = y0;
  return start;
}

}

Outcome runElliptic(const Elliptic& c, const Setting& setting)
{
  const auto seafloor = makeBuiltinSeafloor(c.spec + "x0=-20,x1=20,y0=-20,y1=20");
  const reference::Formula formula = c.shoal.formula();
  RayScene scene = sceneOf(*seafloor, formula);
  scene.period = c.period;
  std::vector<double> lengths;
  for (int i = 1; i <= 30; ++i)
  {
    lengths.push_back(-0.07 * c.from * i);
  }
  for (const double y0 : c.y)
  {
    const Place start = beginning(c.from, y0);
    scene.tracks.push_back({ [&c, y0](const RayMedium& medium) {
                              return reference::startHeading(medium, { c.from, y0 }, 0.0, { 0.0, 1.0 });
                            },
      traceMunkArthur(formula, 2.0 * Pi / c.period, start, lengths, ReferenceStep) });
  }
  RayLimits limits;
  limits.position = 1e-9;
  limits.relative = 1e-9;
  limits.width = 2e-8;
  limits.positionReason = "steps right to 1e-12 of a wavelength of 1.5 m, magnified behind the focus some hundredfold";
  limits.widthReason = "behind the focus a tube magnifies the errors of both sides some hundredfold";
  Outcome outcome = compareRays(scene, limits, setting);
  addGridConvergence(scene, gridPlan(), setting, outcome);
  return outcome;
}

namespace
{

Outcome rays(const Setting& setting)
{
  return runElliptic(
    { "berkhoff:", {}, Period, Start, { -4.7, -2.3, -1.1, -0.35, 0.15, 0.8, 1.7, 2.9, 4.3, 6.0 } }, setting);
}

Outcome caustic(const Setting& setting)
{
  const auto seafloor = makeBuiltinSeafloor("berkhoff:x0=-20,x1=20,y0=-20,y1=20");
  const reference::Formula formula = reference::EllipticShoal().formula();
  std::vector<CausticRay> rays;
  const int count = setting.quick ? 6 : 30;
  rays.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    rays.push_back({ beginning(Start, -2.4 + 4.8 * (i + 0.37) / count), 22.0 });
  }
  return compareCaustics(sceneOf(*seafloor, formula), formula, rays, ReferenceStep, 3.75, gridPlan(), setting);
}

}

std::vector<Case> ellipticCases()
{
  const std::string about =
    "The elliptic shoal of Berkhoff, Booij and Radder 1982 on a slope of 1 in 50, T = 1 s, rays along "
    "+x from x = -10 m, by the equations of Munk and Arthur 1952 with their jumps at the kinks.";
  return { { "c7c_berkhoff_rays", "Elliptic shoal", about, rays },
    { "c7c_berkhoff_caustic", "Elliptic shoal: its caustic", about, caustic } };
}

}
