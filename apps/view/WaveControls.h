#pragma once

namespace swellray::view
{

/** What the sliders set. */
struct WaveControls
{
  double period = 10.0;         ///< s
  double directionFrom = 270.0; ///< nautical degrees, 0 to 360
  double height = 1.0;          ///< offshore, crest to trough, m
  double waterLevel = 0.0;      ///< tide, m

  bool operator==(const WaveControls& other) const
  {
    return this->period == other.period && this->directionFrom == other.directionFrom && this->height == other.height &&
      this->waterLevel == other.waterLevel;
  }
  bool operator!=(const WaveControls& other) const { return !(*this == other); }
};

/** Ends of a slider, and the step to which its values are rounded. */
struct ControlRange
{
  double low = 0.0;
  double high = 1.0;
  double step = 0.01;
  bool logarithmic = false; ///< equal ways for equal ratios; needs low > 0

  /** 0 at low, 1 at high. */
  double share(double value) const;

  /** Value at a share of the way, rounded to the step, within the ends. */
  double value(double share) const;

  /** The next value up (1) or down (-1), within the ends. */
  double next(double value, int steps) const;
};

/** Ranges of all sliders. */
struct ControlRanges
{
  ControlRange period;
  ControlRange direction;
  ControlRange height;
  ControlRange waterLevel;
};

/** A wave that fits a scene; SI units, where none was asked for. */
WaveControls controlsForScene(double width, double facing, double waterLevel);

/**
 * Ranges around the controls that a window opens with: a fifth to five times of period and height, and tides of up to a
 * fifth of the greatest depth.
 * @param deepest greatest depth, m
 */
ControlRanges rangesAround(const WaveControls& controls, double deepest);

}
