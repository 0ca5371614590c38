#include "sim/SplineCurrent.h"

#include <stdexcept>

namespace swellray
{

SplineCurrent::SplineCurrent(const ElevationGrid& u, const ElevationGrid& v)
  : U(u)
  , V(v)
{
  if (u.columns != v.columns || u.rows != v.rows || u.origin != v.origin || u.spacing != v.spacing)
  {
    throw std::invalid_argument("the two components of the current must lie on the same nodes");
  }
}

void SplineCurrent::evaluate(const glm::dvec2& p, CurrentSample& sample) const
{
  BedSample u;
  BedSample v;
  this->U.evaluate(p, 0, u);
  this->V.evaluate(p, 0, v);
  sample.velocity = { u.elevation, v.elevation };
  sample.dx = { u.gradient.x, v.gradient.x };
  sample.dy = { u.gradient.y, v.gradient.y };
  sample.dxx = { u.xx, v.xx };
  sample.dxy = { u.xy, v.xy };
  sample.dyy = { u.yy, v.yy };
}

}
