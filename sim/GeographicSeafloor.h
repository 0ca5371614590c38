#pragma once

#include "sim/EllipsoidMercator.h"
#include "sim/SplineSeafloor.h"

#include <memory>

namespace swellray
{

/**
 * Seafloor of a grid in longitude and latitude on Mercator's map of an ellipsoid: the C2 spline of the grid itself, in
 * degrees, seen through the map and not resampled. Longitudes may go on beyond 180 degrees.
 */
class GeographicSeafloor final : public Seafloor
{
public:
  /**
   * @param grid elevations on nodes in degrees: x longitude, y latitude within those of EllipsoidMercator
   * @throws std::invalid_argument as SplineSeafloor, or where the latitudes reach beyond the map's
   */
  GeographicSeafloor(const ElevationGrid& grid, std::shared_ptr<const EllipsoidMercator> map);

  /** The map, whose metres the points of this seafloor are. */
  const EllipsoidMercator& map() const { return *this->Map; }

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override;
  double featureLength() const override;
  double resolution() const override;
  /** True metres at the middle of the grid. */
  double cellSize() const override { return this->TrueCell; }
  std::vector<glm::dvec2> outline() const override;
  bool hasHoles() const override { return this->Spline.hasHoles(); }
  bool isHole(const glm::dvec2& p) const override;
  double highestElevation(const Rectangle& box) const override;
  double lowestElevation(const Rectangle& box) const override;

private:
  Rectangle toLonLat(const Rectangle& box) const;

  SplineSeafloor Spline;
  std::shared_ptr<const EllipsoidMercator> Map;
  Rectangle Bounds;
  double SmallestCell = 0.0; // m of the map
  double LargestCell = 0.0;
  double TrueCell = 0.0; // m
};

}
