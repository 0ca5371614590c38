#pragma once

#include "sim/Execution.h"
#include "sim/StraightPhase.h"
#include "sim/SurfHistory.h"
#include "sim/SurfaceSheet.h"
#include "sim/WaveGroups.h"
#include "sim/sections/WaveSection.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** What a surface is made of besides its rays. */
struct SurfaceOptions
{
  double period = 10.0;       ///< T, s
  double wavelength = 100.0;  ///< of the incident wave, m: scale of the variation along crests
  double waterLevel = 0.0;    ///< m, positive up
  double breakerIndex = 0.78; ///< H/h at which waves break
  std::uint64_t seed = 1;     ///< of what varies from wave to wave
  double gravity = 9.81;      ///< m/s2, with which they were traced
  WaveGroups groups;          ///< in which they come

  /** @throws std::invalid_argument naming what is out of range */
  void validate() const;
};

/**
 * Where the surface is: plain arrays in the order of the sheet's points, with `components` entries a point where said. A
 * null pointer: not wanted.
 */
struct SurfaceArrays
{
  double* position = nullptr;       ///< 3 components, m
  float* normal = nullptr;          ///< 3 components, unit vector, up where the surface does not overhang
  float* velocity = nullptr;        ///< 3 components, of the particles, m/s
  double* depth = nullptr;          ///< of the bed below still water under the displaced point, m; negative on a beach
  double* phase = nullptr;          ///< Phi = S - omega t, rad; crests are at 2 pi n
  std::uint8_t* breaking = nullptr; ///< 1 where the wave that is there is broken, and no more than half whole again
};

/** A place of the undisturbed surface and the wave there. */
struct StillPlace
{
  glm::dvec2 position{ 0.0 };       ///< m
  glm::dvec2 direction{ 1.0, 0.0 }; ///< unit vector of the wavenumber
  double height = 0.0;              ///< H, m
  double wavenumber = 1.0;          ///< rad/m
  double depth = 1.0;               ///< m
  double slope = 0.0;               ///< of the bed along the wave, tan(beta)
};

/** Where such a place is at a time. */
struct MovedPlace
{
  glm::dvec3 position{ 0.0 };         ///< m
  glm::dvec3 normal{ 0.0, 0.0, 1.0 }; ///< of any size
  glm::dvec3 velocity{ 0.0 };         ///< of the particle, m/s
  double depth = 0.0;                 ///< of the bed below still water under the position, m
};

/**
 * The breaking-wave surface: a sheet of rays moved by a vertical section, at any time by itself.
 *
 * A point of phase S belongs at time t to the wave n whose crest, at S = omega t + 2 pi n on the same ray, is within pi
 * of it. Its section gets the point's height, depth and slope, and the state of that crest (SurfHistory), so that a
 * wave breaks as a whole. Each breaks later than the trace says by up to the section's variation.
 *
 * With the ray's direction d the point x goes to x + along d + up z; the normal is that of the tangents along the ray,
 * (1 + k along') d + k up' z, and along the crest, which is taken as straight; the velocity is -omega (along' d + up' z).
 * Waves of a group (WaveGroups) are lower than the traced one by their share; each breaks where the breaking waves of the
 * trace have become as low as it is. The group's time is the integral of dS/(k Cg + omega - sigma) along the ray, also on a
 * current, and at its start S over omega n: exact along an edge of one depth.
 * Points of the shore move up and down only, and none is carried past it. Nothing goes below the bed: what would, lies on
 * it.
 */
class WaveSurface
{
public:
  /** The sheet and the seafloor must outlive this. @throws std::invalid_argument on bad options */
  WaveSurface(const SurfaceSheet& sheet, const Seafloor& seafloor, const SurfaceOptions& options,
    const Execution& execution = {});

  WaveSurface(const WaveSurface&) = delete;
  WaveSurface& operator=(const WaveSurface&) = delete;

  /** The surface at a time, s. The same for any loop in `execution`. */
  void displace(
    double time, const WaveSection& section, const SurfaceArrays& arrays, const Execution& execution = {}) const;

  /**
   * Move the surface by another phase than the traced one (Peachey 1986): crests are then where it is a multiple of 2 pi,
   * every point is taken by itself, and no wave breaks.
   */
  void setPhase(const StraightPhase& phase);

  /** Where a section takes a place: along its direction and up, held by the shore and the bed. */
  MovedPlace move(const StillPlace& still, const SectionPoint& moved) const;

  /**
   * State at the time of a phase S of the wave n whose crest passes there, on a ray.
   * @param section whose variation delays the breaking
   */
  CrestState crest(std::size_t ray, double phase, std::int64_t wave, const WaveSection& section) const;

  const SurfaceSheet& sheet() const { return this->Sheet; }
  const SurfaceOptions& options() const { return this->Options; }

  /** What becomes of waves along a ray. */
  const SurfHistory& history(std::size_t ray) const { return this->Histories[ray]; }

  /** True where another phase than the traced one moves the surface. */
  bool hasOwnPhase() const { return !this->OwnPhase.empty(); }

  /** When a group that is at phase 0 at time 0 comes to a point of a ray, s; 0 without groups. */
  double groupTime(std::size_t point) const { return this->GroupTime.empty() ? 0.0 : this->GroupTime[point]; }

  /** Traced height of a point of a ray over that which shoaling alone would have given since it broke, above 0 to 1. */
  double brokenShare(std::size_t point) const { return this->BrokenShare.empty() ? 1.0 : this->BrokenShare[point]; }

  /** WaveGroups::share of wave n as its crest passes a phase S of a ray. */
  double groupShare(std::size_t ray, double phase, std::int64_t wave) const;

  /** Share of the traced height that this wave has there. */
  double heightShare(std::size_t ray, double phase, std::int64_t wave) const;

  /** H/h over that at which waves break next, of a point of a ray, 0 to 1. */
  double ripeness(std::size_t point) const { return this->Ripeness[point]; }

  /** Phase S by which a point of the sheet moves. */
  double phase(std::size_t point) const;

  /**
   * What foam at a point of the sheet comes from: the phase S at which the breaking that it lies in began, or that has
   * ended less than ReformingPhase before it, and its share that is left; NaN and 0 where there is none.
   */
  FoamOrigin foamOrigin(std::size_t point) const;

private:
  struct Run;

  // Where a phase lies on a ray.
  struct RayPlace
  {
    std::size_t ray = 0; // or one beside which it was inserted
    std::size_t before = 0;
    std::size_t after = 0;
    double weight = 0.0; // of the later point
  };
  RayPlace placeAt(std::size_t ray, double phase) const;
  void findGroups(std::size_t ray);
  double brokenSince(const RayPlace& place, double phase, double from, double share) const;
  void lowerBy(CrestState& crest, const RayPlace& place, double phase, double delay, double share) const;

  void displaceRay(std::size_t ray, double time, const WaveSection& section, const SurfaceArrays& arrays) const;
  void displaceByOwnPhase(std::size_t ray, double time, const WaveSection& section, const SurfaceArrays& arrays) const;
  void place(const Run& run, const SurfaceArrays& arrays) const;

  const SurfaceSheet& Sheet;
  const Seafloor& Bed;
  SurfaceOptions Options;
  std::vector<SurfHistory> Histories; // one a ray
  std::vector<double> Ripeness;       // one a point of a ray
  std::vector<double> GroupTime;      // one a point of a ray; empty without groups, as the next
  std::vector<double> BrokenShare;
  double ShoreDepth = 0.0;      // of points aground
  std::vector<double> OwnPhase; // one a point, where it is not the traced one; else empty
};

}
