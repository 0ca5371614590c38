#pragma once

#include "sim/WaveSource.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace swellray
{

/** Waves from a point of the plane: straight rays, circular crests. */
class PointSource final : public WaveSource
{
public:
  /** @param position m */
  explicit PointSource(const glm::dvec2& position)
    : Position(position)
  {
  }

  void evaluate(const glm::dvec2& place, SourceSample& sample) const override
  {
    const glm::dvec2 way = place - this->Position;
    const double square = glm::dot(way, way);
    sample.heading = std::atan2(way.y, way.x);
    sample.turn = glm::dvec2(-way.y, way.x) / square;
    sample.distance = sample.width = std::sqrt(square);
  }

private:
  glm::dvec2 Position;
};

}
