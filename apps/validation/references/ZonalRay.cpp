#include "ZonalRay.h"

#include <cmath>
#include <utility>

namespace swellray::reference
{

Real Ellipsoid::normalRadius(Real latitude) const
{
  const Real e2 = this->flattening * (2.0L - this->flattening);
  const Real sine = std::sin(latitude);
  return this->semiMajor / std::sqrt(1.0L - e2 * sine * sine);
}

Real Ellipsoid::meridionalRadius(Real latitude) const
{
  const Real e2 = this->flattening * (2.0L - this->flattening);
  const Real n = this->normalRadius(latitude) / this->semiMajor;
  return this->semiMajor * (1.0L - e2) * n * n * n;
}

ZonalRay::ZonalRay(std::function<Real(Real)> depth, double period, Real latitude, Real longitude, Real azimuth,
  const Ellipsoid& ellipsoid)
  : Depth(std::move(depth))
  , Earth(ellipsoid)
  , Omega(2.0L * Pi / period)
  , Latitude(latitude)
  , Longitude(longitude)
  , P(this->momentum(latitude) * std::sin(azimuth))
{
}

Real ZonalRay::momentum(Real latitude) const
{
  return wavenumber(this->Omega, this->Depth(latitude)) * this->Earth.normalRadius(latitude) * std::cos(latitude);
}

ZonalPlace ZonalRay::at(Real latitude) const
{
  const auto northward = [this](Real phi)
  {
    const Real q = this->momentum(phi);
    return std::sqrt((q - this->P) * (q + this->P));
  };
  const auto sums = integrate(
    [&](Real phi) -> std::array<Real, 4>
    {
      const Real f = northward(phi);
      const Real m = this->Earth.meridionalRadius(phi);
      const Real way = this->momentum(phi) * m / f;
      const Real depth = this->Depth(phi);
      return { this->P * m / (this->Earth.normalRadius(phi) * std::cos(phi) * f), way,
        way * wavenumber(this->Omega, depth), way / groupSpeed(this->Omega, depth) };
    },
    this->Latitude, latitude);
  // Across the ray a step in longitude is N cos(phi) cos(az) = sqrt(f)/k.
  const auto width = [&](Real phi) { return northward(phi) / wavenumber(this->Omega, this->Depth(phi)); };
  ZonalPlace place;
  place.latitude = static_cast<double>(latitude);
  place.longitude = static_cast<double>(this->Longitude + sums[0]);
  place.azimuth = static_cast<double>(std::atan2(this->P, northward(latitude)));
  place.length = static_cast<double>(sums[1]);
  place.phase = static_cast<double>(sums[2]);
  place.time = static_cast<double>(sums[3]);
  place.width = static_cast<double>(width(latitude) / width(this->Latitude));
  return place;
}

}
