#pragma once

#include "sim/DirectionalSpreading.h"
#include "sim/FrequencySpectrum.h"

#include <array>
#include <cstddef>
#include <vector>

namespace swellray
{

/** Frequencies and directions at which a directional spectrum is known. */
struct SpectralGrid
{
  std::vector<double> frequencies; ///< Hz, > 0, increasing, at least 2
  std::vector<double> headings;    ///< rad anticlockwise from east, going to, increasing, within less than a circle

  std::size_t size() const { return frequencies.size() * headings.size(); }

  /** True where the headings go round the whole circle: their largest gap is below twice their mean distance. */
  bool isCircle() const;

  /**
   * Weights of the frequencies in an integral: half the distance of the neighbours (trapezoid), Hz.
   * They are at the same time the integrals of the hat functions of the nodes.
   */
  std::vector<double> frequencyWeights() const;

  /** The same of the headings, rad; periodic on a circle. */
  std::vector<double> headingWeights() const;

  /** @throws std::invalid_argument saying what is wrong */
  void validate() const;

  /** Frequencies in geometric progression and headings all around. @param headingCount >= 3 */
  static SpectralGrid logarithmic(double lowest, double highest, std::size_t frequencyCount, std::size_t headingCount);
};

/** What is told of a sea. */
struct SeaParameters
{
  double significantHeight = 0.0; ///< Hs = 4 sqrt(m0), m
  double peakPeriod = 0.0;        ///< Tp, s, of a parabola through the highest frequency and its neighbours
  double meanPeriod01 = 0.0;      ///< Tm01 = m0/m1, s
  double meanPeriod02 = 0.0;      ///< Tm02 = sqrt(m0/m2), s
  double energyPeriod = 0.0;      ///< Tm-10 = m-1/m0, s
  double meanDirectionFrom = 0.0; ///< of the energy, nautical degrees; NaN where there is none
  double spread = 0.0;            ///< circular standard deviation (Kuik et al. 1988), degrees; NaN where there is none
};

/** Directional spectrum E(f, heading), m2/(Hz rad), on a grid; between the nodes linear in both. */
struct DirectionalSpectrum
{
  SpectralGrid grid;
  std::vector<double> density; ///< frequency by frequency, one entry a heading

  double at(std::size_t frequency, std::size_t heading) const
  {
    return density[frequency * grid.headings.size() + heading];
  }

  /** E at any frequency and heading; 0 outside of the grid. */
  double interpolate(double frequency, double heading) const;

  /** Spectrum over frequency, integrated over the headings, m2/Hz. */
  std::vector<double> overFrequency() const;

  /**
   * Sample a sea on the grid. Each node takes the mean of E with the hat function of its frequency as weight, and over
   * its share of the circle: m0 and m1 of the frequencies within the grid are kept exactly. Then all is scaled so
   * that what lies outside of the grid is not missing in Hs.
   * @param meanHeading rad, going to
   * @throws std::invalid_argument on a bad grid, or where less than 90 % of the energy lies within it
   */
  static DirectionalSpectrum sample(const SpectralGrid& grid, const FrequencySpectrum& spectrum,
    const DirectionalSpreading& spreading, double meanHeading);
};

/**
 * Brings seas from one grid to another, as often as wanted. Their energy is kept, and the integral of f E, but for what
 * lies outside of the grid: that share of the energy is dealt to its ends.
 */
class SpectrumResampler
{
public:
  /** @throws std::invalid_argument on a bad grid */
  SpectrumResampler(const SpectralGrid& from, const SpectralGrid& to);

  /**
   * @param density on the first grid
   * @return on the second
   * @throws std::invalid_argument where less than 90 % of the energy lies within its frequencies
   */
  std::vector<double> apply(const std::vector<double>& density) const;

private:
  // Weights of the values at the nodes of one axis in those of another: rows are the new nodes.
  struct AxisWeights
  {
    std::vector<double> weights;
    std::vector<double> whole;  // what each old node holds
    std::vector<double> inside; // and how much of it lies within the new axis
  };
  static AxisWeights frequencyAxis(const SpectralGrid& from, const SpectralGrid& to);
  static AxisWeights headingAxis(const SpectralGrid& from, const SpectralGrid& to);

  SpectralGrid To;
  AxisWeights Frequencies;
  AxisWeights Headings;
};

/** The same sea on another grid (SpectrumResampler). */
DirectionalSpectrum resample(const DirectionalSpectrum& spectrum, const SpectralGrid& grid);

/** Frequencies between which this share of the energy lies, the same below and above, Hz. */
std::array<double, 2> energyBand(const DirectionalSpectrum& spectrum, double share);

/**
 * Heights, periods and directions of a sea. All moments by the weights of the grid, over its frequencies alone.
 * The periods are NaN where there is no energy.
 */
SeaParameters seaParameters(const DirectionalSpectrum& spectrum);

/**
 * The same of the sums of a spectrum over its headings.
 * @param frequencies Hz, as in a SpectralGrid, n
 * @param weights of the frequencies, Hz, n
 * @param sums the integrals of E, E cos(heading) and E sin(heading) over the headings, m2/Hz: 3 n, frequency by frequency
 */
SeaParameters seaParameters(
  const std::vector<double>& frequencies, const std::vector<double>& weights, const double* sums);

}
