#pragma once

#include "sim/forms/LocalFrame.h"

namespace swellray
{

/**
 * Coast with a bay between two capes, or a headland between two coves. In the axes of the coast, u seaward and
 * v along the shore, the shoreline is
 *
 *   us(v) = a (1 - t^2) exp(-t^2/2),  t = v/w      (a > 0: headland, a < 0: bay)
 *
 * and the depth, with d = u - us(v) the distance seaward of it,
 *
 *   h = s (d + us(v) tanh(d/e))
 *
 * so that the contours follow the shoreline inshore and straighten within a few e offshore, where h = s u.
 * The depth grows seaward everywhere when e is larger than the farthest that the shoreline lies landward of u = 0.
 */
class CurvedCoast final : public Seafloor
{
public:
  struct Shape
  {
    double slope = 0.0; ///< s, m/m, > 0
    double reach = 0.0; ///< a, m, signed
    double sigma = 1.0; ///< w, m, > 0
    double fade = 1.0;  ///< e, m, > 0
  };

  /** @param bearing nautical degrees the seaward normal of the straight coast points to */
  CurvedCoast(const Rectangle& bounds, double bearing, const Shape& shape);

  /** How far the coves beside a headland of reach 1 cut in: 2 exp(-3/2). */
  static double coveShare();

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override;
  double featureLength() const override;
  double resolution() const override { return 0.1 * featureLength(); }
  double highestElevation(const Rectangle& box) const override;
  double lowestElevation(const Rectangle& box) const override;

private:
  struct Interval
  {
    double low = 0.0;
    double high = 0.0;
  };

  Interval shoreline(const Interval& v) const;
  Interval depthsIn(const Rectangle& box) const;

  Rectangle Bounds;
  LocalFrame Frame;
  Shape Coast;
};

}
