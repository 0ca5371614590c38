#pragma once

#include "sim/Foam.h"
#include "sim/SheetLocator.h"
#include "sim/WaveSurface.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace swellray
{

/** A place of the undisturbed surface on one sheet: all about it that does not change in time. */
struct SheetPlace
{
  StillPlace still;
  double phase = 0.0;                      ///< S, rad
  double ripeness = 0.0;                   ///< as CrestState::ripeness, of the place
  double groupTime = 0.0;                  ///< as WaveSurface::groupTime
  double brokenShare = 1.0;                ///< as WaveSurface::brokenShare
  double shore = 0.0;                      ///< share of the shore, 0 to 1: points of it only go up and down
  std::array<std::size_t, 3> ray{};        ///< of the corners around it
  std::array<double, 3> weight{};          ///< of these
  std::array<double, 3> breakingPhase{};   ///< of the corners, rad, as FoamOrigin; NaN where there is none
  std::array<double, 3> foamShare{};       ///< of the corners, as FoamOrigin
  std::array<double, 3> plungePhase{};     ///< of the corners, as FoamOrigin, rad
  std::array<double, 3> launchParameter{}; ///< m
};

/** The surface at a place and time. */
struct SurfaceValue
{
  bool covered = false;               ///< false where no wave comes: the rest is not set
  double elevation = 0.0;             ///< of the surface, m, positive up
  glm::dvec3 normal{ 0.0, 0.0, 1.0 }; ///< unit vector
  glm::dvec3 velocity{ 0.0 };         ///< of the water there, m/s
  double depth = 0.0;                 ///< of the bed below still water, m
  double foam = 0.0;                  ///< 0 to 1
  bool breaking = false;              ///< a wave that is there is broken
  std::size_t sheets = 0;             ///< waves that cross there
};

/** What the surface is moved by. */
struct SurfaceMotion
{
  const WaveSection* section = nullptr;
  FoamOptions foam;     ///< its life; the rest is taken from the surface and the section
  double spacing = 0.0; ///< of the samples that are taken, m: waves that they do not resolve are left out; 0: none are
};

/**
 * Share of a wave that samples so far apart may show: 0 of one shorter than two samples, 1 from three on (antialiasing by
 * dropping components: Peachey 1986; Thon et al. 2000, section 2.4).
 */
double resolvedShare(double wavelength, double spacing);

/**
 * The breaking-wave surface as a function of place and time, without a mesh: that of WaveSurface, which its points meet.
 *
 * On a triangle of the sheet S is sum w_i (S_i + k_i.(x - x_i)/2), as for maps, everything else linear, also the state
 * of the crest between its corners' rays. A section that moves places along the wave takes the undisturbed X to
 * x = X + along(X, t) d(X); the X of a place x are found along the wave through it, and where the surface overhangs it is
 * the topmost that counts. Where sheets cross, each is found so and the heights above still water are added; the
 * normal is that of their slopes, the velocity their sum, the foam the largest. On the beach beyond the last rays there is
 * no surface.
 */
class SurfaceFunction
{
public:
  /** The surface must outlive this and move by the traced phase. @throws std::invalid_argument where it does not */
  explicit SurfaceFunction(const WaveSurface& surface);

  /**
   * Values at places, m. The same for any loop in `execution`.
   * @param times s, one a place or one for all
   * @throws std::invalid_argument where there are neither so many
   */
  std::vector<SurfaceValue> at(const std::vector<glm::dvec2>& places, const std::vector<double>& times,
    const SurfaceMotion& motion, const Execution& execution = {}) const;

  /** The same at one place. */
  SurfaceValue at(const glm::dvec2& place, double time, const SurfaceMotion& motion) const;

  double waterLevel() const { return this->Surface.options().waterLevel; }

  const WaveSurface& surface() const { return this->Surface; }

  /** Undisturbed places of the sheets that cover a place, in the order of the sheet. */
  void cover(const glm::dvec2& place, std::vector<SheetPlace>& sheets) const;

  /** Where a place of the sheet is at a time. @param breaking set where the wave that is there is broken; may be null */
  MovedPlace move(const SheetPlace& place, double time, const WaveSection& section, bool* breaking = nullptr) const;

  /** Foam that such a place carries, 0 to 1. */
  double foam(const SheetPlace& place, double time, const SurfaceMotion& motion) const;

private:
  struct Scratch;
  struct Root;

  CrestState crest(const SheetPlace& place, double phase, std::int64_t wave, const WaveSection& section) const;
  bool follow(const SheetPlace& from, const glm::dvec2& place, Scratch& scratch, SheetPlace& found) const;
  bool highest(const SheetPlace& start, double time, const WaveSection& section, Scratch& scratch, Root& top) const;
  double reach(const SheetPlace& place, double time, const WaveSection& section) const;
  void settle(Root& root, const glm::dvec2& place, double time, const WaveSection& section, Scratch& scratch) const;
  SheetPlace placeOn(const SheetCover& cover, const glm::dvec2& place) const;
  SurfaceValue at(const glm::dvec2& place, double time, const SurfaceMotion& motion, Scratch& scratch) const;

  const WaveSurface& Surface;
  SheetLocator Locator;
  std::vector<std::uint32_t> RayOf; // one a point of a ray
  std::vector<FoamOrigin> Foam;     // one a point of a ray
};

}
