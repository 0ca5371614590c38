#pragma once

#include "sim/forms/RadialForm.h"

namespace swellray
{

/**
 * Conical island: h = s (r - rs) up to the toe r = rt, flat beyond.
 *
 * Its summit is rounded within r < rs/2 by a polynomial in r^2 that keeps the bed twice continuously
 * differentiable.
 */
class ConicalIsland final : public RadialForm
{
public:
  /**
   * @param slope s, m/m, > 0
   * @param shoreRadius rs, m, > 0
   * @param toeRadius rt, m, > rs
   */
  ConicalIsland(const Rectangle& bounds, const glm::dvec2& centre, double slope, double shoreRadius, double toeRadius);

protected:
  Profile profile(double w) const override;

private:
  double Slope;
  double ShoreRadius;
};

}
