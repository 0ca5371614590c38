#include "StationTable.h"

#include "Console.h"
#include "Csv.h"
#include "Failure.h"

#include <fmt/format.h>

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>

namespace swellray::cli
{

StationTable::StationTable(const std::string& path)
  : Path(path)
{
  std::size_t columns = 0;
  std::size_t xColumn = 0;
  std::size_t yColumn = 1;
  std::optional<std::size_t> timeColumn;
  for (const CsvLine& line : readCsv(path))
  {
    const std::vector<std::string>& fields = line.fields;
    Station station;
    station.line = line.text;
    station.fields = fields;
    station.number = line.number;
    const bool first = columns == 0;
    columns = first ? fields.size() : columns;
    double none = 0.0;
    if (first && fields.size() >= 2 && !parseField(fields[0], none) && !parseField(fields[1], none))
    {
      this->Heading = line.text;
      this->Columns = fields;
      xColumn = columnOf(fields, { "x", "lon", "longitude", "easting" }).value_or(0);
      yColumn = columnOf(fields, { "y", "lat", "latitude", "northing" }).value_or(1);
      timeColumn = columnOf(fields, { "time", "t" });
      continue;
    }
    const std::size_t needed = std::max(xColumn, yColumn) + 1;
    if (fields.size() < needed || !parseField(fields[xColumn], station.x) || !parseField(fields[yColumn], station.y))
    {
      throw WorkError(fmt::format("'{}' line {}: '{}' is no point; it needs two numbers, x,y or lon,lat, first on the "
                                  "line or in columns of these names",
        path, line.number, line.text));
    }
    if (fields.size() != columns)
    {
      throw WorkError(
        fmt::format("'{}' line {} has {} columns, the first one has {}", path, line.number, fields.size(), columns));
    }
    if (timeColumn)
    {
      double time = 0.0;
      if (!parseField(fields[*timeColumn], time))
      {
        throw WorkError(fmt::format("'{}' line {}: '{}' is no time, s", path, line.number, fields[*timeColumn]));
      }
      this->Times.push_back(time);
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

std::optional<std::vector<double>> StationTable::numbers(const std::vector<std::string>& words) const
{
  const std::optional<std::size_t> column = columnOf(this->Columns, words);
  if (!column)
  {
    return {};
  }
  std::vector<double> numbers;
  for (const Station& station : this->Stations)
  {
    const std::string& field = station.fields[*column];
    numbers.push_back(std::numeric_limits<double>::quiet_NaN());
    if (!field.empty() && !parseField(field, numbers.back()))
    {
      throw WorkError(fmt::format(
        "'{}' line {}: '{}' in column '{}' is no number", this->Path, station.number, field, this->Columns[*column]));
    }
  }
  return numbers;
}

std::string StationTable::heading(const std::vector<std::string>& columns) const
{
  std::string heading = this->Heading;
  for (const std::string& name : columns)
  {
    heading += ',' + name;
  }
  return heading;
}

std::vector<std::string> StationTable::rows(
  vtkPointData* values, const std::vector<std::string>& columns, const std::string& wave, std::size_t& without) const
{
  std::vector<std::string> rows;
  without = 0;
  for (std::size_t i = 0; i < this->Stations.size(); ++i)
  {
    const auto tuple = static_cast<vtkIdType>(i);
    const bool reached = std::isfinite(values->GetArray(wave.c_str())->GetComponent(tuple, 0));
    without += reached ? 0 : 1;
    rows.push_back(this->Stations[i].line);
    for (const std::string& name : columns)
    {
      vtkDataArray* array = values->GetArray(name.c_str());
      const double value = array->GetComponent(tuple, 0);
      const bool known = std::isfinite(value) && (reached || array->GetDataType() != VTK_UNSIGNED_CHAR);
      rows.back() += ',' + (known ? fmt::format("{:.10g}", value) : std::string());
    }
  }
  return rows;
}

void StationTable::write(vtkPointData* values, const std::vector<std::string>& columns, const std::string& wave,
  const OutputFile& file, Console& console) const
{
  std::size_t without = 0;
  std::ofstream table(file.temporary(), std::ios::trunc);
  table << this->heading(columns) << '\n';
  for (const std::string& row : this->rows(values, columns, wave, without))
  {
    table << row << '\n';
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
