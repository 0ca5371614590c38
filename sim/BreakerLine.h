#pragma once

#include "sim/Crests.h"
#include "sim/IncidentWave.h"
#include "sim/Seafloor.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swellray
{

/** Rays with their heights as plain arrays, as they lie in a ray file: one entry a point unless said otherwise. */
struct BreakerRays
{
  std::size_t rays = 0;
  const Obstacles* obstacles = nullptr;        ///< no line goes on across them; null: none
  const std::int64_t* offsets = nullptr;       ///< rays + 1 entries into the point arrays
  const double* launchParameter = nullptr;     ///< a ray, m
  const std::int32_t* launchSegment = nullptr; ///< a ray
  const double* positions = nullptr;           ///< x, y, z a point, m
  const double* scale = nullptr;               ///< length on the map of the Earth over true length; null: 1
  const double* direction = nullptr;           ///< 3 components, unit vector the wave goes to
  const double* depth = nullptr;               ///< m
  const double* wavenumber = nullptr;          ///< rad/m
  const double* groupSpeed = nullptr;          ///< m/s
  const double* shoaling = nullptr;            ///< Ks
  const double* refraction = nullptr;          ///< Kr in use
  const double* height = nullptr;              ///< m
  const double* breakingDistance = nullptr;    ///< m, 0 where the wave is not broken
  const std::uint8_t* breaking = nullptr;      ///< 1 where the wave is broken
};

/** The wave that the heights belong to. */
struct BreakerSea
{
  IncidentWave wave;
  bool random = false; ///< heights are root mean square heights of a sea (ofRandomWaves())
};

/** Where waves begin to break: points offsets[i] to offsets[i + 1] - 1 form line i, in the order of lambda. */
struct BreakerLines
{
  std::vector<std::size_t> offsets{ 0 };
  std::vector<std::int32_t> number; ///< a line: 1 where the wave breaks first along its rays, 2 the second time, ...

  // One entry a point. Slopes and contours are those of the seafloor at the point.
  std::vector<RayPlace> places;
  std::vector<double> height; ///< Hb, m
  std::vector<double> depth;  ///< hb, m
  std::vector<double> angle;  ///< from the way up the bed to that of the wave, anticlockwise, rad; NaN on a flat bed
  std::vector<double> iribarrenOffshore;    ///< xi_0 of the slope and the height in deep water
  std::vector<double> iribarrenBreaking;    ///< xi_b of the slope and Hb
  std::vector<std::uint8_t> type;           ///< BreakerType by xi_0
  std::vector<std::uint8_t> typeAtBreaking; ///< BreakerType by xi_b
  std::vector<double> peelAngle;            ///< between crest and breaker line, rad, 0 (closes out) to pi/2
  std::vector<double> vortexRatio;          ///< Mead and Black 2001; NaN out of its range
  std::vector<double> setDown;              ///< at breaking, m
  std::vector<double> setUp;                ///< at the still-water line, m
  std::vector<double> maximumSetUp;         ///< m
  std::vector<double> longshoreFlux;        ///< P_ls, W/m, positive to the left looking up the bed
  std::vector<double> longshoreTransport;   ///< m3/s of sand, signed alike
};

/**
 * Lines of breaking over neighbouring rays. A wave that broke already where its ray began has no place on them. A line
 * ends at a ray that does not break, between launch segments, and where neighbours are further apart than maxGap (m; 0:
 * no limit); rays that begin inside the surf zone are passed over. A place alone makes no line.
 *
 * The height is that of the wave as it arrives: from the last unbroken point on by Ks Kr, linear between points; of
 * random waves linear between the heights. The peel angle is that of Walker 1974 (Recreational surf parameters, Look
 * Lab. TR 30) and Mead and Black 2001, the line's direction by central differences. The other quantities: Breaking.h,
 * SurfZone.h; longshore flux with Hs = sqrt 2 Hrms of random waves, otherwise with the height taken for Hs.
 * @throws std::invalid_argument on a bad wave
 */
BreakerLines extractBreakerLines(
  const BreakerRays& rays, const Seafloor& seafloor, const BreakerSea& sea, double maxGap);

}
