#pragma once

#include "WaveControls.h"

#include <array>
#include <optional>
#include <string>

namespace swellray::view
{

/** A slider of the panel. */
enum class Control
{
  Period,
  Direction,
  Height,
  WaterLevel,
};
constexpr std::size_t ControlCount = 4;

/** A point of the window, pixels from its lower left corner. */
struct Pixel
{
  double x = 0.0;
  double y = 0.0;
};

/** Where a slider lies and what it says. */
struct SliderShape
{
  Control control = Control::Period;
  std::string label;
  std::string value; ///< with its unit
  double left = 0.0; ///< ends of the track
  double right = 0.0;
  double y = 0.0;
  double knob = 0.0; ///< x of the knob
};

/** Where the compass lies; waves come from the rim at `directionFrom`. */
struct CompassShape
{
  Pixel center;
  double radius = 0.0;
  double directionFrom = 0.0; ///< nautical degrees
};

/**
 * The controls beside the view, without a window: where sliders and compass lie, and what the mouse makes of them.
 * It stands on the left of the window, over its whole height.
 */
class Panel
{
public:
  Panel(const WaveControls& values, const ControlRanges& ranges);

  /** The window has this size, pixels. */
  void resize(int width, int height);

  /** Size of the type, pixels; all other sizes follow it. */
  double unit() const { return this->Unit; }
  double width() const;
  int windowWidth() const { return this->WindowWidth; }
  int windowHeight() const { return this->WindowHeight; }

  const WaveControls& values() const { return this->Values; }
  void setValues(const WaveControls& values);

  std::array<SliderShape, ControlCount> sliders() const;
  CompassShape compass() const;

  /** Height below which the panel has room for words. */
  double wordsTop() const;

  /** The mouse button goes down. @return the panel has it: the view must not turn */
  bool press(const Pixel& at);

  /** The mouse moves. @return a value changed */
  bool drag(const Pixel& at);

  /** The mouse button goes up. @return the panel had it */
  bool release();

  /** The wheel turns over a slider or the compass. @return the panel has it */
  bool turnWheel(const Pixel& at, int steps);

  /** The control that is dragged. */
  std::optional<Control> held() const { return this->Held; }

private:
  const ControlRange& range(Control control) const;
  double& value(Control control);
  double value(Control control) const;
  std::optional<Control> sliderAt(const Pixel& at) const;
  bool isOnCompass(const Pixel& at) const;
  void setDirection(double degrees);

  WaveControls Values;
  ControlRanges Ranges;
  int WindowWidth = 1;
  int WindowHeight = 1;
  double Unit = 13.0;
  std::optional<Control> Held;
  bool Turning = false; // the compass
};

}
