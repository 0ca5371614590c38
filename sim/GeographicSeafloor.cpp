#include "sim/GeographicSeafloor.h"

#include "sim/Angles.h"
#include "sim/ConvexOutline.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace swellray
{

namespace
{

// Cells of the grid that one step of an integrator may look over: as of the spline.
constexpr double FeatureCells = 8.0;

constexpr double OutlineInset = 1.5; // cells

}

GeographicSeafloor::GeographicSeafloor(const ElevationGrid& grid, std::shared_ptr<const EllipsoidMercator> map)
  : Spline(grid)
  , Map(std::move(map))
{
  const Rectangle box = grid.bounds();
  constexpr double largest = EllipsoidMercator::LargestLatitude;
  if (!(box.low.y >= -largest && box.high.y <= largest))
  {
    std::ostringstream message;
    message << "latitudes of " << box.low.y << " to " << box.high.y << " degrees reach beyond " << largest
            << ", where Mercator's map ends: crop them";
    throw std::invalid_argument(message.str());
  }
  this->Bounds = { this->Map->toMap(box.low), this->Map->toMap(box.high) };

  const double east = radians(grid.spacing.x) / this->Map->longitudeRate();
  const auto north = [&](double y) { return radians(grid.spacing.y) / this->Map->parallel(y).dy; };
  const glm::dvec2 middle = this->Map->toMap(0.5 * (box.low + box.high));
  // A degree of latitude is shortest on the map where it is nearest to the equator.
  this->SmallestCell = std::min(east, north(std::clamp(0.0, this->Bounds.low.y, this->Bounds.high.y)));
  this->LargestCell = std::max({ east, north(this->Bounds.low.y), north(this->Bounds.high.y) });
  this->TrueCell = std::max(east, north(middle.y)) / this->Map->scale(middle);
}

void GeographicSeafloor::evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const
{
  const double dx = degrees(this->Map->longitudeRate());
  const ParallelSample parallel = this->Map->parallel(p.y);
  const double dy = degrees(parallel.dy);
  this->Spline.evaluate({ this->Map->toLonLat({ p.x, 0.0 }).x, degrees(parallel.latitude) }, region, bed);
  bed.yy = bed.yy * dy * dy + bed.gradient.y * degrees(parallel.dyy);
  bed.xy *= dx * dy;
  bed.xx *= dx * dx;
  bed.gradient *= glm::dvec2(dx, dy);
}

double GeographicSeafloor::featureLength() const
{
  return FeatureCells * this->SmallestCell;
}

double GeographicSeafloor::resolution() const
{
  return 0.5 * this->SmallestCell;
}

std::vector<glm::dvec2> GeographicSeafloor::outline() const
{
  if (!this->hasHoles())
  {
    return this->Seafloor::outline();
  }
  std::vector<glm::dvec2> corners = this->Spline.dataCorners();
  std::transform(corners.begin(), corners.end(), corners.begin(),
    [this](const glm::dvec2& corner) { return this->Map->toMap(corner); });
  return insetConvex(convexHull(std::move(corners)), OutlineInset * this->LargestCell, this->Bounds);
}

Rectangle GeographicSeafloor::toLonLat(const Rectangle& box) const
{
  return { this->Map->toLonLat(box.low), this->Map->toLonLat(box.high) };
}

bool GeographicSeafloor::isHole(const glm::dvec2& p) const
{
  return this->Spline.hasHoles() && this->Spline.isHole(this->Map->toLonLat(p));
}

double GeographicSeafloor::highestElevation(const Rectangle& box) const
{
  return this->Spline.highestElevation(this->toLonLat(box));
}

double GeographicSeafloor::lowestElevation(const Rectangle& box) const
{
  return this->Spline.lowestElevation(this->toLonLat(box));
}

}
