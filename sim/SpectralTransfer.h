#pragma once

#include "sim/BackwardTracer.h"
#include "sim/DirectionalSpectrum.h"
#include "sim/Execution.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <vector>

namespace swellray
{

/** From where the components of the sea at one place come: what its spectrum is made of, whatever the sea offshore. */
struct SpectralOrigins
{
  glm::dvec2 place{ 0.0 }; ///< m
  double depth = 0.0;      ///< m; NaN in a hole or outside, not above 0 on land

  /**
   * Offshore heading and gain (WaveOrigin) of each ray: frequency by frequency, one entry a direction of the rays. NaN
   * and 0 where no wave comes from offshore. Empty where the place is dry.
   */
  std::vector<double> headings;
  std::vector<double> gains;

  std::size_t steps = 0; ///< of all these rays; 0 where they come from a file
};

/**
 * Rays by which the sea at a place is found. Each direction of the grid is the middle of a bin, and `perDirection` rays
 * stand in the middles of its equal parts.
 */
struct SpectralRays
{
  SpectralGrid grid;
  std::size_t perDirection = 1;

  std::size_t directionCount() const { return grid.headings.size() * perDirection; }
  /** Heading of ray i of directionCount(), rad. */
  double heading(std::size_t i) const;
  /** Width of the part of a bin that a ray stands for, rad. */
  double width() const;

  /** @throws std::invalid_argument where the grid makes no sense, or its directions are not equally spaced */
  void validate() const;
};

/**
 * Trace back all components at these places.
 *
 * The result is the same for any loop in `execution`. What is cancelled is incomplete.
 * @throws std::invalid_argument
 */
std::vector<SpectralOrigins> traceOrigins(const BackwardTracer& tracer, const SpectralRays& rays,
  const std::vector<glm::dvec2>& places, const Execution& execution = {});

/**
 * The spectrum at a place: linear in the spectrum offshore.
 *
 * Between two neighbouring rays whose offshore headings differ by less than 75 degrees the offshore heading is linear in
 * that at the place, and E offshore, linear between its nodes, is averaged over what a bin sees; elsewhere, as at the
 * edge of a shadow, a ray stands for its own part of the bin. So a narrow sea is not missed between two rays.
 */
class SpectralTransfer
{
public:
  /**
   * @param offshore grid of the spectra offshore; its frequencies must be those of the rays
   * @throws std::invalid_argument
   */
  SpectralTransfer(const SpectralRays& rays, const SpectralGrid& offshore, const SpectralOrigins& origins);

  /** Spectrum at the place on the grid of the rays. @param offshore density on the offshore grid */
  void apply(const std::vector<double>& offshore, DirectionalSpectrum& result) const;

  /**
   * Weights by which the densities offshore make, frequency by frequency, the spectrum over frequency at the place
   * (m2/Hz) and its parts towards east and north: three numbers a node of the offshore grid.
   */
  const std::vector<double>& frequencyWeights() const { return this->Sums; }

private:
  std::size_t Directions = 0;
  std::size_t OffshoreDirections = 0;
  std::vector<double> Rows; // [frequency][direction][offshore direction]
  std::vector<double> Sums; // [frequency][offshore direction][3]
  SpectralGrid Grid;
};

}
