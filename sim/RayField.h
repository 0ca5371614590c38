#pragma once

#include "sim/RayCaustic.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace swellray
{

/** State of a ray on a front (Gonzato and Le Saec 1997, section 3.3). */
enum class RayState : std::uint8_t
{
  Dead = 0, ///< left the scene, or lies between two aground rays
  Alive = 1,
  Flat = 2,    ///< wave height below the threshold: traced, but not refined
  Aground = 3, ///< reached the beach; follows the shoreline from there on
};

/** True for a ray that is still a wave on the water. */
constexpr bool isOnWater(RayState state)
{
  return state == RayState::Alive || state == RayState::Flat;
}

/** What ended a ray. The numbers are those of the cell array EndReason. */
enum class EndReason : std::uint8_t
{
  StepCap = 0,
  LeftScene = 1,
  EnteredHole = 2,
  Aground = 3,
  BetweenAground = 4,
  Cancelled = 5,
  BlockedByCurrent = 6,
  StoppedByObstacle = 7,
};

/** Front number of a place that lies on none: where a ray began or ended between two fronts. */
constexpr std::uint32_t BetweenFronts = 0xffffffffu;

/** One position of a ray. */
struct RayPoint
{
  glm::dvec2 position{ 0.0 };     ///< m
  glm::dvec2 wavenumber{ 0.0 };   ///< vector, rad/m, along the direction the wave goes to
  glm::dvec2 rayDirection{ 0.0 }; ///< unit vector along the ray
  glm::dvec2 current{ 0.0 };      ///< U, m/s; 0 along the shore, where a ray only follows the beach
  double depth = 0.0;             ///< m
  double phase = 0.0;             ///< S, rad
  double travelTime = 0.0;        ///< s since launch
  double tubeWidth = 0.0;    ///< signed width of the ray tube over its width offshore (beta); NaN where it has none
  double spacingWidth = 0.0; ///< the same from the neighbouring rays, unsigned; NaN where a ray has no neighbour
  std::uint32_t front = 0;   ///< number of the front, or BetweenFronts
  std::int32_t caustics = 0; ///< caustics passed (KMAH index)
  RayState state = RayState::Alive;
};

/** What holds for a whole ray. */
struct RayInfo
{
  double launchParameter = 0.0;   ///< lambda, m along the incident crest
  std::int32_t parent = -1;       ///< ray it was inserted beside, or reflected from; -1 for a launched ray
  std::int32_t launchSegment = 0; ///< piece of the launch line; rays of different pieces are no neighbours
  bool lee = false;               ///< a model of diffraction, not a refracted ray
  std::int32_t reflections = 0;   ///< by obstacles, so far
  double reflection = 1.0;        ///< product of their coefficients
  RayState finalState = RayState::Alive;
  EndReason endReason = EndReason::StepCap;
  double dispersionError = 0.0; ///< largest error of the dispersion relation along the ray (RayPath): a free check
};

/**
 * Rays as they were traced. points[offsets[i]] to points[offsets[i + 1] - 1] belong to rays[i] in the
 * order of their fronts. An inserted ray begins on the front on which it was inserted.
 */
struct RayField
{
  std::vector<RayInfo> rays;
  std::vector<std::size_t> offsets{ 0 };
  std::vector<RayPoint> points;
  std::vector<RayCaustic> caustics;     ///< touched by refracted rays, ordered by ray and along it
  std::uint32_t fronts = 0;             ///< number of fronts that were traced
  double spacing = 0.0;                 ///< launch spacing used, m
  double maxSpacing = 0.0;              ///< insertion threshold used, m
  double stepsPerWave = 0.0;            ///< fronts a wavelength used; 0 for fronts of equal length
  double directionFrom = 0.0;           ///< of the incident wave where it first meets the scene, nautical degrees
  std::optional<double> sourceDistance; ///< way to there from the point that it comes from, m; none of a plane wave
  double launchWidth = 0.0;             ///< length of the launch line along the incident crest, m
  bool rayCapReached = false;           ///< no more rays were inserted because of the cap
  bool stepCapReached = false;          ///< rays ended because of the cap on fronts or steps
  bool cancelled = false;
  std::size_t steps = 0;       ///< steps of all rays, those of inserted ones on their way to the front among them
  std::size_t evaluations = 0; ///< evaluations of the ray equations

  /**
   * Points at which the wave feels the bottom (kh < pi) in more than twice its height of water, and how many of
   * them have fewer than 5 cells of the seafloor's grid a wavelength.
   */
  std::size_t refractingPoints = 0;
  std::size_t coarsePoints = 0;

  std::size_t pointCount(std::size_t ray) const { return offsets[ray + 1] - offsets[ray]; }
};

}
