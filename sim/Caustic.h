#pragma once

#include "sim/RayCaustic.h"

#include <complex>

namespace swellray
{

/** One of the two waves that meet at a fold caustic: a exp(i S), without the shift of phase at the caustic. */
struct FoldBranch
{
  double amplitude = 0.0; ///< geometric, any unit; finite
  double phase = 0.0;     ///< S, rad
};

/**
 * The sum of both branches of a fold caustic, uniform up to it:
 *
 *   u = sqrt(pi) exp(i (Sm - pi/4)) ((a1 + a2) z^(1/4) Ai(-z) - i (a1 - a2) z^(-1/4) Ai'(-z)),
 *   Sm = (S1 + S2)/2,   (2/3) z^(3/2) = (S2 - S1)/2
 *
 * (Kravtsov 1964; Ludwig 1966, Commun. Pure Appl. Math. 19, eq. 3.2.) Far from the caustic it is the sum of rays
 * a1 exp(i S1) + a2 exp(i (S2 - pi/2)), the rest falling with 1/(S2 - S1).
 *
 * @param before the branch that comes to the caustic
 * @param behind the branch that has touched it, with the longer phase
 * @return the sum of rays, where behind.phase is not the longer one
 */
std::complex<double> foldWave(const FoldBranch& before, const FoldBranch& behind);

/** What makes up both branches of a fold caustic together, smooth across it. */
struct FoldField
{
  double z = 0.0;          ///< (2/3) z^(3/2) is half the phase between the branches; negative on the dark side
  double sum = 0.0;        ///< (a1 + a2) z^(1/4)
  double difference = 0.0; ///< (a1 - a2) z^(-1/4)
  double middle = 0.0;     ///< Sm, rad
};

/** The same on both sides of a caustic, the dark one included. */
std::complex<double> foldWave(const FoldField& field);

/**
 * What a fold caustic leaves of the geometric amplitude of one branch: the modulus of the Airy function that turns into
 * that branch alone,
 *
 *   sqrt(pi) z^(1/4) (Ai(-z)^2 + Bi(-z)^2)^(1/2) = (pi half/2 (J(half)^2 + Y(half)^2))^(1/2),  half = (2/3) z^(3/2),
 *
 * J and Y of order 1/3 (Abramowitz and Stegun 1964, eqs. 10.4.15 to 10.4.20). Grows from 0 at the caustic, as z^(1/4), to
 * 1, to 1e-8 exact.
 * @param half half the phase between the branches, rad, >= 0
 */
double foldModulus(double half);

/**
 * Curvature of a caustic relative to a ray that touches it, 1/m, rounded at cusps:
 *
 *   kappa = (d beta/ds)/l1,  l1^4 = (dl/dlambda)^4 + c^4 (2 l2)^3 (2/(K (d beta/ds)^2)),  l2 = |d2l/dlambda2|
 *
 * Far from a cusp it is the caustic's own. On the cusp itself, where that is infinite, c = 0.1718 makes foldPeak() the
 * height of the wave there, Kr = Gamma(5/4) (2/pi)^(1/2) 24^(1/4) (K/l2)^(1/4) = 1.601 (K/l2)^(1/4) (the integral of Pearcey
 * 1946 at its origin, by stationary phase next to it).
 * @return not negative; NaN where the caustic has no neighbours
 */
double roundedCurvature(const RayCaustic& caustic);

/**
 * The finite refraction coefficient of one branch on a caustic: limit of foldModulus() |beta|^(-1/2) at the place touched,
 * 2 sqrt(pi) Ai(0) (K kappa^2/2)^(1/6) |d beta/ds|^(-1/2).
 * @param curvature kappa, 1/m, not 0
 */
double foldPeak(const RayCaustic& caustic, double curvature);

}
