#pragma once

#include "sim/forms/StraightBeach.h"

namespace swellray
{

/** Plane beach: h = s u. */
class PlaneBeach final : public StraightBeach
{
public:
  /**
   * @param slope s, m/m, > 0
   * @param offshoreDepth depth at which the slope ends at a flat floor, m; 0: it goes on
   */
  PlaneBeach(const Rectangle& bounds, double bearing, double slope, double offshoreDepth);

protected:
  Profile profile(double u) const override;
  Interval depthBounds(const Interval& u) const override;

private:
  double Slope;
};

}
