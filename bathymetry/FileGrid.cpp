#include "bathymetry/FileGrid.h"

#include "bathymetry/Text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace swellray
{

namespace
{

glm::dvec2 solve(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& right)
{
  const double determinant = a.x * b.y - b.x * a.y;
  return { (right.x * b.y - b.x * right.y) / determinant, (a.x * right.y - right.x * a.y) / determinant };
}

Rectangle boxOf(const glm::dvec2& first, const glm::dvec2& along, const glm::dvec2& across)
{
  Rectangle box{ first, first };
  for (const glm::dvec2& corner : { first + along, first + across, first + along + across })
  {
    box.low = glm::dvec2(std::min(box.low.x, corner.x), std::min(box.low.y, corner.y));
    box.high = glm::dvec2(std::max(box.high.x, corner.x), std::max(box.high.y, corner.y));
  }
  return box;
}

std::string words(const Rectangle& box)
{
  return text(box.low.x, 9) + "," + text(box.low.y, 9) + "," + text(box.high.x, 9) + "," + text(box.high.y, 9);
}

}

glm::dvec2 FileGrid::toFile(const glm::dvec2& index) const
{
  return this->first + index.x * this->columnStep + index.y * this->rowStep;
}

glm::dvec2 FileGrid::toIndex(const glm::dvec2& file) const
{
  return solve(this->columnStep, this->rowStep, file - this->first);
}

glm::dvec2 FileGrid::lastIndex() const
{
  return { static_cast<double>(this->values.columns - 1), static_cast<double>(this->values.rows - 1) };
}

bool FileGrid::axisAligned() const
{
  // A shift of a thousandth of a cell over the whole grid is rounding in the file.
  constexpr double rounding = 1e-3;
  const glm::dvec2 last = this->lastIndex();
  return std::abs(this->columnStep.y) * last.x < rounding * std::abs(this->rowStep.y) &&
    std::abs(this->rowStep.x) * last.y < rounding * std::abs(this->columnStep.x);
}

void FileGrid::ascend()
{
  const std::size_t columns = this->values.columns;
  const auto width = static_cast<std::ptrdiff_t>(columns);
  std::vector<double>& z = this->values.elevation;
  if (this->columnStep.x < 0.0)
  {
    for (auto row = z.begin(); row != z.end(); row += width)
    {
      std::reverse(row, row + width);
    }
    this->first += this->lastIndex().x * this->columnStep;
    this->columnStep = -this->columnStep;
  }
  if (this->rowStep.y < 0.0)
  {
    for (std::size_t low = 0, high = this->values.rows - 1; low < high; ++low, --high)
    {
      const auto lower = z.begin() + static_cast<std::ptrdiff_t>(low * columns);
      std::swap_ranges(lower, lower + width, z.begin() + static_cast<std::ptrdiff_t>(high * columns));
    }
    this->first += this->lastIndex().y * this->rowStep;
    this->rowStep = -this->rowStep;
  }
  this->columnStep.y = 0.0;
  this->rowStep.x = 0.0;
}

Rectangle FileGrid::extent() const
{
  const glm::dvec2 last = this->lastIndex();
  return boxOf(this->first, last.x * this->columnStep, last.y * this->rowStep);
}

RasterWindow selectWindow(const RasterHeader& header, const std::optional<std::array<double, 4>>& crop, bool longitudes)
{
  if (header.columns < FewestNodes || header.rows < FewestNodes)
  {
    throw std::runtime_error("it has " + std::to_string(header.columns) + " x " + std::to_string(header.rows) +
      " cells; a seafloor needs at least 4 x 4");
  }
  const double determinant = header.columnStep.x * header.rowStep.y - header.rowStep.x * header.columnStep.y;
  if (!std::isfinite(header.first.x + header.first.y) || !std::isfinite(determinant) || determinant == 0.0)
  {
    throw std::runtime_error(
      "its cells have no size (spacing " + text(header.columnStep.x) + ", " + text(header.rowStep.y) + ")");
  }

  RasterWindow window{ 0, 0, header.columns, header.rows };
  if (crop)
  {
    const auto last = glm::dvec2(static_cast<double>(header.columns - 1), static_cast<double>(header.rows - 1));
    const Rectangle box = boxOf(header.first, last.x * header.columnStep, last.y * header.rowStep);
    Rectangle wanted{ { (*crop)[0], (*crop)[1] }, { (*crop)[2], (*crop)[3] } };
    if (longitudes)
    {
      const double turn = 360.0 * std::round(0.5 * (box.low.x + box.high.x - wanted.low.x - wanted.high.x) / 360.0);
      wanted.low.x += turn;
      wanted.high.x += turn;
    }
    // Corners of the box in nodes; the window is what lies between them.
    glm::dvec2 low(last);
    glm::dvec2 high(0.0);
    for (const glm::dvec2& corner :
      { wanted.low, wanted.high, glm::dvec2(wanted.low.x, wanted.high.y), glm::dvec2(wanted.high.x, wanted.low.y) })
    {
      const glm::dvec2 index = solve(header.columnStep, header.rowStep, corner - header.first);
      low = glm::dvec2(std::min(low.x, index.x), std::min(low.y, index.y));
      high = glm::dvec2(std::max(high.x, index.x), std::max(high.y, index.y));
    }
    constexpr double rounding = 1e-6; // nodes
    low = glm::dvec2(std::max(0.0, std::ceil(low.x - rounding)), std::max(0.0, std::ceil(low.y - rounding)));
    high = glm::dvec2(std::min(last.x, std::floor(high.x + rounding)), std::min(last.y, std::floor(high.y + rounding)));
    if (high.x - low.x < FewestNodes - 1.0 || high.y - low.y < FewestNodes - 1.0)
    {
      throw std::runtime_error("crop leaves fewer than 4 x 4 cells of it; its extent is " + words(box));
    }
    window.firstColumn = static_cast<std::size_t>(low.x);
    window.firstRow = static_cast<std::size_t>(low.y);
    window.columns = static_cast<std::size_t>(high.x - low.x) + 1;
    window.rows = static_cast<std::size_t>(high.y - low.y) + 1;
  }
  return window;
}

void limitNodes(std::size_t columns, std::size_t rows)
{
  if (columns > MostNodes / rows)
  {
    throw std::runtime_error("it has " + std::to_string(columns) + " x " + std::to_string(rows) +
      " cells, above the limit of " + std::to_string(MostNodes / 1000000) +
      " million; read a part of it with --crop, or coarser with --resample");
  }
}

}
