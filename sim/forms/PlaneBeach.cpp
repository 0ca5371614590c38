#include "sim/forms/PlaneBeach.h"

namespace swellray
{

PlaneBeach::PlaneBeach(const Rectangle& bounds, double bearing, double slope, double offshoreDepth)
  : StraightBeach(bounds, bearing)
  , Slope(slope)
{
  if (offshoreDepth > 0.0)
  {
    setOffshoreFloor(offshoreDepth / slope, offshoreDepth);
  }
}

StraightBeach::Profile PlaneBeach::profile(double u) const
{
  return { this->Slope * u, this->Slope, 0.0 };
}

StraightBeach::Interval PlaneBeach::depthBounds(const Interval& u) const
{
  return { this->Slope * u.low, this->Slope * u.high };
}

}
