#pragma once

#include "bathymetry/Georeference.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swellray
{

/** A quantity of lines or of points: one of the pointers is set, one value each. */
struct LineField
{
  std::string name;
  const double* numbers = nullptr; ///< not finite: no value
  const std::int32_t* integers = nullptr;
  const std::uint8_t* bytes = nullptr;
};

/** Lines of a scene with their quantities. */
struct LineImage
{
  std::string layer; ///< name of the layer
  std::size_t lines = 0;
  const std::int64_t* offsets = nullptr; ///< lines + 1 entries: where each line begins among the points
  const double* points = nullptr;        ///< x, y, z a point, m in the scene's plane; z is not written
  std::vector<LineField> ofLines;
  std::vector<LineField> ofPoints;
  Georeference place;
  std::string source;  ///< the program that made it
  std::string history; ///< how it was called
};

/**
 * Write lines for maps: a feature a line (of two points or more), its quantities as fields, and what is known of its
 * points: of numbers the mean and the largest (NameMean, NameMax), of whole numbers the largest. The mean of
 * DirectionFrom is that of unit vectors; Longitude and Latitude are left out. Numbers that are not finite have no value.
 *
 * GeoPackage: in the CRS of the seafloor's file and its unit; a local plane has none. A line across the antimeridian
 * goes on beyond 180 degrees.
 *
 * @param withPoints add a layer, its name with `_points`, of all points with their own quantities and the number of
 *   their line among the features or those left out (Line, from 0)
 * @throws std::runtime_error where the file cannot be written, saying why; what is left of it is to be removed
 */
void writeGeoPackage(const std::string& path, const LineImage& image, bool withPoints);

/**
 * The same as GeoJSON after RFC 7946: longitude and latitude on WGS 84 to nine digits (0.1 mm), lines across the
 * antimeridian cut there.
 * @throws std::runtime_error as writeGeoPackage, and where the scene has no place on Earth
 */
void writeGeoJson(const std::string& path, const LineImage& image);

}
