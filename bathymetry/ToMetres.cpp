#include "bathymetry/ToMetres.h"

#include "bathymetry/GridLayout.h"
#include "bathymetry/InscribedRectangle.h"
#include "bathymetry/Text.h"
#include "sim/EllipsoidMercator.h"
#include "sim/SplineSeafloor.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Points of the outline a side: the chord between two stays within a thousandth of a cell of a mapped edge.
constexpr std::size_t OutlinePoints = 256;

glm::dvec2 fileToPoint(const Georeference& georeference, const FileGrid& file, const glm::dvec2& index)
{
  return georeference.fromFile(file.toFile(index));
}

std::vector<glm::dvec2> outline(const FileGrid& file, const Georeference& georeference)
{
  const glm::dvec2 last = file.lastIndex();
  const glm::dvec2 corners[] = { { 0.0, 0.0 }, { last.x, 0.0 }, last, { 0.0, last.y }, { 0.0, 0.0 } };
  std::vector<glm::dvec2> points;
  points.reserve(4 * OutlinePoints);
  for (std::size_t side = 0; side < 4; ++side)
  {
    for (std::size_t i = 0; i < OutlinePoints; ++i)
    {
      const double t = static_cast<double>(i) / static_cast<double>(OutlinePoints);
      points.push_back(fileToPoint(georeference, file, corners[side] + t * (corners[side + 1] - corners[side])));
    }
  }
  return points;
}

Rectangle boxAround(const std::vector<glm::dvec2>& points)
{
  Rectangle box{ points.front(), points.front() };
  for (const glm::dvec2& p : points)
  {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

// Places of the nodes of one row, in nodes of the file. The map is computed at every few nodes and interpolated by
// cubics between them: over knots this far apart it departs from a cubic by less than a micrometre.
class RowPlaces
{
public:
  RowPlaces(const ElevationGrid& grid, const FileGrid& file, const Georeference& georeference)
    : Grid(grid)
    , File(file)
    , Place(georeference)
    , Geographic(georeference.kind() == GeoreferenceKind::Geographic)
    , Middle(file.toFile(0.5 * file.lastIndex()).x)
    , Stride(static_cast<std::size_t>(std::clamp(KnotDistance / grid.spacing.x, 1.0, 64.0)))
    , Knots(grid.columns / this->Stride + 4)
  {
  }

  void moveTo(std::size_t row)
  {
    for (std::size_t k = 0; k < this->Knots.size(); ++k)
    {
      const double column = (static_cast<double>(k) - 1.0) * static_cast<double>(this->Stride);
      const glm::dvec2 offset = this->Grid.spacing * glm::dvec2(column, static_cast<double>(row));
      this->Knots[k] = this->place(this->Grid.origin + offset);
    }
  }

  glm::dvec2 operator()(std::size_t column) const
  {
    const glm::dvec2* p = &this->Knots[column / this->Stride];
    const double t = static_cast<double>(column % this->Stride) / static_cast<double>(this->Stride);
    const double before = t + 1.0;
    const double after = t - 1.0;
    const double last = t - 2.0;
    return -t * after * last / 6.0 * p[0] + before * after * last / 2.0 * p[1] - before * t * last / 2.0 * p[2] +
      before * t * after / 6.0 * p[3];
  }

private:
  static constexpr double KnotDistance = 2000.0; // m

  glm::dvec2 place(const glm::dvec2& point) const
  {
    glm::dvec2 coordinates = this->Place.toFile(point);
    if (this->Geographic)
    {
      coordinates.x = this->Middle + std::remainder(coordinates.x - this->Middle, 360.0);
    }
    return this->File.toIndex(coordinates);
  }

  const ElevationGrid& Grid;
  const FileGrid& File;
  const Georeference& Place;
  bool Geographic;
  double Middle;
  std::size_t Stride;
  std::vector<glm::dvec2> Knots; // the first lies one stride before the row
};

void sample(ElevationGrid& grid, const FileGrid& file, const Georeference& georeference, const Execution& execution)
{
  const SplineSeafloor spline(file.values);
  const glm::dvec2 last = file.lastIndex();
  // An upright grid lies inside of the file; a rotated file lies inside of the grid.
  constexpr double rounding = 1e-6; // nodes
  const bool reachesOut = !file.axisAligned();
  const auto isOutside = [&last](const glm::dvec2& index)
  { return index.x < -rounding || index.y < -rounding || index.x > last.x + rounding || index.y > last.y + rounding; };
  execution.forRange(grid.rows,
    [&](std::size_t begin, std::size_t end)
    {
      RowPlaces places(grid, file, georeference);
      BedSample bed;
      for (std::size_t row = begin; row < end; ++row)
      {
        places.moveTo(row);
        for (std::size_t column = 0; column < grid.columns; ++column)
        {
          glm::dvec2 index = places(column);
          const bool outside = reachesOut && isOutside(index);
          index = glm::dvec2(std::clamp(index.x, 0.0, last.x), std::clamp(index.y, 0.0, last.y));
          if (outside || spline.isHole(index))
          {
            grid.at(column, row) = std::numeric_limits<double>::quiet_NaN();
            continue;
          }
          spline.evaluate(index, 0, bed);
          grid.at(column, row) = bed.elevation;
        }
      }
    });
}

}

double largestScaleError(const Rectangle& box, const Georeference& georeference)
{
  constexpr int steps = 16;
  double largest = 0.0;
  for (int j = 0; j <= steps; ++j)
  {
    for (int i = 0; i <= steps; ++i)
    {
      const glm::dvec2 p = box.low + box.size() * (glm::dvec2(i, j) / static_cast<double>(steps));
      largest = std::max(largest, std::abs(georeference.scale(p) - 1.0));
    }
  }
  return largest;
}

Georeference placeGrid(FileGrid& file, const std::string& crs, EarthModel earth)
{
  const Rectangle extent = file.extent();
  const glm::dvec2 middle = 0.5 * (extent.low + extent.high);
  const double turned = std::remainder(middle.x, 360.0);
  Georeference georeference(crs, glm::dvec2(turned, std::clamp(middle.y, -90.0, 90.0)), extent.low);
  const bool ellipsoid = earth == EarthModel::Ellipsoid;
  if (ellipsoid && (georeference.kind() != GeoreferenceKind::Geographic || !file.axisAligned()))
  {
    throw std::runtime_error(std::string("on the ellipsoid a grid must be in longitude and latitude, north up; ") +
      "trace this one on the plane (earth plane)");
  }
  if (georeference.kind() != GeoreferenceKind::Geographic)
  {
    return georeference;
  }
  const std::string coordinates = "its coordinates, " + text(extent.low.x, 9) + " to " + text(extent.high.x, 9) +
    " and " + text(extent.low.y, 9) + " to " + text(extent.high.y, 9) + ",";
  if (std::abs(extent.low.y) > 90.0 || std::abs(extent.high.y) > 90.0 || extent.low.x < -360.0 || extent.high.x > 540.0)
  {
    throw std::runtime_error(coordinates + " are no longitude and latitude, as CRS '" + georeference.crsName() +
      "' would have them; say --crs");
  }
  file.first.x += turned - middle.x;
  if (ellipsoid)
  {
    constexpr double largest = EllipsoidMercator::LargestLatitude;
    if (extent.low.y < -largest || extent.high.y > largest || extent.size().x > 360.0)
    {
      throw std::runtime_error(coordinates + " reach beyond latitude " + text(largest) +
        ", or around the Earth, on the ellipsoid; use --crop");
    }
    return Georeference::onEllipsoid(crs, turned, middle.y);
  }
  if (extent.size().x > WidestScene || extent.size().y > WidestScene)
  {
    throw std::runtime_error(coordinates + " span more than " + text(WidestScene) +
      " degrees, too much for one plane map; use --crop, or --earth ellipsoid");
  }
  return georeference;
}

glm::dvec2 cellSize(const FileGrid& file, const Georeference& georeference)
{
  const glm::dvec2 middle = 0.5 * file.lastIndex();
  const glm::dvec2 column(0.5, 0.0);
  const glm::dvec2 row(0.0, 0.5);
  const glm::dvec2 along =
    fileToPoint(georeference, file, middle + column) - fileToPoint(georeference, file, middle - column);
  const glm::dvec2 across =
    fileToPoint(georeference, file, middle + row) - fileToPoint(georeference, file, middle - row);
  return { std::hypot(along.x, along.y), std::hypot(across.x, across.y) };
}

MetricGrid toMercator(const FileGrid& file, const Georeference& georeference, const Execution& execution)
{
  const EllipsoidMercator& map = *georeference.mercator();
  MetricGrid result;
  result.georeference = georeference;
  result.resampled = true;
  result.geographic = file.values;
  result.geographic->origin = file.first;
  result.geographic->spacing = { file.columnStep.x, file.rowStep.y };
  const Rectangle extent = result.geographic->bounds();
  ElevationGrid& grid = result.grid;
  grid.columns = file.values.columns;
  grid.rows = file.values.rows;
  grid.origin = map.toMap(extent.low);
  grid.spacing = (map.toMap(extent.high) - grid.origin) /
    glm::dvec2(static_cast<double>(grid.columns - 1), static_cast<double>(grid.rows - 1));
  grid.elevation.resize(grid.columns * grid.rows);
  const SplineSeafloor spline(*result.geographic);
  execution.forRange(grid.rows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t row = begin; row < end; ++row)
      {
        const double latitude = std::clamp(map.toLonLat(grid.node(0, row)).y, extent.low.y, extent.high.y);
        for (std::size_t column = 0; column < grid.columns; ++column)
        {
          const glm::dvec2 node(result.geographic->node(column, 0).x, latitude);
          grid.at(column, row) =
            spline.isHole(node) ? std::numeric_limits<double>::quiet_NaN() : spline.elevation(node);
        }
      }
    });
  return result;
}

MetricGrid toMetres(const FileGrid& file, const Georeference& georeference, const std::optional<double>& resample,
  const Execution& execution)
{
  MetricGrid result;
  result.georeference = georeference;
  const bool geographic = georeference.kind() == GeoreferenceKind::Geographic;
  const bool straight = !geographic && file.axisAligned();
  if (straight && !resample)
  {
    const double unit = georeference.metresPerUnit();
    result.grid = file.values;
    result.grid.origin = glm::dvec2(0.0);
    result.grid.spacing = glm::dvec2(file.columnStep.x, file.rowStep.y) * unit;
    return result;
  }

  // The axis of the result that the rows of the file lie nearest to takes their spacing.
  glm::dvec2 spacing = cellSize(file, georeference);
  const glm::dvec2 middle = 0.5 * file.lastIndex();
  const glm::dvec2 along =
    fileToPoint(georeference, file, middle + glm::dvec2(0.5, 0.0)) - fileToPoint(georeference, file, middle);
  if (std::abs(along.y) > std::abs(along.x))
  {
    std::swap(spacing.x, spacing.y);
  }
  if (resample)
  {
    spacing = glm::dvec2(*resample);
  }
  const std::vector<glm::dvec2> edge = outline(file, georeference);
  const Rectangle box = file.axisAligned() ? inscribedRectangle(edge) : boxAround(edge);
  result.grid = layOutGrid(box, spacing, !straight);
  result.resampled = true;
  sample(result.grid, file, georeference, execution);
  if (geographic)
  {
    result.scaleError = largestScaleError(result.grid.bounds(), georeference);
  }
  else
  {
    const glm::dvec2 origin = georeference.toFile(result.grid.origin);
    result.georeference = Georeference(georeference.crs(), glm::dvec2(0.0), origin);
    result.grid.origin = glm::dvec2(0.0);
  }
  return result;
}

}
