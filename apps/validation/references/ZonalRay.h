#pragma once

#include "ReferenceSolutions.h"

#include <functional>

namespace swellray::reference
{

/** An ellipsoid of revolution. */
struct Ellipsoid
{
  Real semiMajor = 6378137.0L;             ///< m
  Real flattening = 1.0L / 298.257223563L; ///< WGS 84

  Real normalRadius(Real latitude) const;     ///< N, m; latitude in rad
  Real meridionalRadius(Real latitude) const; ///< M, m
};

/** A place of a ray on the ellipsoid; angles in rad, the azimuth clockwise from north. */
struct ZonalPlace
{
  double latitude = 0.0;
  double longitude = 0.0;
  double azimuth = 0.0;
  double length = 0.0; ///< m, and phase (rad) and time (s) since the start
  double phase = 0.0;
  double time = 0.0;
  double width = 1.0; ///< of the tube of rays that are one ray moved in longitude, over that at the start
};

/**
 * Ray over a depth that varies with latitude only, northwards from a place (its azimuth within 90 degrees of north up to
 * where it turns). With N, M the radii of curvature the invariant of Clairaut and Snell is
 *
 *   P = k N cos(phi) sin(az),  f = (k N cos phi)^2 - P^2
 *   lambda = int P M/(N cos phi sqrt f) dphi,  s = int k N cos(phi) M/sqrt f dphi,
 *   S = int k ds,  t = int ds/Cg
 */
class ZonalRay
{
public:
  /** @param depth of a latitude (rad), m */
  ZonalRay(std::function<Real(Real)> depth, double period, Real latitude, Real longitude, Real azimuth,
    const Ellipsoid& ellipsoid = {});

  /** Place at a latitude north of the start, before the ray turns; rad. */
  ZonalPlace at(Real latitude) const;

private:
  Real momentum(Real latitude) const; // k N cos(phi)

  std::function<Real(Real)> Depth;
  Ellipsoid Earth;
  Real Omega;
  Real Latitude;
  Real Longitude;
  Real P;
};

}
