#pragma once

#include "sim/DirectionalSpectrum.h"

#include <cstddef>
#include <vector>

namespace swellray
{

/** Samples of a record in time. */
struct ElevationTimes
{
  double interval = 0.5;    ///< s, > 0
  std::size_t count = 2400; ///< >= 2
  std::size_t index = 0;    ///< of the record: each has phases of its own
  unsigned seed = 1;

  /**
   * Set `count` for a record of at least this length: the next number that is 4 times factors of 2, 3 and 5 only.
   * @throws std::invalid_argument where it has not 2 to a million samples
   */
  void cover(double duration);

  /** @throws std::invalid_argument */
  void validate() const;
};

/**
 * Surface elevation at a place in time, by random phases: a sum of cosines at the multiples of 1/length up to half the
 * sampling frequency, the energy of each that of its share of the spectrum, linear between the frequencies that are given.
 * The record has just the Hs of the spectrum, but for what lies beyond half the sampling frequency, and repeats after its
 * length. The same seed and index give the same record anywhere.
 *
 * @return m, `count` samples
 * @throws std::invalid_argument where less than 90 % of the energy lies below half the sampling frequency, or the record is
 * shorter than four peak periods
 */
std::vector<double> elevationSeries(const DirectionalSpectrum& spectrum, const ElevationTimes& times);

}
