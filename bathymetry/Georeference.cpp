#include "bathymetry/Georeference.h"

#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "bathymetry/Wkt.h"
#include "sim/Angles.h"
#include "sim/EllipsoidMercator.h"

#include <GeographicLib/TransverseMercator.hpp>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace swellray
{

namespace
{

constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();

double normalisedLongitude(double longitude)
{
  return std::remainder(longitude, 360.0);
}

}

struct Georeference::Impl
{
  GeoreferenceKind Kind = GeoreferenceKind::Local;
  std::string Wkt;
  std::string Name;
  glm::dvec2 LonLat{ NotKnown };
  glm::dvec2 Origin{ 0.0 };
  double Unit = 1.0;
  std::unique_ptr<GeographicLib::TransverseMercator> Map;
  double MapOriginY = 0.0;
  double SemiMajor = 0.0;
  double Flattening = 0.0;
  std::shared_ptr<const EllipsoidMercator> Mercator; // in place of Map

  // A transformation is not to be used by two threads at once.
  mutable std::mutex Guard;
  std::unique_ptr<OGRCoordinateTransformation> ToWgs84;
  std::unique_ptr<OGRCoordinateTransformation> FromWgs84;

  void readCrs(const std::string& crs);
  void lonLatOfFile(std::size_t n, glm::dvec2* coordinates) const;
};

void Georeference::Impl::readCrs(const std::string& crs)
{
  const QuietGdal quiet;
  OGRSpatialReference reference;
  // Neither files nor the network: a CRS may come out of somebody's data.
  if (reference.SetFromUserInput(crs.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) !=
    OGRERR_NONE)
  {
    throw std::runtime_error(
      "CRS '" + oneLine(crs).substr(0, 80) + "' is not understood: " + QuietGdal::lastError("no reason given"));
  }
  if (reference.IsCompound())
  {
    reference.StripVertical();
  }
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  this->Wkt = wktOf(reference);
  this->Name = reference.GetName() ? reference.GetName() : "";

  if (reference.IsGeographic())
  {
    constexpr double smallAngle = 1e-9; // relative; beyond rounding in WKT
    if (reference.IsDerivedGeographic() || std::abs(reference.GetPrimeMeridian()) > smallAngle ||
      std::abs(reference.GetAngularUnits() / radians(1.0) - 1.0) > smallAngle)
    {
      throw std::runtime_error("CRS '" + this->Name + "' is not in degrees of longitude and latitude from Greenwich; " +
        "bring the file to EPSG:4326 first (gdalwarp -t_srs EPSG:4326)");
    }
    const double inverse = reference.GetInvFlattening();
    this->Kind = GeoreferenceKind::Geographic;
    this->SemiMajor = reference.GetSemiMajor();
    this->Flattening = inverse > 0.0 ? 1.0 / inverse : 0.0;
    this->Map = std::make_unique<GeographicLib::TransverseMercator>(this->SemiMajor, this->Flattening, 1.0);
  }
  else if (reference.IsProjected())
  {
    this->Kind = GeoreferenceKind::Projected;
    this->Unit = reference.GetLinearUnits();
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    this->ToWgs84.reset(OGRCreateCoordinateTransformation(&reference, &wgs84));
    this->FromWgs84.reset(OGRCreateCoordinateTransformation(&wgs84, &reference));
    if (!this->ToWgs84 || !this->FromWgs84)
    {
      throw std::runtime_error(
        "no way from CRS '" + this->Name + "' to longitude and latitude: " + QuietGdal::lastError("no reason given"));
    }
  }
  else if (reference.IsLocal())
  {
    this->Unit = reference.GetLinearUnits();
  }
  else
  {
    throw std::runtime_error("CRS '" + this->Name + "' is neither a plane nor longitude and latitude");
  }
}

// File coordinates of a projected CRS become longitude and latitude in place, NaN where there are none.
void Georeference::Impl::lonLatOfFile(std::size_t n, glm::dvec2* coordinates) const
{
  std::vector<double> x(n);
  std::vector<double> y(n);
  std::vector<int> done(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    x[i] = coordinates[i].x;
    y[i] = coordinates[i].y;
  }
  {
    const QuietGdal quiet;
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->ToWgs84->Transform(static_cast<int>(n), x.data(), y.data(), nullptr, done.data());
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    coordinates[i] = done[i] ? glm::dvec2(normalisedLongitude(x[i]), y[i]) : glm::dvec2(NotKnown);
  }
}

Georeference::Georeference()
  : Data(std::make_shared<Impl>())
{
}

Georeference::Georeference(const std::string& crs, const glm::dvec2& originLonLat, const glm::dvec2& originXY)
{
  auto data = std::make_shared<Impl>();
  if (!crs.empty())
  {
    data->readCrs(crs);
  }
  if (data->Kind == GeoreferenceKind::Geographic)
  {
    if (!(std::abs(originLonLat.y) <= 90.0) || !std::isfinite(originLonLat.x))
    {
      throw std::runtime_error(
        "origin " + text(originLonLat.x) + ", " + text(originLonLat.y) + " is no longitude and latitude in degrees");
    }
    data->LonLat = glm::dvec2(normalisedLongitude(originLonLat.x), originLonLat.y);
    double x = 0.0;
    data->Map->Forward(data->LonLat.x, data->LonLat.y, data->LonLat.x, x, data->MapOriginY);
  }
  else
  {
    data->Origin = originXY;
    if (data->Kind == GeoreferenceKind::Projected)
    {
      data->LonLat = originXY;
      data->lonLatOfFile(1, &data->LonLat);
    }
  }
  this->Data = data;
}

Georeference Georeference::onEllipsoid(const std::string& crs, double longitude, double standardLatitude)
{
  auto data = std::make_shared<Impl>();
  data->readCrs(crs);
  if (data->Kind != GeoreferenceKind::Geographic)
  {
    throw std::runtime_error("on the ellipsoid a grid must be in longitude and latitude, not in CRS '" + data->Name +
      "'; trace it on the plane");
  }
  constexpr double digits = 1e6;
  data->LonLat = { std::round(normalisedLongitude(longitude) * digits) / digits, 0.0 };
  data->Mercator = std::make_shared<EllipsoidMercator>(
    data->SemiMajor, data->Flattening, data->LonLat.x, std::round(standardLatitude * digits) / digits);
  Georeference georeference;
  georeference.Data = data;
  return georeference;
}

Georeference Georeference::fromMercator(const std::string& mapCrs)
{
  const QuietGdal quiet;
  OGRSpatialReference reference;
  std::unique_ptr<OGRSpatialReference> base;
  OGRErr error = reference.importFromWkt(mapCrs.c_str());
  const double longitude =
    reference.GetNormProjParm(SRS_PP_CENTRAL_MERIDIAN, 0.0, error == OGRERR_NONE ? &error : nullptr);
  const double latitude =
    reference.GetNormProjParm(SRS_PP_STANDARD_PARALLEL_1, 0.0, error == OGRERR_NONE ? &error : nullptr);
  base.reset(error == OGRERR_NONE ? reference.CloneGeogCS() : nullptr);
  if (!base)
  {
    throw std::runtime_error("CRS '" + oneLine(mapCrs).substr(0, 80) + "' is no Mercator map with a standard parallel");
  }
  return onEllipsoid(wktOf(*base), longitude, latitude);
}

const std::shared_ptr<const EllipsoidMercator>& Georeference::mercator() const
{
  return this->Data->Mercator;
}

GeoreferenceKind Georeference::kind() const
{
  return this->Data->Kind;
}

const std::string& Georeference::crs() const
{
  return this->Data->Wkt;
}

const std::string& Georeference::crsName() const
{
  return this->Data->Name;
}

double Georeference::originLongitude() const
{
  return this->Data->LonLat.x;
}

double Georeference::originLatitude() const
{
  return this->Data->LonLat.y;
}

double Georeference::originX() const
{
  return this->Data->Origin.x;
}

double Georeference::originY() const
{
  return this->Data->Origin.y;
}

double Georeference::metresPerUnit() const
{
  return this->Data->Unit;
}

glm::dvec2 Georeference::toFile(const glm::dvec2& point) const
{
  const Impl& data = *this->Data;
  if (data.Kind != GeoreferenceKind::Geographic)
  {
    return point / data.Unit + data.Origin;
  }
  glm::dvec2 file;
  if (data.Mercator)
  {
    file = data.Mercator->toLonLat(point);
    return { normalisedLongitude(file.x), file.y };
  }
  data.Map->Reverse(data.LonLat.x, point.x, point.y + data.MapOriginY, file.y, file.x);
  return file;
}

glm::dvec2 Georeference::fromFile(const glm::dvec2& file) const
{
  const Impl& data = *this->Data;
  if (data.Kind != GeoreferenceKind::Geographic)
  {
    return (file - data.Origin) * data.Unit;
  }
  if (data.Mercator)
  {
    const glm::dvec2 near(data.LonLat.x + normalisedLongitude(file.x - data.LonLat.x), file.y);
    return data.Mercator->toMap(near);
  }
  glm::dvec2 point;
  data.Map->Forward(data.LonLat.x, file.y, file.x, point.x, point.y);
  point.y -= data.MapOriginY;
  return point;
}

std::optional<glm::dvec2> Georeference::toLonLat(const glm::dvec2& point) const
{
  glm::dvec2 lonLat;
  if (!this->toLonLat(1, &point, &lonLat) || std::isnan(lonLat.x))
  {
    return {};
  }
  return lonLat;
}

void Georeference::toFile(std::size_t n, const glm::dvec2* points, glm::dvec2* file) const
{
  for (std::size_t i = 0; i < n; ++i)
  {
    file[i] = this->toFile(points[i]);
  }
}

void Georeference::fromFile(std::size_t n, const glm::dvec2* file, glm::dvec2* points) const
{
  for (std::size_t i = 0; i < n; ++i)
  {
    points[i] = this->fromFile(file[i]);
  }
}

bool Georeference::toLonLat(std::size_t n, const glm::dvec2* points, glm::dvec2* lonLat) const
{
  if (this->Data->Kind == GeoreferenceKind::Local)
  {
    return false;
  }
  this->toFile(n, points, lonLat);
  if (this->Data->Kind == GeoreferenceKind::Projected)
  {
    // Pieces of this size fit the cache and the int that the transformation counts in.
    constexpr std::size_t piece = 1u << 16;
    for (std::size_t begin = 0; begin < n; begin += piece)
    {
      this->Data->lonLatOfFile(std::min(piece, n - begin), lonLat + begin);
    }
  }
  return true;
}

double Georeference::convergence(const glm::dvec2& point) const
{
  const Impl& data = *this->Data;
  if (data.Kind == GeoreferenceKind::Local || data.Mercator)
  {
    return 0.0;
  }
  if (data.Kind == GeoreferenceKind::Geographic)
  {
    double latitude = 0.0;
    double longitude = 0.0;
    double gamma = 0.0;
    double scale = 1.0;
    data.Map->Reverse(data.LonLat.x, point.x, point.y + data.MapOriginY, latitude, longitude, gamma, scale);
    return gamma;
  }
  const std::optional<glm::dvec2> lonLat = this->toLonLat(point);
  if (!lonLat)
  {
    return 0.0;
  }
  // Along the meridian, about 1 m either way: far above rounding, far below the curvature of the map.
  constexpr double arc = 1e-5;
  double x[2] = { lonLat->x, lonLat->x };
  double y[2] = { lonLat->y - arc, lonLat->y + arc };
  const QuietGdal quiet;
  const std::lock_guard<std::mutex> lock(data.Guard);
  if (!data.FromWgs84->Transform(2, x, y))
  {
    return 0.0;
  }
  return degrees(-std::atan2(x[1] - x[0], y[1] - y[0]));
}

double Georeference::scale(const glm::dvec2& point) const
{
  const Impl& data = *this->Data;
  if (data.Kind != GeoreferenceKind::Geographic)
  {
    return 1.0;
  }
  if (data.Mercator)
  {
    return data.Mercator->scale(point);
  }
  double latitude = 0.0;
  double longitude = 0.0;
  double gamma = 0.0;
  double scale = 1.0;
  data.Map->Reverse(data.LonLat.x, point.x, point.y + data.MapOriginY, latitude, longitude, gamma, scale);
  return scale;
}

std::string crsToWkt(const std::string& crs)
{
  return Georeference(crs, glm::dvec2(0.0), glm::dvec2(0.0)).crs();
}

}
