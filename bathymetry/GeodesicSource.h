#pragma once

#include "bathymetry/Geodesics.h"
#include "bathymetry/Georeference.h"
#include "sim/WaveSource.h"

namespace swellray
{

/**
 * Waves from a point of the Earth, a storm far away: over deep water they follow the geodesics out of it. Their crests at the end
 * of a geodesic of reduced length m12 and scale M21 have the curvature M21/m12, positive where they spread, and so, a metre
 * of the map of scale m in the direction of the unit vector a, the heading turns by
 *
 *   (a.L) ((M21/m12)/m + (t.grad m)/m) - (a.t) (L.grad m)/m
 *
 * t along the waves and L to their left: the first bracket is the curvature of the crest on the map, the rest that of the
 * geodesic. (Karney 2013, J. Geodesy 87, for m12 and M21.)
 *
 * Of a scene on a plane the heading is the azimuth less the convergence of its meridians, and its turn that by differences over
 * 100 m either way: 1e-10 of it on a geographic grid, 1e-5 on a projected one.
 */
class GeodesicSource final : public WaveSource
{
public:
  /**
   * @param lonLat of the source, degrees
   * @param scene to whose points, in m, the source is asked
   * @throws std::invalid_argument a latitude beyond 90 degrees or a longitude beyond 360, or a scene that does not say where on
   *   Earth it lies
   */
  GeodesicSource(const glm::dvec2& lonLat, const Georeference& scene);

  void evaluate(const glm::dvec2& place, SourceSample& sample) const override;

private:
  /** The geodesic that comes in at a place, and its heading there. */
  Geodesic arriving(const glm::dvec2& place, double& heading) const;

  glm::dvec2 LonLat;
  Georeference Scene;
  Geodesics Earth;
};

}
