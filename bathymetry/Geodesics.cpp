#include "bathymetry/Geodesics.h"

#include <GeographicLib/Geodesic.hpp>

#include <stdexcept>

namespace swellray
{

struct Geodesics::Impl
{
  GeographicLib::Geodesic Solver;
};

Geodesics::Geodesics(double semiMajor, double flattening)
{
  try
  {
    this->Data = std::make_shared<Impl>(Impl{ GeographicLib::Geodesic(semiMajor, flattening) });
  }
  catch (const GeographicLib::GeographicErr& error)
  {
    throw std::invalid_argument(error.what());
  }
}

Geodesic Geodesics::direct(const glm::dvec2& lonLat, double azimuth, double length) const
{
  using Solver = GeographicLib::Geodesic;
  Geodesic way;
  way.from = lonLat;
  way.azimuthFrom = azimuth;
  way.length = length;
  double ignored = 0.0;
  this->Data->Solver.GenDirect(lonLat.y, lonLat.x, azimuth, false, length,
    Solver::LATITUDE | Solver::LONGITUDE | Solver::AZIMUTH | Solver::REDUCEDLENGTH | Solver::GEODESICSCALE |
      Solver::LONG_UNROLL,
    way.to.y, way.to.x, way.azimuthTo, ignored, way.reducedLength, way.scale, way.scaleBack, ignored);
  return way;
}

Geodesic Geodesics::inverse(const glm::dvec2& from, const glm::dvec2& to) const
{
  Geodesic way;
  way.from = from;
  way.to = to;
  this->Data->Solver.Inverse(from.y, from.x, to.y, to.x, way.length, way.azimuthFrom, way.azimuthTo, way.reducedLength,
    way.scale, way.scaleBack);
  return way;
}

}
