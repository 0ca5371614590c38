#include "Panel.h"

#include "apps/drawing/Scale.h"
#include "sim/Angles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swellray::view
{

namespace
{

// Sizes in units of the type.
constexpr double Width = 21.0;
constexpr double Margin = 1.4;
constexpr double CompassTop = 4.2; // below the upper edge of the window
constexpr double CompassRadius = 5.2;
constexpr double FirstSlider = 19.2; // below the upper edge of the window
constexpr double SliderStep = 3.6;
constexpr double Grip = 1.0; // above and below a track
constexpr double Hub = 0.5;  // of the compass: too near to it a direction is none

// The type's size follows the window's height between these, pixels.
constexpr double UnitsUp = 58.0;
constexpr double SmallestUnit = 9.0;
constexpr double LargestUnit = 24.0;

}

Panel::Panel(const WaveControls& values, const ControlRanges& ranges)
  : Values(values)
  , Ranges(ranges)
{
}

void Panel::resize(int width, int height)
{
  this->WindowWidth = std::max(1, width);
  this->WindowHeight = std::max(1, height);
  this->Unit = std::clamp(std::floor(this->WindowHeight / UnitsUp), SmallestUnit, LargestUnit);
}

double Panel::width() const
{
  return Width * this->Unit;
}

void Panel::setValues(const WaveControls& values)
{
  this->Values = values;
}

const ControlRange& Panel::range(Control control) const
{
  switch (control)
  {
  case Control::Period:
    return this->Ranges.period;
  case Control::Direction:
    return this->Ranges.direction;
  case Control::Height:
    return this->Ranges.height;
  default:
    return this->Ranges.waterLevel;
  }
}

double& Panel::value(Control control)
{
  switch (control)
  {
  case Control::Period:
    return this->Values.period;
  case Control::Direction:
    return this->Values.directionFrom;
  case Control::Height:
    return this->Values.height;
  default:
    return this->Values.waterLevel;
  }
}

double Panel::value(Control control) const
{
  return const_cast<Panel*>(this)->value(control);
}

std::array<SliderShape, ControlCount> Panel::sliders() const
{
  std::array<SliderShape, ControlCount> shapes;
  const double u = this->Unit;
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    SliderShape& shape = shapes[i];
    shape.control = static_cast<Control>(i);
    shape.left = Margin * u;
    shape.right = (Width - Margin) * u;
    shape.y = this->WindowHeight - (FirstSlider + SliderStep * static_cast<double>(i)) * u;
    const double value = this->value(shape.control);
    shape.knob = shape.left + this->range(shape.control).share(value) * (shape.right - shape.left);
    const std::string number = drawing::shortNumber(value);
    switch (shape.control)
    {
    case Control::Period:
      shape.label = "Period";
      shape.value = number + " s";
      break;
    case Control::Direction:
      shape.label = "Waves from";
      shape.value = fmt::format("{}\u00b0 ({})", number, drawing::compassPoint(value));
      break;
    case Control::Height:
      shape.label = "Height offshore";
      shape.value = number + " m";
      break;
    case Control::WaterLevel:
      shape.label = "Tide";
      shape.value = number + " m";
      break;
    }
  }
  return shapes;
}

CompassShape Panel::compass() const
{
  const double u = this->Unit;
  return { { 0.5 * Width * u, this->WindowHeight - (CompassTop + CompassRadius) * u }, CompassRadius * u,
    this->Values.directionFrom };
}

double Panel::wordsTop() const
{
  return this->WindowHeight - (FirstSlider + SliderStep * (ControlCount - 1) + 2.0) * this->Unit;
}

std::optional<Control> Panel::sliderAt(const Pixel& at) const
{
  for (const SliderShape& shape : this->sliders())
  {
    const double grip = Grip * this->Unit;
    if (std::abs(at.y - shape.y) <= grip && at.x >= shape.left - grip && at.x <= shape.right + grip)
    {
      return shape.control;
    }
  }
  return {};
}

bool Panel::isOnCompass(const Pixel& at) const
{
  const CompassShape shape = this->compass();
  const double distance = std::hypot(at.x - shape.center.x, at.y - shape.center.y);
  return distance <= shape.radius + 0.5 * this->Unit;
}

void Panel::setDirection(double direction)
{
  const double whole = std::fmod(std::round(direction) + 720.0, 360.0);
  this->Values.directionFrom = whole;
}

bool Panel::press(const Pixel& at)
{
  if (at.x >= this->width())
  {
    return false;
  }
  this->Held = this->sliderAt(at);
  this->Turning = !this->Held && this->isOnCompass(at);
  if (this->Turning)
  {
    this->Held = Control::Direction;
  }
  return true;
}

bool Panel::drag(const Pixel& at)
{
  if (!this->Held)
  {
    return false;
  }
  const WaveControls before = this->Values;
  if (this->Turning)
  {
    const CompassShape shape = this->compass();
    const double x = at.x - shape.center.x;
    const double y = at.y - shape.center.y;
    if (std::hypot(x, y) > Hub * this->Unit)
    {
      this->setDirection(degrees(std::atan2(x, y)));
    }
  }
  else
  {
    const SliderShape shape = this->sliders()[static_cast<std::size_t>(*this->Held)];
    this->value(*this->Held) = this->range(*this->Held).value((at.x - shape.left) / (shape.right - shape.left));
  }
  return this->Values != before;
}

bool Panel::release()
{
  const bool had = this->Held.has_value();
  this->Held.reset();
  this->Turning = false;
  return had;
}

bool Panel::turnWheel(const Pixel& at, int steps)
{
  if (at.x >= this->width())
  {
    return false;
  }
  if (this->isOnCompass(at))
  {
    this->setDirection(this->Values.directionFrom + steps);
  }
  else if (const auto control = this->sliderAt(at))
  {
    this->value(*control) = this->range(*control).next(this->value(*control), steps);
  }
  return true;
}

}
