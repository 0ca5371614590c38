#pragma once

#include "sim/Execution.h"
#include "sim/Obstacles.h"
#include "sim/WaveSurface.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** How waves throw spray. */
struct SprayOptions
{
  double steepest =
    0.0;              ///< S_max: H/L at which crests are as fast as the wave; 0: that at which the traced wave breaks
  double rate = 20.0; ///< particles a metre of crest, second and m/s by which the water is faster, >= 0
  double scatter = 0.25;   ///< standard deviation of each component of the velocity, of Q, 0 to 1
  double rebound = 0.7;    ///< speed after an obstacle, of Q, 0 to 1
  double gravity = 9.81;   ///< m/s2, > 0
  double steepShore = 0.5; ///< slope of the bed from which on a shore is an obstacle, > 0
  std::uint64_t seed = 1;
  std::size_t maxParticles = 50'000'000;

  /** @throws std::invalid_argument naming what is out of range */
  void validate() const;
};

/** What threw a particle. */
enum class SpraySource : std::uint8_t
{
  Crest = 0,
  Obstacle = 1,
};

/** A drop in the air. */
struct SprayParticle
{
  glm::dvec3 position{ 0.0 }; ///< m
  glm::dvec3 velocity{ 0.0 }; ///< m/s, now
  double age = 0.0;           ///< s since it was thrown
  SpraySource source = SpraySource::Crest;
};

/** Q: speed of the water in a crest, m/s (Peachey 1986, eq. 2 with its correction): pi S C/(pi S_max). */
inline double orbitalSpeed(double steepness, double steepest, double phaseSpeed)
{
  return phaseSpeed * steepness / steepest;
}

/** Direction after an ideal elastic collision with a face of this unit normal (Peachey 1986, figure 3). */
glm::dvec3 elasticReflection(const glm::dvec3& direction, const glm::dvec3& normal);

/** Unit normal of a face: horizontally to the side `outward` (unit vector), rising by `slope` over run; 0: vertical. */
glm::dvec3 faceNormal(const glm::dvec2& outward, double slope);

/**
 * Share of the largest rate of spray at an obstacle, by the phase of the wave there: 0 an eighth of a wave before the
 * crest comes, 1 at the crest, 0 an eighth behind it (raised cosine; Peachey 1986, section 3.4, says that it rises and falls).
 */
double impactShare(double phase);

/**
 * Spray of breaking crests and of obstacles that waves strike (Peachey 1986, section 3.4).
 *
 * A crest throws water where it is faster than the wave, Q > C, the more the faster: `rate` (Q - C) particles a metre and
 * second. S is the steepness that the wave would have had it not broken (H grows by shoaling alone from where it
 * breaks: the paper's waves keep their height); as the wave lowers in the surf its crest throws less, H over that height.
 * With S_max that of the breaking wave, Q = C where the trace, and the wave's own delay, say that it begins to break.
 * Particles start at the crest, as the section moves it, with Q along the wave and a Gaussian of `scatter` Q in each
 * component.
 *
 * Obstacles are walls at which rays end, with the slope of their faces, and shores of a steep bed. Particles start on the
 * line between the ends of neighbouring rays, at the height of the wave there, with `rebound` Q in the direction of the
 * elastic reflection and the same Gaussian; `rate` Q of them a metre and second as the crest passes, times the sine of the
 * angle to the face and impactShare().
 *
 * From then on they fall freely, so position is a function of time: a frame needs no other. They are drawn from the seed,
 * the rays, the wave and a time slot of 1/64 period. A particle ends where it is lower than the trough.
 */
class Spray
{
public:
  /**
   * The surface must outlive this; it must move by the traced phase.
   * @param obstacles that the rays met; null: none
   * @throws std::invalid_argument on bad options or another phase
   */
  Spray(const WaveSurface& surface, const Seafloor& seafloor, const Obstacles* obstacles, const SprayOptions& options);

  /**
   * Particles in the air at a time, s: in the order of the rays, the same for any loop in `execution`.
   * @throws std::runtime_error where there are more than the most
   */
  std::vector<SprayParticle> at(double time, const WaveSection& section, const Execution& execution = {}) const;

  /** Longest time that a particle may be in the air, s. */
  double longestLife() const { return this->Life; }

  /** Rays whose waves strike an obstacle. */
  std::size_t impactCount() const { return this->ImpactCount; }

private:
  // Between two neighbouring rays, over a stretch of their phases.
  struct Strip
  {
    std::size_t left = 0;
    std::size_t right = 0;
    double begin = 0.0;
    double end = 0.0;
  };

  // Where the waves of a ray strike an obstacle.
  struct Impact
  {
    bool strikes = false;
    glm::dvec2 place{ 0.0 };
    double phase = 0.0;
    double height = 0.0;
    double speed = 0.0;      // Q
    double groupTime = 0.0;  // s
    double directness = 0.0; // sine of the angle between the wave and the face
    glm::dvec3 away{ 0.0 };  // direction after the collision
  };

  // What is thrown at a place and time: at the corners of a slot, and between them.
  struct Source
  {
    glm::dvec3 position{ 0.0 };
    glm::dvec3 velocity{ 0.0 };
    double scatter = 0.0; // m/s
    double floor = 0.0;   // elevation below which particles end
    double rate = 0.0;    // particles a metre and second
  };

  struct Slot;
  struct RayPlace;

  void findStrips();
  void findImpacts(const Seafloor& seafloor, const Obstacles* obstacles);
  void boundLife();
  RayPlace onRay(std::size_t ray, double phase) const;
  double unbrokenHeight(const RayPlace& at, const BreakingStretch* stretch, std::size_t ray) const;
  double speedOf(std::size_t ray, double phase, double plunge) const;
  Source crestSource(std::size_t ray, std::int64_t step, std::int64_t wave, const WaveSection& section) const;
  Source impactSource(const Impact& impact, std::int64_t step, std::int64_t wave) const;
  void throwCrests(const Strip& strip, double time, const WaveSection& section, std::vector<SprayParticle>& out) const;
  void throwImpacts(const Strip& strip, double time, std::vector<SprayParticle>& out) const;
  void requireFew(double particles) const;
  void throwSlot(const Slot& slot, double time, std::vector<SprayParticle>& out) const;

  const WaveSurface& Surface;
  SprayOptions Options;
  std::vector<Strip> Crests;
  std::vector<Strip> Impacts;   // both rays strike
  std::vector<Impact> ImpactOf; // one a ray
  std::size_t ImpactCount = 0;
  double SlotTime = 0.0;
  double Life = 0.0;
};

}
