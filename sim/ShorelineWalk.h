#pragma once

#include "sim/RayPath.h"

namespace swellray
{

/**
 * An aground ray: follows the depth contour on which it grounded, in the sense of its motion, at the phase
 * speed of that depth.
 */
class ShorelineWalk
{
public:
  ShorelineWalk() = default;

  /**
   * @param ground place where the ray ran aground; its wavenumber gives the sense of motion
   */
  ShorelineWalk(const RayMedium& medium, const RayPoint& ground);

  /**
   * Go on along the contour.
   * @param distance m
   * @return false where the contour leaves the scene or runs into a hole: the walk ends there
   */
  bool advance(double distance);

  const glm::dvec2& position() const { return this->Position; }
  /** Unit tangent of the contour, in the sense of motion. */
  const glm::dvec2& direction() const { return this->Direction; }
  /** Unit normal of the contour, towards the deeper water. */
  glm::dvec2 seaward() const;
  /** Wavenumber (rad/m), and group speed (m/s), of the wave in the depth of the contour. */
  double wavenumber() const { return this->Wavenumber; }
  double groupSpeed() const { return this->GroupSpeed; }

private:
  void turn();

  RayMedium Medium;
  glm::dvec2 Position{ 0.0 };
  glm::dvec2 Direction{ 1.0, 0.0 };
  double Wavenumber = 1.0;
  double GroupSpeed = 1.0;
};

}
