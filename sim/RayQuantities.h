#pragma once

#include "sim/Dispersion.h"
#include "sim/Execution.h"
#include "sim/IncidentWave.h"
#include "sim/MapScale.h"
#include "sim/RayField.h"

#include <cstdint>

namespace swellray
{

/** Refraction coefficient Kr = sqrt(b0/b) of a width ratio b/b0 (signed: beta); infinite at 0, NaN for NaN. */
double refractionCoefficient(double widthRatio);

/**
 * Shoaling coefficient at a point of a ray, from the wave action that a tube keeps (Bretherton and Garrett 1968):
 *
 *   H^2 |V| b/sigma = const,  V = Cg k/|k| + U:  Ks = sqrt(sigma Cg0/(omega |V|)) = sqrt(Cg0/Cg) without a current
 *
 * @param speeds at the point, relative to the water, m/s
 * @param groupSpeedOffshore Cg0 in the offshore depth of the wave, where there is no current, m/s
 * @param omega absolute frequency, rad/s
 */
double shoalingCoefficient(const RayPoint& point, const WaveSpeeds& speeds, double groupSpeedOffshore, double omega);

/**
 * Where the quantities of a ray field go: plain arrays with one entry a point, or `components` entries a point
 * where said, in the order of RayField::points. A null pointer: not wanted.
 */
struct RayQuantities
{
  double* position = nullptr;       ///< 3 components: x, y and the still-water level, m
  double* depth = nullptr;          ///< h, m
  double* phase = nullptr;          ///< S, rad
  double* travelTime = nullptr;     ///< s since launch
  double* wavenumber = nullptr;     ///< k, rad/m
  double* wavelength = nullptr;     ///< L = 2 pi/k, m
  double* phaseSpeed = nullptr;     ///< C = sigma/k, m/s, relative to the water
  double* groupSpeed = nullptr;     ///< Cg = n C, m/s, relative to the water
  double* direction = nullptr;      ///< 3 components: unit vector of the wavenumber, going to
  double* rayDirection = nullptr;   ///< 3 components: unit vector along the ray, going to
  double* current = nullptr;        ///< 3 components: U, m/s
  double* directionFrom = nullptr;  ///< of the wavenumber, nautical degrees, 0 to 360
  double* krSpacing = nullptr;      ///< Kr from the neighbouring rays; NaN without a neighbour
  double* krTube = nullptr;         ///< Kr from the ray tube; infinite at a caustic, NaN where there is no tube
  double* tubeWidth = nullptr;      ///< beta, signed
  double* shoaling = nullptr;       ///< Ks, of wave action on a current
  std::int32_t* caustics = nullptr; ///< caustics passed
  std::uint8_t* state = nullptr;    ///< RayState
  double* scale = nullptr;          ///< map length over true length, of `map`
  const MapScale* map = nullptr;    ///< on which the rays were traced; none: a plane
};

/**
 * Fill the wanted arrays from a traced field, point by point (formulas: Dispersion.h).
 * @param waterLevel m, positive up: the height at which the points lie
 * @throws std::invalid_argument on a bad wave
 */
void computeRayQuantities(const RayField& field, const IncidentWave& wave, double waterLevel,
  const RayQuantities& quantities, const Execution& execution = {});

}
