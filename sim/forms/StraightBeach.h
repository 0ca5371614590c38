#pragma once

#include "sim/forms/LocalFrame.h"

namespace swellray
{

/**
 * Beach with straight parallel contours: the depth is a function of the distance u seaward of the shoreline,
 * which runs through the origin. The slope may end at a flat floor offshore, at a declared kink.
 */
class StraightBeach : public Seafloor
{
public:
  /** @param bearing nautical degrees the seaward normal points to */
  StraightBeach(const Rectangle& bounds, double bearing);

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override;
  double featureLength() const override { return this->FeatureLength; }
  double resolution() const override { return 0.1 * this->FeatureLength; }
  unsigned kinkCount() const override { return this->HasFloor ? 1 : 0; }
  double kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const override;
  double highestElevation(const Rectangle& box) const override;
  double lowestElevation(const Rectangle& box) const override;

protected:
  /** Depth, m, and its derivatives in the direction seaward. */
  struct Profile
  {
    double depth = 0.0;
    double slope = 0.0;     ///< m/m
    double curvature = 0.0; ///< 1/m
  };

  struct Interval
  {
    double low = 0.0;
    double high = 0.0;
  };

  /** Profile at u, m, of any sign; finite everywhere. */
  virtual Profile profile(double u) const = 0;

  /** Bounds of the depth for u in an interval. */
  virtual Interval depthBounds(const Interval& u) const = 0;

  /** The floor is flat seaward of u = edge, at this depth. */
  void setOffshoreFloor(double edge, double depth);

  void setFeatureLength(double length) { this->FeatureLength = length; }

private:
  Interval depthsIn(const Rectangle& box) const;

  Rectangle Bounds;
  LocalFrame Frame;
  double FeatureLength;
  bool HasFloor = false;
  double FloorEdge = 0.0;
  double FloorDepth = 0.0;
};

}
