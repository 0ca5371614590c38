#pragma once

#include <complex>
#include <functional>
#include <vector>

namespace swellray::reference
{

/**
 * A plane wave exp(i k0 x) of unit height over a seafloor that is round, within a radius, and flat around: the exact field
 * by partial waves,
 *
 *   u = sum over m of e_m i^m f_m(r) cos(m phi),   (r p f')'/r + (k^2 - m^2/r^2) p f = 0,   e_0 = 1, otherwise 2
 *
 * inside by Runge-Kutta steps of order 4 in ln r, outside f = J_m(k0 r) + b_m H_m(k0 r), f and p f' continuous. p = 1: the
 * equation of Helmholtz; p = C Cg: the mild-slope equation (Berkhoff 1972). To about 1e-6.
 */
class RoundWave
{
public:
  using Profile = std::function<double(double r)>;

  /** @param k rad/m, constant from `radius` on; @param p any unit, the same */
  RoundWave(const Profile& k, const Profile& p, double radius);

  std::complex<double> at(double x, double y) const;

private:
  struct Mode
  {
    std::complex<double> inside;  // factor of the profile
    std::complex<double> outside; // b
    std::vector<double> value;    // f at the steps, 1 at the radius
    std::vector<double> slope;    // by ln r
  };

  double Radius;
  double K0;
  double First;    // ln r of the first step
  double StepSize; // of ln r
  std::vector<Mode> Modes;
};

}
