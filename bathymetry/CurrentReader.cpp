#include "bathymetry/CurrentReader.h"

#include "bathymetry/FileGrid.h"
#include "bathymetry/QuietGdal.h"
#include "bathymetry/RasterSource.h"
#include "bathymetry/Text.h"
#include "sim/Angles.h"
#include "sim/SplineSeafloor.h"

#include <ogr_spatialref.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace swellray
{

namespace
{

// No current is faster, m/s: what is, marks missing data or has another unit.
constexpr double FastestCurrent = 50.0;

constexpr double MetresPerDegree = 111195.0;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

const std::array<std::pair<const char*, const char*>, 8> ComponentNames{ {
  { "eastward_sea_water_velocity", "northward_sea_water_velocity" },
  { "sea_water_x_velocity", "sea_water_y_velocity" },
  { "u", "v" },
  { "U", "V" },
  { "uo", "vo" },
  { "water_u", "water_v" },
  { "ubar", "vbar" },
  { "1", "2" },
} };

using Sources = std::array<std::unique_ptr<RasterSource>, 2>;

Sources openComponents(const std::string& path)
{
  if (!std::filesystem::exists(path))
  {
    throw std::runtime_error("no such file");
  }
  std::string reason;
  for (const auto& [u, v] : ComponentNames)
  {
    try
    {
      return { openRaster(path, u), openRaster(path, v) };
    }
    catch (const std::runtime_error& error)
    {
      reason = reason.empty() ? error.what() : reason;
    }
  }
  throw std::runtime_error(
    reason + "; a current has two variables or bands, named u and v or by their CF standard names");
}

double metresPerSecond(const std::string& unit)
{
  static const std::map<std::string, double> known{ { "", 1.0 }, { "m s-1", 1.0 }, { "m/s", 1.0 }, { "ms-1", 1.0 },
    { "m s**-1", 1.0 }, { "m s^-1", 1.0 }, { "meter second-1", 1.0 }, { "meters/second", 1.0 }, { "cm s-1", 0.01 },
    { "cm/s", 0.01 }, { "knots", 1852.0 / 3600.0 }, { "knot", 1852.0 / 3600.0 }, { "kn", 1852.0 / 3600.0 } };
  const auto found = known.find(plain(unit));
  if (found == known.end())
  {
    throw std::runtime_error("its unit '" + unit + "' is not understood: m/s, cm/s or knots");
  }
  return found->second;
}

FileGrid readComponent(const RasterSource& source, bool longitudes)
{
  const RasterHeader& header = source.header();
  const RasterWindow window = selectWindow(header, {}, longitudes);
  limitNodes(window.columns, window.rows);
  FileGrid file;
  file.values.columns = window.columns;
  file.values.rows = window.rows;
  file.values.elevation = source.read(window, NotANumber);
  file.first = header.node(static_cast<double>(window.firstColumn), static_cast<double>(window.firstRow));
  file.columnStep = header.columnStep;
  file.rowStep = header.rowStep;
  const double factor = metresPerSecond(header.vertical.units);
  for (double& value : file.values.elevation)
  {
    value *= factor;
    if (std::abs(value) > FastestCurrent)
    {
      throw std::runtime_error("it has a current of " + text(value) +
        " m/s, faster than any: is it a mark for missing "
        "data, or another unit?");
    }
  }
  if (!file.axisAligned())
  {
    throw std::runtime_error("its grid is rotated; bring it north up first (gdalwarp)");
  }
  file.ascend();
  return file;
}

/** Places of the scene in the coordinates of a file of another CRS, and how its axes lie there. */
class OtherPlace
{
public:
  /** Both must outlive this. @throws std::runtime_error where no way leads from one to the other */
  OtherPlace(const Georeference& own, const Georeference& scene, double middleLongitude)
    : Own(own)
    , Scene(scene)
    , Middle(middleLongitude)
  {
    if (own.kind() == GeoreferenceKind::Geographic)
    {
      return;
    }
    const QuietGdal quiet;
    OGRSpatialReference from;
    OGRSpatialReference to;
    from.importFromWkt(scene.crs().c_str());
    to.importFromWkt(own.crs().c_str());
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    this->Transformation.reset(OGRCreateCoordinateTransformation(&from, &to));
    if (!this->Transformation)
    {
      throw std::runtime_error("no way from CRS '" + scene.crsName() + "' to its own, '" + own.crsName() +
        "': " + QuietGdal::lastError("no reason given"));
    }
  }

  /** A place in the file's coordinates; NaN where it has none. */
  glm::dvec2 file(const glm::dvec2& point) const
  {
    if (!this->Transformation)
    {
      glm::dvec2 place = this->Scene.toLonLat(point).value_or(glm::dvec2(NotANumber));
      place.x = this->Middle + std::remainder(place.x - this->Middle, 360.0);
      return place;
    }
    glm::dvec2 place = this->Scene.toFile(point);
    const QuietGdal quiet;
    const std::lock_guard<std::mutex> lock(this->Guard); // PROJ's transformations are for one thread at a time
    return this->Transformation->Transform(1, &place.x, &place.y) ? place : glm::dvec2(NotANumber);
  }

  /** Turn from the file's axes to those of the scene, rad: true north lies the convergence anticlockwise from y. */
  double turn(const glm::dvec2& point, const glm::dvec2& file) const
  {
    const double own = this->Transformation ? this->Own.convergence(this->Own.fromFile(file)) : 0.0;
    return radians(this->Scene.convergence(point) - own);
  }

private:
  const Georeference& Own;
  const Georeference& Scene;
  double Middle;
  std::unique_ptr<OGRCoordinateTransformation> Transformation; // none: to longitude and latitude
  mutable std::mutex Guard;
};

/** Nodes of a grid over the scene, about as far apart as those of a file of another CRS. */
ElevationGrid layOver(const Rectangle& bounds, const FileGrid& file, const Georeference& own)
{
  glm::dvec2 cell(file.columnStep.x, file.rowStep.y);
  if (own.kind() == GeoreferenceKind::Geographic)
  {
    const double latitude = file.first.y + 0.5 * file.lastIndex().y * file.rowStep.y;
    cell *= MetresPerDegree * glm::dvec2(std::max(0.01, std::cos(radians(latitude))), 1.0);
  }
  else
  {
    cell *= own.metresPerUnit();
  }
  const glm::dvec2 cells = glm::max(glm::ceil(bounds.size() / cell), glm::dvec2(3.0));
  if (cells.x * cells.y > static_cast<double>(MostNodes))
  {
    throw std::runtime_error("it is too fine for a scene of this size; make it coarser, or crop the seafloor");
  }
  ElevationGrid grid;
  grid.columns = static_cast<std::size_t>(cells.x) + 1;
  grid.rows = static_cast<std::size_t>(cells.y) + 1;
  grid.origin = bounds.low;
  grid.spacing = bounds.size() / cells;
  grid.elevation.resize(grid.columns * grid.rows);
  return grid;
}

void resample(const FileGrid& alongX, const FileGrid& alongY, const Georeference& own, const Georeference& scene,
  const Rectangle& bounds, CurrentGrids& result, const Execution& execution)
{
  const SplineSeafloor u(alongX.values);
  const SplineSeafloor v(alongY.values);
  result.u = layOver(bounds, alongX, own);
  result.v = result.u;
  const glm::dvec2 last = alongX.lastIndex();
  const OtherPlace other(own, scene, alongX.first.x + 0.5 * last.x * alongX.columnStep.x);
  // Rows are shared out to threads, in which nothing may be thrown.
  std::vector<unsigned char> outside(result.u.rows, 0);
  execution.forRange(result.u.rows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t row = begin; row < end; ++row)
      {
        for (std::size_t column = 0; column < result.u.columns; ++column)
        {
          const glm::dvec2 point = result.u.node(column, row);
          const glm::dvec2 place = other.file(point);
          const glm::dvec2 index = alongX.toIndex(place);
          constexpr double rounding = 1e-6; // cells
          if (!(index.x > -rounding && index.y > -rounding && index.x < last.x + rounding &&
                index.y < last.y + rounding))
          {
            outside[row] = 1;
            continue;
          }
          const glm::dvec2 velocity(u.elevation(index), v.elevation(index));
          const double turn = other.turn(point, place);
          result.u.at(column, row) = velocity.x * std::cos(turn) - velocity.y * std::sin(turn);
          result.v.at(column, row) = velocity.x * std::sin(turn) + velocity.y * std::cos(turn);
        }
      }
    });
  if (std::any_of(outside.begin(), outside.end(), [](unsigned char is) { return is != 0; }))
  {
    const Rectangle extent = alongX.extent();
    const bool degrees = own.kind() == GeoreferenceKind::Geographic;
    throw std::runtime_error(std::string("it covers ") + (degrees ? "longitudes " : "x ") + text(extent.low.x) +
      " to " + text(extent.high.x) + " and " + (degrees ? "latitudes " : "y ") + text(extent.low.y) + " to " +
      text(extent.high.y) + ", not all of the scene (outside it is not taken as 0); crop the seafloor");
  }
}

bool isSamePlane(const Georeference& own, const Georeference& scene)
{
  return own.crs().empty() || scene.crs().empty() || own.crs() == scene.crs() || own.crsName() == scene.crsName();
}

CurrentGrids read(
  const std::string& path, const Georeference& scene, const Rectangle& bounds, const Execution& execution)
{
  const Sources sources = openComponents(path);
  const RasterHeader& header = sources[0]->header();
  const Georeference own(header.crs.empty() ? scene.crs() : header.crs, glm::dvec2(0.0), glm::dvec2(0.0));
  const bool geographic = own.kind() == GeoreferenceKind::Geographic;
  FileGrid u = readComponent(*sources[0], geographic);
  FileGrid v = readComponent(*sources[1], geographic);
  if (u.values.columns != v.values.columns || u.values.rows != v.values.rows || u.first != v.first ||
    u.columnStep != v.columnStep || u.rowStep != v.rowStep)
  {
    throw std::runtime_error("its components lie on different nodes; bring them to the same (staggered grids: "
                             "average them)");
  }
  CurrentGrids result;
  const auto missing =
    std::count_if(u.values.elevation.begin(), u.values.elevation.end(), [](double value) { return std::isnan(value); });
  if (missing == static_cast<std::ptrdiff_t>(u.values.elevation.size()))
  {
    throw std::runtime_error("it has no data: every node is marked as missing");
  }
  if (missing > 0)
  {
    result.notes.push_back(std::to_string(missing) + " of " + std::to_string(u.values.elevation.size()) +
      " nodes of the current have no data: there it continues smoothly from those around");
  }
  const bool other = geographic || scene.kind() == GeoreferenceKind::Geographic || !isSamePlane(own, scene);
  if (other && (scene.crs().empty() || own.crs().empty()))
  {
    throw std::runtime_error(geographic
        ? "it is in longitude and latitude, and the seafloor does not say where on Earth it lies"
        : "it does not say where on Earth it lies, and the seafloor is in longitude and latitude; give it a CRS "
          "(gdal_edit)");
  }
  if (other)
  {
    resample(u, v, own, scene, bounds, result, execution);
    return result;
  }
  for (FileGrid* file : { &u, &v })
  {
    ElevationGrid& grid = file == &u ? result.u : result.v;
    grid = std::move(file->values);
    grid.origin = scene.fromFile(file->first);
    grid.spacing = glm::dvec2(file->columnStep.x, file->rowStep.y) * scene.metresPerUnit();
  }
  return result;
}

}

CurrentGrids readCurrent(
  const std::string& path, const Georeference& scene, const Rectangle& bounds, const Execution& execution)
{
  try
  {
    return read(path, scene, bounds, execution);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(oneLine("current '" + path + "': " + error.what()));
  }
}

}
