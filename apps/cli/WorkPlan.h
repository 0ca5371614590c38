#pragma once

#include <string>

namespace swellray::cli
{

/** What work will take, as far as a part of it tells: between two numbers, which may be the same. */
struct Estimate
{
  double low = 0.0;
  double high = 0.0;

  /** At most this. */
  void limit(double most);

  /** "about 4,500 to 8,200", to two digits; one number where the two are about the same. */
  std::string text() const;
};

Estimate operator*(double factor, const Estimate& estimate);

/** Two digits of a number above or at 0, as "4,500". */
std::string roughly(double value);

/** "about 0.02 GB". */
std::string memoryText(const Estimate& bytes);

/** "about 30 s", minutes or hours. */
std::string timeText(const Estimate& seconds);

/**
 * What `times` as much work will take, told by a part of it. Where a smaller part, `growth` (> 1) times less, is known, too, the
 * work grows between in proportion and by the power that the two show, up to 1.5.
 * @param value of the part
 * @param before of the smaller part; 0: not known
 */
Estimate extrapolate(double value, double before, double growth, double times);

}
