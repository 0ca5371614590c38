#include "sim/forms/PolynomialShoal.h"

namespace swellray
{

PolynomialShoal::PolynomialShoal(
  const Rectangle& bounds, const glm::dvec2& centre, double depth, double height, double radius)
  : RadialForm(bounds, centre, 0.125 * radius)
  , Depth(depth)
  , Height(height)
  , RimSquared(radius * radius)
{
  setRim(radius, depth);
}

RadialForm::Profile PolynomialShoal::profile(double w) const
{
  const double t = 1.0 - w / this->RimSquared;
  return { this->Height * t * t * t - this->Depth, -3.0 * this->Height * t * t / this->RimSquared,
    6.0 * this->Height * t / (this->RimSquared * this->RimSquared) };
}

}
