#include "sim/forms/ConicalIsland.h"

#include <algorithm>
#include <cmath>

namespace swellray
{

ConicalIsland::ConicalIsland(
  const Rectangle& bounds, const glm::dvec2& centre, double slope, double shoreRadius, double toeRadius)
  : RadialForm(bounds, centre, 0.5 * std::min(shoreRadius, toeRadius - shoreRadius))
  , Slope(slope)
  , ShoreRadius(shoreRadius)
{
  setRim(toeRadius, slope * (toeRadius - shoreRadius));
}

RadialForm::Profile ConicalIsland::profile(double w) const
{
  const double cap = 0.5 * this->ShoreRadius;
  if (w < cap * cap)
  {
    // Value, slope and curvature of the cone at r = cap.
    const double t = w / (cap * cap);
    const double rise = this->Slope * cap;
    return { this->Slope * this->ShoreRadius - 0.125 * rise * (3.0 + t * (6.0 - t)),
      -0.125 * this->Slope / cap * (6.0 - 2.0 * t), 0.25 * this->Slope / (cap * cap * cap) };
  }
  const double r = std::sqrt(w);
  return { -this->Slope * (r - this->ShoreRadius), -0.5 * this->Slope / r, 0.25 * this->Slope / (r * w) };
}

}
