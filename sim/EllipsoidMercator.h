#pragma once

#include "sim/MapScale.h"

namespace swellray
{

/** Latitude of a parallel of the map and its derivatives by y. */
struct ParallelSample
{
  double latitude = 0.0; ///< rad
  double dy = 0.0;       ///< rad/m of the map
  double dyy = 0.0;      ///< rad/m2
};

/**
 * Mercator's map of an ellipsoid of revolution, conformal. With the semi-major axis a, the first eccentricity e,
 * W^2 = 1 - e^2 sin^2 phi, N = a/W and M = a (1 - e^2)/W^3 the radii of curvature across and along the meridian, and
 * c = N cos(phi)/a on the standard parallel:
 *
 *   x = c a (lambda - lambda0),  y = c a (atanh(sin phi) - e atanh(e sin phi)),  m = c a/(N cos phi)
 *   dm/dy = m sin(phi)/(c a),  d2m/dy2 = (sin^2(phi) (1 - e^2)/W^2 + cos^2 phi)/(c a M cos phi)
 *   dphi/dy = 1/(m M)
 *
 * (Snyder 1987, Map Projections: a Working Manual, eqs. 7-6 to 7-9.) The latitude of y by Newton's method on its tangent
 * (Karney 2011, J. Geodesy 85, eqs. 7 to 9 and 19 to 21), to rounding.
 */
class EllipsoidMercator final : public MapScale
{
public:
  /**
   * @param semiMajor a, m, > 0
   * @param flattening f, 0 (a sphere) to below 1
   * @param longitude of x = 0, degrees
   * @param standardLatitude degrees, within -85 to 85: the parallel on which the scale is 1
   * @throws std::invalid_argument on a value out of range
   */
  EllipsoidMercator(double semiMajor, double flattening, double longitude, double standardLatitude);

  /** Latitude up to which the map is used, degrees: there its scale is 11.5 times that of the equator. */
  static constexpr double LargestLatitude = 85.0;

  void evaluate(const glm::dvec2& p, ScaleSample& sample) const override;
  double scale(const glm::dvec2& p) const override;

  /** Point of longitude and latitude, degrees, below 90. Longitudes go on beyond 180, as x does. */
  glm::dvec2 toMap(const glm::dvec2& lonLat) const;

  /** Longitude, not brought into any range, and latitude of a point, degrees. */
  glm::dvec2 toLonLat(const glm::dvec2& point) const;

  /** Latitude on the parallel at height y of the map. */
  ParallelSample parallel(double y) const;

  /** The parallel on which the scale is 1, degrees. */
  double standardLatitude() const { return this->Standard; }

  /** Of the ellipsoid: a, m, and f. */
  double semiMajor() const { return this->SemiMajor; }
  double flattening() const { return this->Flattening; }

  /** Longitude a metre of x, rad/m; the same everywhere. */
  double longitudeRate() const { return 1.0 / this->Radius; }

private:
  double Eccentricity;
  double Longitude; // of x = 0, rad
  double Share;     // c
  double Radius;    // c a
  double SemiMajor;
  double Flattening;
  double Standard; // degrees
};

}
