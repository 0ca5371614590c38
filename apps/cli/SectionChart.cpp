#include "SectionChart.h"

#include "ChartItem.h"
#include "ItemPicture.h"

#include "apps/drawing/Scale.h"

#include <fmt/format.h>

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkContextItem.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRect.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace swellray::cli
{

using namespace drawing;

namespace
{

// Sizes in units of the type: what stands around the panels.
constexpr double LeftMargin = 5.0;
constexpr double RightMargin = 1.6;
constexpr double TopMargin = 8.2;
constexpr double BottomMargin = 3.8;
constexpr double Gap = 0.7;
constexpr double StandardPanel = 8.0;

constexpr double UnitsAcross = 70.0;
constexpr int StandardWidth = 1600;

// Of the water under its level at least so much is shown, heights of the highest crest, and so much air over it.
constexpr double WaterShown = 1.8;
constexpr double AirShown = 1.3;

SectionLayout enlarged(SectionLayout layout, int factor)
{
  layout.width *= factor;
  layout.height *= factor;
  layout.unit *= factor;
  for (PixelBox& box : layout.panels)
  {
    box = { factor * box.x, factor * box.y, factor * box.width, factor * box.height };
  }
  return layout;
}

/** Paints sections with their axes and headings. */
class SectionItem : public vtkContextItem
{
public:
  static SectionItem* New();
  vtkTypeMacro(SectionItem, vtkContextItem)

  void setContent(const SectionContent* content, const SectionLayout& layout)
  {
    this->Content = content;
    this->Layout = layout;
  }

  bool Paint(vtkContext2D* painter) override
  {
    const double u = this->Layout.unit;
    const double left = this->Layout.panels.front().x;
    const double top = this->Layout.height;
    const double room = this->Layout.panels.front().width;
    write(painter, left, top - 1.9 * u, this->Content->title, 1.55 * u, VTK_TEXT_LEFT, Ink, room, true);
    write(painter, left, top - 3.9 * u, this->Content->caption, u, VTK_TEXT_LEFT, SoftInk, room);
    for (std::size_t i = 0; i < this->Layout.panels.size(); ++i)
    {
      this->paintPanel(painter, this->Content->panels[i], this->Layout.panels[i]);
    }
    this->paintDistances(painter);
    return true;
  }

private:
  static void pen(vtkContext2D* painter, const Rgb& color, double width, double opacity = 1.0)
  {
    painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    painter->GetPen()->SetColorF(color[0], color[1], color[2], opacity);
    painter->GetPen()->SetWidth(static_cast<float>(width));
  }

  static void line(vtkContext2D* painter, double x0, double y0, double x1, double y1)
  {
    painter->DrawLine(static_cast<float>(x0), static_cast<float>(y0), static_cast<float>(x1), static_cast<float>(y1));
  }

  // Made smaller where it would be wider than its room, where that is above 0.
  static void write(vtkContext2D* painter, double x, double y, const std::string& words, double size, int align,
    const Rgb& color, double room = 0.0, bool bold = false, double turn = 0.0)
  {
    vtkTextProperty* style = painter->GetTextProp();
    style->SetFontFamilyToArial();
    style->SetColor(color[0], color[1], color[2]);
    style->SetFontSize(static_cast<int>(std::lround(size)));
    style->SetBold(bold);
    style->SetOrientation(turn);
    style->SetJustification(align);
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
  }

  double across(const PixelBox& box, double along) const { return box.x + along / this->Content->length * box.width; }

  double upwards(const PixelBox& box, double z) const
  {
    return box.y + (z - this->Layout.low) / (this->Layout.high - this->Layout.low) * box.height;
  }

  void paintPanel(vtkContext2D* painter, const SectionPanel& panel, const PixelBox& box)
  {
    const double u = this->Layout.unit;
    const double level = this->Content->waterLevel;
    painter->DrawImage(vtkRectf(static_cast<float>(box.x), static_cast<float>(box.y), static_cast<float>(box.width),
                         static_cast<float>(box.height)),
      sectionImage(*this->Content, panel, this->Layout, static_cast<int>(box.width), static_cast<int>(box.height)));
    int clip[4] = { static_cast<int>(box.x), static_cast<int>(box.y), static_cast<int>(box.width),
      static_cast<int>(box.height) };
    painter->GetDevice()->SetClipping(clip);
    painter->GetDevice()->EnableClipping(true);
    pen(painter, Ink, 0.03 * u, 0.4);
    line(painter, box.x, this->upwards(box, level), box.x + box.width, this->upwards(box, level));
    pen(painter, Ink, 0.09 * u);
    std::vector<float> bed;
    for (std::size_t i = 0; i < this->Content->bed.size(); ++i)
    {
      if (std::isfinite(this->Content->bed[i]))
      {
        const double share = static_cast<double>(i) / (static_cast<double>(this->Content->bed.size()) - 1.0);
        bed.push_back(static_cast<float>(box.x + share * box.width));
        bed.push_back(static_cast<float>(this->upwards(box, this->Content->bed[i])));
      }
    }
    painter->DrawPoly(bed.data(), static_cast<int>(bed.size() / 2));
    std::vector<float> water;
    for (const CutSegment& segment : panel.water)
    {
      for (const glm::dvec2& end : { segment.begin, segment.end })
      {
        water.push_back(static_cast<float>(this->across(box, end.x)));
        water.push_back(static_cast<float>(this->upwards(box, end.y)));
      }
    }
    if (!water.empty())
    {
      painter->DrawLines(water.data(), static_cast<int>(water.size() / 2));
    }
    painter->GetDevice()->EnableClipping(false);
    pen(painter, Ink, 0.07 * u);
    painter->GetBrush()->SetOpacity(0);
    painter->DrawRect(static_cast<float>(box.x), static_cast<float>(box.y), static_cast<float>(box.width),
      static_cast<float>(box.height));
    painter->GetBrush()->SetOpacity(255);
    write(painter, box.x + 0.6 * u, box.y + 0.9 * u, panel.label, u, VTK_TEXT_LEFT, { 1.0, 1.0, 1.0 }, 0.0, true);
    const int marks = std::max(1, static_cast<int>(box.height / (2.2 * u)));
    const Ticks ticks = ticksWithin(this->Layout.low - level, this->Layout.high - level, marks);
    for (const double value : ticks.values)
    {
      const double y = this->upwards(box, value + level);
      // Numbers of two panels would touch.
      if (y < box.y + 0.3 * u || y > box.y + box.height - 0.3 * u)
      {
        continue;
      }
      pen(painter, Ink, 0.07 * u);
      line(painter, box.x - 0.45 * u, y, box.x, y);
      write(painter, box.x - 0.75 * u, y, ticks.label(value), 0.85 * u, VTK_TEXT_RIGHT, Ink);
    }
  }

  // Below the last panel distances, over the first one the depths there.
  void paintDistances(vtkContext2D* painter)
  {
    const double u = this->Layout.unit;
    const PixelBox& first = this->Layout.panels.front();
    const PixelBox& last = this->Layout.panels.back();
    const Ticks ticks = ticksWithin(0.0, this->Content->length, 10);
    for (const double value : ticks.values)
    {
      const double x = this->across(last, value);
      pen(painter, Ink, 0.07 * u);
      line(painter, x, last.y - 0.45 * u, x, last.y);
      write(painter, x, last.y - 1.2 * u, ticks.label(value), 0.85 * u, VTK_TEXT_CENTERED, Ink);
      const double share = value / this->Content->length * (static_cast<double>(this->Content->bed.size()) - 1.0);
      const double depth = this->Content->waterLevel - this->Content->bed[static_cast<std::size_t>(std::lround(share))];
      if (std::isfinite(depth) && depth > -0.05)
      {
        const double above = first.y + first.height;
        line(painter, x, above, x, above + 0.45 * u);
        const std::string words =
          depth < 9.95 ? fmt::format("{:.1f}", std::max(0.0, depth)) : fmt::format("{:.0f}", depth);
        write(painter, x, above + 1.1 * u, words, 0.85 * u, VTK_TEXT_CENTERED, Ink);
      }
    }
    write(painter, first.x + 0.5 * first.width, first.y + first.height + 2.4 * u, "depth of still water (m)", 0.9 * u,
      VTK_TEXT_CENTERED, Ink);
    write(painter, last.x + 0.5 * last.width, last.y - 2.7 * u, "distance along the line (m)", 0.9 * u,
      VTK_TEXT_CENTERED, Ink);
    write(painter, first.x - 4.0 * u, 0.5 * (first.y + first.height + last.y), "height (m)", 0.9 * u, VTK_TEXT_CENTERED,
      Ink, 0.0, false, 90.0);
  }

  const SectionContent* Content = nullptr;
  SectionLayout Layout;
};

vtkStandardNewMacro(SectionItem);

}

SectionLayout layOutSections(const SectionContent& content, const std::optional<std::array<int, 2>>& size,
  const std::optional<double>& exaggeration)
{
  const auto count = static_cast<double>(content.panels.size());
  SectionLayout layout;
  layout.width = size ? (*size)[0] : StandardWidth;
  layout.unit = layout.width / UnitsAcross;
  const double around = TopMargin + BottomMargin + (count - 1.0) * Gap;
  layout.height = size ? (*size)[1] : static_cast<int>((around + count * StandardPanel) * layout.unit);
  layout.unit = std::min(layout.unit, layout.height / (around + 2.0 * count));
  const double u = layout.unit;
  const double width = std::floor(layout.width - (LeftMargin + RightMargin) * u);
  const double height = std::max(1.0, std::floor((layout.height - around * u) / count));
  double top = layout.height - TopMargin * u;
  for (std::size_t i = 0; i < content.panels.size(); ++i)
  {
    top = std::floor(top - height);
    layout.panels.push_back({ std::floor(LeftMargin * u), top, width, height });
    top -= Gap * u;
  }
  const double crest = std::max(1e-9, content.highest);
  const double across = content.length / width; // m a pixel
  layout.exaggeration = exaggeration.value_or(roundNumber(height * across / ((WaterShown + AirShown) * crest)));
  layout.high = content.waterLevel + AirShown * crest;
  layout.low = layout.high - height * across / layout.exaggeration;
  return layout;
}

vtkSmartPointer<vtkImageData> drawSections(const SectionContent& content, const SectionLayout& layout)
{
  vtkNew<SectionItem> item;
  item->setContent(&content, enlarged(layout, enlargementOf(layout.width, layout.height)));
  return drawItem(item, layout.width, layout.height);
}

}
