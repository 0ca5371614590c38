#pragma once

#include "sim/IncidentWave.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <limits>
#include <optional>
#include <vector>

namespace swellray
{

/**
 * Spectrum of Perlin's noise (glm::perlin of three coordinates) on a plane of constant x, over wavenumber and all
 * directions. Noise is the sum of w(p - c) g.(p - c) over the corners c of the lattice, w a product of fades and g gradients
 * without correlation, so that its spectrum is the sum of the squares of the Fourier transforms of w(p) times x, y and z,
 * each times the mean square of that component of g. These are not alike: gradients lie more along z, and so do the
 * wavenumbers of the noise.
 */
class NoiseSpectrum
{
public:
  NoiseSpectrum();

  /** Density over the wavenumber, its integral 1. @param wavenumber rad a cell of the lattice, >= 0 */
  double density(double wavenumber) const;

  /** Share of the energy below a wavenumber. */
  double shareBelow(double wavenumber) const;

  /** Variance of the noise, measured. */
  static constexpr double Variance = 0.0846;

  /** Wavenumber of most energy, rad a cell. */
  static constexpr double Peak = 3.4;

private:
  std::vector<double> Density;
  std::vector<double> Below;
};

/** What the short waves of a sea are to be like. */
struct TurbulenceTarget
{
  double wavenumber = 1.0; ///< kmax of the waves that are drawn one by one, rad/m, > 0
  double level = 1.0;      ///< S(kmax), m3/rad, >= 0
  double slope = -3.0;     ///< d ln S/d ln k at kmax
  double heading = 0.0;    ///< where the sea goes to, rad
  double gravity = StandardGravity;
  double depth = std::numeric_limits<double>::infinity(); ///< m
  std::optional<double> tile;                             ///< the sum repeats over a square of this side, m
  unsigned seed = 1;
};

/**
 * Perlin's turbulence as the short waves of a sea (Thon, Dischler and Ghazanfarpour 2000, eq. 9 and 10):
 *
 *   A sum over i of Noise(P m^i)/m^i
 *
 * with m and A such that slope and level of its spectrum are those of the sea at kmax, which lies where the spectrum of the
 * first noise falls. Most of its waves lie along the sea's direction (the z of the noise). Each noise moves through its
 * lattice at the phase speed of its own waves, with the sea and along the third axis: then its mean square frequency at a
 * place is about that of free waves.
 */
class SeaTurbulence
{
public:
  /** @throws std::invalid_argument */
  explicit SeaTurbulence(const TurbulenceTarget& target);

  double multiplier() const { return this->Multiplier; } ///< m
  double amplitude() const { return this->Amplitude; }   ///< A, m

  /** Its spectrum over wavenumber, m3/rad. */
  double density(double wavenumber) const;

  /** Mean square, m2: of all, or of what is shorter than a wavenumber. */
  double variance() const;
  double varianceAbove(double wavenumber) const;

  /** Height, m. @param footprint size of what cannot be told apart, m: waves shorter than twice that are left out */
  double height(const glm::dvec2& place, double time, double footprint) const;

private:
  struct Octave
  {
    double scale = 1.0;          // cells of the lattice a metre
    double weight = 1.0;         // m
    double cells = 0.0;          // of a tile; 0: it does not repeat
    double speed = 0.0;          // m/s
    glm::dvec2 main{ 1.0, 0.0 }; // axis of the lattice along which most waves go, unit
    glm::dvec3 offset{ 0.0 };
  };

  double rawDensity(double scaled) const;

  NoiseSpectrum Noise;
  double Multiplier = 2.0;
  double Amplitude = 0.0;
  double Cell = 1.0; // cells of the first lattice a metre
  glm::dvec2 Along{ 1.0, 0.0 };
  std::vector<Octave> Octaves;
};

/** Weight of a wave by its length where the footprint is so large: 1 above four footprints, 0 below two, smooth between. */
double footprintWeight(double wavelength, double footprint);

}
