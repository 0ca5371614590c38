#pragma once

#include "sim/forms/StraightBeach.h"

namespace swellray
{

/**
 * Equilibrium beach: h = A u^(2/3) (Bruun 1954, Dean 1977).
 *
 * The formula has a vertical slope at the shoreline. Where it is shallower than hm, at u < um, the profile
 * goes on, twice continuously differentiable, as
 *
 *   h = hm + m d - c um (um (exp(d/um) - 1) - d),  d = u - um,  m = 2 hm/(3 um),  c = 2 hm/(9 um^2)
 *
 * whose slope tends to 8 hm/(9 um) landward.
 */
class DeanBeach final : public StraightBeach
{
public:
  /**
   * @param scale A, m^(1/3), > 0
   * @param minDepth hm, m, > 0
   * @param offshoreDepth depth at which the slope ends at a flat floor, m, > hm; 0: it goes on
   */
  DeanBeach(const Rectangle& bounds, double bearing, double scale, double minDepth, double offshoreDepth);

protected:
  Profile profile(double u) const override;
  Interval depthBounds(const Interval& u) const override;

private:
  double Scale;
  double JoinDepth;
  double JoinDistance;
};

}
