#pragma once

#include "OutputFile.h"

#include "bathymetry/Georeference.h"

#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

class vtkPointData;
class vtkPolyData;

namespace swellray::cli
{

class Console;

/**
 * Points of a CSV file, x,y or lon,lat in the coordinates of the seafloor's file: the columns of these names (or
 * longitude, latitude, easting, northing, x_..., y_...), otherwise the first two; the others are kept. A first line whose first two fields are no numbers
 * is a heading. Blank lines and lines that begin
 * with # are passed over; fields may stand in double quotes.
 */
class StationTable
{
public:
  /** @throws WorkError naming the file, and the line that is no point */
  explicit StationTable(const std::string& path);

  /** The points in the plane of a scene, m. @throws WorkError naming the line of one that lies nowhere */
  vtkSmartPointer<vtkPolyData> places(const Georeference& scene) const;

  /** Times of the points, s, of a column `time` or `t` (or time_..., t_...); empty where there is none. */
  const std::vector<double>& times() const { return this->Times; }

  /** Numbers of the first column that is one of these words, one a point, NaN where a field is empty; none without the column. @throws WorkError */
  std::optional<std::vector<double>> numbers(const std::vector<std::string>& words) const;

  std::size_t size() const { return this->Stations.size(); }

  /** A point as it stands in the file. */
  const std::string& line(std::size_t i) const { return this->Stations[i].line; }

  /** Heading of a table with these columns after the points' own. */
  std::string heading(const std::vector<std::string>& columns) const;

  /** The rows of such a table, as write() has them, and how many of them have no wave. */
  std::vector<std::string> rows(
    vtkPointData* values, const std::vector<std::string>& columns, const std::string& wave, std::size_t& without) const;

  /**
   * Write the points, each with its values, to the file's hidden name. A value that is not finite is an empty field; so
   * are the flags (bytes) of a point that has no wave. How many points have none is said.
   * @param values one tuple a point
   * @param columns names of arrays of one component
   * @param wave the column that is not finite where there is no wave
   * @throws WorkError
   */
  void write(vtkPointData* values, const std::vector<std::string>& columns, const std::string& wave,
    const OutputFile& file, Console& console) const;

private:
  struct Station
  {
    double x = 0.0;
    double y = 0.0;
    std::string line; // as it was read
    std::vector<std::string> fields;
    std::size_t number = 0;
  };

  std::string Path;
  std::string Heading;
  std::vector<std::string> Columns; // of the heading, empty without one
  std::vector<Station> Stations;
  std::vector<double> Times;
};

}
