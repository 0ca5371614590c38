#pragma once

#include "sim/forms/StraightBeach.h"

namespace swellray
{

/** Plane beach with a longshore bar: h = s u - hb exp(-((u - xb)/wb)^2). */
class BarBeach final : public StraightBeach
{
public:
  struct Bar
  {
    double height = 0.0;   ///< hb, m
    double position = 0.0; ///< xb, m seaward of the shoreline
    double width = 1.0;    ///< wb, m, > 0
  };

  /**
   * @param slope s, m/m, > 0
   * @param offshoreDepth depth at which the slope ends at a flat floor, m, > s xb; 0: it goes on
   */
  BarBeach(const Rectangle& bounds, double bearing, double slope, const Bar& bar, double offshoreDepth);

protected:
  Profile profile(double u) const override;
  Interval depthBounds(const Interval& u) const override;

private:
  double Slope;
  Bar Shape;
};

}
