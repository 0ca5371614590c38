#include "ChartItem.h"

#include "FieldValues.h"

#include "sim/Angles.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPoints2D.h>
#include <vtkPolyData.h>
#include <vtkRect.h>
#include <vtkTextProperty.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swellray::cli
{

vtkStandardNewMacro(ChartItem);

namespace
{

const Rgb Ink{ 0.13, 0.15, 0.18 };
const Rgb SoftInk{ 0.36, 0.39, 0.43 };
const Rgb ShoreInk{ 0.27, 0.23, 0.18 };

constexpr double KilometresFrom = 5000.0; // extent from which the axes count in kilometres, m

std::string degreesText(double value, char positive, char negative)
{
  return fmt::format("{:.4f}\u00b0 {}", std::abs(value), value < 0.0 ? negative : positive);
}

}

void ChartItem::setContent(const ChartContent& content, const ChartLayout& layout)
{
  this->Content = content;
  this->Layout = layout;
  this->Colors = chooseRayColors(content);
  this->Lines = makeChartLines(content, layout, this->Colors);
  this->Depths = depthRange(content.seafloor, content.waterLevel);
  this->Bed.waterLevel = content.waterLevel;
  this->Bed.deepest = roundRange(0.0, std::max(1e-6, this->Depths.deepest)).high;
  this->Bed.highest = std::max(1e-6, this->Depths.highest);
  this->Bed.shore = ShoreInk;
  this->Bed.shoreWidth = std::max(1, static_cast<int>(std::lround(0.05 * layout.unit)));
  this->Background = seafloorPicture(
    content.seafloor, this->Bed, static_cast<int>(layout.map.width), static_cast<int>(layout.map.height));
}

bool ChartItem::Paint(vtkContext2D* painter)
{
  const double u = this->Layout.unit;
  this->paintMap(painter);
  this->paintAxes(painter);
  this->paintHeading(painter);

  const PixelBox& column = this->Layout.column;
  const double top = this->paintArrows(painter, column.y + column.height);
  double bottom = this->paintScaleBar(painter, column.y);
  bottom = this->paintLegend(painter, bottom + 1.6 * u);

  // The colour scales share what is left, but a scale need not be taller than it is useful.
  const bool rayScale = this->Colors.kind == RayColors::Kind::Scale;
  const double room = top - bottom - 1.6 * u;
  const double height = std::min(rayScale ? 0.5 * (room - 1.2 * u) : room, 18.0 * u);
  const double spare = room - (rayScale ? 2.0 : 1.0) * height;
  double y = top - (rayScale ? 0.25 : 0.5) * spare;
  if (rayScale)
  {
    const std::string unit = this->Colors.unit.empty() ? "" : " (" + this->Colors.unit + ")";
    this->paintColorScale(
      painter, y, height, this->Colors.name + unit, this->Colors.range, [](double t) { return rayMap().rgb(t); }, false,
      this->Colors.above, this->Colors.below);
    y -= height + 0.5 * spare;
  }
  this->paintColorScale(
    painter, y, height, "Water depth (m)", { 0.0, this->Bed.deepest }, [](double t) { return waterMap().rgb(t); }, true,
    false, false);
  return true;
}

void ChartItem::pen(vtkContext2D* painter, const Rgb& color, double width, double opacity)
{
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetColorF(color[0], color[1], color[2], opacity);
  painter->GetPen()->SetWidth(static_cast<float>(width));
}

void ChartItem::brush(vtkContext2D* painter, const Rgb& color)
{
  painter->GetBrush()->SetTexture(nullptr);
  painter->GetBrush()->SetColorF(color[0], color[1], color[2], 1.0);
}

void ChartItem::text(vtkContext2D* painter, double x, double y, const std::string& words, double size, Align align,
  double room, bool bold, double turn)
{
  vtkTextProperty* style = painter->GetTextProp();
  style->SetFontFamilyToArial();
  style->SetFontSize(static_cast<int>(std::lround(size)));
  style->SetBold(bold);
  style->SetOrientation(turn);
  style->SetJustification(align == Align::Left ? VTK_TEXT_LEFT
      : align == Align::Center                 ? VTK_TEXT_CENTERED
                                               : VTK_TEXT_RIGHT);
  style->SetVerticalJustificationToCentered();
  if (room > 0.0)
  {
    float bounds[4];
    painter->ComputeStringBounds(words, bounds);
    if (bounds[2] > room)
    {
      style->SetFontSize(static_cast<int>(std::floor(size * room / bounds[2])));
    }
  }
  painter->DrawString(static_cast<float>(x), static_cast<float>(y), words);
  style->SetOrientation(0.0);
  style->SetBold(false);
}

void ChartItem::paintLine(vtkContext2D* painter, const PixelLine& line)
{
  const double u = this->Layout.unit;
  double width = 0.075 * u;
  switch (line.kind)
  {
  case LineKind::Contour:
    width = 0.045 * u;
    break;
  case LineKind::Crest:
    width = 0.05 * u;
    break;
  case LineKind::AgroundRay:
    width = 0.11 * u;
    break;
  default:
    break;
  }
  this->pen(painter, Ink, width);
  const int count = static_cast<int>(line.points.size() / 2);
  auto* points = const_cast<float*>(line.points.data());
  auto* colors = const_cast<unsigned char*>(line.colors.data());
  if (line.kind != LineKind::LeeRay)
  {
    painter->DrawPoly(points, count, colors, 4);
    return;
  }
  // Dashes by length along the line.
  const double dash = 0.5 * u;
  const double gap = 0.3 * u;
  double along = 0.0;
  int first = 0;
  for (int i = 1; i < count; ++i)
  {
    along += std::hypot(points[2 * i] - points[2 * i - 2], points[2 * i + 1] - points[2 * i - 1]);
    if (along >= dash || i + 1 == count)
    {
      painter->DrawPoly(points + 2 * first, i - first + 1, colors + 4 * first, 4);
      double skipped = 0.0;
      while (i + 1 < count && skipped < gap)
      {
        ++i;
        skipped += std::hypot(points[2 * i] - points[2 * i - 2], points[2 * i + 1] - points[2 * i - 1]);
      }
      first = i;
      along = 0.0;
    }
  }
}

void ChartItem::paintMap(vtkContext2D* painter)
{
  const double u = this->Layout.unit;
  const PixelBox& map = this->Layout.map;
  painter->DrawImage(vtkRectf(static_cast<float>(map.x), static_cast<float>(map.y), static_cast<float>(map.width),
                       static_cast<float>(map.height)),
    this->Background);
  int clip[4] = { static_cast<int>(map.x), static_cast<int>(map.y), static_cast<int>(map.width),
    static_cast<int>(map.height) };
  painter->GetDevice()->SetClipping(clip);
  painter->GetDevice()->EnableClipping(true);
  for (const PixelLine& line : this->Lines.lines)
  {
    this->paintLine(painter, line);
  }
  this->pen(painter, Ink, 0.04 * u);
  this->brush(painter, { 1.0, 1.0, 1.0 });
  for (std::size_t i = 0; i + 1 < this->Lines.breakers.size(); i += 2)
  {
    painter->DrawEllipse(
      this->Lines.breakers[i], this->Lines.breakers[i + 1], static_cast<float>(0.12 * u), static_cast<float>(0.12 * u));
  }
  painter->GetDevice()->EnableClipping(false);

  this->pen(painter, Ink, 0.09 * u);
  painter->GetBrush()->SetOpacity(0);
  painter->DrawRect(static_cast<float>(map.x), static_cast<float>(map.y), static_cast<float>(map.width),
    static_cast<float>(map.height));
}

void ChartItem::paintAxes(vtkContext2D* painter)
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
  for (int axis = 0; axis < 2; ++axis)
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

void ChartItem::paintHeading(vtkContext2D* painter)
{
  const double u = this->Layout.unit;
  const double left = this->Layout.map.x;
  const double room = this->Layout.column.x + this->Layout.column.width - left;
  const double top = std::min<double>(this->Layout.height, this->Layout.map.y + this->Layout.map.height + 5.2 * u);
  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
  this->text(painter, left, top - 1.9 * u, this->Content.title, 1.55 * u, Align::Left, room, true);

  std::vector<std::string> parts;
  if (this->Content.rays)
  {
    const auto period = fieldNumber(this->Content.rays, "Period");
    const auto direction = fieldNumber(this->Content.rays, "DirectionFrom");
    const auto height = fieldNumber(this->Content.rays, "WaveHeight");
    if (period && direction && height)
    {
      const auto depth = fieldNumber(this->Content.rays, "OffshoreDepth");
      parts.push_back(fmt::format("waves of {} s, {} m high, from {}\u00b0 ({}){}", shortNumber(*period),
        shortNumber(*height), shortNumber(*direction), compassPoint(*direction),
        depth && std::isfinite(*depth) ? fmt::format(" in {} m of water", shortNumber(*depth)) : " in deep water"));
    }
  }
  if (this->Content.waterLevel != 0.0)
  {
    parts.push_back(fmt::format("water level {} m", shortNumber(this->Content.waterLevel)));
  }
  if (this->Content.rays)
  {
    parts.push_back(fmt::format("{} rays", this->Content.rays->GetNumberOfCells()));
  }
  const Georeference georeference = georeferenceOf(this->Content.seafloor);
  if (!georeference.crsName().empty() && georeference.crsName() != "unknown")
  {
    parts.push_back(georeference.crsName());
  }
  std::string caption;
  for (const std::string& part : parts)
  {
    caption += (caption.empty() ? "" : "  \u00b7  ") + part;
  }
  painter->GetTextProp()->SetColor(SoftInk[0], SoftInk[1], SoftInk[2]);
  this->text(painter, left, top - 3.9 * u, caption, 1.0 * u, Align::Left, room);
  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
}

void ChartItem::paintArrow(
  vtkContext2D* painter, double x, double y, double bearing, const std::string& label, bool hollow)
{
  const double u = this->Layout.unit;
  const double turn = radians(bearing);
  const auto corner = [&](double right, double forward)
  {
    return std::array<float, 2>{ static_cast<float>(x + u * (right * std::cos(turn) + forward * std::sin(turn))),
      static_cast<float>(y + u * (forward * std::cos(turn) - right * std::sin(turn))) };
  };
  this->pen(painter, Ink, 0.09 * u);
  if (hollow)
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
  this->text(painter, x, y - 2.75 * u, label, 0.85 * u, Align::Center, 6.0 * u);
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
  this->paintArrow(painter, column.x + 2.6 * u, y, known ? -convergence : 0.0, known ? "true north" : "north", false);
  const auto direction =
    this->Content.rays ? fieldNumber(this->Content.rays, "DirectionFrom") : std::optional<double>();
  if (direction)
  {
    this->paintArrow(painter, column.x + 9.0 * u, y, *direction + 180.0, "waves go", true);
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
      return [](double t) { return rayMap().rgb(t); };
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
