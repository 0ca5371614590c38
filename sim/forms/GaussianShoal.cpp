#include "sim/forms/GaussianShoal.h"

#include <cmath>

namespace swellray
{

GaussianShoal::GaussianShoal(
  const Rectangle& bounds, const glm::dvec2& centre, double depth, double height, double sigma)
  : RadialForm(bounds, centre, 0.5 * sigma)
  , Depth(depth)
  , Height(height)
  , Decay(0.5 / (sigma * sigma))
{
}

RadialForm::Profile GaussianShoal::profile(double w) const
{
  const double bell = this->Height * std::exp(-this->Decay * w);
  return { bell - this->Depth, -this->Decay * bell, this->Decay * this->Decay * bell };
}

}
