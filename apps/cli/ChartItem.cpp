#include "ChartItem.h"

#include "Failure.h"
#include "FieldValues.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPolyData.h>
#include <vtkRect.h>
#include <vtkTextProperty.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swellray::cli
{

using namespace drawing;

vtkStandardNewMacro(ChartItem);

namespace
{

const Rgb ShoreInk{ 0.27, 0.23, 0.18 };

// None where the frame is metric.
std::vector<GraticuleLine> graticuleOf(const ChartContent& content)
{
  const Georeference georeference = georeferenceOf(content.seafloor);
  const bool geographic = georeference.kind() == GeoreferenceKind::Geographic;
  if (content.frame == ChartFrame::Metric || (content.frame == ChartFrame::Auto && !geographic))
  {
    return {};
  }
  double bounds[6];
  content.seafloor->GetBounds(bounds);
  std::vector<GraticuleLine> lines = makeGraticule(georeference, bounds);
  if (lines.empty())
  {
    throw WorkError("--frame graticule needs a seafloor with a coordinate reference system: give --crs, or take "
                    "--frame metric");
  }
  return lines;
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
  this->Graticule = graticuleOf(content);
  WaterField field;
  if (content.map)
  {
    this->MapColors = chooseMapColors(content);
    field = { content.map, content.mapBy, this->MapColors.range, content.colors };
  }
  this->Background = seafloorPicture(
    content.seafloor, this->Bed, field, static_cast<int>(layout.map.width), static_cast<int>(layout.map.height));
}

vtkDataObject* ChartItem::waves() const
{
  return this->Content.rays ? static_cast<vtkDataObject*>(this->Content.rays) : this->Content.map;
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
  const auto paintScale = [&](const RayColors& colors, const std::string& what)
  {
    const std::string unit = colors.unit.empty() ? "" : " (" + colors.unit + ")";
    this->paintColorScale(
      painter, y, height, what + colors.name + unit, colors.range,
      [this](double t) { return this->Content.colors->rgb(t); }, false, colors.above, colors.below);
  };
  if (rayScale)
  {
    paintScale(this->Colors, this->Content.map ? "Rays: " : "");
    y -= height + 0.5 * spare;
  }
  if (this->Content.map)
  {
    paintScale(this->MapColors, "");
    return true;
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
  case LineKind::Obstacle:
    width = 0.16 * u;
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
  const auto stretch = [points](std::ptrdiff_t i)
  { return std::hypot(points[2 * i] - points[2 * i - 2], points[2 * i + 1] - points[2 * i - 1]); };
  double along = 0.0;
  std::ptrdiff_t first = 0;
  for (std::ptrdiff_t i = 1; i < count; ++i)
  {
    along += stretch(i);
    if (along < dash && i + 1 < count)
    {
      continue;
    }
    painter->DrawPoly(points + 2 * first, static_cast<int>(i - first + 1), colors + 4 * first, 4);
    for (along = 0.0; i + 1 < count && along < gap; along += stretch(i))
    {
      ++i;
    }
    first = i;
    along = 0.0;
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
  this->paintGraticule(painter);
  for (const PixelLine& line : this->Lines.lines)
  {
    this->paintLine(painter, line);
  }
  for (const ContourLabel& label : this->Lines.labels)
  {
    // A halo keeps the words apart from rays that cross them.
    vtkTextProperty* style = painter->GetTextProp();
    const double size = 0.7 * u;
    style->SetOpacity(0.5);
    style->SetColor(1.0, 1.0, 1.0);
    for (const auto& [x, y] : { std::pair{ 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } })
    {
      this->text(painter, label.x + 0.08 * u * x, label.y + 0.08 * u * y, label.words, size, Align::Center, 0.0, false,
        label.angle);
    }
    style->SetOpacity(1.0);
    style->SetColor(Ink[0], Ink[1], Ink[2]);
    this->text(painter, label.x, label.y, label.words, size, Align::Center, 0.0, false, label.angle);
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

void ChartItem::paintHeading(vtkContext2D* painter)
{
  const double u = this->Layout.unit;
  const double left = this->Layout.map.x;
  const double room = this->Layout.column.x + this->Layout.column.width - left;
  const double top = std::min<double>(this->Layout.height, this->Layout.map.y + this->Layout.map.height + 5.2 * u);
  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
  this->text(painter, left, top - 1.9 * u, this->Content.title, 1.55 * u, Align::Left, room, true);

  std::vector<std::string> parts;
  if (vtkDataObject* waves = this->waves())
  {
    parts.push_back(waveWords(waves));
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
    caption += (caption.empty() || part.empty() ? "" : "  \u00b7  ") + part;
  }
  painter->GetTextProp()->SetColor(SoftInk[0], SoftInk[1], SoftInk[2]);
  this->text(painter, left, top - 3.9 * u, caption, 1.0 * u, Align::Left, room);
  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
}

}
