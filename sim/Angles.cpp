#include "sim/Angles.h"

#include <cmath>

namespace swellray
{

double wrapDegrees(double angle)
{
  const double wrapped = std::fmod(angle, 360.0);
  const double positive = wrapped < 0.0 ? wrapped + 360.0 : wrapped;
  return positive < 360.0 ? positive : 0.0;
}

double nauticalFromVector(const glm::dvec2& direction)
{
  return wrapDegrees(270.0 - degrees(std::atan2(direction.y, direction.x)));
}

}
