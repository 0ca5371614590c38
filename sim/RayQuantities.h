#pragma once

#include "sim/Execution.h"
#include "sim/IncidentWave.h"
#include "sim/RayField.h"

#include <cstdint>

namespace swellray
{

/** Refraction coefficient Kr = sqrt(b0/b) of a width ratio b/b0 (signed: beta); infinite at 0, NaN for NaN. */
double refractionCoefficient(double widthRatio);

/**
 * Where the quantities of a ray field go: plain arrays with one entry a point, or `components` entries a point
 * where said, in the order of RayField::points. A null pointer: not wanted.
 */
struct RayQuantities
{
  double* position = nullptr;     ///< 3 components: x, y and the still-water level, m
  double* depth = nullptr;        ///< h, m
  double* phase = nullptr;        ///< S, rad
  double* travelTime = nullptr;   ///< s since launch
  double* wavenumber = nullptr;   ///< k, rad/m
  double* wavelength = nullptr;   ///< L = 2 pi/k, m
  double* phaseSpeed = nullptr;   ///< C = sigma/k, m/s, relative to the water
  double* groupSpeed = nullptr;   ///< Cg = n C, m/s, relative to the water
  double* direction = nullptr;    ///< 3 components: unit vector of the wavenumber, going to
  double* rayDirection = nullptr; ///< 3 components: unit vector along the ray, going to
  double* directionFrom = nullptr; ///< of the wavenumber, nautical degrees, 0 to 360
  double* krSpacing = nullptr;    ///< Kr from the neighbouring rays; NaN without a neighbour
  double* krTube = nullptr;       ///< Kr from the ray tube; infinite at a caustic, NaN where there is no tube
  double* tubeWidth = nullptr;    ///< beta, signed
  double* shoaling = nullptr;     ///< Ks = sqrt(Cg0/Cg), Cg0 in the offshore depth of the wave
  std::int32_t* caustics = nullptr; ///< caustics passed
  std::uint8_t* state = nullptr;  ///< RayState
};

/**
 * Fill the wanted arrays from a traced field, point by point (formulas: Dispersion.h).
 * @param waterLevel m, positive up: the height at which the points lie
 * @throws std::invalid_argument on a bad wave
 */
void computeRayQuantities(const RayField& field, const IncidentWave& wave, double waterLevel,
  const RayQuantities& quantities, const Execution& execution = {});

}
