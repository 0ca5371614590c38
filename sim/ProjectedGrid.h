#pragma once

#include "sim/SurfaceFunction.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** A camera that looks at the sea, and the picture that it takes. */
struct GridCamera
{
  glm::dvec3 position{ 0.0, 0.0, 10.0 };    ///< m, above the water
  glm::dvec3 focalPoint{ 0.0, 100.0, 0.0 }; ///< m
  glm::dvec3 viewUp{ 0.0, 0.0, 1.0 };
  double viewAngle = 30.0; ///< from the lower to the upper edge of the picture, degrees, above 0 to below 180
  int width = 1024;        ///< pixels
  int height = 768;
  int step = 8;    ///< pixels from sample to sample, >= 1
  int margin = 64; ///< pixels that are sampled beyond the edges, from where waves may lean in, >= 0

  /** @throws std::invalid_argument naming what is out of range */
  void validate() const;
};

/** The surface as a camera samples it: an entry a sample on which there are waves. */
struct ProjectedSurface
{
  std::vector<glm::dvec3> position; ///< m
  std::vector<glm::dvec3> normal;   ///< unit vectors
  std::vector<glm::dvec3> velocity; ///< m/s
  std::vector<double> depth;        ///< of the bed below still water at the undisturbed place, m
  std::vector<float> foam;          ///< 0 to 1
  std::vector<std::uint8_t> breaking;
  std::vector<std::array<std::int64_t, 3>> triangles; ///< wound so that the undisplaced surface looks up
};

/**
 * The sea surface sampled at every n-th pixel of a camera (Jeschke et al. 2003, section 5): its cost follows the picture and
 * not the scene.
 *
 * The line of sight of each of these pixels meets the still water in a place, which then moves as a point of the surface
 * does (SurfaceFunction::move), so crests overhang. Where sheets or waves cross their displacements are added, and the normal is
 * that of both tangents. A wave that the samples do not resolve there is left out (resolvedShare()), so the sea becomes
 * calm towards the horizon instead of flickering. The distance of samples is that across the line of sight or along it,
 * whichever is larger.
 */
class ProjectedGrid
{
public:
  /** @throws std::invalid_argument on a bad camera, or one that is not above the water */
  ProjectedGrid(const GridCamera& camera, double waterLevel);

  /** Samples that meet the water. */
  std::size_t sampleCount() const { return this->Count; }

  /**
   * @param waves of the sea, each traced on its own, on the water level of this
   * @throws std::invalid_argument where there are none, or of another level
   */
  ProjectedSurface sample(const std::vector<const SurfaceFunction*>& waves, double time, const SurfaceMotion& motion,
    const Execution& execution = {}) const;

private:
  // Place on still water, and how far the next samples are, m; a spacing of 0: the line of sight meets no water.
  struct Sample
  {
    glm::dvec2 place{ 0.0 };
    double spacing = 0.0;
  };

  double WaterLevel = 0.0;
  std::size_t Columns = 0;
  std::size_t Rows = 0;
  std::size_t Count = 0;
  std::vector<Sample> Samples;
};

}
