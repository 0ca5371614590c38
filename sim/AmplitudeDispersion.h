#pragma once

#include "sim/Dispersion.h"

namespace swellray
{

/** How the length of a wave depends on its height. */
enum class WaveDispersion
{
  Linear,    ///< not at all
  Nonlinear, ///< finiteAmplitudeWavenumber()
};

/**
 * Wavenumber of a wave of finite amplitude a,
 *
 *   omega^2 = g k (1 + f1 e^2 D) tanh(k h + f2 e),   e = k a
 *   D = (cosh 4kh + 8 - 2 tanh^2 kh)/(8 sinh^4 kh),  f1 = tanh^5 kh,  f2 = (kh/sinh kh)^4
 *
 * which is Stokes' of third order in deep water (f2 -> 0) and Hedges' (1976) solitary-like tanh(k (h + a)) in shallow
 * water, where Stokes' does not hold. Kirby and Dalrymple 1986, An approximate model for nonlinear dispersion in
 * monochromatic wave propagation models, Coastal Eng. 9, 545-561; Hedges 1976, Proc. ICE 61, 111-114.
 *
 * Right to 1e-12 relative. Between the wavenumber of linear waves (a = 0) and less.
 * @param omega rad/s, > 0
 * @param depth h, m, > 0
 * @param amplitude a, half the height, m, >= 0
 */
double finiteAmplitudeWavenumber(double omega, double depth, double amplitude, double gravity = StandardGravity);

}
