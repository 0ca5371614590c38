#pragma once

#include "sim/Current.h"
#include "sim/SplineSeafloor.h"

namespace swellray
{

/**
 * Gridded current: each component is the interpolating C2 spline of SplineSeafloor, with its orders of error.
 *
 * Nodes that are NaN (land, no data) take a smooth continuation of the current around them.
 */
class SplineCurrent final : public Current
{
public:
  /**
   * @param u, v east and north component, m/s, in the place of elevations, on the same nodes
   * @throws std::invalid_argument as SplineSeafloor, or where the two grids differ
   */
  SplineCurrent(const ElevationGrid& u, const ElevationGrid& v);

  Rectangle bounds() const override { return this->U.bounds(); }
  void evaluate(const glm::dvec2& p, CurrentSample& sample) const override;
  double featureLength() const override { return this->U.featureLength(); }

private:
  SplineSeafloor U;
  SplineSeafloor V;
};

}
