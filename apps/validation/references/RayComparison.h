#pragma once

#include "ReferenceSolutions.h"

#include "sim/Dispersion.h"
#include "sim/HamiltonianRay.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace swellray::reference
{

inline RayMedium mediumOf(const Seafloor& seafloor, double period, double agroundDepth)
{
  RayMedium medium;
  medium.seafloor = &seafloor;
  medium.angularFrequency = 2.0 * swellray::Pi / period;
  medium.agroundDepth = agroundDepth;
  return medium;
}

/** Wavenumber at a place for a heading, by the library's own dispersion relation. */
inline glm::dvec2 wavenumberAt(const RayMedium& medium, const glm::dvec2& position, double heading)
{
  const glm::dvec2 along(std::cos(heading), std::sin(heading));
  const double depth = medium.depth(position);
  double k = solveWavenumber(medium.angularFrequency, depth, medium.gravity);
  if (medium.current)
  {
    // sigma + k.U = omega by repetition: rays start where the current is weak.
    const double speed = glm::dot(medium.current->velocity(position), along);
    for (int i = 0; i < 50; ++i)
    {
      k = solveWavenumber(medium.angularFrequency - k * speed, depth, medium.gravity);
    }
  }
  return k * along;
}

/** Start of rays that all have this heading along a line: its tangent is dPosition. */
inline RayStart startHeading(
  const RayMedium& medium, const glm::dvec2& position, double heading, const glm::dvec2& tangent)
{
  RayStart start;
  start.position = position;
  start.wavenumber = wavenumberAt(medium, position, heading);
  start.dPosition = tangent;
  // Depth and current may vary along the line, and with them |k|: dk = -(sigma_h dh + k.dU)/(sigma_k + U along k).
  const glm::dvec2 along(std::cos(heading), std::sin(heading));
  Frequency frequency{};
  evaluateFrequency(glm::length(start.wavenumber), medium.depth(position), medium.gravity, frequency);
  double change = -frequency.h * glm::dot(medium.seafloor->bed(position).gradient, tangent);
  double speed = frequency.k;
  if (medium.current)
  {
    CurrentSample current;
    medium.current->evaluate(position, current);
    change += glm::dot(start.wavenumber, tangent.x * current.dx + tangent.y * current.dy);
    speed += glm::dot(current.velocity, along);
  }
  start.dWavenumber = -change / speed * along;
  return start;
}

/** Largest errors of traced places. */
struct RayErrors
{
  double position = 0.0; ///< m a km of path, or m on the first km
  double theta = 0.0;    ///< rad
  double phase = 0.0;    ///< relative, absolute (rad) below 1
  double time = 0.0;     ///< relative, absolute (s) below 1
  double width = 0.0;    ///< relative, of a tenth where the tube is narrower
  int caustics = 0;      ///< places with another number of caustics
  int places = 0;        ///< compared

  void add(const RayPoint& traced, const Place& exact)
  {
    const auto largest = [](double& error, double now)
    {
      // Written so that a value that is not a number stays.
      if (!(now <= error))
      {
        error = now;
      }
    };
    const double heading = std::atan2(traced.wavenumber.y, traced.wavenumber.x);
    largest(this->position,
      std::hypot(traced.position.x - exact.x, traced.position.y - exact.y) / std::max(1.0, exact.length / 1000.0));
    largest(this->theta, std::abs(std::remainder(heading - exact.theta, 2.0 * swellray::Pi)));
    largest(this->phase, std::abs(traced.phase - exact.phase) / std::max(1.0, exact.phase));
    largest(this->time, std::abs(traced.travelTime - exact.time) / std::max(1.0, exact.time));
    largest(this->width, std::abs(traced.tubeWidth - exact.width) / std::max(0.1, std::abs(exact.width)));
    this->caustics += traced.caustics != exact.caustics;
    ++this->places;
  }
};

inline std::ostream& operator<<(std::ostream& out, const RayErrors& e)
{
  return out << "position " << e.position << " m/km, theta " << e.theta << ", phase " << e.phase << ", time " << e.time
             << ", width " << e.width << ", wrong caustics " << e.caustics << " of " << e.places;
}

}
