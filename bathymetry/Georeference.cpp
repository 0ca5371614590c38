#include "bathymetry/Georeference.h"

#include "bathymetry/QuietGdal.h"
#include "bathymetry/Text.h"
#include "bathymetry/Wkt.h"
#include "sim/Angles.h"

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
    this->Map = std::make_unique<GeographicLib::TransverseMercator>(
      reference.GetSemiMajor(), inverse > 0.0 ? 1.0 / inverse : 0.0, 1.0);
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
  if (data.Kind == GeoreferenceKind::Local)
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
