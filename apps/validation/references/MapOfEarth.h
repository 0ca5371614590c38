#pragma once

#include "ReferenceSolutions.h"

#include "sim/Dispersion.h"
#include "sim/EllipsoidMercator.h"
#include "sim/HamiltonianRay.h"

#include <cmath>
#include <functional>
#include <utility>

namespace swellray::reference
{

/** A depth that varies with latitude only, on a map of the Earth. */
class ZonalSeafloor final : public Seafloor
{
public:
  /** Depth of a latitude (rad) and its first two derivatives. */
  using Profile = std::function<void(double latitude, double& h, double& h1, double& h2)>;

  ZonalSeafloor(Profile profile, const EllipsoidMercator& map, const Rectangle& bounds)
    : Depth(std::move(profile))
    , Map(map)
    , Bounds(bounds)
  {
  }

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned, BedSample& bed) const override
  {
    const ParallelSample parallel = this->Map.parallel(p.y);
    double h = 0.0;
    double h1 = 0.0;
    double h2 = 0.0;
    this->Depth(parallel.latitude, h, h1, h2);
    bed = BedSample();
    bed.elevation = -h;
    bed.gradient.y = -h1 * parallel.dy;
    bed.yy = -(h2 * parallel.dy * parallel.dy + h1 * parallel.dyy);
  }
  double featureLength() const override { return 1e6; }
  double resolution() const override { return 1e5; }

private:
  Profile Depth;
  const EllipsoidMercator& Map;
  Rectangle Bounds;
};

/**
 * Start of a ray with an azimuth (rad) on a map, one of a row of rays whose heading is the same along `tangent`, a step
 * on the map by the launch parameter.
 */
inline RayStart startAzimuth(
  const RayMedium& medium, const glm::dvec2& position, double azimuth, const glm::dvec2& tangent)
{
  ScaleSample m;
  medium.map->evaluate(position, m);
  const BedSample bed = medium.seafloor->bed(position);
  const double depth = medium.waterLevel - bed.elevation;
  const double k = solveWavenumber(medium.angularFrequency, depth, medium.gravity);
  Frequency frequency{};
  evaluateFrequency(k, depth, medium.gravity, frequency);
  const glm::dvec2 heading(std::sin(azimuth), std::cos(azimuth));
  const double dk = frequency.h / frequency.k *
    (bed.gradient.x * tangent.x + bed.gradient.y * tangent.y); // depth grows as the bed falls
  const double dm = m.gradient.x * tangent.x + m.gradient.y * tangent.y;
  RayStart start;
  start.position = position;
  start.wavenumber = k / m.scale * heading;
  start.dPosition = tangent;
  start.dWavenumber = (dk - k * dm / m.scale) / m.scale * heading;
  return start;
}

}
