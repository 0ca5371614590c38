#pragma once

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

}
