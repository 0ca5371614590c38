#include "sim/forms/StraightBeach.h"

#include <algorithm>

namespace swellray
{

StraightBeach::StraightBeach(const Rectangle& bounds, double bearing)
  : Bounds(bounds)
  , Frame(LocalFrame::facing(bearing))
  , FeatureLength(0.1 * std::min(bounds.size().x, bounds.size().y))
{
}

void StraightBeach::setOffshoreFloor(double edge, double depth)
{
  this->HasFloor = true;
  this->FloorEdge = edge;
  this->FloorDepth = depth;
}

void StraightBeach::evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const
{
  bed = {};
  if (region & 1u)
  {
    bed.elevation = -this->FloorDepth;
    return;
  }
  const Profile at = profile(glm::dot(this->Frame.axis(), p));
  bed.elevation = -at.depth;
  bed.gradient.x = -at.slope;
  bed.xx = -at.curvature;
  this->Frame.toScene(bed);
}

double StraightBeach::kinkLevel(unsigned, const glm::dvec2& p, glm::dvec2& gradient) const
{
  gradient = this->Frame.axis();
  return glm::dot(gradient, p) - this->FloorEdge;
}

StraightBeach::Interval StraightBeach::depthsIn(const Rectangle& box) const
{
  const Rectangle local = this->Frame.boxToLocal(box);
  const Interval u{ local.low.x, local.high.x };
  if (!this->HasFloor || u.high <= this->FloorEdge)
  {
    return depthBounds(u);
  }
  if (u.low >= this->FloorEdge)
  {
    return { this->FloorDepth, this->FloorDepth };
  }
  const Interval depth = depthBounds({ u.low, this->FloorEdge });
  return { std::min(depth.low, this->FloorDepth), std::max(depth.high, this->FloorDepth) };
}

double StraightBeach::highestElevation(const Rectangle& box) const
{
  return -depthsIn(box).low;
}

double StraightBeach::lowestElevation(const Rectangle& box) const
{
  return -depthsIn(box).high;
}

}
