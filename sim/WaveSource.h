#pragma once

#include <glm/vec2.hpp>

namespace swellray
{

/** What a place offshore knows of the point that its waves come from. */
struct SourceSample
{
  double heading = 0.0;   ///< of the waves, anticlockwise from +x, going to, rad
  glm::dvec2 turn{ 0.0 }; ///< gradient of the heading by the position, rad/m
  double distance = 0.0;  ///< along the ray from the source, m; above 0
  double width = 0.0;     ///< of the tube of rays out of the source, m a radian at the source: on a plane the distance
};

/**
 * A point from which waves come: their rays in water of one depth. On a map of the curved Earth heading and turn are those on
 * the map (the turn by its metres), distance and width true ones.
 *
 * evaluate() may be called from several threads at once.
 */
class WaveSource
{
public:
  virtual ~WaveSource() = default;

  virtual void evaluate(const glm::dvec2& place, SourceSample& sample) const = 0;
};

}
