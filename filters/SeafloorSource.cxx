#include "SeafloorSource.h"

#include "FieldData.h"
#include "GeoreferenceField.h"
#include "MeshSource.h"
#include "SeafloorField.h"
#include "XmlFile.h"
#include "bathymetry/FillGaps.h"
#include "bathymetry/SmoothGrid.h"
#include "bathymetry/Text.h"
#include "sim/BuiltinSeafloor.h"
#include "sim/SplineSeafloor.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

constexpr double NodesOfAForm = 500.0;

// 800 MB of elevations: more is a slip of the unit.
constexpr double MostNodes = 1e8;

std::string extentText(const Rectangle& box)
{
  return text(box.low.x) + "," + text(box.low.y) + "," + text(box.high.x) + "," + text(box.high.y);
}

/** Sample the box at nodes `spacing` apart from its south-west corner, as many as fit. */
ElevationGrid sample(
  const Seafloor& seafloor, const Rectangle& box, const glm::dvec2& spacing, const Execution& execution)
{
  // The node on the far edge must not be lost to rounding.
  const glm::dvec2 cells = glm::floor(box.size() / spacing * (1.0 + 1e-12));
  const glm::dvec2 nodes = cells + 1.0;
  if (nodes.x < 4.0 || nodes.y < 4.0 || nodes.x * nodes.y > MostNodes)
  {
    throw std::invalid_argument("resample to " + text(spacing.x) + " m gives a grid of " + text(nodes.x) + " x " +
      text(nodes.y) + " nodes; it must have at least 4 x 4 and at most " + text(MostNodes));
  }
  ElevationGrid grid;
  grid.columns = static_cast<std::size_t>(nodes.x);
  grid.rows = static_cast<std::size_t>(nodes.y);
  grid.origin = box.low;
  grid.spacing = spacing;
  grid.elevation.resize(grid.columns * grid.rows);
  execution.forRange(grid.rows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t row = begin; row < end; ++row)
      {
        for (std::size_t column = 0; column < grid.columns; ++column)
        {
          const glm::dvec2 p = glm::min(grid.node(column, row), box.high);
          grid.at(column, row) = seafloor.isHole(p) ? std::numeric_limits<double>::quiet_NaN() : seafloor.elevation(p);
        }
      }
    });
  return grid;
}

/** Extent, spacing and elevations of the grid into the report. */
void describe(Bathymetry& bathymetry, double waterLevel, const std::string& name)
{
  const ElevationGrid& grid = bathymetry.grid;
  SeafloorReport& report = bathymetry.report;
  report.path = name;
  report.kind = bathymetry.georeference.kind();
  report.crsName = bathymetry.georeference.crsName();
  report.columns = grid.columns;
  report.rows = grid.rows;
  report.spacing = grid.spacing;
  report.extent = grid.bounds();
  report.count(grid, waterLevel);
  if (report.noDataShare == 1.0)
  {
    throw std::runtime_error("'" + name + "' has no elevations: every node is without data");
  }
  if (report.waterShare == 0.0)
  {
    throw std::runtime_error("'" + name + "' has no water at water level " + text(waterLevel) +
      " m: its elevations are " + text(report.lowest) + " to " + text(report.highest) +
      " m; if these are depths, positive down, say so with --positive down");
  }
}

SeafloorScene loadForm(const std::string& spec, const SeafloorOptions& options, const Execution& execution)
{
  if (options.earth == EarthModel::Ellipsoid)
  {
    throw std::invalid_argument(
      "the ellipsoid needs a grid in longitude and latitude; '" + spec + "' is a built-in form");
  }
  if (options.positive != Positive::Auto || !options.crs.empty() || options.nodata || !options.variable.empty())
  {
    throw std::invalid_argument(
      "positive, crs, nodata and variable say how a file is to be understood; '" + spec + "' is a built-in form");
  }
  const std::shared_ptr<const Seafloor> seafloor = makeBuiltinSeafloor(spec);
  Rectangle box = seafloor->bounds();
  if (options.crop)
  {
    const auto& crop = *options.crop;
    const Rectangle whole = box;
    box.low = glm::max(box.low, glm::dvec2(crop[0], crop[1]));
    box.high = glm::min(box.high, glm::dvec2(crop[2], crop[3]));
    if (!(box.low.x < box.high.x && box.low.y < box.high.y))
    {
      throw std::invalid_argument("crop lies outside of '" + spec + "', which spans " + extentText(whole));
    }
  }
  const glm::dvec2 size = box.size();
  const glm::dvec2 cells =
    glm::max(glm::round(size * (NodesOfAForm - 1.0) / std::max(size.x, size.y)), glm::dvec2(3.0));

  SeafloorScene scene;
  Bathymetry& bathymetry = scene.bathymetry;
  bathymetry.grid = sample(*seafloor, box, options.resample ? glm::dvec2(*options.resample) : size / cells, execution);
  smoothGrid(bathymetry.grid, options.smooth, execution);
  if (!options.resample && options.smooth == 0.0)
  {
    scene.form = spec;
  }
  SeafloorReport& report = bathymetry.report;
  report.driver = "built-in form";
  report.units = "m";
  report.unitsSource = "built in";
  report.sign = "elevation, up";
  report.signSource = "built in";
  report.fileColumns = report.readColumns = bathymetry.grid.columns;
  report.fileRows = report.readRows = bathymetry.grid.rows;
  report.fileExtent = seafloor->bounds();
  report.fileSpacing = bathymetry.grid.spacing;
  describe(bathymetry, options.waterLevel, spec);
  return scene;
}

/** Cut the grid to the nodes in a box of file coordinates. */
void cropGrid(Bathymetry& bathymetry, const std::array<double, 4>& crop, const std::string& name)
{
  const ElevationGrid& grid = bathymetry.grid;
  const glm::dvec2 corner = bathymetry.georeference.fromFile(glm::dvec2(crop[0], crop[1]));
  const glm::dvec2 opposite = bathymetry.georeference.fromFile(glm::dvec2(crop[2], crop[3]));
  const glm::dvec2 last = glm::dvec2(static_cast<double>(grid.columns), static_cast<double>(grid.rows)) - 1.0;
  const glm::dvec2 from =
    glm::max(glm::ceil((glm::min(corner, opposite) - grid.origin) / grid.spacing), glm::dvec2(0.0));
  const glm::dvec2 to = glm::min(glm::floor((glm::max(corner, opposite) - grid.origin) / grid.spacing), last);
  if (!(to.x - from.x >= 3.0 && to.y - from.y >= 3.0))
  {
    throw std::runtime_error("'" + name + "': crop " + extentText({ { crop[0], crop[1] }, { crop[2], crop[3] } }) +
      " leaves fewer than 4 x 4 nodes");
  }
  ElevationGrid cut;
  const auto firstColumn = static_cast<std::size_t>(from.x);
  const auto firstRow = static_cast<std::size_t>(from.y);
  cut.columns = static_cast<std::size_t>(to.x - from.x) + 1;
  cut.rows = static_cast<std::size_t>(to.y - from.y) + 1;
  cut.origin = grid.node(firstColumn, firstRow);
  cut.spacing = grid.spacing;
  cut.elevation.reserve(cut.columns * cut.rows);
  for (std::size_t row = 0; row < cut.rows; ++row)
  {
    const auto begin =
      grid.elevation.begin() + static_cast<std::ptrdiff_t>((firstRow + row) * grid.columns + firstColumn);
    cut.elevation.insert(cut.elevation.end(), begin, begin + static_cast<std::ptrdiff_t>(cut.columns));
  }
  bathymetry.grid = std::move(cut);
}

SeafloorScene loadImage(const std::string& path, const SeafloorOptions& options, const Execution& execution)
{
  vtkNew<vtkXMLImageDataReader> reader;
  try
  {
    readXmlFile(reader, path, "a VTK image (.vti)");
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error("cannot read '" + path + "': " + error.what());
  }
  vtkImageData* image = reader->GetOutput();

  SeafloorScene scene;
  Bathymetry& bathymetry = scene.bathymetry;
  try
  {
    bathymetry.grid = gridOfImage(image, image->GetPointData()->GetArray("Elevation"));
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("'" + path + "': " + error.what());
  }
  const ElevationGrid asRead = bathymetry.grid;
  const Georeference own = georeferenceOf(image);
  bathymetry.georeference = options.crs.empty()
    ? own
    : Georeference(options.crs == "local" ? "" : crsToWkt(options.crs), { own.originLongitude(), own.originLatitude() },
        { own.originX(), own.originY() });
  if (options.earth == EarthModel::Ellipsoid && !own.mercator())
  {
    throw std::runtime_error(
      "'" + path + "' was made on the plane; read the file that it was made from on the ellipsoid");
  }
  if (own.mercator())
  {
    bathymetry.georeference = own;
    const bool whole = !options.crop && !options.nodata && !options.resample && options.smooth == 0.0;
    bathymetry.geographic = whole && options.positive != Positive::Down ? geographicGridOf(image) : std::nullopt;
  }
  SeafloorReport& report = bathymetry.report;
  report.driver = "VTK image";
  report.variable = "Elevation";
  report.crsSource = options.crs.empty() ? (own.crs().empty() ? "" : "file") : "as asked";
  report.units = "m";
  report.unitsSource = "the format";
  report.sign = options.positive == Positive::Down ? "depth, down" : "elevation, up";
  report.signSource = options.positive == Positive::Auto ? "the format" : "as asked";
  report.fileColumns = asRead.columns;
  report.fileRows = asRead.rows;
  report.fileExtent = { own.toFile(asRead.bounds().low), own.toFile(asRead.bounds().high) };
  report.fileSpacing = asRead.spacing;

  ElevationGrid& grid = bathymetry.grid;
  if (options.crop)
  {
    cropGrid(bathymetry, *options.crop, path);
  }
  report.readColumns = grid.columns;
  report.readRows = grid.rows;
  for (double& z : grid.elevation)
  {
    z = options.nodata && z == *options.nodata ? std::numeric_limits<double>::quiet_NaN() : z;
    z = options.positive == Positive::Down ? -z : z;
    report.noDataRead += std::isnan(z) ? 1 : 0;
  }
  report.filled = fillGaps(grid, grid.spacing, options.maxGap).filled;
  if (options.resample)
  {
    grid = sample(SplineSeafloor(grid), grid.bounds(), glm::dvec2(*options.resample), execution);
    report.resampled = true;
  }
  smoothGrid(grid, options.smooth, execution);
  if (!options.resample && options.smooth == 0.0)
  {
    scene.form = fieldString(image, "SeafloorForm").value_or("");
  }
  describe(bathymetry, options.waterLevel, path);
  return scene;
}

bool endsWith(const std::string& name, const std::string& ending)
{
  return name.size() >= ending.size() && plain(name.substr(name.size() - ending.size())) == ending;
}

}

SeafloorScene loadSeafloor(const std::string& name, const SeafloorOptions& options, const Execution& execution)
{
  options.validate();
  std::error_code none;
  if (isBuiltinSeafloor(name) || (!std::filesystem::exists(name, none) && resemblesBuiltinSeafloor(name)))
  {
    return loadForm(name, options, execution);
  }
  if (endsWith(name, ".vti"))
  {
    return loadImage(name, options, execution);
  }
  if (endsWith(name, ".vts") || endsWith(name, ".vtu"))
  {
    return { loadMesh(name, options, execution), {} };
  }
  return { readSeafloor(name, options, execution), {} };
}

}
