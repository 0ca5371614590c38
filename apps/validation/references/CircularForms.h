#pragma once

#include "ReferenceSolutions.h"

namespace swellray::reference
{

/** A circular shoal or island around the origin, by its formula and as a built-in form. */
struct CircularForm
{
  std::string spec;                                                ///< of the built-in form, without a scene
  std::function<Real(Real r)> depth;                               ///< m
  std::function<Jet(const Jet& square, unsigned region)> ofSquare; ///< the same, of r^2
  double rim = 0.0;     ///< radius of a kink beyond which the bed is flat, m; 0 without one
  double feature = 0.0; ///< length over which the bed changes, m

  /** The same for the equations of Munk and Arthur. */
  Formula formula() const;
};

/** h = h0 - a exp(-r^2/(2 sigma^2)). */
CircularForm gaussianShoal(double h0, double a, double sigma);

/** h = h0 - a (1 - r^2/R^2)^3 within R. */
CircularForm polynomialShoal(double h0, double a, double R);

/** h = s (r - rs) from the shore at rs to the toe at rt. */
CircularForm conicalIsland(double s, double rs, double rt);

/** h = h0 r^2/R^2 within R. */
CircularForm parabolicIsland(double h0, double R);

}
