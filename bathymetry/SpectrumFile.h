#pragma once

#include "sim/DirectionalSpectrum.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swellray
{

/** A directional spectrum as a file holds it. */
struct SpectrumRecord
{
  std::string time;                ///< as the file says it; empty: none
  std::optional<glm::dvec2> place; ///< file coordinates, or longitude and latitude
  bool geographic = false;         ///< the place is longitude and latitude
  DirectionalSpectrum spectrum;    ///< absolute frequencies
};

/** The spectra of a file, place by place within time by time. */
struct SpectrumFile
{
  std::string format; ///< "SWAN", "NetCDF" or "NDBC"
  std::vector<SpectrumRecord> records;
  std::vector<std::string> notes; ///< what a user should know, one line each
};

/** Directions of spectra that a file gives by mean direction and spread. */
constexpr std::size_t StandardDirections = 72;

/**
 * Read spectra:
 *
 * - SWAN standard spectral files (.bnd, .spc, .sp1, .sp2): 1-D with direction and spread per frequency, and 2-D;
 *   variance or energy densities, nautical or Cartesian directions. Relative frequencies are taken as absolute.
 * - NetCDF: a variable efth, or with the standard name sea_surface_wave_directional_variance_spectral_density, over time,
 *   station, frequency and direction in any order (WAVEWATCH III, CF); directions from or to as their standard name says.
 * - NDBC: spectral densities of a buoy (46042w2010.txt, or 46042.data_spec), with the files of the directions and lengths of
 *   its first two moments beside it; spread by maximum entropy (MaximumEntropySpreading).
 *
 * A 1-D spectrum is spread as cos^2s about its mean direction, frequency by frequency (DirectionalSpreading); the spread
 * is the circular standard deviation, as in SWAN.
 *
 * @throws std::runtime_error a file that cannot be read or understood; the message names it and the line
 */
SpectrumFile readSpectra(const std::string& path);

/**
 * Write spectra as a SWAN standard spectral file, 2-D: variance densities, nautical directions. All must be on the same
 * grid. Values keep 5 digits of the largest of their spectrum.
 * @throws std::invalid_argument where they are not; std::runtime_error where the file cannot be written
 */
void writeSwanSpectra(const std::string& path, const std::vector<SpectrumRecord>& records, const std::string& source);

/**
 * Write spectra as NetCDF-4 after CF, as WAVEWATCH III lays them out: efth (time, station, frequency, direction) in
 * m2 s rad-1, directions going to, degrees clockwise from north; longitude and latitude, or x and y, of the stations.
 * @param records on one grid, place by place within time by time, the same places each time; times as secondsOfTime() reads
 * @throws std::invalid_argument where they are not; std::runtime_error where the file cannot be written
 */
void writeNetcdfSpectra(const std::string& path, const std::vector<SpectrumRecord>& records, const std::string& source);

}
