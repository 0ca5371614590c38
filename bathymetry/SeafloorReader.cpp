#include "bathymetry/SeafloorReader.h"

#include "bathymetry/CrsChoice.h"
#include "bathymetry/EvenCells.h"
#include "bathymetry/FileGrid.h"
#include "bathymetry/FillGaps.h"
#include "bathymetry/GridSoundings.h"
#include "bathymetry/ModelFiles.h"
#include "bathymetry/NetcdfCurvilinear.h"
#include "bathymetry/RasterElevations.h"
#include "bathymetry/RasterSource.h"
#include "bathymetry/SmoothGrid.h"
#include "bathymetry/SoundingsReader.h"
#include "bathymetry/Text.h"
#include "bathymetry/ToMetres.h"
#include "bathymetry/UgridMesh.h"
#include "sim/EllipsoidMercator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Scale error of the map above which it is said aloud.
constexpr double NotableScaleError = 0.005;

void report(const Execution& execution, double share)
{
  if (!execution.report(share))
  {
    throw std::runtime_error("reading was cancelled");
  }
}

std::string wordsForRange(const ElevationGrid& grid)
{
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const double z : grid.elevation)
  {
    if (!std::isnan(z))
    {
      lowest = std::min(lowest, z);
      highest = std::max(highest, z);
    }
  }
  return text(lowest) + " to " + text(highest) + " m";
}

// A mark for missing data that the file does not declare looks like a deep sea.
void noteLikelyMark(const FileGrid& file, const VerticalMeaning& meaning, std::vector<std::string>& notes)
{
  constexpr double usualMark = -9999.0;
  const auto marks = std::count_if(file.values.elevation.begin(), file.values.elevation.end(),
    [&meaning](double z) { return z / meaning.factor == usualMark; });
  if (marks > 0)
  {
    notes.push_back(
      std::to_string(marks) + " cells hold -9999, which often marks missing data: if so, say --nodata -9999");
  }
}

void requireWater(const ElevationGrid& grid, const SeafloorOptions& options, const VerticalMeaning& meaning)
{
  const auto& z = grid.elevation;
  if (std::none_of(z.begin(), z.end(), [&options](double e) { return e < options.waterLevel; }))
  {
    throw std::runtime_error("it has no cell below the water level of " + text(options.waterLevel) + " m (elevations " +
      wordsForRange(grid) + "); if its values are " +
      (meaning.factor > 0.0 ? "depths, say --positive down" : "elevations, say --positive up"));
  }
}

// Smooth the grid of a seafloor and say what it has become.
void finish(
  Bathymetry& result, const VerticalMeaning& meaning, const SeafloorOptions& options, const Execution& execution)
{
  SeafloorReport& said = result.report;
  smoothGrid(result.grid, options.smooth, execution);
  said.units = meaning.units;
  said.unitsSource = meaning.unitsSource;
  said.sign = meaning.sign;
  said.signSource = meaning.signSource;
  said.waterLevel = options.waterLevel;
  said.crsName = result.georeference.crsName();
  said.kind = result.georeference.kind();
  said.columns = result.grid.columns;
  said.rows = result.grid.rows;
  said.spacing = result.grid.spacing;
  said.extent = result.grid.bounds();
  said.count(result.grid, options.waterLevel);
  if (said.waterShare == 0.0)
  {
    throw std::runtime_error("no water is left of it on the grid in metres");
  }
  if (result.georeference.metresPerUnit() != 1.0)
  {
    said.notes.push_back("its coordinates are units of " + text(result.georeference.metresPerUnit(), 12) +
      " m: the scene is in metres, file coordinate = point / " + text(result.georeference.metresPerUnit(), 12) +
      " + origin");
  }
  if (said.scaleError > NotableScaleError)
  {
    said.notes.push_back("distances on the map are off by up to " + text(100.0 * said.scaleError, 2) +
      " %; --crop for a smaller scene, with less");
  }
}

Bathymetry readScattered(
  const std::string& path, const Soundings& soundings, const SeafloorOptions& options, const Execution& execution)
{
  Bathymetry result;
  SeafloorReport& said = result.report;
  Execution first = execution;
  first.progress = [&execution](double share) { return execution.report(0.3 + 0.6 * share); };
  GriddedSoundings gridded = gridSoundings(soundings, options, first);
  result.grid = std::move(gridded.grid);
  result.georeference = gridded.georeference;
  requireWater(result.grid, options, gridded.meaning);
  if (const auto& map = result.georeference.mercator())
  {
    // From here on it is a grid of longitudes and latitudes like any other.
    FileGrid file;
    file.first = result.grid.origin;
    const double middle = 0.5 * (result.grid.bounds().low.x + result.grid.bounds().high.x);
    file.first.x += 360.0 * std::round((result.georeference.originLongitude() - middle) / 360.0);
    file.columnStep.x = result.grid.spacing.x;
    file.rowStep.y = result.grid.spacing.y;
    file.values = std::move(result.grid);
    file.values.origin = glm::dvec2(0.0);
    file.values.spacing = glm::dvec2(1.0);
    MetricGrid metric = toMercator(file, result.georeference, execution);
    result.grid = std::move(metric.grid);
    result.geographic = std::move(metric.geographic);
    said.resampled = true;
    said.standardLatitude = map->standardLatitude();
  }
  said.path = path;
  said.files = soundings.files;
  said.driver = soundings.driver;
  said.variable = soundings.variable;
  said.fileExtent = gridded.fileExtent;
  said.crsSource = gridded.crsSource;
  said.scaleError = gridded.scaleError;
  said.soundings = gridded.report;
  said.notes = gridded.notes;
  finish(result, gridded.meaning, options, execution);
  report(execution, 1.0);
  return result;
}

Bathymetry readRaster(
  const std::string& path, RasterSource& source, const SeafloorOptions& options, const Execution& execution)
{
  Bathymetry result;
  SeafloorReport& said = result.report;
  const RasterHeader& header = source.header();
  if (options.earth == EarthModel::Ellipsoid && options.resample)
  {
    throw std::runtime_error(
      "on the ellipsoid the grid is taken as it is, in longitude and latitude: leave out resample");
  }
  const VerticalMeaning meaning = understandVertical(header.vertical, options.positive);
  said.path = path;
  said.files = header.files;
  said.driver = header.driver;
  said.variable = header.variable;
  said.fileColumns = header.columns;
  said.fileRows = header.rows;
  Execution first = execution;
  first.progress = [&execution](double share) { return execution.report(0.3 * share); };
  std::vector<std::string> averaged;
  FileGrid file = readElevations(source, options, meaning, averaged, first);
  report(execution, 0.3);
  said.readColumns = file.values.columns;
  said.readRows = file.values.rows;
  said.fileExtent = file.extent();
  said.fileSpacing = { std::hypot(file.columnStep.x, file.columnStep.y), std::hypot(file.rowStep.x, file.rowStep.y) };
  said.notes = header.notes;
  said.notes.insert(said.notes.end(), averaged.begin(), averaged.end());
  said.notes.insert(said.notes.end(), meaning.notes.begin(), meaning.notes.end());
  noteLikelyMark(file, meaning, said.notes);
  requireWater(file.values, options, meaning);

  const CrsChoice choice = chooseCrs(
    options.crs, header.crs, header.crsSource, file.extent(), [&file] { return rmsSlope(file); }, said.notes);
  const Georeference place = placeGrid(file, choice.crs, options.earth);
  const GapCount gaps = fillGaps(file.values, cellSize(file, place), options.maxGap);
  said.noDataRead = gaps.filled + gaps.left;
  said.filled = gaps.filled;
  report(execution, 0.5);

  if (!file.axisAligned())
  {
    said.notes.push_back("the grid is rotated: resampled to north up; what lies outside of it is a hole");
  }
  MetricGrid metric =
    place.mercator() ? toMercator(file, place, execution) : toMetres(file, place, options.resample, execution);
  report(execution, 0.9);
  result.grid = std::move(metric.grid);
  result.geographic = std::move(metric.geographic);
  result.georeference = metric.georeference;
  said.crsSource = choice.source;
  said.resampled = metric.resampled;
  said.scaleError = metric.scaleError;
  if (place.mercator())
  {
    said.standardLatitude = place.mercator()->standardLatitude();
  }
  finish(result, meaning, options, execution);
  report(execution, 1.0);
  return result;
}

Bathymetry readGrid(
  const std::string& path, ModelGrid&& grid, const SeafloorOptions& options, const Execution& execution)
{
  if (grid.places.empty())
  {
    return readRaster(path, *rasterOf(std::move(grid)), options, execution);
  }
  evenCells(grid, options.nodata);
  return readScattered(path, soundingsOf(std::move(grid)), options, execution);
}

Bathymetry read(const std::string& path, const SeafloorOptions& options, const Execution& execution)
{
  if (std::optional<ModelGrid> model = readModelGrid(path))
  {
    return readGrid(path, std::move(*model), options, execution);
  }
  if (const std::optional<Soundings> mesh = readUgridMesh(path, options.variable))
  {
    return readScattered(path, *mesh, options, execution);
  }
  if (std::optional<ModelGrid> curvilinear = readNetcdfCurvilinear(path, options.variable))
  {
    return readGrid(path, std::move(*curvilinear), options, execution);
  }
  if (const std::optional<Soundings> soundings = readSoundings(path, options.variable))
  {
    return readScattered(path, *soundings, options, execution);
  }
  return readRaster(path, *openRaster(path, options.variable), options, execution);
}

// What `make` returns; its errors name the file.
template <typename Make>
Bathymetry named(const std::string& path, const SeafloorOptions& options, const Make& make)
{
  options.validate();
  try
  {
    return make();
  }
  catch (const std::exception& error)
  {
    // Words of the file may be in it.
    throw std::runtime_error(oneLine("seafloor '" + path + "': " + error.what()));
  }
}

}

Bathymetry readSeafloor(const std::string& path, const SeafloorOptions& options, const Execution& execution)
{
  return named(path, options, [&] { return read(path, options, execution); });
}

Bathymetry readSeafloor(
  const std::string& path, ModelGrid grid, const SeafloorOptions& options, const Execution& execution)
{
  return named(path, options, [&] { return readGrid(path, std::move(grid), options, execution); });
}

Bathymetry readSeafloor(
  const std::string& path, const Soundings& soundings, const SeafloorOptions& options, const Execution& execution)
{
  return named(path, options, [&] { return readScattered(path, soundings, options, execution); });
}

}
