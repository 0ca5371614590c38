#include "Graticule.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace swellray::drawing
{

namespace
{

// Lines of one kind across a map, about.
constexpr double LinesAcross = 5.0;

// Places on each side of the map between which meridians and parallels are taken as straight.
constexpr int Places = 65;

// Longitudes and latitudes of the places of a map.
class DegreeGrid
{
public:
  DegreeGrid(const Georeference& georeference, const double bounds[4])
  {
    const glm::dvec2 low{ bounds[0], bounds[2] };
    const glm::dvec2 high{ bounds[1], bounds[3] };
    for (int j = 0; j < Places; ++j)
    {
      for (int i = 0; i < Places; ++i)
      {
        this->Points.push_back(low + glm::dvec2(i, j) / (Places - 1.0) * (high - low));
      }
    }
    this->LonLat.resize(this->Points.size());
    this->Known = georeference.toLonLat(this->Points.size(), this->Points.data(), this->LonLat.data());
    // Longitudes go on across the antimeridian.
    const double middle = this->LonLat[this->LonLat.size() / 2].x;
    for (glm::dvec2& at : this->LonLat)
    {
      at.x = middle + std::remainder(at.x - middle, 360.0);
    }
  }

  bool isKnown() const { return this->Known; }

  // Lowest and highest longitude (0) or latitude (1).
  std::array<double, 2> range(int kind) const
  {
    std::array<double, 2> ends{ HUGE_VAL, -HUGE_VAL };
    for (const glm::dvec2& at : this->LonLat)
    {
      ends[0] = std::min(ends[0], at[kind]);
      ends[1] = std::max(ends[1], at[kind]);
    }
    return ends;
  }

  // The line of a longitude (0) or latitude (1) where it crosses the map's rows or columns.
  std::vector<glm::dvec2> line(int kind, double degrees) const
  {
    std::vector<glm::dvec2> points;
    for (int along = 0; along < Places; ++along)
    {
      for (int across = 0; across + 1 < Places; ++across)
      {
        const std::size_t a = this->index(kind, along, across);
        const std::size_t b = this->index(kind, along, across + 1);
        const double from = this->LonLat[a][kind] - degrees;
        const double to = this->LonLat[b][kind] - degrees;
        if ((from <= 0.0) != (to <= 0.0))
        {
          points.push_back(this->Points[a] + from / (from - to) * (this->Points[b] - this->Points[a]));
          break;
        }
      }
    }
    return points;
  }

private:
  // Meridians cross rows, parallels cross columns.
  std::size_t index(int kind, int along, int across) const
  {
    const int row = kind == 0 ? along : across;
    const int column = kind == 0 ? across : along;
    return static_cast<std::size_t>(row) * Places + static_cast<std::size_t>(column);
  }

  std::vector<glm::dvec2> Points;
  std::vector<glm::dvec2> LonLat;
  bool Known = false;
};

// Degrees, minutes or seconds between lines.
double stepWithin(double range)
{
  constexpr double Minute = 1.0 / 60.0;
  constexpr double Second = Minute / 60.0;
  const std::array<double, 18> steps{ Second, 2 * Second, 5 * Second, 10 * Second, 15 * Second, 30 * Second, Minute,
    2 * Minute, 5 * Minute, 10 * Minute, 15 * Minute, 30 * Minute, 1, 2, 5, 10, 15, 30 };
  for (const double step : steps)
  {
    if (range / step <= LinesAcross + 1.0)
    {
      return step;
    }
  }
  return steps.back();
}

}

std::string degreesMinutes(double degrees, bool isLongitude)
{
  const double inside = isLongitude ? std::remainder(degrees, 360.0) : degrees;
  const auto seconds = std::llround(std::abs(inside) * 3600.0);
  std::string text = fmt::format("{}\u00b0", seconds / 3600);
  if (seconds % 3600 != 0)
  {
    text += fmt::format("{:02}'", seconds / 60 % 60);
  }
  if (seconds % 60 != 0)
  {
    text += fmt::format("{:02}\"", seconds % 60);
  }
  const bool neither = seconds == 0 || (isLongitude && seconds == 180 * 3600);
  const char* side = neither ? "" : isLongitude ? (inside < 0.0 ? " W" : " E") : (inside < 0.0 ? " S" : " N");
  return text + side;
}

std::vector<GraticuleLine> makeGraticule(const Georeference& georeference, const double bounds[4])
{
  const DegreeGrid grid(georeference, bounds);
  if (!grid.isKnown())
  {
    return {};
  }
  std::vector<GraticuleLine> lines;
  for (int kind = 0; kind < 2; ++kind)
  {
    const auto [low, high] = grid.range(kind);
    const double step = stepWithin(high - low);
    for (double n = std::ceil(low / step); n * step <= high; ++n)
    {
      GraticuleLine line{ kind == 0, n * step, degreesMinutes(n * step, kind == 0), grid.line(kind, n * step) };
      if (line.points.size() >= 2)
      {
        lines.push_back(std::move(line));
      }
    }
  }
  return lines;
}

}
