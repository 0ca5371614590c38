#include "bathymetry/GeodesicSource.h"

#include "bathymetry/Text.h"
#include "sim/Angles.h"
#include "sim/EllipsoidMercator.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Way by which headings on a plane are compared, m: they change by some 1e-7 a metre.
constexpr double Step = 100.0;

Geodesics earthOf(const Georeference& scene)
{
  return scene.mercator() ? Geodesics(scene.mercator()->semiMajor(), scene.mercator()->flattening()) : Geodesics();
}

}

GeodesicSource::GeodesicSource(const glm::dvec2& lonLat, const Georeference& scene)
  : LonLat(lonLat)
  , Scene(scene)
  , Earth(earthOf(scene))
{
  if (!(std::abs(lonLat.x) <= 360.0) || !(std::abs(lonLat.y) <= 90.0))
  {
    throw std::invalid_argument(
      "a storm needs a longitude within -360 to 360 and a latitude within -90 to 90 degrees, not " + text(lonLat.x) +
      ", " + text(lonLat.y));
  }
  if (scene.kind() == GeoreferenceKind::Local)
  {
    throw std::invalid_argument("waves from a storm need a seafloor that says where on Earth it lies: give its CRS");
  }
}

Geodesic GeodesicSource::arriving(const glm::dvec2& place, double& heading) const
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const Geodesic way = this->Earth.inverse(this->LonLat, this->Scene.toLonLat(place).value_or(glm::dvec2(unknown)));
  heading = radians(90.0 - way.azimuthTo + this->Scene.convergence(place));
  return way;
}

void GeodesicSource::evaluate(const glm::dvec2& place, SourceSample& sample) const
{
  const Geodesic way = this->arriving(place, sample.heading);
  sample.distance = way.length;
  sample.width = way.reducedLength;
  if (this->Scene.mercator())
  {
    ScaleSample m;
    this->Scene.mercator()->evaluate(place, m);
    const glm::dvec2 along(std::cos(sample.heading), std::sin(sample.heading));
    const glm::dvec2 left(-along.y, along.x);
    sample.turn = (way.scaleBack / way.reducedLength + glm::dot(along, m.gradient)) / m.scale * left -
      glm::dot(left, m.gradient) / m.scale * along;
    return;
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    glm::dvec2 step(0.0);
    step[axis] = Step;
    double ahead = 0.0;
    double behind = 0.0;
    this->arriving(place + step, ahead);
    this->arriving(place - step, behind);
    sample.turn[axis] = std::remainder(ahead - behind, 2.0 * Pi) / (2.0 * Step);
  }
}

}
