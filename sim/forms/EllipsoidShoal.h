#pragma once

#include "sim/forms/LocalFrame.h"

namespace swellray
{

/**
 * Shoal cut from an ellipsoid, on a flat floor or a slope. In axes u, v turned clockwise by an angle from x, y, with
 * their origin at the shoal's centre, the floor has
 *
 *   h = h0                          u < -toe
 *   h = h0 - s (u + toe)            beyond, down to hmin, and flat from there (hmin > 0)
 *
 * and inside the ellipse on which it vanishes, (u/A)^2 + (v/B)^2 = 1 - (c/b)^2, the shoal rises above it by
 *
 *   b sqrt(1 - (u/A)^2 - (v/B)^2) - c
 *
 * Source: Berkhoff, Booij and Radder 1982; Vincent and Briggs 1989. Kinks: the ellipse, the toe, the end of the slope.
 */
class EllipsoidShoal final : public Seafloor
{
public:
  struct Floor
  {
    double depth = 0.0;    ///< h0, m, > 0
    double slope = 0.0;    ///< s, m/m, >= 0
    double toe = 0.0;      ///< distance from the toe of the slope to the shoal's centre, m
    double minDepth = 0.0; ///< hmin, m, < h0; 0: the slope goes on above water
    double rotation = 0.0; ///< clockwise angle from x to u, rad
  };

  struct Ellipsoid
  {
    double height = 1.0;        ///< b, m, > 0
    double sunk = 0.0;          ///< c, m, 0 <= c < b
    glm::dvec2 semiAxes{ 1.0 }; ///< A, B, m, > 0
  };

  EllipsoidShoal(const Rectangle& bounds, const Floor& floor, const Ellipsoid& shoal);

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override;
  double featureLength() const override;
  double resolution() const override { return 0.1 * featureLength(); }
  unsigned kinkCount() const override;
  double kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const override;
  double highestElevation(const Rectangle& box) const override;
  double lowestElevation(const Rectangle& box) const override;

private:
  static constexpr unsigned OnShoal = 1u;
  static constexpr unsigned OnSlope = 2u;
  static constexpr unsigned OnShallowFloor = 4u;

  double floorElevation(double u) const;
  void addShoal(const glm::dvec2& local, BedSample& bed) const;

  Rectangle Bounds;
  LocalFrame Frame;
  Floor Bed;
  Ellipsoid Shoal;
  double SlopeEnd = 0.0; // u where the slope ends at the shallow floor
};

}
