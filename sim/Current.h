#pragma once

#include "sim/Seafloor.h"

#include <glm/vec2.hpp>

#include <limits>

namespace swellray
{

/** Velocity of the water and its first and second derivatives at a point. */
struct CurrentSample
{
  glm::dvec2 velocity{ 0.0 }; ///< (u, v), east and north, m/s
  glm::dvec2 dx{ 0.0 };       ///< derivative by x, 1/s
  glm::dvec2 dy{ 0.0 };       ///< derivative by y, 1/s
  glm::dvec2 dxx{ 0.0 };      ///< second derivatives, 1/(m s)
  glm::dvec2 dxy{ 0.0 };
  glm::dvec2 dyy{ 0.0 };
};

/**
 * A steady horizontal current U(x), the same from the surface to the bed, as a twice continuously differentiable
 * function.
 *
 * All members may be called from several threads at once.
 */
class Current
{
public:
  virtual ~Current() = default;

  /** Where the current is known, m. A scene must lie within. */
  virtual Rectangle bounds() const
  {
    const double all = std::numeric_limits<double>::infinity();
    return { glm::dvec2(-all), glm::dvec2(all) };
  }

  /** Current at p: in the bounds and, as a smooth continuation, a little outside of them. */
  virtual void evaluate(const glm::dvec2& p, CurrentSample& sample) const = 0;

  /** Length over which the current may change its shape unseen by an integrator's step, m, > 0 (Seafloor). */
  virtual double featureLength() const = 0;

  /** Velocity at p, m/s. */
  glm::dvec2 velocity(const glm::dvec2& p) const
  {
    CurrentSample sample;
    this->evaluate(p, sample);
    return sample.velocity;
  }
};

/**
 * Nothing is known of the water beyond a current's data, least of all that it stands still.
 * @throws std::runtime_error where the current does not cover the scene
 */
void requireCover(const Current& current, const Rectangle& scene);

}
