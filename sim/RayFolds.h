#pragma once

#include "sim/RayCaustic.h"

#include <cstddef>
#include <vector>

namespace swellray
{

/**
 * The fold caustics along one ray, seen from its points. Half the phase between the two branches of a fold is
 *
 *   half = K kappa^2 sigma^3/3,  sigma = (ds/dS)_c kc^2 |integral of dS/k^2 from the place touched|
 *
 * (index c: at the place touched). sigma is the way from there, stretched so that the formula is exact all along the
 * rays of a plane fold, where k^2 is linear across the caustic; else it holds near the caustic, and far from it all that
 * follows is next to 1 anyway. kappa is rounded at cusps (roundedCurvature).
 */
class RayFolds
{
public:
  /**
   * @param caustics of this ray; those without neighbours, and foci (foldPeak above 10), are left out
   * @param phase S at the points, rad, increasing
   * @param wavenumber k at the points, rad/m
   * @param beside half the phase of a fold that goes beside the ray (foldsBeside), a point, rad; null: none
   */
  RayFolds(const RayCaustic* caustics, std::size_t count, const double* phase, const double* wavenumber,
    std::size_t points, const double* beside = nullptr);

  bool empty() const { return this->Folds.empty() && this->Beside.empty(); }

  /** Half the phase between the branches of the nearest fold that the ray touches, at a point, rad; infinite without one. */
  double half(std::size_t point) const;

  /** Largest refraction coefficient on a fold (foldPeak); 0 without one. */
  double highestPeak() const { return this->HighestPeak; }

  /**
   * Share of the tube's own width that is to be taken at a point, against that from the spacing of rays: 1 within 0.5
   * rad of half phase of a fold, where the two must vanish at the same place, smoothly down to 0 beyond 3 rad.
   */
  double tubeShare(std::size_t point) const;

  /**
   * Refraction coefficient at a point: |width|^(-1/2) with the foldModulus() of all folds; finite where one is touched. A fold
   * beside the ray takes away no more than what the way towards it has added: it leaves 1.
   */
  double refraction(std::size_t point, double width) const;

private:
  struct Fold
  {
    double peak = 0.0;
    std::vector<double> half; // a point
  };

  std::vector<Fold> Folds;
  std::vector<double> Beside; // half a point; empty: none
  double HighestPeak = 0.0;
};

}
