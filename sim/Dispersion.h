#pragma once

#include "sim/Angles.h"
#include "sim/IncidentWave.h"

#include <cmath>

namespace swellray
{

/**
 * Linear waves over a depth h without a current:
 *
 *   omega^2 = g k tanh(k h)                                          (1)
 *   C = omega/k,  Cg = n C,  n = (1 + 2kh/sinh(2kh))/2               (2)
 *
 * (Dean and Dalrymple 1991, Water Wave Mechanics for Engineers and Scientists, eqs. 3.34, 4.80.)
 * Units: m, s, rad. The functions that do not say otherwise throw nothing and give NaN for NaN.
 */

/**
 * Wavenumber that solves (1), rad/m, to 1e-14 relative.
 * @param omega angular frequency, rad/s, finite, > 0
 * @param depth h, m, > 0; infinity: omega^2/g
 * @param gravity m/s2, finite, > 0
 * @throws std::invalid_argument where an argument is out of range
 */
double solveWavenumber(double omega, double depth, double gravity = StandardGravity);

struct WaveSpeeds
{
  double phaseSpeed; ///< C, m/s
  double groupSpeed; ///< Cg, m/s
  double groupRatio; ///< n = Cg/C, 1/2 (deep) to 1 (shallow)
};

/**
 * Speeds (2) of a wave that satisfies (1); finite for any kh.
 * @param wavenumber k, rad/m, > 0
 * @param depth h, m, > 0, infinity allowed
 */
WaveSpeeds waveSpeeds(double wavenumber, double depth, double gravity = StandardGravity);

/** Wavelength, m, of a wavenumber, rad/m, > 0; also the other way round. */
inline double wavelengthOf(double wavenumber)
{
  return 2.0 * Pi / wavenumber;
}

/** Shoaling coefficient Ks = sqrt(Cg0/Cg), of two group speeds in m/s, > 0. */
inline double shoalingCoefficient(double groupSpeedOffshore, double groupSpeed)
{
  return std::sqrt(groupSpeedOffshore / groupSpeed);
}

/** sigma(k, h) = sqrt(g k tanh(k h)) and its derivatives by k and h, for the Hamiltonian ray equations. */
struct Frequency
{
  double sigma; ///< rad/s
  double k;     ///< d sigma/dk: the group speed, m/s
  double h;     ///< d sigma/dh, 1/(m s); at constant sigma dk/dh is -h/k
  double kk;    ///< second derivatives: m2/s
  double kh;    ///< 1/s
  double hh;    ///< 1/(m2 s)
};

/**
 * Evaluate sigma and its derivatives to about 1e-15 relative for any k h, down to 0 (kh and kk to rounding of their
 * largest term).
 *
 * With q = k h, T = tanh q, s = 1 - T^2, a = g/(4 T sigma) the derivatives of sqrt(g k T) are
 *
 *   sigma_k  = 2 a T (T + q s)                 sigma_h = 2 a T k^2 s
 *   sigma_kk = -a ((T - q s)^2 + 4 q^2 T^2 s)/k
 *   sigma_kh =  a k s (3T - q - 3 q T^2)       sigma_hh = -a k^3 s (1 + 3 T^2)
 *
 * in which no large terms cancel, neither in deep nor in shallow water.
 *
 * @param k wavenumber, rad/m, > 0
 * @param h depth, m, > 0, finite
 */
inline void evaluateFrequency(double k, double h, double gravity, Frequency& frequency)
{
  const double q = k * h;
  double T;
  double s;
  if (q > 0.25)
  {
    const double e = std::exp(-2.0 * q);
    const double inverse = 1.0 / (1.0 + e);
    T = (1.0 - e) * inverse;
    s = 4.0 * e * inverse * inverse;
  }
  else
  {
    // 1 - e would lose digits. Sixth convergent of Lambert's continued fraction: error q^12/1.4e9, 4e-17 at 0.25.
    const double q2 = q * q;
    T = q * (10395.0 + q2 * (1260.0 + q2 * 21.0)) / (10395.0 + q2 * (4725.0 + q2 * (210.0 + q2)));
    s = 1.0 - T * T;
  }
  const double T2 = T * T;
  const double qs = q * s;
  const double sigma = std::sqrt(gravity * k * T);
  const double a = 0.25 * gravity / (T * sigma);
  const double difference = T - qs;
  const double ks = k * s;
  frequency.sigma = sigma;
  frequency.k = 2.0 * a * T * (T + qs);
  frequency.h = 2.0 * a * T * k * ks;
  frequency.kk = -a * (difference * difference + 4.0 * q * qs * T2) / k;
  frequency.kh = a * ks * (3.0 * T - q - 3.0 * q * T2);
  frequency.hh = -a * k * k * ks * (1.0 + 3.0 * T2);
}

}
