#include "bathymetry/RasterElevations.h"

#include "bathymetry/AveragedRead.h"
#include "bathymetry/CrsChoice.h"
#include "bathymetry/Text.h"
#include "bathymetry/ToMetres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Cells along each side of the part in the middle whose slope tells degrees from metres.
constexpr std::size_t SampleCells = 1000;

double markOf(const SeafloorOptions& options)
{
  return options.nodata.value_or(std::numeric_limits<double>::quiet_NaN());
}

// Places of the nodes of a window, block by block, without values.
FileGrid placesOf(const RasterHeader& header, const RasterWindow& window, const CellBlock& block)
{
  FileGrid file;
  file.values.columns = window.columns / block.columns;
  file.values.rows = window.rows / block.rows;
  const auto columns = static_cast<double>(block.columns);
  const auto rows = static_cast<double>(block.rows);
  file.first = header.node(static_cast<double>(window.firstColumn) + 0.5 * (columns - 1.0),
    static_cast<double>(window.firstRow) + 0.5 * (rows - 1.0));
  file.columnStep = columns * header.columnStep;
  file.rowStep = rows * header.rowStep;
  return file;
}

double middleSlope(
  const RasterSource& source, const SeafloorOptions& options, const RasterWindow& window, double factor)
{
  const std::size_t columns = std::min(window.columns, SampleCells);
  const std::size_t rows = std::min(window.rows, SampleCells);
  const RasterWindow middle{ window.firstColumn + (window.columns - columns) / 2,
    window.firstRow + (window.rows - rows) / 2, columns, rows };
  FileGrid file = placesOf(source.header(), middle, {});
  file.values.elevation = source.read(middle, markOf(options));
  return std::abs(factor) * rmsSlope(file);
}

// As many cells as fit into the distance of the nodes that are asked for.
CellBlock blockFor(
  const RasterSource& source, const SeafloorOptions& options, const RasterWindow& window, double factor)
{
  CellBlock block;
  if (!options.resample)
  {
    return block;
  }
  const RasterHeader& header = source.header();
  FileGrid file = placesOf(header, window, block);
  std::vector<std::string> unsaid;
  const CrsChoice choice = chooseCrs(
    options.crs, header.crs, header.crsSource, file.extent(),
    [&] { return middleSlope(source, options, window, factor); }, unsaid);
  const Georeference place = placeGrid(file, choice.crs);
  const glm::dvec2 cell = cellSize(file, place);
  const auto fit = [&options](double size, std::size_t cells)
  {
    constexpr double rounding = 1e-9;
    const double most = static_cast<double>(std::max<std::size_t>(1, cells / FewestNodes));
    return static_cast<std::size_t>(std::clamp(std::floor(*options.resample / size * (1.0 + rounding)), 1.0, most));
  };
  block.columns = fit(cell.x, window.columns);
  block.rows = fit(cell.y, window.rows);
  return block;
}

void requireElevation(double value, double factor)
{
  if (std::abs(value * factor) > FarthestElevation)
  {
    throw std::runtime_error("it has an elevation of " + text(value * factor) +
      " m, farther from the sea's level than any place on Earth; if " + text(value) +
      " marks missing data, say --nodata " + text(value, 17));
  }
}

}

FileGrid readElevations(RasterSource& source, const SeafloorOptions& options, const VerticalMeaning& meaning,
  std::vector<std::string>& notes, const Execution& execution)
{
  const bool longitudes = isLongitudes(options.crs, source.header().crs);
  RasterWindow window = selectWindow(source.header(), options.crop, longitudes);
  CellBlock block = blockFor(source, options, window, meaning.factor);
  if (source.useOverview(static_cast<double>(std::min(block.columns, block.rows))))
  {
    window = selectWindow(source.header(), options.crop, longitudes);
    block = blockFor(source, options, window, meaning.factor);
  }
  FileGrid file = placesOf(source.header(), window, block);
  limitNodes(file.values.columns, file.values.rows);
  AveragedValues read = readAveraged(source, window, block, markOf(options), execution);
  if (!(read.lowest <= read.highest))
  {
    throw std::runtime_error("it has no data: every cell that was read is marked as missing");
  }
  requireElevation(read.lowest, meaning.factor);
  requireElevation(read.highest, meaning.factor);
  if (block.columns * block.rows > 1)
  {
    notes.push_back("cells averaged over " + std::to_string(block.columns) + " x " + std::to_string(block.rows) +
      " of them, for --resample " + text(*options.resample));
  }
  file.values.elevation = std::move(read.values);
  for (double& z : file.values.elevation)
  {
    z *= meaning.factor;
  }
  if (file.axisAligned())
  {
    file.ascend();
  }
  return file;
}

double rmsSlope(const FileGrid& file)
{
  const ElevationGrid& z = file.values;
  const double along = std::hypot(file.columnStep.x, file.columnStep.y);
  const double across = std::hypot(file.rowStep.x, file.rowStep.y);
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t row = 0; row + 1 < z.rows; ++row)
  {
    for (std::size_t column = 0; column + 1 < z.columns; ++column)
    {
      const double a = (z.at(column + 1, row) - z.at(column, row)) / along;
      const double b = (z.at(column, row + 1) - z.at(column, row)) / across;
      if (!std::isnan(a + b))
      {
        squares += a * a + b * b;
        count += 1.0;
      }
    }
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

}
