#pragma once

namespace swellray
{

/** Airy's function Ai(x) and its derivative. */
struct AiryValue
{
  double value = 0.0;
  double slope = 0.0;
};

/**
 * By its power series within 1 of 0, else by Bessel functions of order 1/3 and 2/3 (Abramowitz and Stegun 1964, eqs.
 * 10.4.2, 10.4.14 to 10.4.17). Relative to the modulus (Ai^2 + Bi^2)^(1/2), and to Ai itself where x > 0, right to 1e-12
 * for |x| up to 100.
 */
AiryValue airy(double x);

}
