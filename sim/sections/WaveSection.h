#pragma once

#include "sim/Angles.h"
#include "sim/BuiltinSeafloor.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace swellray
{

/** State of one wave where its crest is now: what the shape of the whole wave hangs on as it breaks. */
struct CrestState
{
  double height = 0.0;     ///< H, m
  double wavenumber = 1.0; ///< rad/m
  double depth = 1.0;      ///< m, > 0
  double ripeness = 0.0;   ///< H/h over that at which it breaks, 0 to 1; 1 from breaking on
  double plunge = 0.0;     ///< way since breaking began over the way that a plunging crest takes to fall (Galvin 1969):
                           ///< 0 where it is not broken, 1 where the crest has come down
  double plungeHeight = 0.0; ///< H where the crest came down, m; used where plunge > 1
  double roller =
    1.0; ///< share of the broken wave's shape that is left, 0 to 1: 1 while it breaks, less where the wave
         ///< forms again behind a bar; used where plunge > 0

  /** True where the wave is broken, and no more than half whole again. */
  bool isBroken() const { return this->plunge > 0.0 && this->roller >= 0.5; }
  double slope = 0.0; ///< of the bed along the ray, tan(beta), positive where it rises forward
};

/** Undisturbed places along a ray that belong to one wave: plain arrays with one entry a place. */
struct SectionPlaces
{
  std::size_t count = 0;
  const double* phase = nullptr;      ///< from the crest of the wave, rad, -pi (trough behind) to pi (trough ahead)
  const double* height = nullptr;     ///< H, m, >= 0
  const double* wavenumber = nullptr; ///< rad/m, > 0
  const double* depth = nullptr;      ///< m, > 0
  const double* slope = nullptr;      ///< tan(beta) along the ray, positive where the bed rises forward
  const double* ripeness = nullptr;   ///< as CrestState::ripeness, of the place
};

/** Where the surface goes from these places, and its derivatives by the phase: plain arrays, filled. */
struct SectionPoints
{
  double* along = nullptr;     ///< m, along the ray
  double* up = nullptr;        ///< m, above still water
  double* alongRate = nullptr; ///< m/rad
  double* upRate = nullptr;    ///< m/rad
};

/** One place and where it goes: WaveSection::at(). */
struct SectionPlace
{
  double phase = 0.0;
  double height = 0.0;
  double wavenumber = 1.0;
  double depth = 1.0;
  double slope = 0.0;
  double ripeness = 0.0;
};

struct SectionPoint
{
  double along = 0.0;
  double up = 0.0;
  double alongRate = 0.0;
  double upRate = 0.0;
};

/**
 * A vertical section of the sea: how a wave moves its surface, along the ray and up, as a function of its phase, height,
 * wavenumber, depth and the slope of the bed, and of how far it has broken.
 *
 * The phase grows forward and is 0 at the crest, so 0 to pi is the front of a wave and -pi to 0 its back. Two waves meet
 * in the trough between them; there (at -pi and pi) a section depends on the place alone and not on the wave. The still
 * water is the mean level. Nothing here throws or allocates; all may be called from several threads at once.
 */
class WaveSection
{
public:
  virtual ~WaveSection() = default;

  /** Displace places of one wave. */
  virtual void displace(const CrestState& crest, const SectionPlaces& places, const SectionPoints& points) const = 0;

  /** Points a wavelength that show the shape. */
  virtual double pointsPerWave() const { return 16.0; }

  /** Largest delay of the breaking of single waves, in wavelengths, >= 0: no two break at quite the same place. */
  virtual double variation() const { return 0.0; }

  /** Phase ahead of the crest up to which a wave is white that has come down: its front, rad, >= 0. */
  virtual double frontPhase() const { return 0.25 * Pi; }

  /** False where places move up and down only: one height a place. */
  virtual bool movesAlong() const { return true; }

  /** One place. */
  SectionPoint at(const CrestState& crest, const SectionPlace& place) const;
};

/** Every section by name with its keys, in the order of a listing. */
const std::vector<FormDescription>& waveSections();

/**
 * Make a section.
 * @param spec `NAME` or `NAME:key=value,...`
 * @throws std::invalid_argument unknown name or key (naming the nearest), a value that is no number or out of range
 */
std::unique_ptr<WaveSection> makeWaveSection(const std::string& spec);

}
