#pragma once

#include "bathymetry/Georeference.h"
#include "bathymetry/SoundingReport.h"
#include "sim/ElevationGrid.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swellray
{

/** What was read and how it was understood. */
struct SeafloorReport
{
  std::string path;
  std::vector<std::string> files; ///< that were read because `path` names them, or that go with it; may hold it too
  std::string driver;             ///< name of the format, GDAL's short one where it reads it
  std::string variable;
  std::size_t fileColumns = 0; ///< nodes of the whole file; 0 where it has no rows and columns
  std::size_t fileRows = 0;
  std::size_t readColumns = 0; ///< nodes of the part that was read
  std::size_t readRows = 0;
  Rectangle fileExtent;          ///< of the nodes that were read, file coordinates
  glm::dvec2 fileSpacing{ 0.0 }; ///< distance of nodes along a row and along a column, file coordinates
  GeoreferenceKind kind = GeoreferenceKind::Local;
  std::string crsName;   ///< empty where there is none
  std::string crsSource; ///< "file", "as asked", or why it was assumed

  std::size_t columns = 0; ///< nodes of the result
  std::size_t rows = 0;
  glm::dvec2 spacing{ 0.0 }; ///< m
  Rectangle extent;          ///< m
  bool resampled = false;
  double scaleError = 0.0;                ///< largest |map length / true length - 1|
  std::optional<double> standardLatitude; ///< on the ellipsoid: where the map is true to scale, degrees

  double waterLevel = 0.0; ///< m
  double lowest = 0.0;     ///< elevation, m
  double highest = 0.0;    ///< elevation, m
  double waterShare = 0.0; ///< of the nodes of the result, 0 to 1
  double landShare = 0.0;
  double noDataShare = 0.0;   ///< holes
  std::size_t noDataRead = 0; ///< nodes without data that were read
  std::size_t filled = 0;     ///< of these, filled

  std::string units; ///< of the values, as understood
  std::string unitsSource;
  std::string sign;       ///< of the values, as understood
  std::string signSource; ///< e.g. "positive attribute", "assumed"

  std::optional<SoundingReport> soundings; ///< of a survey or a mesh without rows and columns

  std::vector<std::string> notes; ///< what a user should know, one line each

  /** Set the water level, the elevations' range and the shares of the nodes of the resulting grid. */
  void count(const ElevationGrid& grid, double level);

  /** The report as label and text, in the order in which it is to be printed. */
  std::vector<std::pair<std::string, std::string>> lines() const;
};

}
