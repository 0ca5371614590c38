#pragma once

#include "sim/RayPath.h"

namespace swellray
{

/**
 * A ray by the scheme of Gonzato and Le Saec 1997, section 3.3, kept as a baseline: steps of one length; the
 * contour's direction from the two points of an equilateral triangle around the ray that have its depth; Snell's
 * law between the phase speeds here and one step ahead. First order in the step. It has no ray tube. Walls mirror it.
 */
class SnellRay final : public RayPath
{
public:
  /** @param step length of a step, m, > 0 */
  SnellRay(const RayMedium& medium, const RayStart& start, double step, std::size_t maxSteps = 1000000);

  bool advance(FrontMeasure measure, double target, RayPoint& point) override;

private:
  struct Place
  {
    glm::dvec2 position{ 0.0 };
    glm::dvec2 direction{ 1.0, 0.0 };
    double depth = 0.0;
    double phase = 0.0;
    double travelTime = 0.0;
    double length = 0.0;
  };

  bool step();
  void reflect();
  bool contourNormal(const glm::dvec2& position, double depth, glm::dvec2& normal, double& slope) const;
  void describe(double share, RayPoint& point);

  RayMedium Medium;
  double Step;
  std::size_t MaxSteps;
  Place Before;
  Place After;
  bool Terminal = false;
  std::optional<std::size_t> LeavingWall; // on which the first step starts
  double LeavingSide = 1.0;
};

}
