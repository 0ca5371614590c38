#include "sim/forms/RadialForm.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace swellray
{

RadialForm::RadialForm(const Rectangle& bounds, const glm::dvec2& centre, double featureLength)
  : Bounds(bounds)
  , Centre(centre)
  , FeatureLength(featureLength)
{
}

void RadialForm::setRim(double radius, double depth)
{
  this->Rim = radius;
  this->FlatDepth = depth;
}

void RadialForm::evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const
{
  bed = {};
  if (region & 1u)
  {
    bed.elevation = -this->FlatDepth;
    return;
  }
  const glm::dvec2 d = p - this->Centre;
  const Profile at = profile(glm::dot(d, d));
  bed.elevation = at.elevation;
  bed.gradient = 2.0 * at.first * d;
  bed.xx = 2.0 * at.first + 4.0 * at.second * d.x * d.x;
  bed.xy = 4.0 * at.second * d.x * d.y;
  bed.yy = 2.0 * at.first + 4.0 * at.second * d.y * d.y;
}

double RadialForm::kinkLevel(unsigned, const glm::dvec2& p, glm::dvec2& gradient) const
{
  // About r - Rim near the rim, and smooth at the centre.
  const glm::dvec2 d = p - this->Centre;
  gradient = d / this->Rim;
  return 0.5 * (glm::dot(d, d) / this->Rim - this->Rim);
}

double RadialForm::elevationAt(double w) const
{
  return this->Rim > 0.0 && w > this->Rim * this->Rim ? -this->FlatDepth : profile(w).elevation;
}

double RadialForm::highestElevation(const Rectangle& box) const
{
  const glm::dvec2 nearest = glm::clamp(this->Centre, box.low, box.high) - this->Centre;
  return elevationAt(glm::dot(nearest, nearest));
}

double RadialForm::lowestElevation(const Rectangle& box) const
{
  const glm::dvec2 farthest = glm::max(glm::abs(box.low - this->Centre), glm::abs(box.high - this->Centre));
  return elevationAt(glm::dot(farthest, farthest));
}

}
