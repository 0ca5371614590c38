#pragma once

namespace swellray::cli
{

class Console;
struct Request;

/**
 * Trace the waves at every water level of a series, each level once, and write the table of the stations: a row a
 * time and station.
 * @throws WorkError
 */
void traceWaterLevels(const Request& request, Console& console);

}
