#include "sim/ShorelineWalk.h"

#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace swellray
{

ShorelineWalk::ShorelineWalk(const RayMedium& medium, const RayPoint& ground)
  : Medium(medium)
  , Position(ground.position)
  , Direction(ground.rayDirection)
{
  this->Wavenumber = solveWavenumber(medium.angularFrequency, medium.agroundDepth, medium.gravity);
  this->GroupSpeed = waveSpeeds(this->Wavenumber, medium.agroundDepth, medium.gravity).groupSpeed;
  this->turn();
}

void ShorelineWalk::turn()
{
  const BedSample bed = this->Medium.seafloor->bed(this->Position);
  const double slope = glm::length(bed.gradient);
  if (slope > 0.0)
  {
    const glm::dvec2 tangent = glm::dvec2(-bed.gradient.y, bed.gradient.x) / slope;
    this->Direction = glm::dot(tangent, this->Direction) >= 0.0 ? tangent : -tangent;
  }
}

glm::dvec2 ShorelineWalk::seaward() const
{
  const BedSample bed = this->Medium.seafloor->bed(this->Position);
  const double slope = glm::length(bed.gradient);
  return slope > 0.0 ? -bed.gradient / slope : glm::dvec2(0.0);
}

bool ShorelineWalk::advance(double distance)
{
  const Seafloor& seafloor = *this->Medium.seafloor;
  const double longest = seafloor.resolution();
  distance *= this->Medium.scale(this->Position);
  while (distance > 0.0)
  {
    const double part = std::min(distance, longest);
    distance -= part;
    glm::dvec2 next = this->Position + part * this->Direction;
    // Newton back onto the contour, never further than the part just gone.
    for (int i = 0; i < 4; ++i)
    {
      const BedSample bed = seafloor.bed(next);
      const double square = glm::dot(bed.gradient, bed.gradient);
      if (!(square > 0.0))
      {
        break;
      }
      const double miss = this->Medium.waterLevel - bed.elevation - this->Medium.agroundDepth;
      glm::dvec2 correction = bed.gradient * (miss / square);
      const double size = glm::length(correction);
      if (size > part)
      {
        correction *= part / size;
      }
      next += correction;
      if (size < 1e-9 * longest)
      {
        break;
      }
    }
    if (!seafloor.bounds().contains(next) || seafloor.isHole(next))
    {
      return false;
    }
    this->Position = next;
    this->turn();
  }
  return true;
}

}
