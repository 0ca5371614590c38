#include "WaveControls.h"

#include "apps/drawing/Scale.h"
#include "sim/Angles.h"
#include "sim/IncidentWave.h"

#include <algorithm>
#include <cmath>

namespace swellray::view
{

namespace
{

// Period and height reach from a fifth of what the window opens with to five times that.
constexpr double Reach = 5.0;

// Steps of a slider over the value it opens with.
constexpr double StepShare = 0.02;

// Wavelengths across a scene that show refraction and can still be told apart.
constexpr double WavesAcross = 25.0;
constexpr double LongestPeriod = 12.0; // s
constexpr double Steepness = 0.03;
constexpr double GreatestHeight = 2.0; // m

constexpr double LeastTide = 0.05;    // m
constexpr double GreatestTide = 10.0; // m

ControlRange around(double value)
{
  ControlRange range;
  range.step = drawing::roundNumber(StepShare * value);
  range.low = std::max(range.step, std::floor(value / Reach / range.step) * range.step);
  range.high = std::ceil(value * Reach / range.step) * range.step;
  range.logarithmic = true;
  return range;
}

}

double ControlRange::share(double value) const
{
  const double inside = std::clamp(value, this->low, this->high);
  return this->logarithmic ? std::log(inside / this->low) / std::log(this->high / this->low)
                           : (inside - this->low) / (this->high - this->low);
}

double ControlRange::value(double share) const
{
  const double t = std::clamp(share, 0.0, 1.0);
  const double exact =
    this->logarithmic ? this->low * std::pow(this->high / this->low, t) : this->low + t * (this->high - this->low);
  // Whole steps over their number a unit, so that 0.3 is the number that is typed as 0.3.
  const double perUnit = 1.0 / this->step;
  const double steps = std::round(exact * perUnit);
  return std::clamp(perUnit >= 1.0 ? steps / std::round(perUnit) : steps * this->step, this->low, this->high);
}

double ControlRange::next(double value, int steps) const
{
  const double perUnit = 1.0 / this->step;
  const double whole = std::round(value * perUnit) + steps;
  return std::clamp(perUnit >= 1.0 ? whole / std::round(perUnit) : whole * this->step, this->low, this->high);
}

WaveControls controlsForScene(double width, double facing, double waterLevel)
{
  WaveControls controls;
  const double length = width / WavesAcross;
  controls.period = std::min(LongestPeriod, std::sqrt(2.0 * Pi * length / StandardGravity));
  const double step = drawing::roundNumber(StepShare * controls.period);
  controls.period = std::max(1.0, std::round(controls.period / step)) * step;
  controls.height = drawing::roundNumber(std::min(GreatestHeight, Steepness * length));
  controls.directionFrom = std::fmod(std::fmod(std::round(facing), 360.0) + 360.0, 360.0);
  controls.waterLevel = waterLevel;
  return controls;
}

ControlRanges rangesAround(const WaveControls& controls, double deepest)
{
  ControlRanges ranges;
  ranges.period = around(controls.period);
  ranges.height = around(controls.height);
  ranges.direction = { 0.0, 360.0, 1.0, false };
  const double tide = drawing::roundNumber(std::clamp(0.2 * deepest, LeastTide, GreatestTide));
  ranges.waterLevel = { controls.waterLevel - tide, controls.waterLevel + tide, tide / 50.0, false };
  return ranges;
}

}
