#pragma once

#include "bathymetry/Soundings.h"

#include <optional>
#include <string>

namespace swellray
{

/**
 * Soundings of a file: text (readTextSoundings()), or NetCDF with a survey (readNetcdfSoundings()). A text that GDAL
 * reads as a regular grid of x, y and z is none.
 *
 * @param variable name of the column or variable of values, or the number of the column; empty: by their names
 * @return nothing where the file is of another kind, or there is none
 * @throws std::runtime_error where it cannot be understood
 */
std::optional<Soundings> readSoundings(const std::string& path, const std::string& variable);

}
