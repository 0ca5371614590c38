#include "sim/FrontMarch.h"

#include "sim/Dispersion.h"
#include "sim/RayQuantities.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

// Widths of the tubes between neighbours on a front, and the heights that they make.

namespace swellray
{

namespace
{

// Share of the incident height below which a wave is flat.
constexpr double FlatShare = 0.1;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

}

const FrontMarch::Ray* FrontMarch::neighbour(std::size_t at, int step, const Ray& self) const
{
  const bool linked = step > 0 ? this->Order[at].linked : at > 0 && this->Order[at - 1].linked;
  if (!linked || this->Order[step > 0 ? at : at - 1].blocked)
  {
    return nullptr;
  }
  const Ray& other = this->standing(step > 0 ? at + 1 : at - 1);
  // A refracted ray's tube is bounded by refracted rays; a lee ray shares the tube of whatever stands beside it.
  const bool shares = self.info.lee || (!other.info.lee && isOnWater(other.state));
  return shares && !other.waiting ? &other : nullptr;
}

double FrontMarch::spacingWidth(std::size_t at) const
{
  const Ray& self = this->standing(at);
  const Ray* left = this->neighbour(at, -1, self);
  const Ray* right = this->neighbour(at, 1, self);
  const glm::dvec2 x = self.place.position;
  const double lambda = self.info.launchParameter;
  if (self.info.lee)
  {
    const double from = left ? left->info.launchParameter : lambda;
    const double to = right ? right->info.launchParameter : lambda;
    const double front =
      (left ? this->distance(left->place, self.place) : 0.0) + (right ? this->distance(right->place, self.place) : 0.0);
    return to > from ? front / (to - from) : NotANumber;
  }

  // Derivative of the position by lambda along the front, of second order at unequal distances.
  const auto second = [&](const Ray* near, int step, std::size_t place) -> const Ray*
  { return near ? this->neighbour(place, step, *near) : nullptr; };
  const Ray* a = left;
  const Ray* b = right;
  if (!a)
  {
    a = second(right, 1, at + 1);
  }
  else if (!b)
  {
    b = a;
    a = second(left, -1, at - 1);
  }
  glm::dvec2 derivative(0.0);
  if (a && b)
  {
    const double ha = a->info.launchParameter - lambda;
    const double hb = b->info.launchParameter - lambda;
    if (ha == 0.0 || hb == 0.0 || ha == hb)
    {
      return NotANumber;
    }
    derivative = (ha * ha * (b->place.position - x) - hb * hb * (a->place.position - x)) / (ha * hb * (ha - hb));
  }
  else if (const Ray* only = a ? a : b)
  {
    derivative = (only->place.position - x) / (only->info.launchParameter - lambda);
  }
  else
  {
    return NotANumber;
  }
  const glm::dvec2 ray = self.place.rayDirection;
  return std::abs(ray.x * derivative.y - ray.y * derivative.x) / this->Medium.scale(x);
}

void FrontMarch::measureSpacing()
{
  std::vector<double> width(this->Order.size(), NotANumber);
  this->Run.forRange(this->Order.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Ray& ray = this->standing(i);
        if (!ray.waiting && isOnWater(ray.state))
        {
          width[i] = this->spacingWidth(i);
        }
      }
    });
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    Ray& ray = this->standing(i);
    // An aground ray keeps the width it grounded with; a launch point has the exact one.
    if (!ray.waiting && isOnWater(ray.state) && !ray.launching)
    {
      ray.place.spacingWidth = width[i];
    }
  }
}

void FrontMarch::markFlat()
{
  const double flatHeight = this->Options.flatHeight.value_or(FlatShare * this->Wave.height);
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    Ray& ray = this->standing(i);
    if (ray.waiting || !isOnWater(ray.state))
    {
      continue;
    }
    ray.state = this->heightOf(ray) < flatHeight ? RayState::Flat : RayState::Alive;
  }
}

double FrontMarch::heightOf(const Ray& ray) const
{
  const RayPoint& place = ray.place;
  const double width = std::isfinite(place.spacingWidth) ? place.spacingWidth : std::abs(place.tubeWidth);
  const WaveSpeeds speeds = waveSpeeds(glm::length(place.wavenumber), place.depth, this->Medium.gravity);
  return this->Wave.height * ray.info.reflection * refractionCoefficient(width) *
    shoalingCoefficient(place, speeds, this->Wave.groupSpeed(), this->Medium.angularFrequency);
}

}
