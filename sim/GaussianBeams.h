#pragma once

#include "sim/Execution.h"
#include "sim/RaySheets.h"

#include <complex>
#include <cstddef>
#include <vector>

namespace swellray
{

/** The wave that beams make at a place. */
struct BeamShare
{
  std::complex<double> wave; ///< m; its phase is that of the sheets
  double weight = 0.0;       ///< 0 to 1: share that it has against sheets and strips
  glm::dvec2 wavenumber{ 0.0 };
};

/** A cusp of a caustic, or a focus. */
struct BeamFocus
{
  glm::dvec2 position{ 0.0 };        ///< m
  glm::dvec2 along{ 0.0 };           ///< unit vector of the ray in its midst
  double phase = 0.0;                ///< S, rad
  double length = 0.0;               ///< way over which the rays close to it, |d beta/ds|^-1, m, on the map of the rays
  std::complex<double> spread = 0.0; ///< M of the beams there, 1/m2
};

/**
 * The wave around cusps and foci, where more than two rays meet: the integral over all rays of a family
 *
 *   u(x) = integral of A ((M q - p)/(2 pi i))^(1/2) exp(i (S + M n^2/2)) d lambda,
 *
 * n being the distance of x from the ray at its foot there, q = beta and p = k d beta/ds the tube of the ray, A the
 * height of a tube of width 1, and the root continuous along the ray, so that a caustic turns its phase by pi/2. By
 * stationary phase it is the sum of rays where tubes are wide, for any M with Im M > 0; M q - p vanishes nowhere, whatever
 * the caustic. (Popov 1982, Wave Motion 4, 85-97; Klimes 1984, Geophys. J. R. astr. Soc. 79, 105-118; for M real, Maslov
 * and Fedoriuk 1981.)
 *
 * M is not that of beams which came with the rays from offshore, but is chosen at the focus, so that all of them are
 * narrow there at once, and spreads from it as in water of level ground:
 *
 *   M0 = (0.3 + 0.7 i) k |d beta/ds|,   1/M = 1/M0 + tau,   tau = integral of dS/k^2
 *
 * along the ray from the phase of the focus;
 *
 * with several foci the mean of their M by weights (1 + (d/L)^2)^-3, d the distance from each, L = |d beta/ds|^-1. The
 * factors are those with the least errors over five round shoals (docs/theory.md).
 *
 * They have the place of sheets and strips within 5 L of a focus, and by a smooth step down to 8 L a share; on the way
 * to the focus, where no caustic has been touched, only from 0.6 L before it on, and a share from 1.2 L on. Rays that
 * leave the scene go on straight beyond it. Where rays end or have no neighbour, and where walls stand, the ends of the
 * family would ring, and where neighbours are too far apart the sum is not the integral: there the beams give way to
 * the sheets. There are none around foci on a current, nor where L is below a wavelength.
 */
class GaussianBeams
{
public:
  /** Out to so many lengths of a focus its beams have a share. */
  static constexpr double Farthest = 8.0;

  /** @param sheets with caustics; must outlive this */
  explicit GaussianBeams(const RaySheets& sheets, const Execution& execution = {});

  const std::vector<BeamFocus>& foci() const { return this->Foci; }

  bool empty() const { return this->Segments.empty(); }

  /** The share that beams have by the way of a place from the foci, 0 to 1. */
  double reach(const glm::dvec2& place) const;

  /**
   * The waves at places in a row along x.
   * @param first x of place 0 and y of all, m
   * @param step distance of the places, m, > 0; anything for one
   * @param shares one a place; BeamShare::weight tells on entry which are wanted (0: not)
   */
  void addRow(const glm::dvec2& first, double step, std::size_t count, BeamShare* shares) const;

private:
  friend class BeamBuilder;

  /** What holds at a point of a ray. */
  struct Point
  {
    glm::dvec2 position{ 0.0 };
    glm::dvec2 along{ 0.0 }; // unit vector
    double phase = 0.0;
    double wavenumber = 0.0;              // true, rad/m
    double scale = 1.0;                   // of the map
    double width = 0.0;                   // half, out to where nothing is left, on the map
    double end = 0.0;                     // 0 to 1: the family of rays ends here
    double coarse = 0.0;                  // 0 to 1: error of the sum over rays so far apart
    std::complex<double> spread = 0.0;    // M
    std::complex<double> amplitude = 0.0; // with the share of lambda that is the ray's
  };

  /** Between two points of a ray. */
  struct Segment
  {
    std::size_t first = 0;
    double length = 0.0;
    Rectangle box;
  };

  struct Sum;

  void add(const Segment& segment, const glm::dvec2& place, Sum& sum) const;

  const RaySheets& Sheets;
  std::vector<BeamFocus> Foci;
  std::vector<Point> Points;
  std::vector<Segment> Segments; // ordered by ray and along it
};

}
