#include "sim/forms/ParabolicIsland.h"

namespace swellray
{

ParabolicIsland::ParabolicIsland(const Rectangle& bounds, const glm::dvec2& centre, double depth, double radius)
  : RadialForm(bounds, centre, 0.125 * radius)
  , Curvature(depth / (radius * radius))
{
  setRim(radius, depth);
}

RadialForm::Profile ParabolicIsland::profile(double w) const
{
  return { -this->Curvature * w, -this->Curvature, 0.0 };
}

}
