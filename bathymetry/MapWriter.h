#pragma once

#include "bathymetry/Georeference.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swellray
{

/** A quantity at the nodes of a map: one of the three pointers is set, columns x rows values, south row first. */
struct MapVariable
{
  std::string name;
  std::string longName;
  std::string unit;                ///< as CF has it ("m", "degree", "1")
  std::string standardName;        ///< CF standard name; empty: there is none for it
  std::string flagMeanings;        ///< of the values 0, 1, ..., blank-separated; empty: no flags
  const double* numbers = nullptr; ///< NaN: no value
  const std::int32_t* integers = nullptr;
  const std::uint8_t* bytes = nullptr;
};

/** A map on a regular grid. */
struct MapImage
{
  std::size_t columns = 0;   ///< nodes along x
  std::size_t rows = 0;      ///< nodes along y
  glm::dvec2 origin{ 0.0 };  ///< the south-west node, m in the scene's plane
  glm::dvec2 spacing{ 1.0 }; ///< of the nodes, m, > 0
  Georeference place;
  std::vector<MapVariable> variables;
  std::string source;  ///< the program that made it
  std::string history; ///< how it was called
};

/**
 * CRS in which a map is written, as WKT: that of the file where it is projected or local; where it is geographic the
 * transverse Mercator of the scene, centred on its origin, or on the ellipsoid its Mercator, in metres. Empty without a
 * CRS.
 */
std::string mapCrs(const Georeference& place);

/**
 * Write a GeoTIFF: a band a variable, named, 32-bit floating point, NaN for no value, a pixel centred on each node.
 * @throws std::runtime_error where the file cannot be written, saying why; what is left of it is to be removed
 */
void writeGeoTiff(const std::string& path, const MapImage& map);

/**
 * Write a NetCDF-4 file after the CF conventions (1.8): a variable a quantity, coordinates x and y, grid mapping.
 * @throws std::runtime_error as writeGeoTiff
 */
void writeNetcdf(const std::string& path, const MapImage& map);

}
