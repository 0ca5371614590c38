#pragma once

#include "sim/Current.h"
#include "sim/Execution.h"
#include "sim/IncidentWave.h"
#include "sim/LaunchLine.h"
#include "sim/Obstacles.h"
#include "sim/RayField.h"
#include "sim/Seafloor.h"
#include "sim/WaveSource.h"

#include <optional>

namespace swellray
{

enum class TraceScheme
{
  Ode,   ///< adaptive Dormand-Prince 5(4) integration of the ray equations
  Snell, ///< Gonzato and Le Saec 1997: Snell's law across each step of fixed length
};

enum class InsertionRule
{
  None,        ///< no oversampling (Ts'o and Barsky 1987)
  Retrace,     ///< trace the new ray afresh from the launch line: exact
  Interpolate, ///< start it midway between its neighbours (Gonzato and Le Saec 1997)
};

struct TraceOptions
{
  double waterLevel = 0.0;            ///< m, positive up
  std::optional<double> spacing;      ///< launch spacing along the incident crest, m, > 0
  std::optional<double> maxSpacing;   ///< insertion threshold, m, > 0; 1.5 times the spacing
  std::optional<double> stepsPerWave; ///< fronts a wavelength, > 0; 8, or fewer in a scene of very many points
  std::optional<double> step;         ///< fronts of equal length instead of equal phase, m, > 0
  TraceScheme scheme = TraceScheme::Ode;
  double tolerance = 1e-8; ///< relative, per step, > 0
  InsertionRule insertion = InsertionRule::Retrace;
  bool leeRays = true;                ///< model diffraction into the lee by inserted rays
  std::optional<double> flatHeight;   ///< height below which a ray is FLAT, m, >= 0; a tenth of the incident height
  std::optional<double> agroundDepth; ///< depth at which a ray is aground, m, > 0; 5 % of the incident height
  EdgeRule edge = EdgeRule::Contours;
  std::optional<double> shoreNormal;    ///< nautical degrees, seaward normal of the contours
  const Current* current = nullptr;     ///< must outlive the trace; none: still water
  const Obstacles* obstacles = nullptr; ///< must outlive the trace; none: nothing stands in the water
  const MapScale* map = nullptr; ///< of the Earth, whose metres those of the seafloor are (RayMedium); none: a plane
  const WaveSource* source =
    nullptr; ///< a point that the wave comes from, in place of its direction; must outlive the trace
  std::vector<std::vector<glm::dvec2>>
    launchLines;                         ///< poly-lines within the scene where rays start, m; none: its edges
  std::vector<LaunchPlace> launchPlaces; ///< points where rays start; none: as the lines say
  std::size_t maxReflections = 10;       ///< of one wave by obstacles
  std::size_t maxRays = 200000;
  std::size_t maxFronts = 100000;
  std::size_t maxPoints = 40000000; ///< in all rays together: some gigabytes

  /** @throws std::invalid_argument naming the option that is out of range */
  void validate() const;
};

/**
 * Dynamic wave tracing (Gonzato and Le Saec 1997) with Hamiltonian rays:
 * all rays advance together from front to front.
 *
 * A ray that meets an obstacle ends there. Where that reflects, and the reflected wave is higher than 1 % of the incident
 * one, it goes on as a new ray whose parent is the one that was stopped. Reflected rays are launched by the wall: those
 * of neighbours that met the same obstacle are neighbours, in a launch segment of their own.
 *
 * The result is ordered by ray and identical for any loop in `execution`.
 * @throws std::invalid_argument bad wave or option; std::runtime_error where the wave comes in nowhere over water, or
 *   the current does not cover the seafloor
 */
RayField traceWaves(
  const Seafloor& seafloor, const IncidentWave& wave, const TraceOptions& options, const Execution& execution = {});

}
