#pragma once

#include "sim/forms/RadialForm.h"

namespace swellray
{

/**
 * Polynomial shoal: h = h0 - a (1 - (r/R)^2)^3 up to r = R, flat beyond.
 *
 * The bed is twice continuously differentiable at the rim; it is declared as a kink all the same, because its
 * third derivatives jump there and steps that end on it keep the integrator's order.
 */
class PolynomialShoal final : public RadialForm
{
public:
  /**
   * @param depth h0 around the shoal, m, > 0
   * @param height a, m, >= 0
   * @param radius R, m, > 0
   */
  PolynomialShoal(const Rectangle& bounds, const glm::dvec2& centre, double depth, double height, double radius);

protected:
  Profile profile(double w) const override;

private:
  double Depth;
  double Height;
  double RimSquared;
};

}
