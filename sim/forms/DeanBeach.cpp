#include "sim/forms/DeanBeach.h"

#include <cmath>

namespace swellray
{

DeanBeach::DeanBeach(const Rectangle& bounds, double bearing, double scale, double minDepth, double offshoreDepth)
  : StraightBeach(bounds, bearing)
  , Scale(scale)
  , JoinDepth(minDepth)
  , JoinDistance(std::pow(minDepth / scale, 1.5))
{
  if (offshoreDepth > 0.0)
  {
    setOffshoreFloor(std::pow(offshoreDepth / scale, 1.5), offshoreDepth);
  }
}

StraightBeach::Profile DeanBeach::profile(double u) const
{
  if (u >= this->JoinDistance)
  {
    const double root = std::cbrt(u);
    const double slope = 2.0 * this->Scale / (3.0 * root);
    return { this->Scale * root * root, slope, -slope / (3.0 * u) };
  }
  const double join = this->JoinDistance;
  const double slope = 2.0 * this->JoinDepth / (3.0 * join);
  const double curvature = -slope / (3.0 * join);
  const double d = u - join;
  const double rise = std::expm1(d / join);
  return { this->JoinDepth + slope * d + curvature * join * (join * rise - d), slope + curvature * join * rise,
    curvature * (rise + 1.0) };
}

StraightBeach::Interval DeanBeach::depthBounds(const Interval& u) const
{
  return { profile(u.low).depth, profile(u.high).depth };
}

}
