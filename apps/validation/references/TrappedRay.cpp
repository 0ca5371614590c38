#include "TrappedRay.h"

#include <cmath>

namespace swellray::reference
{

Place TrappedRay::at(Real theta) const
{
  const Real omega = 2.0L * Pi / this->period;
  const Real start = this->theta0 * Pi / 180.0L;
  const Real along = wavenumber(omega, this->slope * this->x0) * std::sin(start);
  const auto rate = [&](Real heading) -> std::array<Real, 4>
  {
    const Real k = along / std::sin(heading);
    const Real h = depthOf(omega, k);
    // dx/dtheta = h'(k)/s dk/dtheta, dk/dtheta = -k cos/sin: over cos theta.
    const Real overCosine = -k / std::sin(heading) / (wavenumberSlope(omega, h) * this->slope);
    return { std::sin(heading) * overCosine, k * overCosine, overCosine / groupSpeed(omega, h), overCosine };
  };
  const auto sums = integrate(rate, start, theta);
  Place place;
  place.x = static_cast<double>(depthOf(omega, along / std::sin(theta)) / this->slope);
  place.y = static_cast<double>(sums[0]);
  place.theta = static_cast<double>(theta);
  place.phase = static_cast<double>(sums[1]);
  place.time = static_cast<double>(sums[2]);
  place.length = static_cast<double>(sums[3]);
  place.width = static_cast<double>(std::cos(theta) / std::cos(start));
  place.caustics = place.width < 0.0 ? 1 : 0;
  return place;
}

}
