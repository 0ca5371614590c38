#pragma once

#include "sim/Angles.h"
#include "sim/sections/PointwiseSection.h"

#include <algorithm>
#include <cstdint>

namespace swellray
{

/**
 * Lake, Reagin and Van Drasek 2005: three passes over a wave.
 *
 * Deep: a sine (one of a sum of sines; sum the rays of several waves). Shallow: the wave shortens by the dispersion
 * relation and steepens: points draw together at the crest as on a trochoid of steepness Q = q K R, up to `steepness`
 * where the wave breaks,
 *
 *   along = -Q/K sin Phi,  up = Q R/2 + R cos Phi,  R = H/2,
 *
 * where Q R/2 keeps the column of water: the mean level stays the still water's.
 * Curling: where the trace says that the wave breaks, or H/L exceeds a threshold (1/7 in the slides), an ellipse rolls
 * ahead of the crest, the vortex. Points of the TOP are thrown over it, the tip ahead and down; those of the FRONT go
 * around the hollow, from its roof by its back to its floor; the BACK is drawn along so that no gap opens; FLAT ones stay.
 * The vortex opens while the crest falls (CrestState::plunge 0 to 1); then it shrinks and sinks towards the sea as the wave
 * loses height on its way in.
 *
 * The vortex is `length/width` as long as wide: 0.065 X + 0.821 on a bed of slope 1:X (Mead and Black 2001), within the
 * 1.73 to 4.43 of the slides: square on steep reefs, almond-shaped on flat ones. (The slides put the circle midway to the
 * next wave; real swell is too long for that: here it lies against the face.)
 */
class VortexSection : public PointwiseSection<VortexSection>
{
public:
  struct Parameters
  {
    double threshold = 1.0 / 7.0; ///< H/L beyond which a wave curls in any depth, > 0
    double steepness = 0.8;       ///< Q of a breaking wave, 0 to below 1
    double variation = 0.2;       ///< as WaveSection::variation
  };

  /** What the third pass does with a point. */
  enum class Part : std::uint8_t
  {
    Flat = 0,
    Back = 1,
    Top = 2,
    Front = 3,
  };

  /** A vortex: an ellipse whose long axis falls forward. */
  struct Vortex
  {
    double curl = 0.0;    ///< how far points have gone around it, 0 to 1
    double forward = 0.0; ///< centre, m ahead of the crest
    double up = 0.0;      ///< centre, m above the trough
    double length = 0.0;  ///< axes, m
    double width = 0.0;
  };

  struct Shape
  {
    Vortex vortex;
    double standing = 0.0;   ///< how far the front stands against the vortex, 0 to 1
    double crestAngle = 0.0; ///< on the vortex, rad: of the crest above it
    double tipAngle = 0.0;   ///< of the tip of the lip
    double lip = 1.0;        ///< distance of the crest from the centre over that of the vortex
  };

  explicit VortexSection(const Parameters& parameters)
    : Values(parameters)
  {
  }

  double pointsPerWave() const override { return 48.0; }
  double variation() const override { return this->Values.variation; }
  double frontPhase() const override; // all of the FRONT

  /** Length over width of a vortex on a bed of this slope, 1.73 to 4.43. */
  static double lengthToWidth(double slope);

  /** Part of a wave that a phase belongs to. */
  static Part part(double phase);

  Vortex vortex(const CrestState& crest) const;
  Shape shape(const CrestState& crest) const;
  Displacement displacement(const Shape& shape, const SectionPlace& place, const Dual& phase) const;

private:
  Parameters Values;
};

}
