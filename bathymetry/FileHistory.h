#pragma once

#include <string>

namespace swellray
{

/**
 * The command line that is kept in a file of MapWriter or LineWriter: a GeoTIFF, NetCDF, GeoPackage or GeoJSON. Empty where there
 * is none.
 * @throws std::runtime_error a file that GDAL cannot read
 */
std::string readHistory(const std::string& path);

}
