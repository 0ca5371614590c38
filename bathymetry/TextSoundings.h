#pragma once

#include "bathymetry/Soundings.h"

#include <string>

namespace swellray
{

/** True where a file begins like a text: no zero bytes. Any name that GDAL's file system knows. */
bool isText(const std::string& path);

/**
 * Soundings as text, a place on each line: x y z, or longitude, latitude and z, separated by blanks, tabs, commas or
 * semicolons, with a header of names or without (understandColumns()), with comments, in Windows' or Unix' lines, with
 * decimal points or decimal commas. A line whose value is empty or nan is a place without data. Millions of lines take
 * seconds.
 *
 * @param path any name that GDAL's file system knows, such as /vsigzip/soundings.xyz.gz
 * @param variable name of the column of values, or its number from 1; empty: by the names
 * @throws std::runtime_error naming the line that cannot be understood
 */
Soundings readTextSoundings(const std::string& path, const std::string& variable);

}
