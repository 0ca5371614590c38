#pragma once

#include <glm/vec2.hpp>

#include <memory>

namespace swellray
{

/** A geodesic from one point of an ellipsoid to another. */
struct Geodesic
{
  glm::dvec2 from{ 0.0 };   ///< longitude and latitude, degrees
  glm::dvec2 to{ 0.0 };     ///< longitude not brought into any range where it was computed
  double azimuthFrom = 0.0; ///< of its way at either end, degrees clockwise from north
  double azimuthTo = 0.0;
  double length = 0.0;        ///< m
  double reducedLength = 0.0; ///< m12: width at the end of the tube of geodesics out of the first point, m a radian
  double scale = 1.0;         ///< M12: width at the end over that at the start of geodesics that start parallel
  double scaleBack = 1.0;     ///< M21: the same from the end to the start, and d m12/ds at the end
};

/** Geodesics of an ellipsoid of revolution (GeographicLib; Karney 2013, Algorithms for geodesics, J. Geodesy 87). */
class Geodesics
{
public:
  /** @throws std::invalid_argument unless semiMajor is above 0 (m) and the flattening below 1 */
  explicit Geodesics(double semiMajor = 6378137.0, double flattening = 1.0 / 298.257223563);

  /** From a point with an azimuth over a length. */
  Geodesic direct(const glm::dvec2& lonLat, double azimuth, double length) const;

  /** The shortest between two points. */
  Geodesic inverse(const glm::dvec2& from, const glm::dvec2& to) const;

private:
  struct Impl;
  std::shared_ptr<const Impl> Data;
};

}
