#pragma once

#include <optional>
#include <string>

namespace swellray
{

/**
 * Seconds since 1970-01-01T00:00Z of a time as spectral files write it: 2026-11-22T12:00[:00], with a blank in place of the T,
 * or SWAN's 20261122.120000. A zone is not read. None where the text is none of these.
 */
std::optional<double> secondsOfTime(const std::string& text);

/** A time as 2026-11-22T12:00:00, to the nearest second. */
std::string timeOfSeconds(double seconds);

/** Seconds since 1970 of a value in units like "days since 1990-01-01 00:00:00". None where they are no such units. */
std::optional<double> secondsOfUnits(double value, const std::string& units);

}
