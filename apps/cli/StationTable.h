#pragma once

#include "OutputFile.h"
#include "Request.h"

#include <string>
#include <vector>

class vtkImageData;
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

  /**
   * Write the points with the waves at them to the file's hidden name. A value that is not known is an empty field;
   * how many points have none is said.
   * @throws WorkError
   */
  void write(
    vtkPolyData* rays, vtkImageData* seafloor, const OutputFile& file, const Request& request, Console& console) const;

private:
  struct Station
  {
    double x = 0.0;
    double y = 0.0;
    std::string line; // as it was read
    std::size_t number = 0;
  };

  std::string Path;
  std::string Heading;
  std::vector<Station> Stations;
};

}
