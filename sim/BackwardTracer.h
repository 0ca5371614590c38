#pragma once

#include "sim/Current.h"
#include "sim/IncidentWave.h"
#include "sim/LaunchLine.h"
#include "sim/MapScale.h"
#include "sim/RayField.h"
#include "sim/Seafloor.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace swellray
{

/** Bottom friction coefficient of swell over sand in Hasselmann et al. 1973 (JONSWAP), m2/s3. */
constexpr double JonswapFriction = 0.038;

struct BackwardOptions
{
  double waterLevel = 0.0; ///< m, positive up
  double gravity = StandardGravity;
  double tolerance = 1e-5;                                        ///< relative, per step, > 0, at most 0.1
  double agroundDepth = 0.1;                                      ///< a ray ends where it is shallower, m, > 0
  double offshoreDepth = std::numeric_limits<double>::infinity(); ///< depth in which offshore waves are given, m
  EdgeRule edge = EdgeRule::Contours;
  std::optional<double> shoreNormal;    ///< nautical degrees, seaward normal of the contours
  const Current* current = nullptr;     ///< must outlive the tracer; none: still water
  const Obstacles* obstacles = nullptr; ///< must outlive the tracer; none: nothing stands in the water
  const MapScale* map = nullptr; ///< of the Earth, whose metres those of the seafloor are (RayMedium); must outlive the
                                 ///< tracer; none: a plane
  double friction = 0.0;         ///< m2/s3, >= 0; 0: none
  std::size_t maxSteps = 100000; ///< of a ray: it is taken to come from nowhere then

  /** @throws std::invalid_argument naming what is out of range */
  void validate() const;
};

/** Where the wave at a place came from. */
struct WaveOrigin
{
  double heading =
    std::numeric_limits<double>::quiet_NaN(); ///< offshore, going to, rad; NaN: no offshore wave gets here
  double gain = 0.0;                          ///< E(f, heading) at the place over E(f, heading) offshore
  double travelTime = 0.0;                    ///< from the edge of the scene, s
  glm::dvec2 edge{ 0.0 };                ///< where the ray came in, m; of a ray that came from nowhere its other end
  EndReason reason = EndReason::StepCap; ///< what ended the ray at its other end
  std::size_t steps = 0;                 ///< of the integrator
};

/**
 * Follows the waves at a place back to where they came from (Longuet-Higgins 1957, Proc. Camb. Phil. Soc. 53; O'Reilly
 * and Guza 1991, J. Waterway, Port, Coastal, Ocean Eng. 117).
 *
 * A ray of wavenumber k through a current U is that of -k through -U, run backwards. Along it the density of wave
 * action in the plane of wavenumbers stays what it was, and so
 *
 *   E(f, heading) (Cg + U.k/|k|)/(k sigma) = const;  without a current E(f, heading) C Cg = const.
 *
 * At the edge the launching rule (LaunchLine) is applied the other way round: the wavenumber along the contours is kept,
 * and no wave comes from offshore where it is larger than the wavenumber there.
 *
 * On a map of the Earth frequencies, headings (azimuths), depths and gains are true ones, and the invariant holds as it
 * stands: an element of the map and one of its wavenumbers are as large together as the true ones. The sea offshore has the same
 * spectrum of azimuths at every place of the edge.
 *
 * Bottom friction takes dE/dt = -c (sigma/(g sinh kh))^2 E along the ray (Hasselmann et al. 1973), c the coefficient.
 *
 * The seafloor must outlive the tracer. trace() may be called from several threads at once.
 */
class BackwardTracer
{
public:
  /** @throws std::invalid_argument; std::runtime_error where the current does not cover the seafloor */
  BackwardTracer(const Seafloor& seafloor, const BackwardOptions& options);
  ~BackwardTracer();

  const BackwardOptions& options() const { return this->Options; }

  /** Depth at a place, m; NaN in a hole and outside of the scene. */
  double depth(const glm::dvec2& place) const;

  /**
   * @param frequency absolute, Hz, > 0
   * @param heading of the wavenumber at the place, going to, rad
   */
  WaveOrigin trace(const glm::dvec2& place, double frequency, double heading) const;

  /**
   * The same, with the way of the wave in its own sense: from where it came in (or where its ray, followed back, ended)
   * to the place. Phase and time count from there; tubes have no width. Empty where no wave can be at the place.
   * @param stepsPerWave points a wavelength, > 0
   */
  WaveOrigin trace(
    const glm::dvec2& place, double frequency, double heading, double stepsPerWave, std::vector<RayPoint>& way) const;

private:
  WaveOrigin follow(
    const glm::dvec2& place, double frequency, double heading, double stepsPerWave, std::vector<RayPoint>* way) const;
  std::optional<glm::dvec2> normalAt(const glm::dvec2& edge) const;
  bool leavesData(const glm::dvec2& place) const;

  const Seafloor& Floor;
  BackwardOptions Options;
  std::optional<glm::dvec2> ContourNormal;
  std::vector<glm::dvec2> Outline; // clockwise
  std::unique_ptr<Current> Reversed;
};

}
