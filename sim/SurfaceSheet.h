#pragma once

#include "sim/Execution.h"
#include "sim/RaySheets.h"
#include "sim/Seafloor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** Rays with heights as the breaking-wave surface takes them: plain arrays, as they lie in a ray file. */
struct SurfaceRays
{
  SheetRays sheet;
  const double* rayDirection = nullptr;     ///< 3 a point: unit vector along the ray
  const double* breakingDistance = nullptr; ///< a point, m since breaking began
  double maxSpacing = 0.0;                  ///< as RaySheets
};

/**
 * The undisturbed sea surface as rays cover it, ready to be moved by a wave: triangles over points that lie on the rays at
 * equal steps of phase.
 *
 * Between two points of a ray its way is the cubic through both with their directions (dx/dS is known there), so that
 * coarse fronts still make smooth rays; height and wavenumber are linear in the phase; depth and slope are those of the bed
 * at the point. Triangles are those of RaySheets, so that rays of different density join without cracks and crossing
 * sheets stay, turned so that all look up. Where a sheet ends at a beach it is carried on up the slope to the place that
 * the waves of its edge reach.
 */
class SurfaceSheet
{
public:
  using Triangle = RaySheets::Triangle;

  /**
   * @param pointsPerWave on a ray, > 0: fewer where the ray is shorter than that
   * @param waterLevel m, positive up
   * @throws std::invalid_argument pointsPerWave not above 0; std::runtime_error as RaySheets, or where there would be more
   *   than `maxPoints`
   */
  SurfaceSheet(const SurfaceRays& rays, const Seafloor& seafloor, double waterLevel, double pointsPerWave,
    const Execution& execution = {}, std::size_t maxPoints = 100000000);

  std::size_t rayCount() const { return this->Offsets.size() - 1; }
  std::size_t pointCount() const { return this->Phase.size(); } ///< those of rays, then those on the beach
  std::size_t rayPointCount() const { return static_cast<std::size_t>(this->Offsets.back()); }

  // One entry a ray (Offsets: one more).
  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<double> LaunchParameter; ///< m
  std::vector<std::int32_t> LaunchSegment;
  std::vector<std::int32_t> Parent;
  std::vector<std::uint8_t> Lee;
  std::vector<std::int32_t> Reflections; ///< empty: none anywhere
  std::vector<std::uint8_t> EndReasons;  ///< empty without obstacles

  // One entry a point; three of position and direction.
  std::vector<double> Position;
  std::vector<double> Direction;
  std::vector<double> Phase;
  std::vector<double> Height;
  std::vector<double> Wavenumber;
  std::vector<double> Depth;
  std::vector<double> Slope; ///< of the bed along the wave, tan(beta)
  std::vector<double> BreakingDistance;
  std::vector<std::int32_t> Caustics;
  std::vector<std::uint8_t> Breaking;
  std::vector<std::uint8_t> State; ///< RayState
  std::vector<std::uint8_t> Shore; ///< 1 where aground, also where such a ray has died between two others

  std::vector<std::int64_t> BeachBase; ///< one a point on the beach: the point of a ray that it belongs to
  std::vector<Triangle> Triangles;

private:
  void layOut(const SurfaceRays& rays, double step, std::size_t maxPoints);
  void fill(const SurfaceRays& rays, const Seafloor& seafloor, double waterLevel, const Execution& execution);
  void weave(double maxSpacing, const Obstacles* obstacles);
  void turnUp(Triangle& triangle) const;
  void reachBeach(const Seafloor& seafloor, double waterLevel);

  // Where a point lies on its ray: between which of the original points, and at which phase.
  struct Place
  {
    std::int64_t before = 0;
    double phase = 0.0;
  };
  std::vector<Place> Places;
};

}
