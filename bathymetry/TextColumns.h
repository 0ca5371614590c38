#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swellray
{

/** How the lines of a table of text are split into fields. */
struct TextSplit
{
  char separator = ' ';      ///< ',', ';' or a tab, or ' ' for any run of blanks and tabs
  bool decimalComma = false; ///< numbers are written 3,5

  /** The fields of a line, without blanks and quotation marks around them. */
  void fields(std::string_view line, std::vector<std::string_view>& result) const;

  /** True for a line without data: empty, or one that begins with #, %, !, *, // or (where it separates nothing) ;. */
  bool isComment(std::string_view line) const;

  /**
   * A field as a number; NaN for an empty one and for words that stand for none (nan, na, n/a, null, none, -, *).
   * @return false where it is neither
   */
  bool number(std::string_view field, double& value) const;
};

/** Which columns of a table hold a place and its value, counted from 0, and what their names tell. */
struct TextColumns
{
  TextSplit split;
  std::size_t count = 0; ///< columns of the table
  std::size_t x = 0;
  std::size_t y = 1;
  std::size_t z = 2;
  std::string name;     ///< of z, empty where it has none
  std::string units;    ///< of z, empty where its name has none
  bool degrees = false; ///< x and y are named longitude and latitude
  std::vector<std::string> notes;
};

/**
 * Understand a table by its first lines: which of them is the first with data, how it is split, what the columns are
 * called. The last line before the data with as many names as there are columns (or one less: the first column is then
 * the rows' own) is the header, a comment or not.
 *
 * Names understood, whatever their case, with a unit in brackets or after a _: x, lon, longitude, long, easting, east, e,
 * xcoord, point_x; y, lat, latitude, northing, north, n, ycoord, point_y; z, depth, elevation, elev, height, altitude,
 * alt, bathymetry, bathy, topography, topo, bed, bottom, sounding, level. Longitude and latitude come before others.
 *
 * @param lines the first lines of the file
 * @param variable name of the column of values, or its number from 1; empty: by the names
 * @param firstData line of the first data, counted from 0
 * @throws std::runtime_error where no line has data, or the columns cannot be told
 */
TextColumns understandColumns(
  const std::vector<std::string_view>& lines, const std::string& variable, std::size_t& firstData);

/** Which of the names is best one of elevations or depths (those of understandColumns()); nothing where none is. */
std::optional<std::size_t> findValueName(const std::vector<std::string>& names);

}
