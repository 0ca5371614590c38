#pragma once

#include "sim/AmplitudeDispersion.h"
#include "sim/Execution.h"
#include "sim/IncidentWave.h"
#include "sim/LaunchLine.h"
#include "sim/RayMap.h"
#include "sim/Seafloor.h"
#include "sim/WaveHeight.h"

#include <array>
#include <complex>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace swellray
{

/** Which mild-slope problem, and how finely. */
struct MildSlopeOptions
{
  std::optional<double> spacing;  ///< distance of the nodes, m, > 0; none: a tenth of the shortest wavelength
  std::optional<double> minDepth; ///< m, > 0; shallower is coast. None: half the depth in which H0 breaks
  EdgeRule edge = EdgeRule::Contours;
  std::optional<double> shoreNormal; ///< as LaunchLine has it
  bool sideWalls = false;            ///< the two sides along which the wave runs are walls
  double coastReflection = 0.0;      ///< amplitude of the reflected wave over that of the incident one, 0 to 1
  WaveDispersion dispersion = WaveDispersion::Linear;
  HeightOptions height; ///< breaking, gamma, friction and viscosity of these
  double memory = 0.0;  ///< bytes that may be taken; 0: any
  /**
   * What stands in the water of an element, a rectangle in m: the share of the height that it reflects, 0 to 1, or nothing. No wave passes it, be
   * it ever so thin. Empty: there is none. Called once an element, from the loop's threads.
   */
  std::function<std::optional<double>(const Rectangle&)> wall;

  /** @throws std::invalid_argument naming the option that is out of range */
  void validate() const;
};

/** Elements over each side of the scene, and thickness of the absorbing layers: west, east, south, north. */
struct MeshLayout
{
  std::size_t sceneColumns = 1;
  std::size_t sceneRows = 1;
  std::array<std::size_t, 4> padding{};
};

/** What a mild-slope solution will take, known before it is made. */
struct MildSlopePlan
{
  MeshLayout layout;
  std::size_t columns = 0;   ///< nodes along x, those of the absorbing layers included
  std::size_t rows = 0;      ///< along y
  glm::dvec2 spacing{ 0.0 }; ///< m
  double minDepth = 0.0;     ///< m
  double shortestWave = 0.0; ///< wavelength in the shallowest water, m
  double longestWave = 0.0;  ///< in the deepest, m
  double nodesPerWave = 0.0; ///< in that wavelength
  double bytes = 0.0;        ///< memory
  double seconds = 0.0;      ///< about, on one thread, for one solution
  std::size_t solutions = 1; ///< at most: more than one where breaking, friction or amplitude dispersion feed back

  double nodes() const { return static_cast<double>(columns) * static_cast<double>(rows); }
};

/**
 * Plan without solving.
 * @throws std::invalid_argument on a bad wave or option, where the spacing leaves fewer than 4 nodes a wavelength, or
 *   where more memory is needed than there may be: the message says which spacing or crop would do
 * @throws std::runtime_error where the scene has no water
 */
MildSlopePlan planMildSlope(
  const Seafloor& seafloor, double waterLevel, const IncidentWave& wave, const MildSlopeOptions& options);

/** The waves that a mild-slope solution has at places: one entry a place; NaN on land and outside of the scene. */
struct MildSlopeWaves
{
  std::vector<double> height;        ///< m
  std::vector<double> phase;         ///< rad, -pi to pi: a crest stands where phase = omega t + 2 pi n
  std::vector<double> directionFrom; ///< nautical degrees, of the phase's gradient
  std::vector<double> wavelength;    ///< m, of the depth (and the height, with nonlinear dispersion)
  std::vector<std::uint8_t> breaking;
};

class MildSlopeMesh;

/**
 * Complex surface eta of a wave field, Re(eta exp(-i omega t)), on the nodes of its mesh.
 */
class MildSlopeField
{
public:
  MildSlopeField();
  ~MildSlopeField();
  MildSlopeField(MildSlopeField&&) noexcept;
  MildSlopeField& operator=(MildSlopeField&&) noexcept;

  /** Waves at places, m. */
  MildSlopeWaves sample(const std::vector<glm::dvec2>& places, const Execution& execution = {}) const;

  /** Waves at the nodes of a grid, x fastest. @throws std::invalid_argument as mapRays */
  MildSlopeWaves sample(const MapGrid& grid, const Execution& execution = {}) const;

  /** eta at a place, m, H/2 in size; NaN where there is no water. */
  std::complex<double> surface(const glm::dvec2& place) const;

  bool cancelled() const { return this->Cancelled; }
  /** Solutions made: 1, or more where losses or the dispersion depend on the height. */
  std::size_t solutions() const { return this->Solutions; }
  /** Root mean square of the last change of the heights over that of the heights; 0 for one solution. */
  double change() const { return this->Change; }
  /** True where the change is below 1 in 500. */
  bool converged() const;
  /** Largest residual of the equations over the largest right side. */
  double residual() const { return this->Residual; }

private:
  friend MildSlopeField solveMildSlope(
    const Seafloor&, double, const IncidentWave&, const MildSlopeOptions&, const Execution&);

  struct Data;
  std::unique_ptr<Data> Kept;
  std::size_t Solutions = 0;
  double Change = 0.0;
  double Residual = 0.0;
  bool Cancelled = false;
};

/**
 * Waves of one period by the mild-slope equation of Berkhoff (1972), refraction and diffraction and reflection together:
 *
 *   div(C Cg grad eta) + (k^2 C Cg + i omega W) eta = 0
 *
 * W = D/E is the share of the energy that breaking and bottom friction take a second, found from the heights by
 * iteration, as is k where it depends on the amplitude.
 *
 * Elements of four nodes on a regular grid whose stiffness and mass have, for the local k, no numerical dispersion along
 * and across the grid and at 45 degrees, and the impedance of the wave (MildSlopeMesh). The incident wave comes in by the edges
 * as for rays; layers of complex coordinates around the scene (Berenger 1994) take what goes out and differs from it. Coasts and
 * walls: d eta/dn = i k (1 - R)/(1 + R) eta, R the reflection of a wave that comes straight on.
 *
 * The same for any number of threads.
 * @throws as planMildSlope, and std::runtime_error where the equations have no solution
 */
MildSlopeField solveMildSlope(const Seafloor& seafloor, double waterLevel, const IncidentWave& wave,
  const MildSlopeOptions& options, const Execution& execution = {});

}
