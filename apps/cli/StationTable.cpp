#include "StationTable.h"

#include "Console.h"
#include "Failure.h"

#include <fmt/format.h>

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>

namespace swellray::cli
{

namespace
{

std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t\r");
  const auto last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

// The fields of a line, without the quotes around them.
std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    if (line[i] == '"')
    {
      const bool doubled = quoted && i + 1 < line.size() && line[i + 1] == '"';
      quoted = doubled ? quoted : !quoted;
      i += doubled ? 1 : 0;
      if (doubled)
      {
        fields.back() += '"';
      }
    }
    else if (line[i] == ',' && !quoted)
    {
      fields.emplace_back();
    }
    else
    {
      fields.back() += line[i];
    }
  }
  std::transform(fields.begin(), fields.end(), fields.begin(), trimmed);
  return fields;
}

// The first field that is one of these words, in either case, before what follows an underscore: x_rd.
std::optional<std::size_t> columnOf(const std::vector<std::string>& fields, const std::vector<std::string>& words)
{
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    std::string word = fields[i].substr(0, fields[i].find('_'));
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    if (std::find(words.begin(), words.end(), word) != words.end())
    {
      return i;
    }
  }
  return {};
}

bool parse(const std::string& text, double& value)
{
  const char* begin = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end && std::isfinite(value);
}

}

StationTable::StationTable(const std::string& path)
  : Path(path)
{
  std::ifstream file(path);
  if (!file)
  {
    throw WorkError(fmt::format("cannot read '{}': no such file, or it may not be read", path));
  }
  std::string line;
  std::size_t columns = 0;
  std::size_t xColumn = 0;
  std::size_t yColumn = 1;
  for (std::size_t number = 1; std::getline(file, line); ++number)
  {
    if (number == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
    {
      line.erase(0, 3);
    }
    line = trimmed(line);
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    const std::vector<std::string> fields = fieldsOf(line);
    Station station;
    station.line = line;
    station.number = number;
    const bool first = columns == 0;
    columns = first ? fields.size() : columns;
    double none = 0.0;
    if (first && fields.size() >= 2 && !parse(fields[0], none) && !parse(fields[1], none))
    {
      this->Heading = line;
      xColumn = columnOf(fields, { "x", "lon", "longitude", "easting" }).value_or(0);
      yColumn = columnOf(fields, { "y", "lat", "latitude", "northing" }).value_or(1);
      continue;
    }
    const std::size_t needed = std::max(xColumn, yColumn) + 1;
    if (fields.size() < needed || !parse(fields[xColumn], station.x) || !parse(fields[yColumn], station.y))
    {
      throw WorkError(fmt::format("'{}' line {}: '{}' is no point; it needs two numbers, x,y or lon,lat, first on the "
                                  "line or in columns of these names",
        path, number, line));
    }
    if (fields.size() != columns)
    {
      throw WorkError(
        fmt::format("'{}' line {} has {} columns, the first one has {}", path, number, fields.size(), columns));
    }
    this->Stations.push_back(station);
  }
  if (this->Stations.empty())
  {
    throw WorkError(fmt::format("'{}' has no points", path));
  }
  if (this->Heading.empty())
  {
    this->Heading = "x,y";
    for (std::size_t column = 3; column <= columns; ++column)
    {
      this->Heading += fmt::format(",column{}", column);
    }
  }
}

vtkSmartPointer<vtkPolyData> StationTable::places(const Georeference& scene) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Station& station : this->Stations)
  {
    if (scene.kind() == GeoreferenceKind::Geographic && !(std::abs(station.y) <= 90.0))
    {
      throw WorkError(fmt::format("'{}' line {}: latitude {:g} is not within -90 to 90; the columns are lon,lat",
        this->Path, station.number, station.y));
    }
    const glm::dvec2 place = scene.fromFile({ station.x, station.y });
    points->InsertNextPoint(place.x, place.y, 0.0);
  }
  auto stations = vtkSmartPointer<vtkPolyData>::New();
  stations->SetPoints(points);
  return stations;
}

void StationTable::write(vtkPointData* values, const std::vector<std::string>& columns, const std::string& wave,
  const OutputFile& file, Console& console) const
{
  std::ofstream table(file.temporary(), std::ios::trunc);
  table << this->Heading;
  for (const std::string& name : columns)
  {
    table << ',' << name;
  }
  table << '\n';
  vtkIdType without = 0;
  for (std::size_t i = 0; i < this->Stations.size(); ++i)
  {
    const auto tuple = static_cast<vtkIdType>(i);
    const bool reached = std::isfinite(values->GetArray(wave.c_str())->GetComponent(tuple, 0));
    without += reached ? 0 : 1;
    table << this->Stations[i].line;
    for (const std::string& name : columns)
    {
      vtkDataArray* array = values->GetArray(name.c_str());
      const double value = array->GetComponent(tuple, 0);
      const bool known = std::isfinite(value) && (reached || array->GetDataType() != VTK_UNSIGNED_CHAR);
      table << ',' << (known ? fmt::format("{:.10g}", value) : "");
    }
    table << '\n';
  }
  table.close();
  if (!table)
  {
    file.fail("the disk is full, or files may not get so large");
  }
  console.say(fmt::format("stations {} points", this->Stations.size()));
  if (without > 0)
  {
    console.warn(fmt::format(
      "no wave came to {} of {} points of '{}': their fields are empty", without, this->Stations.size(), this->Path));
  }
}

}
