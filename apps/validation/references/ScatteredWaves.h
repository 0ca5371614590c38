#pragma once

#include <complex>
#include <functional>
#include <vector>

/** Exact wave fields of linear waves around simple things: they share no code with the solvers of the library. */
namespace swellray::reference
{

/**
 * Plane wave exp(i k0 x) over a circular bed, by partial waves: the mild-slope equation
 * div(C Cg grad eta) + k^2 C Cg eta = 0, separated in polar coordinates, every order integrated outward (Runge and Kutta, order
 * 4, in ln r) to the rim and matched there to Bessel's functions. Right to about 1e-7.
 */
class PartialWaves
{
public:
  /**
   * @param depth of the radius, m; constant from the rim on
   * @param rim m
   * @param period s
   */
  PartialWaves(const std::function<double(double)>& depth, double rim, double period, double gravity);

  /** eta at x, y. */
  std::complex<double> at(double x, double y) const;

  double offshoreWavenumber() const { return this->K0; } ///< rad/m

private:
  struct Order
  {
    std::vector<double> value; ///< at equal steps of ln r
    std::vector<double> slope; ///< d/d ln r
    std::complex<double> inner;
    std::complex<double> outer;
  };

  double Rim;
  double K0 = 0.0;
  double LowestLog = 0.0;
  double Step = 0.0;
  std::vector<Order> Orders;
};

/**
 * Plane wave of unit amplitude and straight on against a thin rigid wall y = 0, x < 0: Sommerfeld's solution (1896) in Fresnel's
 * integrals (Penney and Price 1952). The wave runs to +y; where it would be without the wall it is exp(i k y).
 */
std::complex<double> halfPlaneWave(double k, double x, double y);

/**
 * Wave over straight contours that turns back at a fold: modulus of eta(x) of (p f')' + p (k^2 - ky^2) f = 0, p = C Cg, integrated from the
 * shadow (Runge and Kutta), scaled so that the incoming part at x = 0, told apart by its local form (p kx)^(-1/2), is 1.
 * @param depth of x, m
 * @param ky rad/m
 * @param shadow x in the shadow where the wave has died away, m
 * @param places x from 0 to `shadow`, ascending
 */
std::vector<double> foldedWave(const std::function<double(double)>& depth, double period, double gravity, double ky,
  double shadow, const std::vector<double>& places);

}
