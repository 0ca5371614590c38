#pragma once

#include "Options.h"

#include "sim/DirectionalSpectrum.h"

#include <vector>

namespace swellray::cli
{

class OutputFile;

/** --elevation-series, --duration, --interval and --seed. */
std::vector<OptionSpec> elevationOptions(Request& request);

/** @throws UsageError */
void checkElevation(const Request& request);

/**
 * Write a table of the surface elevation in time: a column a station, empty where it is dry. The record is as long as asked,
 * or a little longer, so that its samples are many small factors.
 * @throws WorkError
 */
void writeElevations(const std::vector<DirectionalSpectrum>& spectra, const Request& request, const OutputFile& file,
  const Console& console);

}
