// The column of a chart beside its map.
#include "ChartItem.h"

#include "FieldValues.h"

#include "sim/Angles.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkPolyData.h>
#include <vtkTextProperty.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swellray::cli
{

using namespace drawing;

namespace
{

// Below this, degrees, true north and grid north are one to the eye.
constexpr double LeastConvergence = 0.1;

}

void ChartItem::paintArrow(
  vtkContext2D* painter, double x, double y, double bearing, const std::string& label, Arrow kind)
{
  const double u = this->Layout.unit;
  const double turn = radians(bearing);
  const auto corner = [&](double right, double forward)
  {
    return std::array<float, 2>{ static_cast<float>(x + u * (right * std::cos(turn) + forward * std::sin(turn))),
      static_cast<float>(y + u * (forward * std::cos(turn) - right * std::sin(turn))) };
  };
  this->pen(painter, Ink, 0.09 * u);
  if (kind == Arrow::Grid)
  {
    const auto foot = corner(0.0, -1.6);
    const auto top = corner(0.0, 1.75);
    const auto left = corner(-0.45, 0.9);
    const auto right = corner(0.45, 0.9);
    painter->DrawLine(foot[0], foot[1], top[0], top[1]);
    painter->DrawLine(left[0], left[1], top[0], top[1]);
    painter->DrawLine(right[0], right[1], top[0], top[1]);
  }
  else if (kind == Arrow::Waves)
  {
    const auto from = corner(0.0, -1.7);
    const auto to = corner(0.0, 1.0);
    this->pen(painter, Ink, 0.16 * u);
    painter->DrawLine(from[0], from[1], to[0], to[1]);
    const auto tip = corner(0.0, 1.75);
    const auto left = corner(-0.5, 0.55);
    const auto right = corner(0.5, 0.55);
    float head[6] = { tip[0], tip[1], left[0], left[1], right[0], right[1] };
    this->pen(painter, Ink, 0.02 * u);
    this->brush(painter, Ink);
    painter->DrawPolygon(head, 3);
  }
  else
  {
    const auto tip = corner(0.0, 1.75);
    const auto left = corner(-0.75, -1.6);
    const auto notch = corner(0.0, -0.95);
    const auto right = corner(0.75, -1.6);
    float dark[6] = { tip[0], tip[1], left[0], left[1], notch[0], notch[1] };
    float light[6] = { tip[0], tip[1], notch[0], notch[1], right[0], right[1] };
    this->pen(painter, Ink, 0.06 * u);
    this->brush(painter, Ink);
    painter->DrawPolygon(dark, 3);
    this->brush(painter, { 1.0, 1.0, 1.0 });
    painter->DrawPolygon(light, 3);
    float outline[8] = { tip[0], tip[1], notch[0], notch[1], right[0], right[1], tip[0], tip[1] };
    painter->DrawPoly(outline, 4);
  }
  this->text(painter, x, y - 2.75 * u, label, 0.85 * u, Align::Center, 3.8 * u);
}

double ChartItem::paintArrows(vtkContext2D* painter, double top)
{
  const double u = this->Layout.unit;
  const PixelBox& column = this->Layout.column;
  const double y = top - 1.9 * u;
  double bounds[6];
  this->Content.seafloor->GetBounds(bounds);
  const Georeference georeference = georeferenceOf(this->Content.seafloor);
  // True north lies this much anticlockwise from the map's upward axis.
  const double convergence = georeference.convergence({ 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]) });
  const bool known = std::isfinite(convergence) && georeference.kind() != GeoreferenceKind::Local;
  const bool two = known && std::abs(convergence) >= LeastConvergence;
  const auto direction = this->waves() ? fieldNumber(this->waves(), "DirectionFrom") : std::optional<double>();
  const double first = two ? 2.0 : 2.6;
  const double last = two ? 10.6 : 9.0;
  this->paintArrow(
    painter, column.x + first * u, y, known ? -convergence : 0.0, known ? "true north" : "north", Arrow::North);
  if (two)
  {
    const double middle = direction ? 0.5 * (first + last) : last - 2.0;
    this->paintArrow(painter, column.x + middle * u, y, 0.0, "grid north", Arrow::Grid);
    painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
    this->text(painter, column.x + 0.5 * (first + middle) * u, y + 2.3 * u,
      fmt::format("{:.1f}\u00b0", std::abs(convergence)), 0.75 * u, Align::Center);
  }
  if (direction)
  {
    this->paintArrow(painter, column.x + last * u, y, *direction + 180.0, "waves go", Arrow::Waves);
  }
  return y - 4.6 * u;
}

void ChartItem::paintColorScale(vtkContext2D* painter, double top, double height, const std::string& title,
  const Range& range, const std::function<Rgb(double)>& color, bool downwards, bool above, bool below)
{
  const double u = this->Layout.unit;
  const PixelBox& column = this->Layout.column;
  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
  this->text(painter, column.x, top - 0.6 * u, title, 0.95 * u, Align::Left, column.width, true);

  const double x = column.x;
  const double width = 1.4 * u;
  const double high = top - 2.1 * u;
  const double low = top - height + 0.6 * u;
  const int strips = static_cast<int>(high - low);
  for (int i = 0; i < strips; ++i)
  {
    const double t = (i + 0.5) / strips;
    const Rgb rgb = color(downwards ? 1.0 - t : t);
    this->pen(painter, rgb, 0.0, 0.0);
    this->brush(painter, rgb);
    painter->DrawRect(static_cast<float>(x), static_cast<float>(low + i), static_cast<float>(width), 1.0F);
  }
  this->pen(painter, Ink, 0.07 * u);
  painter->GetBrush()->SetOpacity(0);
  painter->DrawRect(
    static_cast<float>(x), static_cast<float>(low), static_cast<float>(width), static_cast<float>(high - low));

  const Ticks ticks = ticksWithin(range.low, range.high, 5);
  for (const double value : ticks.values)
  {
    const double share = downwards ? 1.0 - range.share(value) : range.share(value);
    const double y = low + share * (high - low);
    this->pen(painter, Ink, 0.07 * u);
    painter->DrawLine(static_cast<float>(x + width), static_cast<float>(y), static_cast<float>(x + width + 0.35 * u),
      static_cast<float>(y));
    const bool beyond = (above && std::abs(value - range.high) < 1e-9 * ticks.step) ||
      (below && std::abs(value - range.low) < 1e-9 * ticks.step);
    const std::string sign = beyond ? (value == range.low ? "\u2264 " : "\u2265 ") : "";
    this->text(painter, x + width + 0.7 * u, y, sign + ticks.label(value), 0.85 * u, Align::Left);
  }
}

double ChartItem::paintLegend(vtkContext2D* painter, double bottom)
{
  const double u = this->Layout.unit;
  const PixelBox& column = this->Layout.column;
  struct Entry
  {
    std::string words;
    std::function<void(double)> draw; // at this height
  };
  std::vector<Entry> entries;
  const double left = column.x;
  const double right = column.x + 2.4 * u;
  const auto sample = [&](LineKind kind, const std::function<Rgb(double)>& color)
  {
    return [this, painter, kind, color, left, right](double y)
    {
      PixelLine line;
      line.kind = kind;
      constexpr int Points = 40;
      for (int i = 0; i < Points; ++i)
      {
        const double t = i / (Points - 1.0);
        line.points.push_back(static_cast<float>(left + t * (right - left)));
        line.points.push_back(static_cast<float>(y));
        for (const double channel : color(t))
        {
          line.colors.push_back(static_cast<unsigned char>(std::lround(255.0 * channel)));
        }
        line.colors.push_back(255);
      }
      this->paintLine(painter, line);
    };
  };
  const auto patch = [&](const Rgb& color)
  {
    return [this, painter, color, left, right, u](double y)
    {
      this->pen(painter, SoftInk, 0.04 * u);
      this->brush(painter, color);
      painter->DrawRect(static_cast<float>(left), static_cast<float>(y - 0.45 * u), static_cast<float>(right - left),
        static_cast<float>(0.9 * u));
    };
  };
  const auto lineColor = [&](LineKind kind)
  {
    for (const PixelLine& line : this->Lines.lines)
    {
      if (line.kind == kind)
      {
        return Rgb{ line.colors[0] / 255.0, line.colors[1] / 255.0, line.colors[2] / 255.0 };
      }
    }
    return Ink;
  };
  const auto has = [&](LineKind kind) { return this->Lines.counts.count(kind) > 0; };
  const bool scale = this->Colors.kind == RayColors::Kind::Scale;
  const auto rayColor = [&](LineKind kind) -> std::function<Rgb(double)>
  {
    if (scale)
    {
      return [this](double t) { return this->Content.colors->rgb(t); };
    }
    const Rgb color = lineColor(kind);
    return [color](double) { return color; };
  };

  const std::string every =
    this->Lines.rayStride > 1 ? fmt::format(" (1 in {} drawn)", this->Lines.rayStride) : std::string();
  if (this->Colors.kind == RayColors::Kind::States)
  {
    const char* names[4] = { "dead", "alive", "flat", "aground" };
    for (const int state : { 1, 2, 3, 0 })
    {
      if (this->Lines.states[static_cast<std::size_t>(state)])
      {
        const Rgb color = stateColor(state);
        entries.push_back(
          { std::string("ray, ") + names[state], sample(LineKind::Ray, [color](double) { return color; }) });
      }
    }
  }
  else if (has(LineKind::Ray))
  {
    entries.push_back({ "ray" + every, sample(LineKind::Ray, rayColor(LineKind::Ray)) });
  }
  if (has(LineKind::LeeRay))
  {
    entries.push_back({ "ray into the lee (model)", sample(LineKind::LeeRay, rayColor(LineKind::LeeRay)) });
  }
  if (has(LineKind::AgroundRay) && this->Colors.kind != RayColors::Kind::States)
  {
    const Rgb color = lineColor(LineKind::AgroundRay);
    entries.push_back({ "ray aground", sample(LineKind::AgroundRay, [color](double) { return color; }) });
  }
  if (!this->Lines.breakers.empty())
  {
    entries.push_back({ "breaking begins",
      [this, painter, left, right, u](double y)
      {
        this->pen(painter, Ink, 0.04 * u);
        this->brush(painter, { 1.0, 1.0, 1.0 });
        painter->DrawEllipse(static_cast<float>(0.5 * (left + right)), static_cast<float>(y),
          static_cast<float>(0.22 * u), static_cast<float>(0.22 * u));
      } });
  }
  if (has(LineKind::Crest))
  {
    const auto water = patch(waterMap().rgb(0.6));
    const auto crest = sample(LineKind::Crest, [](double) { return Rgb{ 1.0, 1.0, 1.0 }; });
    entries.push_back({ this->Lines.crestStride > 1 ? fmt::format("crest (1 in {})", this->Lines.crestStride) : "crest",
      [water, crest](double y)
      {
        water(y);
        crest(y);
      } });
  }
  if (has(LineKind::Contour))
  {
    const Rgb color = lineColor(LineKind::Contour);
    entries.push_back(
      { this->Lines.contourInterval > 0.0 ? fmt::format("depth, every {} m", shortNumber(this->Lines.contourInterval))
                                          : "depth contour",
        sample(LineKind::Contour, [color](double) { return color; }) });
  }
  if (has(LineKind::Obstacle))
  {
    const Rgb color = lineColor(LineKind::Obstacle);
    entries.push_back({ "obstacle", sample(LineKind::Obstacle, [color](double) { return color; }) });
  }
  if (this->MapColors.gaps)
  {
    entries.push_back({ "no waves", patch(noValueColor()) });
  }
  if (this->Depths.highest > 0.0)
  {
    entries.push_back({ "land", patch(landMap().rgb(0.4)) });
  }
  if (this->Depths.hasHoles)
  {
    entries.push_back({ "no data", patch(noDataColor()) });
  }

  const double step = 1.45 * u;
  double y = bottom + step * (static_cast<double>(entries.size()) - 0.5);
  const double top = y + 0.5 * step;
  for (const Entry& entry : entries)
  {
    entry.draw(y);
    painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
    this->text(
      painter, right + 0.7 * u, y, entry.words, 0.85 * u, Align::Left, column.x + column.width - right - 0.7 * u);
    y -= step;
  }
  return top;
}

double ChartItem::paintScaleBar(vtkContext2D* painter, double bottom)
{
  const double u = this->Layout.unit;
  const PixelBox& column = this->Layout.column;
  double bounds[6];
  this->Content.seafloor->GetBounds(bounds);
  const double pixelsPerMetre = this->Layout.map.width / (bounds[1] - bounds[0]);
  const double length = roundNumber((column.width - 1.5 * u) / pixelsPerMetre);
  const double width = length * pixelsPerMetre;
  const double height = 0.45 * u;
  const double y = bottom + 0.2 * u;
  this->pen(painter, Ink, 0.06 * u);
  for (int i = 0; i < 4; ++i)
  {
    this->brush(painter, i % 2 == 0 ? Ink : Rgb{ 1.0, 1.0, 1.0 });
    painter->DrawRect(static_cast<float>(column.x + i * width / 4), static_cast<float>(y),
      static_cast<float>(width / 4), static_cast<float>(height));
  }
  const bool kilometres = length >= 1000.0;
  const auto number = [&](double metres) { return shortNumber(kilometres ? metres / 1000.0 : metres); };
  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
  const double above = y + height + 0.75 * u;
  this->text(painter, column.x, above, "0", 0.85 * u, Align::Left);
  this->text(painter, column.x + 0.5 * width, above, number(0.5 * length), 0.85 * u, Align::Center);
  this->text(painter, column.x + width, above, number(length) + (kilometres ? " km" : " m"), 0.85 * u, Align::Center);
  return above + 0.6 * u;
}

}
