#pragma once

#include "sim/Seafloor.h"

namespace swellray
{

/**
 * Circular form: the elevation falls with the distance r from a centre. It may end at a rim, a declared
 * kink, beyond which the bed is flat.
 *
 * Profiles are functions of w = r^2, so that nothing is singular at the centre.
 */
class RadialForm : public Seafloor
{
public:
  RadialForm(const Rectangle& bounds, const glm::dvec2& centre, double featureLength);

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override;
  double featureLength() const override { return this->FeatureLength; }
  double resolution() const override { return 0.1 * this->FeatureLength; }
  unsigned kinkCount() const override { return this->Rim > 0.0 ? 1 : 0; }
  double kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const override;
  double highestElevation(const Rectangle& box) const override;
  double lowestElevation(const Rectangle& box) const override;

protected:
  /** Elevation, m, and its derivatives by w. */
  struct Profile
  {
    double elevation = 0.0;
    double first = 0.0;  ///< 1/m
    double second = 0.0; ///< 1/m3
  };

  /** Profile at w = r^2, m2; finite and not rising with w everywhere, also beyond the rim. */
  virtual Profile profile(double w) const = 0;

  /** The bed is flat beyond r = radius, at this depth. */
  void setRim(double radius, double depth);

private:
  double elevationAt(double w) const;

  Rectangle Bounds;
  glm::dvec2 Centre;
  double FeatureLength;
  double Rim = 0.0;
  double FlatDepth = 0.0;
};

}
