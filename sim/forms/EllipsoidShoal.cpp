#include "sim/forms/EllipsoidShoal.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace swellray
{

namespace
{

// Square root and its derivatives; below `join` the second-order Taylor polynomial, so that the formula of the
// shoal goes on across its edge and stays finite.
struct SquareRoot
{
  double value;
  double first;
  double second;

  SquareRoot(double argument, double join)
  {
    const double at = std::max(argument, join);
    const double root = std::sqrt(at);
    const double slope = 0.5 / root;
    second = -0.5 * slope / at;
    const double d = argument - at;
    first = slope + second * d;
    value = root + d * (slope + 0.5 * second * d);
  }
};

}

EllipsoidShoal::EllipsoidShoal(const Rectangle& bounds, const Floor& floor, const Ellipsoid& shoal)
  : Bounds(bounds)
  , Frame(-floor.rotation)
  , Bed(floor)
  , Shoal(shoal)
{
  if (floor.slope > 0.0 && floor.minDepth > 0.0)
  {
    this->SlopeEnd = (floor.depth - floor.minDepth) / floor.slope - floor.toe;
  }
}

double EllipsoidShoal::featureLength() const
{
  return 0.25 * std::min(this->Shoal.semiAxes.x, this->Shoal.semiAxes.y);
}

unsigned EllipsoidShoal::kinkCount() const
{
  if (this->Bed.slope == 0.0)
  {
    return 1;
  }
  return this->Bed.minDepth > 0.0 ? 3 : 2;
}

double EllipsoidShoal::kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const
{
  const glm::dvec2 local = this->Frame.toLocal(p);
  if (i == 0)
  {
    const glm::dvec2 scaled = local / this->Shoal.semiAxes;
    const double sunk = this->Shoal.sunk / this->Shoal.height;
    gradient = this->Frame.toScene(-2.0 * scaled / this->Shoal.semiAxes);
    return 1.0 - sunk * sunk - glm::dot(scaled, scaled);
  }
  gradient = this->Frame.axis();
  return i == 1 ? local.x + this->Bed.toe : local.x - this->SlopeEnd;
}

void EllipsoidShoal::evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const
{
  bed = {};
  const glm::dvec2 local = this->Frame.toLocal(p);
  if (region & OnShallowFloor)
  {
    bed.elevation = -this->Bed.minDepth;
  }
  else if (region & OnSlope)
  {
    bed.elevation = this->Bed.slope * (local.x + this->Bed.toe) - this->Bed.depth;
    bed.gradient.x = this->Bed.slope;
  }
  else
  {
    bed.elevation = -this->Bed.depth;
  }
  if (region & OnShoal)
  {
    addShoal(local, bed);
  }
  this->Frame.toScene(bed);
}

void EllipsoidShoal::addShoal(const glm::dvec2& local, BedSample& bed) const
{
  const glm::dvec2 axes = this->Shoal.semiAxes;
  const glm::dvec2 scaled = local / axes;
  const double edge = this->Shoal.sunk / this->Shoal.height;
  const SquareRoot root(1.0 - glm::dot(scaled, scaled), std::max(0.25 * edge * edge, 1e-4));
  const glm::dvec2 slope = -2.0 * scaled / axes;
  const double b = this->Shoal.height;
  bed.elevation += b * root.value - this->Shoal.sunk;
  bed.gradient += b * root.first * slope;
  bed.xx += b * (root.second * slope.x * slope.x - 2.0 * root.first / (axes.x * axes.x));
  bed.xy += b * root.second * slope.x * slope.y;
  bed.yy += b * (root.second * slope.y * slope.y - 2.0 * root.first / (axes.y * axes.y));
}

double EllipsoidShoal::floorElevation(double u) const
{
  const double onSlope = this->Bed.slope * std::max(u + this->Bed.toe, 0.0) - this->Bed.depth;
  return this->Bed.minDepth > 0.0 ? std::min(onSlope, -this->Bed.minDepth) : onSlope;
}

double EllipsoidShoal::highestElevation(const Rectangle& box) const
{
  const Rectangle local = this->Frame.boxToLocal(box);
  const glm::dvec2 nearest = glm::clamp(glm::dvec2(0.0), local.low, local.high) / this->Shoal.semiAxes;
  const double root = std::sqrt(std::max(1.0 - glm::dot(nearest, nearest), 0.0));
  return floorElevation(local.high.x) + std::max(this->Shoal.height * root - this->Shoal.sunk, 0.0);
}

double EllipsoidShoal::lowestElevation(const Rectangle& box) const
{
  return floorElevation(this->Frame.boxToLocal(box).low.x);
}

}
