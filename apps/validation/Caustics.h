#pragma once

#include "GridRun.h"

namespace swellray::validation
{

/** A ray that passes a caustic, over the formula of its seafloor. */
struct CausticRay
{
  reference::Place start;
  double reach = 0.0; ///< m: look for caustics so far along the ray
};

/**
 * Compare the places where tubes have no width, found in the equations of Munk and Arthur, with those of the rays.
 * @param step m, of the exact side
 * The same on grids, without those spacings whose rays come to it elsewhere altogether.
 * @param step m, of the exact side
 * @param length a length of the scene over which a ray tube changes, m
 */
Outcome compareCaustics(const RayScene& scene, const reference::Formula& formula, const std::vector<CausticRay>& rays,
  double step, double length, const GridPlan& plan, const Setting& setting);

}
