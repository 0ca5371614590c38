#pragma once

#include "sim/forms/RadialForm.h"

namespace swellray
{

/** Gaussian shoal: h = h0 - a exp(-r^2/(2 sigma^2)). */
class GaussianShoal final : public RadialForm
{
public:
  /**
   * @param depth h0 around the shoal, m, > 0
   * @param height a, m, >= 0
   * @param sigma standard deviation, m, > 0
   */
  GaussianShoal(const Rectangle& bounds, const glm::dvec2& centre, double depth, double height, double sigma);

protected:
  Profile profile(double w) const override;

private:
  double Depth;
  double Height;
  double Decay; // 1/(2 sigma^2)
};

}
