#pragma once

#include <string>
#include <vector>

namespace swellray::drawing
{

/** 1, 2 or 5 times a power of ten: the largest that is not above `value`. value > 0. */
double roundNumber(double value);

/** Round marks of an axis. */
struct Ticks
{
  std::vector<double> values;
  double step = 1.0;

  /** A mark's number with as many decimals as the step needs. */
  std::string label(double value) const;
};

/** About `count` round marks within low to high. */
Ticks ticksWithin(double low, double high, int count);

/** A range with round ends. */
struct Range
{
  double low = 0.0;
  double high = 1.0;

  /** 0 at low, 1 at high. */
  double share(double value) const { return (value - this->low) / (this->high - this->low); }
};

/** The smallest range with round ends that holds low to high. */
Range roundRange(double low, double high);

/** Number without needless digits. */
std::string shortNumber(double value);

/** Sector of the compass, as SE or NNW. */
std::string compassPoint(double degrees);

}
