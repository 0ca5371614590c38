#pragma once

#include <complex>
#include <vector>

namespace swellray
{

/**
 * Distribution of directions from its first two Fourier moments, as a buoy measures them, by maximum entropy (Lygre and
 * Krogstad 1986, J. Phys. Oceanogr. 16, eq. 13). It is above 0 everywhere and has just these moments.
 */
class MaximumEntropySpreading
{
public:
  /**
   * @param r1 length of the first moment, 0 to below 1
   * @param angle1 its direction, rad
   * @param r2 length of the second moment, 0 to below 1
   * @param angle2 its direction, rad (the moment is r2 exp(2 i angle2))
   * @throws std::invalid_argument where no distribution has such moments
   */
  MaximumEntropySpreading(double r1, double angle1, double r2, double angle2);

  /** 1/rad. @param angle rad */
  double density(double angle) const;

  /** Shares of equal bins around these middles, which lie equally spaced around the circle; their sum is 1. */
  std::vector<double> shares(const std::vector<double>& middles) const;

private:
  std::complex<double> First;
  std::complex<double> Second;
  double Scale = 1.0;
};

}
