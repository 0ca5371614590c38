#pragma once

#include <glm/vec2.hpp>

namespace swellray
{

constexpr double Pi = 3.14159265358979323846;

/** Degrees to radians. */
constexpr double radians(double degrees)
{
  return degrees * (Pi / 180.0);
}

/** Radians to degrees. */
constexpr double degrees(double radians)
{
  return radians * (180.0 / Pi);
}

/**
 * Heading (radians anticlockwise from +x, going TO) of a nautical direction (degrees clockwise from
 * north, coming FROM): theta = 270 deg - nautical.
 */
constexpr double headingFromNautical(double nautical)
{
  return radians(270.0 - nautical);
}

/** Nautical direction a wave of this wavenumber vector (or any vector along it) comes from, degrees in [0, 360). */
double nauticalFromVector(const glm::dvec2& direction);

/** Angle, degrees, brought into [0, 360). */
double wrapDegrees(double angle);

}
