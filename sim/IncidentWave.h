#pragma once

#include <glm/vec2.hpp>

#include <limits>

namespace swellray
{

/** Acceleration of gravity unless set, m/s2. */
constexpr double StandardGravity = 9.81;

/** A plane monochromatic wave offshore. */
struct IncidentWave
{
  double period = 10.0;         ///< absolute period T, s, > 0
  double directionFrom = 270.0; ///< nautical, degrees clockwise from north, -360 to 360
  double height = 1.0;          ///< H0, crest to trough, m, > 0
  double offshoreDepth = std::numeric_limits<double>::infinity(); ///< depth in which height and direction hold, m
  double gravity = StandardGravity;

  double angularFrequency() const;
  /** Unit vector the wave goes to, offshore. */
  glm::dvec2 direction() const;
  /** Wavenumber offshore, rad/m. */
  double wavenumber() const;
  /** Group speed offshore, m/s. */
  double groupSpeed() const;

  /** @throws std::invalid_argument naming the value that is out of range */
  void validate() const;
};

}
