#include "PanelItem.h"

#include "apps/drawing/ColorMap.h"
#include "apps/drawing/Scale.h"
#include "sim/Angles.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <cmath>

namespace swellray::view
{

vtkStandardNewMacro(PanelItem);

namespace
{

using drawing::Rgb;

const Rgb Paper{ 0.985, 0.985, 0.98 };
const Rgb Ink{ 0.13, 0.15, 0.18 };
const Rgb SoftInk{ 0.40, 0.43, 0.47 };
const Rgb Pale{ 0.82, 0.84, 0.86 };
const Rgb Accent{ 0.08, 0.40, 0.53 };

constexpr double Margin = 1.4; // units of the type

void setPen(vtkContext2D* painter, const Rgb& color, double width)
{
  painter->GetPen()->SetLineType(width > 0.0 ? vtkPen::SOLID_LINE : vtkPen::NO_PEN);
  painter->GetPen()->SetColorF(color[0], color[1], color[2]);
  painter->GetPen()->SetOpacityF(1.0);
  painter->GetPen()->SetWidth(static_cast<float>(width));
}

void setBrush(vtkContext2D* painter, const Rgb& color, double opacity = 1.0)
{
  painter->GetBrush()->SetTexture(nullptr);
  painter->GetBrush()->SetColorF(color[0], color[1], color[2]);
  painter->GetBrush()->SetOpacityF(opacity);
}

void fillBox(vtkContext2D* painter, double x, double y, double width, double height)
{
  painter->DrawRect(
    static_cast<float>(x), static_cast<float>(y), static_cast<float>(width), static_cast<float>(height));
}

void drawLine(vtkContext2D* painter, double x0, double y0, double x1, double y1)
{
  painter->DrawLine(static_cast<float>(x0), static_cast<float>(y0), static_cast<float>(x1), static_cast<float>(y1));
}

void fillDisc(vtkContext2D* painter, double x, double y, double radius)
{
  painter->DrawEllipse(
    static_cast<float>(x), static_cast<float>(y), static_cast<float>(radius), static_cast<float>(radius));
}

}

void PanelItem::text(
  vtkContext2D* painter, const std::string& words, double x, double y, double size, Align align, bool bold, double room)
{
  vtkTextProperty* style = painter->GetTextProp();
  style->SetFontFamilyToArial();
  style->SetBold(bold);
  style->SetFontSize(static_cast<int>(std::lround(size)));
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
}

bool PanelItem::Paint(vtkContext2D* painter)
{
  const double u = this->Shown->unit();
  const double width = this->Shown->width();
  const double height = this->Shown->windowHeight();
  setPen(painter, Paper, 0.0);
  setBrush(painter, Paper);
  fillBox(painter, 0.0, 0.0, width, height);
  setPen(painter, Pale, 1.0);
  drawLine(painter, width, 0.0, width, height);

  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
  this->text(painter, this->Title, Margin * u, height - 2.0 * u, 1.35 * u, Align::Left, true, width - 2.0 * Margin * u);
  this->paintCompass(painter);
  this->paintSliders(painter);
  this->paintColors(painter);
  this->paintLines(painter);
  painter->GetTextProp()->SetColor(SoftInk[0], SoftInk[1], SoftInk[2]);
  this->text(painter, this->Status, Margin * u, 1.4 * u, 0.9 * u, Align::Left, false, width - 2.0 * Margin * u);
  this->paintHelp(painter);
  return true;
}

void PanelItem::paintCompass(vtkContext2D* painter)
{
  const double u = this->Shown->unit();
  const CompassShape shape = this->Shown->compass();
  const bool held = this->Shown->held() == Control::Direction;
  const double x = shape.center.x;
  const double y = shape.center.y;
  setPen(painter, SoftInk, 0.09 * u);
  setBrush(painter, { 1.0, 1.0, 1.0 });
  fillDisc(painter, x, y, shape.radius);
  for (int degree = 0; degree < 360; degree += 10)
  {
    const double turn = radians(degree);
    const double length = degree % 90 == 0 ? 0.75 : degree % 30 == 0 ? 0.55 : 0.3;
    const double inner = shape.radius - length * u;
    drawLine(painter, x + inner * std::sin(turn), y + inner * std::cos(turn), x + shape.radius * std::sin(turn),
      y + shape.radius * std::cos(turn));
  }
  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
  const char* points[4] = { "N", "E", "S", "W" };
  for (int i = 0; i < 4; ++i)
  {
    const double turn = radians(90.0 * i);
    const double at = shape.radius - 1.5 * u;
    this->text(painter, points[i], x + at * std::sin(turn), y + at * std::cos(turn), 0.95 * u, Align::Center, i == 0);
  }
  // An arrow to where the waves go, and the knob on the rim, where they come from, to be dragged.
  const double turn = radians(shape.directionFrom);
  const auto corner = [&](double right, double out)
  {
    return std::array<float, 2>{ static_cast<float>(x + u * (right * std::cos(turn) + out * std::sin(turn))),
      static_cast<float>(y + u * (out * std::cos(turn) - right * std::sin(turn))) };
  };
  const auto tail = corner(0.0, 2.4);
  const auto neck = corner(0.0, -0.8);
  const auto left = corner(-0.9, -0.7);
  const auto right = corner(0.9, -0.7);
  const auto tip = corner(0.0, -2.6);
  const auto knob = corner(0.0, shape.radius / u);
  setPen(painter, Accent, 0.3 * u);
  painter->DrawLine(tail[0], tail[1], neck[0], neck[1]);
  setPen(painter, Accent, 0.0);
  setBrush(painter, Accent);
  float head[6] = { tip[0], tip[1], left[0], left[1], right[0], right[1] };
  painter->DrawPolygon(head, 3);
  fillDisc(painter, knob[0], knob[1], (held ? 0.85 : 0.7) * u);
}

void PanelItem::paintSliders(vtkContext2D* painter)
{
  const double u = this->Shown->unit();
  for (const SliderShape& shape : this->Shown->sliders())
  {
    const bool held = this->Shown->held() == shape.control;
    painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
    this->text(painter, shape.label, shape.left, shape.y + 1.4 * u, u, Align::Left);
    this->text(painter, shape.value, shape.right, shape.y + 1.4 * u, u, Align::Right, true);
    setPen(painter, Pale, 0.0);
    setBrush(painter, Pale);
    fillBox(painter, shape.left, shape.y - 0.15 * u, shape.right - shape.left, 0.3 * u);
    setPen(painter, Accent, 0.0);
    setBrush(painter, Accent);
    fillBox(painter, shape.left, shape.y - 0.15 * u, shape.knob - shape.left, 0.3 * u);
    fillDisc(painter, shape.knob, shape.y, (held ? 0.8 : 0.65) * u);
  }
}

void PanelItem::paintColors(vtkContext2D* painter)
{
  const double u = this->Shown->unit();
  const double left = Margin * u;
  const double width = this->Shown->width() - 2.0 * left;
  const double top = this->Shown->wordsTop();
  painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
  this->text(painter, "Wave height along the rays (m)", left, top, u, Align::Left);
  constexpr int Strips = 64;
  for (int i = 0; i < Strips; ++i)
  {
    setPen(painter, Paper, 0.0);
    setBrush(painter, drawing::rayMap().rgb((i + 0.5) / Strips));
    fillBox(painter, left + i * width / Strips, top - 1.7 * u, width / Strips + 1.0, 0.8 * u);
  }
  const double height = this->Shown->values().height;
  this->text(painter, "0", left, top - 2.5 * u, 0.9 * u, Align::Left);
  this->text(painter, drawing::shortNumber(height), left + 0.5 * width, top - 2.5 * u, 0.9 * u, Align::Center);
  this->text(
    painter, "\u2265 " + drawing::shortNumber(2.0 * height), left + width, top - 2.5 * u, 0.9 * u, Align::Right);
}

void PanelItem::paintLines(vtkContext2D* painter)
{
  const double u = this->Shown->unit();
  const double left = Margin * u;
  const double right = this->Shown->width() - left;
  double y = this->Shown->wordsTop() - 4.8 * u;
  for (const PanelLine& line : this->Lines)
  {
    const bool heading = line.value.empty();
    const Rgb& color = heading ? Ink : SoftInk;
    painter->GetTextProp()->SetColor(color[0], color[1], color[2]);
    this->text(painter, line.label, left, y, u, Align::Left, heading, right - left);
    painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
    if (!heading)
    {
      this->text(painter, line.value, right, y, u, Align::Right);
    }
    y -= 1.55 * u;
  }
}

void PanelItem::paintHelp(vtkContext2D* painter)
{
  if (this->Help.empty())
  {
    return;
  }
  const double u = this->Shown->unit();
  const double left = this->Shown->width() + 2.0 * u;
  const double height = (1.7 * static_cast<double>(this->Help.size()) + 1.6) * u;
  const double top = this->Shown->windowHeight() - 2.0 * u;
  setPen(painter, Pale, 1.0);
  setBrush(painter, Paper, 0.93);
  fillBox(painter, left, top - height, 37.0 * u, height);
  double y = top - 1.7 * u;
  for (const PanelLine& line : this->Help)
  {
    const bool heading = line.value.empty();
    painter->GetTextProp()->SetColor(Ink[0], Ink[1], Ink[2]);
    this->text(painter, line.label, left + 1.5 * u, y, u, Align::Left, true);
    if (!heading)
    {
      this->text(painter, line.value, left + 9.5 * u, y, u, Align::Left);
    }
    y -= 1.7 * u;
  }
}

}
