#pragma once

#include "sim/DirectionalSpreading.h"
#include "sim/Execution.h"
#include "sim/FrequencySpectrum.h"
#include "sim/SeaTurbulence.h"
#include "sim/TrochoidTable.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace swellray
{

struct SeaSurfaceOptions
{
  std::size_t components = 256; ///< waves drawn one by one, 1 to 4096
  double sharpness = 1.0;       ///< factor on the steepness that shapes them, >= 0; 0: cosines
  bool turbulence = true;       ///< the shorter ones as noise; otherwise they are missing and the others higher
  std::optional<double> tile;   ///< side of the square over which the surface repeats, m; none: it never does
  double depth = std::numeric_limits<double>::infinity(); ///< m, > 0
  double gravity = StandardGravity;
  unsigned seed = 1;

  /** @throws std::invalid_argument naming what is out of range */
  void validate() const;
};

/** One wave of a sea. */
struct SeaComponent
{
  double amplitude = 0.0;       ///< m
  glm::dvec2 wavenumber{ 0.0 }; ///< rad/m, where it goes to
  double frequency = 0.0;       ///< omega, rad/s
  double phase = 0.0;           ///< rad
  double steepness = 0.0;       ///< k r of its trochoid
  double wavelength = 0.0;      ///< m
};

/**
 * Surface of a sea (Thon, Dischler and Ghazanfarpour 2000, eq. 10):
 *
 *   h(x, y, t) = sum of A_i v(k_i.x - omega_i t + phi_i) + turbulence
 *
 * The spectrum is sampled in a matrix of 64 x 64 wavenumbers, each with the energy of its cell and a wavenumber somewhere in
 * it (for a tile: its middle, and more cells where the tile holds many waves). Those of greatest amplitude become trochoids v;
 * fmax is the highest frequency among them. What is shorter is turbulence of the same level and slope at fmax. Below fmax the
 * turbulence has some energy too: that is taken off the cells there, and what is left of those that were not chosen goes to
 * the nearest wavenumber that was, so that the spectrum as a whole is that asked for. Last, the trochoids are scaled so
 * that Hs is (by some percent).
 *
 * A function of place and time: any place, any time, any detail. Waves that a footprint does not resolve are left out
 * smoothly, which is what antialiasing is here. All members may be called from several threads at once.
 */
class SeaSurface
{
public:
  /**
   * @param heading where the sea goes to, rad
   * @throws std::invalid_argument; so where a tile is too small for the waves, or so large that it would take more than
   * 1024 x 1024 cells
   */
  SeaSurface(const FrequencySpectrum& spectrum, const DirectionalSpreading& spreading, double heading,
    const SeaSurfaceOptions& options);
  ~SeaSurface();

  /** Height above the mean level, m. @param footprint size of what cannot be told apart, m, >= 0 */
  double height(const glm::dvec2& place, double time, double footprint = 0.0) const;

  /** Unit normal, up, by differences over the footprint or a centimetre. */
  glm::dvec3 normal(const glm::dvec2& place, double time, double footprint = 0.0) const;

  /**
   * Where a ray first meets the surface: by steps that no slope but the very rarest makes too long, then by halving.
   * @param direction unit
   * @param pixel angle of what cannot be told apart, rad: the footprint grows with the distance
   * @return distance along the ray, m; none up to `farthest`
   */
  std::optional<double> march(
    const glm::dvec3& origin, const glm::dvec3& direction, double time, double farthest, double pixel) const;

  const std::vector<SeaComponent>& components() const { return this->Components; }
  const SeaTurbulence* turbulence() const { return this->Turbulence.get(); }
  double highestFrequency() const { return this->HighestFrequency; } ///< fmax, Hz
  double meanSquare() const { return this->MeanSquare; }             ///< m0, m2
  double peakPeriod() const { return this->PeakPeriod; }             ///< s

private:
  struct Cell;
  std::vector<Cell> sampleCells(const FrequencySpectrum& spectrum, const DirectionalSpreading& spreading,
    double heading, const SeaSurfaceOptions& options) const;
  double wavenumberAt(double frequency) const;
  double frequencyAt(double wavenumber) const; // Hz

  TrochoidTable Profile;
  std::vector<SeaComponent> Components;
  std::unique_ptr<SeaTurbulence> Turbulence;
  double Depth = 0.0;
  double Gravity = 0.0;
  double HighestFrequency = 0.0;
  double MeanSquare = 0.0;
  double PeakPeriod = 0.0;
  double Slope = 0.0; // rms of its components and the longer turbulence
};

/**
 * The surface on a grid, without the waves that it does not resolve.
 * @param corner south-west point, m
 * @param spacing of the points, m, > 0
 * @param heights columns x rows, m, south row first
 * @param normals unit, up, 3 a point, by differences of the heights; null: not wanted
 */
void sampleSea(const SeaSurface& surface, const glm::dvec2& corner, double spacing, std::size_t columns,
  std::size_t rows, double time, double* heights, float* normals, const Execution& execution = {});

}
