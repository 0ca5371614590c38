#include "bathymetry/ModelGrid.h"

#include "bathymetry/CrsChoice.h"
#include "bathymetry/MeshSpacing.h"
#include "sim/Angles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Turn a grid whose rows run along y into one whose rows run along x.
void transpose(ModelGrid& grid)
{
  std::vector<double> turned(grid.values.size());
  for (std::size_t row = 0; row < grid.rows; ++row)
  {
    for (std::size_t column = 0; column < grid.columns; ++column)
    {
      turned[column * grid.rows + row] = grid.values[row * grid.columns + column];
    }
  }
  grid.values = std::move(turned);
  std::swap(grid.columns, grid.rows);
  std::swap(grid.columnStep, grid.rowStep);
}

class GridRaster final : public RasterSource
{
public:
  explicit GridRaster(ModelGrid&& grid)
    : Values(std::move(grid.values))
  {
    this->Header.driver = grid.format;
    this->Header.variable = grid.variable;
    this->Header.columns = grid.columns;
    this->Header.rows = grid.rows;
    this->Header.first = grid.first;
    this->Header.columnStep = grid.columnStep;
    this->Header.rowStep = grid.rowStep;
    this->Header.crs = grid.crs;
    this->Header.crsSource = grid.crsSource;
    this->Header.vertical = grid.vertical;
    this->Header.notes = std::move(grid.notes);
    this->Header.files = std::move(grid.files);
  }

  std::vector<double> read(const RasterWindow& window, double nodata) const override
  {
    NoDataMark missing;
    missing.add(nodata, false);
    std::vector<double> values;
    values.reserve(window.columns * window.rows);
    for (std::size_t row = window.firstRow; row < window.firstRow + window.rows; ++row)
    {
      for (std::size_t column = window.firstColumn; column < window.firstColumn + window.columns; ++column)
      {
        const double value = this->Values[row * this->Header.columns + column];
        values.push_back(missing(value) ? std::numeric_limits<double>::quiet_NaN() : value);
      }
    }
    return values;
  }

private:
  std::vector<double> Values;
};

}

void ModelGrid::layOut(const glm::dvec2& origin, double azimuth, double columnSpacing, double rowSpacing)
{
  // Exact where the grid is not turned, so that it keeps its nodes.
  const double turned = std::remainder(azimuth, 360.0);
  const double quarters = std::round(turned / 90.0);
  const bool straight = turned == 90.0 * quarters;
  const double cosine = straight ? std::round(std::cos(radians(turned))) : std::cos(radians(turned));
  const double sine = straight ? std::round(std::sin(radians(turned))) : std::sin(radians(turned));
  this->first = origin;
  this->columnStep = columnSpacing * glm::dvec2(cosine, sine);
  this->rowStep = rowSpacing * glm::dvec2(-sine, cosine);
}

bool ModelGrid::makeRegular()
{
  if (this->columns < 2 || this->rows < 2)
  {
    return false;
  }
  const auto at = [this](std::size_t column, std::size_t row) { return this->places[row * this->columns + column]; };
  const auto width = static_cast<double>(this->columns - 1);
  const auto height = static_cast<double>(this->rows - 1);
  const glm::dvec2 origin = at(0, 0);
  const glm::dvec2 along = (at(this->columns - 1, 0) - origin) / width;
  const glm::dvec2 across = (at(0, this->rows - 1) - origin) / height;
  constexpr double rounding = 0.02; // cells
  const double allowed = rounding * std::min(glm::length(along), glm::length(across));
  for (std::size_t row = 0; row < this->rows; ++row)
  {
    for (std::size_t column = 0; column < this->columns; ++column)
    {
      const glm::dvec2 even = origin + static_cast<double>(column) * along + static_cast<double>(row) * across;
      if (!(glm::length(at(column, row) - even) <= allowed))
      {
        return false;
      }
    }
  }
  this->first = origin;
  this->columnStep = along;
  this->rowStep = across;
  this->places.clear();
  return true;
}

Soundings soundingsOf(ModelGrid&& grid)
{
  Soundings soundings;
  soundings.driver = grid.format;
  soundings.variable = grid.variable;
  soundings.vertical = grid.vertical;
  soundings.crs = grid.crs;
  soundings.crsSource = grid.crsSource;
  soundings.notes = std::move(grid.notes);
  soundings.files = std::move(grid.files);
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(grid.places.size(), none);
  for (std::size_t i = 0; i < grid.places.size(); ++i)
  {
    const glm::dvec2& place = grid.places[i];
    if (std::isfinite(place.x + place.y))
    {
      number[i] = static_cast<std::uint32_t>(soundings.size());
      soundings.add(place.x, place.y, grid.values[i]);
    }
  }

  soundings.cellOffsets.push_back(0);
  for (std::size_t row = 0; row + 1 < grid.rows; ++row)
  {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column)
    {
      const std::size_t corner = row * grid.columns + column;
      const std::size_t corners[] = { corner, corner + 1, corner + grid.columns + 1, corner + grid.columns };
      if (std::any_of(std::begin(corners), std::end(corners), [&](std::size_t i) { return number[i] == none; }))
      {
        continue;
      }
      for (const std::size_t i : corners)
      {
        soundings.cellNodes.push_back(number[i]);
      }
      soundings.cellOffsets.push_back(soundings.cellNodes.size());
    }
  }
  const double spacing = fineSpacing(soundings, !grid.crs.empty() && isLongitudes("", grid.crs));
  if (!(spacing > 0.0))
  {
    throw std::runtime_error("its grid of " + std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
      " nodes has no cell with four nodes");
  }
  soundings.spacing = grid.spacing.value_or(spacing);
  return soundings;
}

std::unique_ptr<RasterSource> rasterOf(ModelGrid&& grid)
{
  if (grid.columnStep.x == 0.0 && grid.rowStep.y == 0.0)
  {
    transpose(grid);
  }
  return std::make_unique<GridRaster>(std::move(grid));
}

}
