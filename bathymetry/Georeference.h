#pragma once

#include <glm/vec2.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace swellray
{
class EllipsoidMercator;
}

namespace swellray
{

/** What the coordinates of a seafloor's file are. */
enum class GeoreferenceKind
{
  Local,      ///< a plane of its own; no place on Earth
  Projected,  ///< a map projection's easting and northing
  Geographic, ///< longitude and latitude
};

/**
 * Where the points of a scene (metres, x east, y north) lie in the coordinates of its file and on Earth.
 *
 * Projected and local: file coordinate = point / metresPerUnit() + originX/Y, in the file's own unit.
 *
 * Geographic: a point is the transverse Mercator map (Krueger series to 6th order in the third flattening,
 * 5 nm within 3,900 km of the meridian: Karney 2011, Transverse Mercator with an accuracy of a few nanometers,
 * J. Geodesy 85) of the longitude and latitude, on the CRS's own ellipsoid, with scale 1 on the meridian
 * originLongitude and the point (0, 0) at (originLongitude, originLatitude).
 *
 * Geographic on the ellipsoid, whatever the size of the scene: a point is Mercator's map of the longitude and latitude,
 * counted from the scene's middle meridian and the equator, with scale 1 on the scene's middle parallel.
 *
 * It is built again from what an output carries as field data: CRS, OriginLongitude, OriginLatitude, OriginX,
 * OriginY. All members may be called from several threads at once.
 */
class Georeference
{
public:
  /** Local, metres, origin 0. */
  Georeference();

  /**
   * @param crs WKT (any version), or empty for a local plane in metres
   * @param originLonLat degrees; used where the CRS is geographic
   * @param originXY file coordinates of the point (0, 0); used where it is not geographic
   * @throws std::runtime_error a CRS that cannot be understood, or one that is neither a plane nor longitude and
   *   latitude in degrees from Greenwich
   */
  Georeference(const std::string& crs, const glm::dvec2& originLonLat, const glm::dvec2& originXY);

  /**
   * On Mercator's map of the ellipsoid of a geographic CRS. Both angles are rounded to 1e-6 degrees, so that a text
   * holds them.
   * @param longitude of x = 0, degrees
   * @param standardLatitude where the scale is 1, degrees
   * @throws std::runtime_error as the constructor, or where the CRS is not geographic
   */
  static Georeference onEllipsoid(const std::string& crs, double longitude, double standardLatitude);

  /**
   * The same, from the CRS of that map as mapCrs() has it.
   * @throws std::runtime_error where it is none
   */
  static Georeference fromMercator(const std::string& mapCrs);

  /** The map of the ellipsoid; null for a plane. */
  const std::shared_ptr<const EllipsoidMercator>& mercator() const;

  GeoreferenceKind kind() const;

  /** CRS as WKT (2019), empty where there is none. */
  const std::string& crs() const;

  /** Name of the CRS, empty where there is none. */
  const std::string& crsName() const;

  /** Longitude of the point (0, 0), degrees, -180 to 180; NaN where it is not known (local). */
  double originLongitude() const;

  /** Latitude of the point (0, 0), degrees; NaN where it is not known (local). */
  double originLatitude() const;

  /** File coordinates of the point (0, 0), in the file's unit; 0 where the CRS is geographic. */
  double originX() const;
  double originY() const;

  /** Metres a unit of the file's coordinates; 1 where they are degrees. */
  double metresPerUnit() const;

  /** File coordinates of a point: longitude (-180 to 180) and latitude in degrees, or x and y in the file's unit. */
  glm::dvec2 toFile(const glm::dvec2& point) const;

  /** Point of file coordinates. Longitudes may count 0 to 360. */
  glm::dvec2 fromFile(const glm::dvec2& file) const;

  /**
   * Longitude (-180 to 180) and latitude, degrees: of the CRS itself where it is geographic, WGS 84 where it is
   * projected. None for a local plane, and where the projection has no inverse.
   */
  std::optional<glm::dvec2> toLonLat(const glm::dvec2& point) const;

  /** The same for n points at once; in and out may be the same array. */
  void toFile(std::size_t n, const glm::dvec2* points, glm::dvec2* file) const;
  void fromFile(std::size_t n, const glm::dvec2* file, glm::dvec2* points) const;

  /** False, and nothing written, for a local plane. NaN where the projection has no inverse. */
  bool toLonLat(std::size_t n, const glm::dvec2* points, glm::dvec2* lonLat) const;

  /**
   * Meridian convergence: bearing of the scene's +y axis at a point, degrees clockwise from true north; true north
   * lies that much anticlockwise from +y. 0 for a local plane.
   */
  double convergence(const glm::dvec2& point) const;

  /** Scale of the map at a point (true length = map length / scale); 1 unless geographic. */
  double scale(const glm::dvec2& point) const;

private:
  struct Impl;
  std::shared_ptr<const Impl> Data;
};

/**
 * A CRS given in any way that GDAL understands (EPSG:n, WKT, PROJ), as WKT without its vertical part.
 * @throws std::runtime_error where it is not understood
 */
std::string crsToWkt(const std::string& crs);

}
