#include "sim/EllipsoidMercator.h"

#include "sim/Angles.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

// Newton's method squares its error: from the first guess, off by e^2, three steps are beyond rounding.
constexpr int NewtonSteps = 3;

/** What the formulas need of a latitude, from its tangent. */
struct Meridian
{
  double sine;
  double cosine;
  double w; // W^2
};

Meridian meridianOf(double tangent, double e2)
{
  const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
  const double sine = tangent * cosine;
  return { sine, cosine, 1.0 - e2 * sine * sine };
}

/** Tangent of the conformal latitude of a latitude's tangent. */
double conformalTangent(double tangent, double e)
{
  const double secant = std::sqrt(1.0 + tangent * tangent);
  const double sigma = std::sinh(e * std::atanh(e * tangent / secant));
  return tangent * std::sqrt(1.0 + sigma * sigma) - sigma * secant;
}

/** Tangent of the latitude on the parallel whose isometric latitude is psi. */
double tangentOf(double psi, double e, double e2)
{
  const double wanted = std::sinh(psi);
  double tangent = wanted / (1.0 - e2);
  for (int i = 0; i < NewtonSteps; ++i)
  {
    const double now = conformalTangent(tangent, e);
    const double square = tangent * tangent;
    tangent += (wanted - now) / std::sqrt(1.0 + now * now) * (1.0 + (1.0 - e2) * square) /
      ((1.0 - e2) * std::sqrt(1.0 + square));
  }
  return tangent;
}

}

EllipsoidMercator::EllipsoidMercator(double semiMajor, double flattening, double longitude, double standardLatitude)
  : Longitude(radians(longitude))
  , SemiMajor(semiMajor)
  , Flattening(flattening)
  , Standard(standardLatitude)
{
  const bool ellipsoid = semiMajor > 0.0 && std::isfinite(semiMajor) && flattening >= 0.0 && flattening < 1.0;
  if (!ellipsoid || !std::isfinite(longitude) || !(std::abs(standardLatitude) <= LargestLatitude))
  {
    std::ostringstream message;
    message << "a Mercator map needs an ellipsoid (semi-major axis above 0, flattening 0 to below 1) and a standard "
               "parallel within "
            << -LargestLatitude << " to " << LargestLatitude << " degrees, not " << semiMajor << " m, " << flattening
            << ", " << standardLatitude << " degrees";
    throw std::invalid_argument(message.str());
  }
  this->Eccentricity = std::sqrt(flattening * (2.0 - flattening));
  const Meridian at = meridianOf(std::tan(radians(standardLatitude)), this->Eccentricity * this->Eccentricity);
  this->Share = at.cosine / std::sqrt(at.w);
  this->Radius = this->Share * semiMajor;
}

double EllipsoidMercator::scale(const glm::dvec2& p) const
{
  const double e2 = this->Eccentricity * this->Eccentricity;
  const Meridian at = meridianOf(tangentOf(p.y / this->Radius, this->Eccentricity, e2), e2);
  return this->Share * std::sqrt(at.w) / at.cosine;
}

void EllipsoidMercator::evaluate(const glm::dvec2& p, ScaleSample& sample) const
{
  const double e2 = this->Eccentricity * this->Eccentricity;
  const Meridian at = meridianOf(tangentOf(p.y / this->Radius, this->Eccentricity, e2), e2);
  const double w = std::sqrt(at.w);
  const double meridional = this->SemiMajor * (1.0 - e2) / (at.w * w); // M
  sample.scale = this->Share * w / at.cosine;
  sample.gradient = { 0.0, sample.scale * at.sine / this->Radius };
  sample.xx = 0.0;
  sample.xy = 0.0;
  sample.yy = (at.sine * at.sine * (1.0 - e2) / at.w + at.cosine * at.cosine) / (this->Radius * meridional * at.cosine);
}

ParallelSample EllipsoidMercator::parallel(double y) const
{
  const double e2 = this->Eccentricity * this->Eccentricity;
  const double tangent = tangentOf(y / this->Radius, this->Eccentricity, e2);
  const Meridian at = meridianOf(tangent, e2);
  const double unit = 1.0 / ((1.0 - e2) * this->Radius);
  ParallelSample sample;
  sample.latitude = std::atan(tangent);
  sample.dy = at.cosine * at.w * unit;
  sample.dyy = -at.sine * (at.w + 2.0 * e2 * at.cosine * at.cosine) * unit * sample.dy;
  return sample;
}

glm::dvec2 EllipsoidMercator::toMap(const glm::dvec2& lonLat) const
{
  const double latitude = radians(lonLat.y);
  return this->Radius *
    glm::dvec2(
      radians(lonLat.x) - this->Longitude, std::asinh(conformalTangent(std::tan(latitude), this->Eccentricity)));
}

glm::dvec2 EllipsoidMercator::toLonLat(const glm::dvec2& point) const
{
  const double e2 = this->Eccentricity * this->Eccentricity;
  return { degrees(this->Longitude + point.x / this->Radius),
    degrees(std::atan(tangentOf(point.y / this->Radius, this->Eccentricity, e2))) };
}

}
