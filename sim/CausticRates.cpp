#include "sim/CausticRates.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace swellray
{

namespace
{

/** Caustics of a field by ray. */
class Touches
{
public:
  explicit Touches(const RayField& field)
    : Caustics(field.caustics)
    , Begins(field.rays.size() + 1, 0)
  {
    for (const RayCaustic& caustic : field.caustics)
    {
      ++this->Begins[static_cast<std::size_t>(caustic.ray) + 1];
    }
    std::partial_sum(this->Begins.begin(), this->Begins.end(), this->Begins.begin());
  }

  /** The one of this number on a ray, or null. */
  const RayCaustic* find(std::size_t ray, std::int32_t number) const
  {
    const auto begin = this->Caustics.begin() + static_cast<std::ptrdiff_t>(this->Begins[ray]);
    const auto end = this->Caustics.begin() + static_cast<std::ptrdiff_t>(this->Begins[ray + 1]);
    const auto found = std::find_if(begin, end, [number](const RayCaustic& c) { return c.number == number; });
    return found == end ? nullptr : &*found;
  }

private:
  const std::vector<RayCaustic>& Caustics;
  std::vector<std::size_t> Begins;
};

/** A neighbour's place on the caustic: launch parameter and way along the caustic, less those of the ray. */
struct Neighbour
{
  double lambda = 0.0;
  double way = 0.0;
};

// First and second derivative of the way by lambda, of second and first order; the second 0 of a single neighbour.
std::pair<double, double> derivatives(const Neighbour& a, const Neighbour* b)
{
  const double slopeA = a.way / a.lambda;
  if (!b)
  {
    return { slopeA, 0.0 };
  }
  const double slopeB = b->way / b->lambda;
  const double gap = b->lambda - a.lambda;
  return { (b->lambda * slopeA - a.lambda * slopeB) / gap, 2.0 * (slopeB - slopeA) / gap };
}

}

void findCausticRates(RayField& field)
{
  std::vector<std::size_t> sorted;
  for (std::size_t ray = 0; ray < field.rays.size(); ++ray)
  {
    if (!field.rays[ray].lee)
    {
      sorted.push_back(ray);
    }
  }
  std::sort(sorted.begin(), sorted.end(),
    [&](std::size_t a, std::size_t b)
    {
      return std::make_tuple(field.rays[a].launchSegment, field.rays[a].launchParameter, a) <
        std::make_tuple(field.rays[b].launchSegment, field.rays[b].launchParameter, b);
    });
  const Touches touches(field);
  std::vector<std::size_t> place(field.rays.size(), 0);
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    place[sorted[i]] = i;
  }

  for (RayCaustic& caustic : field.caustics)
  {
    const auto ray = static_cast<std::size_t>(caustic.ray);
    const std::size_t at = place[ray];
    // Those that touch the same caustic, out to two on either side.
    const auto reach = [&](std::ptrdiff_t step)
    {
      std::vector<Neighbour> found;
      for (std::ptrdiff_t i = 1; i <= 2; ++i)
      {
        const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(at) + i * step;
        if (next < 0 || next >= static_cast<std::ptrdiff_t>(sorted.size()))
        {
          break;
        }
        const std::size_t other = sorted[static_cast<std::size_t>(next)];
        const RayCaustic* touched = touches.find(other, caustic.number);
        const double lambda = field.rays[other].launchParameter - field.rays[ray].launchParameter;
        if (!touched || field.rays[other].launchSegment != field.rays[ray].launchSegment || lambda == 0.0)
        {
          break;
        }
        found.push_back({ lambda, glm::dot(caustic.rayDirection, touched->position - caustic.position) });
      }
      return found;
    };
    std::vector<Neighbour> before = reach(-1);
    std::vector<Neighbour> after = reach(1);
    std::vector<Neighbour>& longer = before.empty() ? after : before;
    if (longer.empty())
    {
      continue;
    }
    const Neighbour* second = before.empty() || after.empty() ? (longer.size() > 1 ? &longer[1] : nullptr) : &after[0];
    std::tie(caustic.alongRate, caustic.alongChange) = derivatives(longer[0], second);
  }
}

}
