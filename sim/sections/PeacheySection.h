#pragma once

#include "sim/Angles.h"
#include "sim/sections/PointwiseSection.h"

#include <algorithm>
#include <array>

namespace swellray
{

/**
 * Peachey 1986, section 3.3: a height of one value, up = A w(u), A = H/2, u in [0, 1) the share of the wave behind the
 * crest.
 *
 * - Steepness S = H/L blends linearly between cos(2 pi u) and the sharp crest 8 |u - 1/2|^2 - 1; it is sharp from
 *   S = steepest on.
 * - Where the depth over the deep-water length, delta, falls from 1/4 ("deep" in the paper) to 1/20 ("shallow"), u
 *   is raised to a power that grows from 1 to 1 + asymmetry: the back of the crest stretches out, its front
 *   steepens. (The paper's u grows forward. Raised to a power it would steepen the back, against its words; hence
 *   counted from the crest backwards here.)
 * - The mean of the profile is taken off, so that the still water is the mean level (that of the sharp crest is -1/3).
 * - A is held so that the displacement never exceeds the depth.
 */
class PeacheySection : public PointwiseSection<PeacheySection>
{
public:
  struct Parameters
  {
    double steepest = 0.1;  ///< H/L from which on crests are sharp, > 0: the paper's maximum
    double asymmetry = 1.0; ///< >= 0
  };

  explicit PeacheySection(const Parameters& parameters);

  bool movesAlong() const override { return false; }

  /** The power of u at a depth ratio delta. */
  double power(double depthRatio) const;

  /** Profile w(u) of range 2 and mean 0: u in [0, 1], the share of sharpness in [0, 1], the power of u >= 1. */
  Dual profile(const Dual& u, double sharpness, double exponent) const;

  Displacement displacement(const Shape&, const SectionPlace& place, const Dual& phase) const
  {
    const double k = place.wavenumber;
    const double depthRatio = place.depth * k * std::tanh(k * place.depth) / (2.0 * Pi);
    const double steepness = place.height * k / (2.0 * Pi);
    const double amplitude = std::min(0.5 * place.height, place.depth / HighestOfProfile);
    const Dual u = -phase / (2.0 * Pi) + (phase.value > 0.0 ? 1.0 : 0.0);
    const double sharpness = std::min(1.0, steepness / this->Values.steepest);
    return { 0.0, amplitude * this->profile(u, sharpness, this->power(depthRatio)) };
  }

  /** A profile of range 2 and mean 0 stays within it. */
  static constexpr double HighestOfProfile = 2.0;

private:
  static constexpr std::size_t TableSize = 256;

  double cosineMean(double power) const;

  Parameters Values;
  std::array<double, TableSize + 2> CosineMeans{}; // of cos(2 pi u^p), p from 1 to 1 + asymmetry
};

}
