#pragma once

#include <glm/vec2.hpp>

namespace swellray
{

/** Scale of a map and its first and second derivatives at a point. */
struct ScaleSample
{
  double scale = 1.0;         ///< map length over true length, > 0
  glm::dvec2 gradient{ 0.0 }; ///< 1/m of the map
  double xx = 0.0;            ///< second derivatives, 1/m2
  double xy = 0.0;
  double yy = 0.0;
};

/**
 * Scale m of a conformal map of a curved Earth, x east and y north on it. A map is conformal when lengths around a point
 * are stretched alike in all directions, so that angles on it are true: rays of wavenumber k on the Earth are rays of
 * wavenumber k/m on the map.
 *
 * All members may be called from several threads at once.
 */
class MapScale
{
public:
  virtual ~MapScale() = default;

  /** Scale at p, m of the map. */
  virtual void evaluate(const glm::dvec2& p, ScaleSample& sample) const = 0;

  virtual double scale(const glm::dvec2& p) const
  {
    ScaleSample sample;
    this->evaluate(p, sample);
    return sample.scale;
  }
};

}
