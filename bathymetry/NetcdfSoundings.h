#pragma once

#include "bathymetry/Soundings.h"

#include <optional>
#include <string>

namespace swellray
{

/**
 * Soundings of a NetCDF file: one-dimensional variables along one dimension, two of them coordinates (by their units,
 * CF attributes or usual names; longitude and latitude before others), one the elevations or depths (by its standard
 * name or usual names). The sign follows their `positive` attribute or standard name, or else the attribute
 * geospatial_vertical_positive of the file.
 *
 * @param variable name or standard name of the values; empty: the only ones that can be meant
 * @return nothing where the file holds anything with two dimensions, or no such coordinates
 * @throws std::runtime_error where it holds soundings but their values cannot be told or read
 */
std::optional<Soundings> readNetcdfSoundings(const std::string& path, const std::string& variable);

}
