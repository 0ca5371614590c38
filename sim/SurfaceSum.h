#pragma once

#include "sim/Spray.h"
#include "sim/SurfaceFunction.h"

#include <cstddef>
#include <vector>

namespace swellray
{

/**
 * A sea of several waves, each traced on its own: heights above still water added at every place (Peachey 1986, eq. 4),
 * velocities too; the normal is that of their slopes; foam is the largest.
 */
class SurfaceSum
{
public:
  /** The functions must outlive this and have one water level. @throws std::invalid_argument where there is none */
  explicit SurfaceSum(std::vector<const SurfaceFunction*> waves);

  /** As SurfaceFunction::at(): of the waves that come there; the depth and the crossing sheets of all. */
  std::vector<SurfaceValue> at(const std::vector<glm::dvec2>& places, const std::vector<double>& times,
    const SurfaceMotion& motion, const Execution& execution = {}) const;

  /**
   * Raise the points of a moved surface by these waves, where they have come to: its positions, normals and velocities,
   * but not below the bed. A normal of the surface keeps what overhangs: it is that of (x, y, z + f(x, y)).
   * @param spacing of the surface around a point, m: waves that it does not resolve are left out
   * @param arrays with position, normal, velocity and depth
   */
  void addTo(const SurfaceArrays& arrays, std::size_t count, const double* spacing, double time,
    const SurfaceMotion& motion, const Execution& execution = {}) const;

  /**
   * Raise spray of another wave by these waves, as they were where and when each particle was thrown.
   * @param time of the particles, s
   */
  void raise(std::vector<SprayParticle>& particles, double time, const SurfaceMotion& motion,
    const Execution& execution = {}) const;

private:
  std::vector<const SurfaceFunction*> Waves;
  double WaterLevel = 0.0;
};

/** Largest distance of each point of a sheet from its neighbours, undisturbed, m. */
std::vector<double> pointSpacing(const SurfaceSheet& sheet);

}
