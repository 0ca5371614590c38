#include "sim/forms/BarBeach.h"

#include <algorithm>
#include <cmath>

namespace swellray
{

BarBeach::BarBeach(const Rectangle& bounds, double bearing, double slope, const Bar& bar, double offshoreDepth)
  : StraightBeach(bounds, bearing)
  , Slope(slope)
  , Shape(bar)
{
  setFeatureLength(std::min(featureLength(), 0.5 * bar.width));
  if (offshoreDepth > 0.0)
  {
    // Seaward of the bar the depth grows all the way: halve the interval in which it passes the floor's.
    double low = offshoreDepth / slope;
    double high = (offshoreDepth + bar.height) / slope;
    for (double middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high))
    {
      (this->BarBeach::profile(middle).depth < offshoreDepth ? low : high) = middle;
    }
    setOffshoreFloor(high, offshoreDepth);
  }
}

StraightBeach::Profile BarBeach::profile(double u) const
{
  const double t = (u - this->Shape.position) / this->Shape.width;
  const double bar = this->Shape.height * std::exp(-t * t);
  return { this->Slope * u - bar, this->Slope + 2.0 * t * bar / this->Shape.width,
    (2.0 - 4.0 * t * t) * bar / (this->Shape.width * this->Shape.width) };
}

StraightBeach::Interval BarBeach::depthBounds(const Interval& u) const
{
  const auto barAt = [this](double distance)
  {
    const double t = distance / this->Shape.width;
    return this->Shape.height * std::exp(-t * t);
  };
  const double nearest = std::max({ u.low - this->Shape.position, this->Shape.position - u.high, 0.0 });
  const double farthest = std::max(std::abs(u.low - this->Shape.position), std::abs(u.high - this->Shape.position));
  return { this->Slope * u.low - barAt(nearest), this->Slope * u.high - barAt(farthest) };
}

}
