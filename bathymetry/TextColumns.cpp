#include "bathymetry/TextColumns.h"

#include "bathymetry/Text.h"
#include "bathymetry/VerticalMeaning.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace swellray
{

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Without names a wider table is a matrix of depths, not a list of places.
constexpr std::size_t MostNameless = 16;

constexpr std::size_t LongestNumber = 64;

using Fields = std::vector<std::string_view>;

bool isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view trimmed(std::string_view field)
{
  while (!field.empty() && (isBlank(field.front()) || field.front() == '"'))
  {
    field.remove_prefix(1);
  }
  while (!field.empty() && (isBlank(field.back()) || field.back() == '"'))
  {
    field.remove_suffix(1);
  }
  return field;
}

// What from_chars leaves to its caller: a plus sign, a decimal comma, Fortran's exponents with D.
bool oddNumber(std::string_view field, bool decimalComma, double& value)
{
  if (field.front() == '+' && field.size() > 1 && field[1] != '-')
  {
    field.remove_prefix(1);
  }
  if (field.size() > LongestNumber)
  {
    return false;
  }
  char copy[LongestNumber];
  for (std::size_t i = 0; i < field.size(); ++i)
  {
    const char c = field[i];
    copy[i] = decimalComma && c == ',' ? '.' : c == 'D' || c == 'd' ? 'e' : c;
  }
  const auto read = std::from_chars(copy, copy + field.size(), value);
  return read.ec == std::errc() && read.ptr == copy + field.size();
}

bool isMissing(std::string_view field)
{
  const std::string word = plain(std::string(field.substr(0, 8)));
  return word.empty() || word == "nan" || word == "na" || word == "n/a" || word == "null" || word == "none" ||
    word == "-" || word == "*";
}

// Data, when at least half of three or more fields are numbers.
bool isData(const TextSplit& split, const Fields& fields)
{
  std::size_t numbers = 0;
  for (const std::string_view field : fields)
  {
    double value = 0.0;
    numbers += !isMissing(field) && split.number(field, value) ? 1 : 0;
  }
  return fields.size() >= 3 && numbers >= 2 && 2 * numbers >= fields.size();
}

std::optional<TextSplit> splitOf(std::string_view line, Fields& fields)
{
  const auto has = [](std::string_view text, char c) { return text.find(c) != std::string_view::npos; };
  TextSplit split;
  if (has(line, ';'))
  {
    split = { ';', has(line, ',') && !has(line, '.') };
  }
  else if (has(line, ','))
  {
    // 431200,5 5312000,2 -12,3: commas are decimal where none ends a field.
    split = { ' ', true };
    split.fields(line, fields);
    const auto whole = [](std::string_view field)
    { return std::count(field.begin(), field.end(), ',') == 1 && field.front() != ',' && field.back() != ','; };
    if (!isData(split, fields) || !std::all_of(fields.begin(), fields.end(), whole))
    {
      split = { ',', false };
    }
  }
  else if (has(line, '\t'))
  {
    split.separator = '\t';
    split.fields(line, fields);
    const auto empty = [](std::string_view field) { return field.empty(); };
    if (!isData(split, fields) || std::any_of(fields.begin(), fields.end(), empty))
    {
      split.separator = ' ';
    }
  }
  split.fields(line, fields);
  return !split.isComment(line) && isData(split, fields) ? std::optional<TextSplit>(split) : std::nullopt;
}

struct Name
{
  std::string word; // lower case, without unit
  std::string unit;
};

Name nameOf(std::string_view field)
{
  Name name;
  name.word = plain(std::string(field));
  const std::size_t open = name.word.find_first_of("([");
  if (open != std::string::npos)
  {
    const std::size_t close = name.word.find_first_of(")]", open);
    name.unit = plain(name.word.substr(open + 1, close == std::string::npos ? close : close - open - 1));
    name.word = plain(name.word.substr(0, open));
  }
  const std::size_t bar = name.word.rfind('_');
  if (bar != std::string::npos && name.unit.empty() && metresPerUnit(name.word.substr(bar + 1)) > 0.0)
  {
    name.unit = name.word.substr(bar + 1);
    name.word.resize(bar);
  }
  return name;
}

// 1 for the word itself, 2 where it only begins the name (elevation_navd88, lat wgs84); 0: another name.
int matches(const std::string& name, const char* const word)
{
  const std::string wanted = word;
  if (name.compare(0, wanted.size(), wanted) != 0)
  {
    return 0;
  }
  if (name.size() == wanted.size())
  {
    return 1;
  }
  const char next = name[wanted.size()];
  return wanted.size() > 2 && (next == '_' || next == ' ' || next == '.' || next == '-') ? 2 : 0;
}

// The column with the best of the names: whole names before beginnings, earlier names before later ones.
template <std::size_t N>
std::optional<std::size_t> find(const std::vector<Name>& names, const char* const (&words)[N])
{
  for (const int quality : { 1, 2 })
  {
    for (const char* const word : words)
    {
      for (std::size_t column = 0; column < names.size(); ++column)
      {
        if (matches(names[column].word, word) == quality)
        {
          return column;
        }
      }
    }
  }
  return {};
}

constexpr const char* Longitudes[] = { "lon", "longitude", "long" };
constexpr const char* Latitudes[] = { "lat", "latitude" };
constexpr const char* Eastings[] = { "x", "easting", "east", "e", "xcoord", "point_x", "x_coord" };
constexpr const char* Northings[] = { "y", "northing", "north", "n", "ycoord", "point_y", "y_coord" };
constexpr const char* Heights[] = { "z", "elevation", "elev", "depth", "height", "altitude", "alt", "bathymetry",
  "bathy", "topography", "topo", "bed", "bottom", "sounding", "level" };

std::string listOf(const Fields& fields)
{
  std::string list;
  for (const std::string_view field : fields)
  {
    list += (list.empty() ? "" : ", ") + std::string(field);
  }
  return list;
}

std::optional<std::size_t> columnAsked(const std::string& variable, const std::vector<Name>& names, std::size_t count)
{
  std::size_t number = 0;
  const char* end = variable.data() + variable.size();
  const auto read = std::from_chars(variable.data(), end, number);
  if (read.ec == std::errc() && read.ptr == end)
  {
    return number >= 1 && number <= count ? std::optional<std::size_t>(number - 1) : std::nullopt;
  }
  const Name wanted = nameOf(variable);
  for (std::size_t column = 0; column < names.size(); ++column)
  {
    if (names[column].word == wanted.word)
    {
      return column;
    }
  }
  return {};
}

// Fields of a header: split as the data, or at anything.
Fields headerFields(std::string_view line, const TextSplit& split, std::size_t columns)
{
  while (!line.empty() && (isBlank(line.front()) || std::string_view("#%!*;/").find(line.front()) != std::string::npos))
  {
    if (line.front() != ' ' && (line.front() == '\t' || line.front() == split.separator))
    {
      break; // an empty name of the first column
    }
    line.remove_prefix(1);
  }
  const auto fits = [columns](const Fields& fields)
  { return fields.size() == columns || fields.size() + 1 == columns; };
  Fields fields;
  for (const char separator : { split.separator, '\t', ',', ';', ' ' })
  {
    const TextSplit attempt{ separator, false };
    attempt.fields(line, fields);
    if (fits(fields))
    {
      return fields;
    }
  }
  return {};
}

// True where the first column counts the lines.
bool countsLines(const TextSplit& split, const Fields& first, std::string_view second)
{
  Fields next;
  split.fields(second, next);
  double a = 0.0;
  double b = 0.0;
  return !next.empty() && split.number(first.front(), a) && split.number(next.front(), b) && (a == 0.0 || a == 1.0) &&
    b == a + 1.0;
}

bool placesNamed(const std::vector<Name>& names)
{
  return (find(names, Longitudes) && find(names, Latitudes)) || (find(names, Eastings) && find(names, Northings));
}

void takeByNames(TextColumns& columns, const std::vector<Name>& names)
{
  const auto lon = find(names, Longitudes);
  const auto lat = find(names, Latitudes);
  const auto x = find(names, Eastings);
  const auto y = find(names, Northings);
  columns.degrees = lon && lat;
  columns.x = columns.degrees ? *lon : *x;
  columns.y = columns.degrees ? *lat : *y;
}

}

bool TextSplit::isComment(std::string_view line) const
{
  while (!line.empty() && isBlank(line.front()))
  {
    line.remove_prefix(1);
  }
  return line.empty() || std::string_view("#%!*").find(line.front()) != std::string_view::npos ||
    line.substr(0, 2) == "//" || (line.front() == ';' && this->separator != ';');
}

void TextSplit::fields(std::string_view line, std::vector<std::string_view>& result) const
{
  result.clear();
  if (this->separator != ' ')
  {
    for (std::size_t begin = 0; begin <= line.size();)
    {
      const std::size_t end = std::min(line.find(this->separator, begin), line.size());
      result.push_back(trimmed(line.substr(begin, end - begin)));
      begin = end + 1;
    }
    return;
  }
  for (std::size_t begin = 0; begin < line.size();)
  {
    if (isBlank(line[begin]))
    {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    while (end < line.size() && !isBlank(line[end]))
    {
      ++end;
    }
    result.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end;
  }
}

bool TextSplit::number(std::string_view field, double& value) const
{
  const char* end = field.data() + field.size();
  const auto read = std::from_chars(field.data(), end, value);
  if (read.ec == std::errc() && read.ptr == end)
  {
    return true;
  }
  if (isMissing(field))
  {
    value = NotANumber;
    return true;
  }
  return oddNumber(field, this->decimalComma, value);
}

TextColumns understandColumns(
  const std::vector<std::string_view>& lines, const std::string& variable, std::size_t& firstData)
{
  TextColumns columns;
  Fields first;
  std::optional<TextSplit> split;
  for (firstData = 0; firstData < lines.size() && !split; ++firstData)
  {
    split = splitOf(lines[firstData], first);
  }
  if (!split)
  {
    throw std::runtime_error("none of its first " + std::to_string(lines.size()) +
      " lines has numbers in three columns or more, x, y and z or longitude, latitude and z");
  }
  --firstData;
  columns.split = *split;
  columns.count = first.size();

  // The header is the line next to the data that names places, or else the next one that fits.
  Fields header;
  std::vector<Name> names;
  bool placed = false;
  for (std::size_t line = firstData; line-- > 0 && !placed;)
  {
    const Fields fields = headerFields(lines[line], *split, columns.count);
    std::vector<Name> candidate;
    for (const std::string_view field : fields)
    {
      candidate.push_back(nameOf(field));
    }
    if (candidate.size() + 1 == columns.count)
    {
      candidate.insert(candidate.begin(), Name());
    }
    placed = placesNamed(candidate);
    if (placed || (names.empty() && !split->isComment(lines[line])))
    {
      header = fields;
      names = candidate;
    }
  }
  if (placed)
  {
    takeByNames(columns, names);
  }
  else if (columns.count > MostNameless)
  {
    throw std::runtime_error("its lines have " + std::to_string(columns.count) +
      " numbers and no names: a matrix, not soundings (x, y and z on each line)");
  }
  else
  {
    const bool counted =
      columns.count > 3 && firstData + 1 < lines.size() && countsLines(*split, first, lines[firstData + 1]);
    const std::size_t begin = counted ? 1 : 0;
    columns.x = begin;
    columns.y = begin + 1;
    columns.z = begin + 2;
    if (columns.count > 3)
    {
      columns.notes.push_back("columns taken in order: x, y and z are the columns " + std::to_string(begin + 1) + ", " +
        std::to_string(begin + 2) + " and " + std::to_string(begin + 3) + " of " + std::to_string(columns.count) +
        (counted ? " (the first counts the lines)" : ""));
    }
    if (!names.empty())
    {
      columns.notes.push_back("names of columns not understood (" + listOf(header) + "): taken in order, x, y, z");
    }
  }

  const std::optional<std::size_t> known = find(names, Heights);
  const std::optional<std::size_t> asked =
    variable.empty() ? std::nullopt : columnAsked(variable, names, columns.count);
  if (!variable.empty() && !asked)
  {
    throw std::runtime_error("it has no column '" + variable + "'; there are " +
      (names.empty() ? std::to_string(columns.count) + " without names" : listOf(header)));
  }
  if (asked)
  {
    columns.z = *asked;
  }
  else if (placed && known)
  {
    columns.z = *known;
  }
  else if (placed && columns.count == 3)
  {
    columns.z = 3 - columns.x - columns.y;
  }
  else if (placed)
  {
    throw std::runtime_error(
      "which of its columns holds the elevations or depths? Choose with --variable: " + listOf(header));
  }
  if (columns.z == columns.x || columns.z == columns.y)
  {
    throw std::runtime_error("column '" + variable + "' holds a coordinate, not elevations or depths");
  }
  if (columns.z < names.size())
  {
    columns.name = names[columns.z].word;
    columns.units = names[columns.z].unit;
  }
  return columns;
}

std::optional<std::size_t> findValueName(const std::vector<std::string>& names)
{
  std::vector<Name> parsed;
  parsed.reserve(names.size());
  for (const std::string& name : names)
  {
    parsed.push_back(nameOf(name));
  }
  return find(parsed, Heights);
}

}
