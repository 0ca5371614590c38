#include "sim/Seafloor.h"

#include <cmath>
#include <limits>

namespace swellray
{

std::vector<glm::dvec2> Seafloor::outline() const
{
  const Rectangle box = this->bounds();
  return { box.low, glm::dvec2(box.low.x, box.high.y), box.high, glm::dvec2(box.high.x, box.low.y) };
}

double Seafloor::kinkLevel(unsigned, const glm::dvec2&, glm::dvec2& gradient) const
{
  gradient = glm::dvec2(0.0);
  return -1.0;
}

double Seafloor::highestElevation(const Rectangle&) const
{
  return std::numeric_limits<double>::infinity();
}

double Seafloor::lowestElevation(const Rectangle&) const
{
  return -std::numeric_limits<double>::infinity();
}

unsigned Seafloor::region(const glm::dvec2& p) const
{
  unsigned bits = 0;
  glm::dvec2 gradient;
  for (unsigned i = 0; i < kinkCount(); ++i)
  {
    if (kinkLevel(i, p, gradient) > 0.0)
    {
      bits |= 1u << i;
    }
  }
  return bits;
}

double Seafloor::elevation(const glm::dvec2& p) const
{
  return bed(p).elevation;
}

BedSample Seafloor::bed(const glm::dvec2& p) const
{
  BedSample sample;
  evaluate(p, region(p), sample);
  return sample;
}

BedPlane fitWetPlane(const Seafloor& seafloor, double waterLevel, std::size_t samples)
{
  const Rectangle box = seafloor.bounds();
  const glm::dvec2 centre = 0.5 * (box.low + box.high);
  const glm::dvec2 step = box.size() / static_cast<double>(samples);

  // Two passes: the means first, then centred sums, which stay exact on a large scene.
  double count = 0.0;
  glm::dvec2 meanPosition(0.0);
  double meanElevation = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  double syy = 0.0;
  glm::dvec2 sz(0.0);
  for (int pass = 0; pass < 2; ++pass)
  {
    for (std::size_t j = 0; j < samples; ++j)
    {
      for (std::size_t i = 0; i < samples; ++i)
      {
        const glm::dvec2 p = box.low + step * glm::dvec2(i + 0.5, j + 0.5);
        if (seafloor.isHole(p))
        {
          continue;
        }
        const double z = seafloor.elevation(p);
        if (!(z < waterLevel))
        {
          continue;
        }
        const glm::dvec2 local = p - centre;
        if (pass == 0)
        {
          count += 1.0;
          meanPosition += local;
          meanElevation += z;
        }
        else
        {
          const glm::dvec2 d = local - meanPosition;
          sxx += d.x * d.x;
          sxy += d.x * d.y;
          syy += d.y * d.y;
          sz += d * (z - meanElevation);
        }
      }
    }
    if (pass == 0)
    {
      if (count == 0.0)
      {
        return {};
      }
      meanPosition /= count;
      meanElevation /= count;
    }
  }

  BedPlane plane;
  plane.valid = true;
  const double determinant = sxx * syy - sxy * sxy;
  if (determinant > 1e-12 * sxx * syy)
  {
    plane.slope = glm::dvec2(syy * sz.x - sxy * sz.y, sxx * sz.y - sxy * sz.x) / determinant;
  }
  return plane;
}

}
