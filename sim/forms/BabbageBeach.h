#pragma once

#include "sim/SplineSeafloor.h"

namespace swellray
{

/**
 * Babbage Beach, the beach of Peachey 1986 (Modeling waves and surf): 1 km of coast facing north, with cliffs, a
 * sandy beach, a headland and a shoal offshore.
 *
 * The paper has only a picture of its coarse table of elevations; this is a table of our own, refined by a C2
 * spline as the paper proposes. As there, the water along the seaward edge is 10 m deep on average.
 */
class BabbageBeach final : public Seafloor
{
public:
  /** Extent of the table: 1000 m along the shore by 800 m. */
  static Rectangle extent();

  /** Mean depth along the seaward edge in the table, m. */
  static double offshoreDepth();

  /**
   * @param bounds scene, inside extent()
   * @param offshoreDepth mean depth along the seaward edge, m, > 0; the depths of the table are scaled to it
   */
  BabbageBeach(const Rectangle& bounds, double offshoreDepth);

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override
  {
    this->Surface.evaluate(p, region, bed);
  }
  double featureLength() const override { return this->Surface.featureLength(); }
  double resolution() const override { return this->Surface.resolution(); }
  double highestElevation(const Rectangle& box) const override { return this->Surface.highestElevation(box); }
  double lowestElevation(const Rectangle& box) const override { return this->Surface.lowestElevation(box); }

private:
  Rectangle Bounds;
  SplineSeafloor Surface;
};

}
