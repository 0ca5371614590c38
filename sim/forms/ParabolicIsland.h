#pragma once

#include "sim/forms/RadialForm.h"

namespace swellray
{

/** Parabolic island, its shore a point: h = h0 (r/R)^2 up to r = R, flat beyond. */
class ParabolicIsland final : public RadialForm
{
public:
  /**
   * @param depth h0, m, > 0
   * @param radius R, m, > 0
   */
  ParabolicIsland(const Rectangle& bounds, const glm::dvec2& centre, double depth, double radius);

protected:
  Profile profile(double w) const override;

private:
  double Curvature; // h0/R^2
};

}
