// The frame of a chart: metres, or longitude and latitude.
#include "ChartItem.h"

#include "FieldValues.h"

#include <vtkContext2D.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swellray::cli
{

using namespace drawing;

namespace
{

constexpr double KilometresFrom = 5000.0; // extent from which the axes count in kilometres, m

std::string degreesText(double value, char positive, char negative)
{
  return fmt::format("{:.4f}\u00b0 {}", std::abs(value), value < 0.0 ? negative : positive);
}

}

void ChartItem::paintAxes(vtkContext2D* painter)
{
  if (this->Graticule.empty())
  {
    this->paintMetricAxes(painter);
  }
  else
  {
    this->paintDegreeAxes(painter);
  }
}

void ChartItem::paintGraticule(vtkContext2D* painter)
{
  const double u = this->Layout.unit;
  const PixelBox& map = this->Layout.map;
  double bounds[6];
  this->Content.seafloor->GetBounds(bounds);
  const double scale = map.width / (bounds[1] - bounds[0]);
  this->pen(painter, Ink, 0.035 * u, 0.35);
  for (const GraticuleLine& line : this->Graticule)
  {
    std::vector<float> pixels;
    for (const glm::dvec2& point : line.points)
    {
      pixels.push_back(static_cast<float>(map.x + (point.x - bounds[0]) * scale));
      pixels.push_back(static_cast<float>(map.y + (point.y - bounds[2]) * scale));
    }
    painter->DrawPoly(pixels.data(), static_cast<int>(line.points.size()));
  }
}

void ChartItem::paintDegreeAxes(vtkContext2D* painter)
{
  const double u = this->Layout.unit;
  const PixelBox& map = this->Layout.map;
  double bounds[6];
  this->Content.seafloor->GetBounds(bounds);
  const double scale = map.width / (bounds[1] - bounds[0]);
  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
  for (const GraticuleLine& line : this->Graticule)
  {
    const glm::dvec2& end = line.points.front();
    this->pen(painter, Ink, 0.07 * u);
    if (line.meridian && end.y <= bounds[2])
    {
      const double x = map.x + (end.x - bounds[0]) * scale;
      painter->DrawLine(
        static_cast<float>(x), static_cast<float>(map.y), static_cast<float>(x), static_cast<float>(map.y - 0.45 * u));
      this->text(painter, x, map.y - 1.25 * u, line.label, 0.85 * u, Align::Center);
    }
    else if (!line.meridian && end.x <= bounds[0])
    {
      const double y = map.y + (end.y - bounds[2]) * scale;
      painter->DrawLine(
        static_cast<float>(map.x), static_cast<float>(y), static_cast<float>(map.x - 0.45 * u), static_cast<float>(y));
      this->text(painter, map.x - 1.1 * u, y, line.label, 0.85 * u, Align::Center, 0.0, false, 90.0);
    }
  }
  this->text(painter, map.x + 0.5 * map.width, map.y - 2.7 * u, "Longitude", 0.9 * u, Align::Center, map.width);
  this->text(painter, map.x - 3.0 * u, map.y + 0.5 * map.height, "Latitude", 0.9 * u, Align::Center, 0.0, false, 90.0);
}

void ChartItem::paintMetricAxes(vtkContext2D* painter)
{
  const double u = this->Layout.unit;
  const PixelBox& map = this->Layout.map;
  double bounds[6];
  this->Content.seafloor->GetBounds(bounds);
  const double extent = std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  const bool kilometres = extent >= KilometresFrom;
  const double metres = kilometres ? 1000.0 : 1.0;
  const char* unit = kilometres ? "km" : "m";

  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
  // Ticks of both axes have the same step, where the shorter one then still has some.
  const Ticks longer = ticksWithin(0.0, extent / metres, 7);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double low = bounds[2 * axis] / metres;
    const double high = bounds[2 * axis + 1] / metres;
    Ticks ticks = ticksWithin(low, high, 7);
    if ((high - low) / longer.step >= 2.0)
    {
      ticks = ticksWithin(low, high, std::max(1, static_cast<int>(1.001 * (high - low) / longer.step)));
    }
    for (const double value : ticks.values)
    {
      const double share = (value - low) / (high - low);
      this->pen(painter, Ink, 0.07 * u);
      if (axis == 0)
      {
        const double x = map.x + share * map.width;
        painter->DrawLine(static_cast<float>(x), static_cast<float>(map.y), static_cast<float>(x),
          static_cast<float>(map.y - 0.45 * u));
        this->text(painter, x, map.y - 1.25 * u, ticks.label(value), 0.85 * u, Align::Center);
      }
      else
      {
        const double y = map.y + share * map.height;
        painter->DrawLine(static_cast<float>(map.x), static_cast<float>(y), static_cast<float>(map.x - 0.45 * u),
          static_cast<float>(y));
        this->text(painter, map.x - 0.75 * u, y, ticks.label(value), 0.85 * u, Align::Right);
      }
    }
  }

  const Georeference georeference = georeferenceOf(this->Content.seafloor);
  std::string east = fmt::format("x, east ({})", unit);
  std::string north = fmt::format("y, north ({})", unit);
  if (georeference.kind() == GeoreferenceKind::Geographic)
  {
    east = fmt::format("{} east of {}", unit, degreesText(georeference.originLongitude(), 'E', 'W'));
    north = fmt::format("{} north of {}", unit, degreesText(georeference.originLatitude(), 'N', 'S'));
  }
  else if (georeference.originX() != 0.0 || georeference.originY() != 0.0)
  {
    east = fmt::format("{} east of x = {:.10g}", unit, georeference.originX());
    north = fmt::format("{} north of y = {:.10g}", unit, georeference.originY());
  }
  this->text(painter, map.x + 0.5 * map.width, map.y - 2.7 * u, east, 0.9 * u, Align::Center, map.width);
  this->text(painter, map.x - 4.1 * u, map.y + 0.5 * map.height, north, 0.9 * u, Align::Center, 0.0, false, 90.0);
}

}
