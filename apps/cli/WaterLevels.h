#pragma once

#include <string>
#include <vector>

namespace swellray::cli
{

/** The water level at one time. */
struct TimedLevel
{
  std::string time;   ///< as it was typed
  double level = 0.0; ///< m, positive up
};

/**
 * A series of water levels from a CSV file, time and level a line: the columns of these names (or date, datetime;
 * water_level, height, tide, eta), otherwise the first two; a first line whose level is no number is a heading. Times are all
 * ISO 8601 (2024-05-01T06:00, seconds and zone as you like) or all numbers (seconds, hours, ...), and grow.
 * @throws WorkError naming the file, and the line that is none
 */
std::vector<TimedLevel> readWaterLevels(const std::string& path);

}
