#pragma once

#include "sim/Execution.h"
#include "sim/RayCaustic.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** Rays and the caustics that they touch, as plain arrays. */
struct TouchingRays
{
  std::size_t rays = 0;
  const std::int64_t* offsets = nullptr;   ///< rays + 1: points of ray i are those from offsets[i] to offsets[i + 1]
  const double* launchParameter = nullptr; ///< a ray, m
  const std::int32_t* launchSegment = nullptr; ///< a ray; of different ones they are no neighbours
  const std::uint8_t* lee = nullptr;           ///< a ray, 1: a model of diffraction
  const RayCaustic* caustics = nullptr;        ///< by ray, in the order in which they are touched
  const std::size_t* causticOffsets = nullptr; ///< rays + 1, as offsets
  const double* phase = nullptr;               ///< a point, S, rad, increasing
  const double* wavenumber = nullptr;          ///< a point, rad/m
  const double* krTube = nullptr;              ///< a point, |beta|^(-1/2); NaN and infinity allowed
  const std::uint8_t* state = nullptr;         ///< a point, RayState
};

/**
 * The caustics of these rays, RayCaustic::alongRate filled in where no neighbour touches them: where the sheet folds over and
 * back between two rays. beta being 0 along a caustic, dl/dlambda = (d beta/d lambda)/(d beta/ds), of first order from the
 * widths of the neighbours at the phase at which it is touched. NaN stays where no neighbour has one.
 */
std::vector<RayCaustic> loneCausticRates(const TouchingRays& rays);

/**
 * Folds beside rays that do not touch them: where a sheet of rays folds along its way, the rays on one side have touched
 * the caustic while those on the other go beside it, up to the beach maybe, and lie as near to it.
 *
 * Half the phase between the branches is A |beta|^3 on both sides of a caustic, on one front: beta grows with the
 * distance from it there in launch parameter, and the phase with the third power. A at a phase is that of the
 * nearest ray in launch parameter that touches the caustic (RayFolds), so that heights on both sides of it go to the same.
 * The fold is where beta, linear in the launch parameter between that ray and the one next to it, is 0; for rays further from
 * it two of the powers are those of what beta would be, had it gone on growing so: it need not.
 * Next to a caustic that the ray touches itself the other counts for nothing.
 *
 * @return half the phase between the branches a point, rad (RayFolds); infinite where there is no such fold
 */
std::vector<double> foldsBeside(const TouchingRays& rays, const Execution& execution = {});

}
