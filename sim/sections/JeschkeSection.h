#pragma once

#include "sim/sections/HumpSection.h"

namespace swellray
{

/**
 * Jeschke, Birkholz and Schumann 2003, section 4 and table 1: a hump that grows round, breaks into a tube and collapses.
 * s in [0, 1] runs from its back to its front, the lip at 1/2; for either half
 *
 *   s2 = (2s)^k1 or 1 - (2s - 1)^k1,  s1 = s2/2 or 1 - s2/2
 *   z1 = k2 (1 + cos((s2 - 1) pi))/2 + k3 s2^k4,  phi = pi k5 s2^k6/2
 *   forward = 1/2 - (1/2 - s1) cos(phi) + z1 sin(phi)   (the paper's y, which runs against the wave, from the other end)
 *   z       = ((1/2 - s1) sin(phi) + z1 cos(phi)) k7
 *
 * k5 grows as t^(3/2) while the wave breaks, and k1 changes through it (table 1 as corrected). While it collapses, the two
 * halves of the lip end apart on the water level; the surface goes straight from one to the other.
 *
 * The trace places the phases, which the paper sets by hand:
 * - round up to where the trace says that the wave begins to break. H is the traced height. The hump is as long as the
 *   wave, a sine, far from breaking (t = ripeness 0), and 5 H where it breaks, so that it is as high for its length
 *   as in the paper.
 * - breaking while the crest falls: t = CrestState::plunge, 0 to 1
 * - collapsing: k7 = 1 - t is the traced height over that at the end of breaking, down to 0 at the beach.
 *
 * The trough lies below still water by the volume of the round hump.
 */
class JeschkeSection : public PointwiseSection<JeschkeSection>
{
public:
  /** Constants of one half (table 1). */
  struct Half
  {
    double k1 = 1.0;
    double k2 = 0.25;
    double k3 = 0.0;
    double k4 = 0.0;
    double k5 = 0.0;
    double k6 = 1.0;
  };

  struct Shape
  {
    Half front;
    Half back;
    double k7 = 0.8;
    double width = 0.0;  ///< of the hump, m; the unit of `forward`
    double height = 0.0; ///< the unit of z before k7, m
  };

  explicit JeschkeSection(double largestVariation)
    : Variation(largestVariation)
  {
  }

  double pointsPerWave() const override { return 48.0; }
  double variation() const override { return this->Variation; }
  double frontPhase() const override { return HumpLayout::LeastShare * Pi; }

  /** Constants of the three phases at t in [0, 1]. */
  static Shape round(double t);
  static Shape breaking(double t);
  static Shape collapsing(double t);

  /** The paper's curve: s in [0, 1] to (forward, z) before k7, in units of the hump's length. */
  static Displacement curve(const Shape& shape, const Dual& s);

  /** Length of the hump, m. */
  static double humpWidth(double height, double wavenumber, double ripeness);

  Shape shape(const CrestState& crest) const;
  Displacement displacement(const Shape& shape, const SectionPlace& place, const Dual& phase) const;

private:
  double Variation;
};

}
