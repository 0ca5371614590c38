// Seafloors designed for the curves of their rays.
#include "Families.h"
#include "GridRun.h"
#include "Problems.h"

#include <utility>

namespace swellray::validation
{

using reference::Design;
using reference::DesignedRay;

Outcome runDesign(const std::vector<DesignedRay>& rays, const DesignGrid& grid, const Setting& setting)
{
  const reference::FormulaSeafloor seafloor = rays.front().seafloor();
  RayScene scene;
  scene.seafloor = &seafloor;
  scene.period = rays.front().period;
  scene.agroundDepth = 1e-3;
  scene.by = FrontMeasure::Phase;
  scene.map = true;
  for (const DesignedRay& ray : rays)
  {
    scene.tracks.push_back({ [&ray](const RayMedium& medium) { return ray.start(medium); }, ray.places });
  }
  const reference::Formula& formula = rays.front().formula;
  scene.depth = [&formula](const reference::Place& place)
  { return formula.depth(reference::Jet(place.x), reference::Jet(place.y), formula.region(place.x, place.y)).value; };
  RayLimits limits;
  limits.positionReason = "some hundred steps, each right to 1e-12 of a wavelength near 100 m";
  Outcome outcome = compareRays(scene, limits, setting);
  GridPlan plan = planFor(grid.order);
  plan.spacings = grid.spacings;
  addGridConvergence(scene, plan, setting, outcome);
  return outcome;
}

std::vector<Case> designCases()
{
  const std::string how = " The depth is h = atanh(k_inf/k)/k, exact at any period.";
  std::vector<Case> cases;
  const auto add = [&](
                     const char* name, const char* title, const std::string& formula, const DesignGrid& grid, auto make)
  {
    cases.push_back({ name, title, formula + how,
      [grid, make](const Setting& setting) { return runDesign(make(), grid, setting); } });
  };
  const DesignGrid straight{ GridOrder::Straight, { 40.0, 20.0, 10.0 } };
  const DesignGrid turning{ GridOrder::Turning, { 40.0, 20.0, 10.0 } };
  const DesignGrid curved{ GridOrder::Curved, { 40.0, 20.0, 10.0 } };
  const DesignGrid kinked{ GridOrder::Kinked, { 40.0, 20.0, 10.0, 5.0 } };
  const Design beach{ 10.0, 12.0, 1000.0, 45.0 };
  const Design island{ 10.0, 12.0, 1000.0, 40.0 };
  const Design fold{ 10.0, 5.0, 428.654868376, 65.0 };
  const Design lens{ 10.0, 15.0, 500.0, 0.0 };
  using Rays = std::vector<DesignedRay>;
  add("c3_design_circle", "Circular rays", "k = k0 x0/x, T = 10 s, 45 degrees: circles of radius x0/sin(theta0).",
    straight, [beach] { return Rays{ circleRay(beach) }; });
  add("c3_design_cycloid", "Cycloidal rays", "k = k0 sqrt(x0/x), T = 10 s, 45 degrees: a cycloid.", straight,
    [beach] { return Rays{ cycloidRay(beach) }; });
  add("c3_design_spiral_island", "Spiral around an island",
    "k = k0 r0/r, T = 10 s, 40 degrees from the radius: a logarithmic spiral.", curved,
    [island] { return Rays{ spiralRay(island) }; });
  add("c3_design_parabola_island", "Parabola around an island",
    "k = k0 sqrt(r0/r), T = 10 s, 40 degrees from the radius: a parabola around its focus, with a caustic at its "
    "vertex.",
    curved, [island] { return Rays{ islandParabolaRay(island) }; });
  add("c3_design_fold_parabola", "Parabola to a fold caustic",
    "k^2 = k0^2 - mu x, T = 10 s, 65 degrees: a parabola that turns at the caustic.", turning,
    [fold] { return Rays{ foldParabolaRay(fold, reference::Neighbours::Parallel) }; });
  add("c3_design_luneburg", "Luneburg lens",
    "k = k0 sqrt(2 - r^2/R^2), T = 10 s, R = 500 m: all rays meet in (R, 0) with one phase, k0 R (1 + pi/2).", kinked,
    [lens]
    {
      Rays rays;
      for (const double share : { -0.9, -0.5, -0.1, 0.3, 0.7 })
      {
        rays.push_back(luneburgRay(lens, share));
      }
      return rays;
    });
  return cases;
}

}
