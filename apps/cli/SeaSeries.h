#pragma once

#include "bathymetry/SpectrumFile.h"
#include "sim/SeaState.h"
#include "sim/SpectralTransfer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace swellray::cli
{

class Console;
class OutputFile;
class StationTable;
struct Request;

/** Seas offshore in time: parameters from a CSV file, or the spectra of a spectral file. */
class SeaSeries
{
public:
  /**
   * A file that ends in .csv has a line of names (time, hs, tp, direction, and spread if it varies) and a sea a line;
   * everything else is a spectral file (readSpectra), of which one place is taken.
   * @param form what the file does not say of the seas: shape, peakedness, spread
   * @throws WorkError naming the file and the line
   */
  SeaSeries(const std::string& path, const SeaState& form);

  std::size_t size() const { return this->Times.size(); }
  const std::string& time(std::size_t i) const { return this->Times[i]; }

  /** The first sea that is there, where the file gives parameters; none: it gives spectra. */
  std::optional<SeaState> firstState() const;

  /** Frequencies between which 99.5 % of the energy of every sea lies, Hz. */
  std::array<double, 2> band() const;

  /**
   * Density of a sea on the offshore grid, written to `density`; false where the file has none for this time.
   * May be called from several threads at once, for the same grid.
   * @throws WorkError naming the time where the grid does not hold the sea
   */
  bool sample(std::size_t i, const SpectralGrid& grid, double* density) const;

private:
  std::string Path;
  std::vector<std::string> Times;
  std::vector<std::optional<SeaState>> States;
  std::vector<SpectrumRecord> Records;
};

/**
 * Bring a series to the stations and write the table: a row a time and station.
 * @param table rays of the stations
 */
struct SeriesOutcome
{
  std::size_t rows = 0;
  double seconds = 0.0; ///< without writing
};
SeriesOutcome writeSeaSeries(const SeaSeries& series, const SpectralRays& rays,
  const std::vector<SpectralOrigins>& origins, std::optional<double> gamma, const StationTable& stations,
  const OutputFile& file, Console& console);

}
