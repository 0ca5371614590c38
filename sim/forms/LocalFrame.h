#pragma once

#include "sim/Angles.h"
#include "sim/Seafloor.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace swellray
{

/**
 * Axes of a form, turned about the origin of the scene: u along `axis`, v to the left of it.
 */
class LocalFrame
{
public:
  LocalFrame() = default;

  /** u axis at this angle, radians anticlockwise from +x. */
  explicit LocalFrame(double angle)
    : Axis(snap(std::cos(angle)), snap(std::sin(angle)))
  {
  }

  /** Frame of a beach whose seaward normal (u) points to this bearing, degrees clockwise from north. */
  static LocalFrame facing(double bearing) { return LocalFrame(radians(90.0 - bearing)); }

  const glm::dvec2& axis() const { return this->Axis; }
  glm::dvec2 normal() const { return { -this->Axis.y, this->Axis.x }; }

  glm::dvec2 toLocal(const glm::dvec2& p) const { return { glm::dot(this->Axis, p), glm::dot(normal(), p) }; }

  glm::dvec2 toScene(const glm::dvec2& local) const { return local.x * this->Axis + local.y * normal(); }

  /** Turn the derivatives of a bed from the axes of the form to those of the scene. */
  void toScene(BedSample& bed) const
  {
    const double c = this->Axis.x;
    const double s = this->Axis.y;
    const double xx = bed.xx;
    const double xy = bed.xy;
    const double yy = bed.yy;
    bed.gradient = toScene(bed.gradient);
    bed.xx = c * c * xx - 2.0 * c * s * xy + s * s * yy;
    bed.xy = c * s * (xx - yy) + (c * c - s * s) * xy;
    bed.yy = s * s * xx + 2.0 * c * s * xy + c * c * yy;
  }

  /** Box around a rectangle of the scene, in local coordinates. */
  Rectangle boxToLocal(const Rectangle& box) const
  {
    const glm::dvec2 centre = toLocal(0.5 * (box.low + box.high));
    return around(centre, box.size());
  }

  /** Box around a rectangle of local coordinates, in the scene. */
  Rectangle boxToScene(const Rectangle& box) const
  {
    const glm::dvec2 centre = toScene(0.5 * (box.low + box.high));
    return around(centre, box.size());
  }

private:
  // A quarter turn must leave rectangles as they are.
  static double snap(double value) { return std::abs(value) < 1e-15 ? 0.0 : value; }

  Rectangle around(const glm::dvec2& centre, const glm::dvec2& size) const
  {
    const double c = std::abs(this->Axis.x);
    const double s = std::abs(this->Axis.y);
    const glm::dvec2 half(0.5 * (c * size.x + s * size.y), 0.5 * (s * size.x + c * size.y));
    return { centre - half, centre + half };
  }

  glm::dvec2 Axis{ 1.0, 0.0 };
};

}
