#ifndef CausticField_h
#define CausticField_h

#include "sim/RayCaustic.h"

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace swellray
{

/**
 * Put the field data array CausticPoints on rays: a tuple for each place at which a ray touches a caustic, its
 * components named as vtkSwellRayTracer lists them. None without a caustic.
 */
void setCaustics(vtkPolyData* rays, const std::vector<RayCaustic>& caustics);

/** Caustics by ray. */
struct RayCaustics
{
  std::vector<RayCaustic> caustics; ///< RayCaustic::ray is the index of a cell
  std::vector<std::size_t> offsets; ///< those of ray i are caustics[offsets[i]] to caustics[offsets[i + 1] - 1]
};

/**
 * What setCaustics() has put there. Rays that are not there any more (by the cell array RayId) are left out.
 * @throws std::invalid_argument where the array has other components
 */
RayCaustics causticsOf(vtkPolyData* rays);

}

#endif
