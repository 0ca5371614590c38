#pragma once

#include "Jet.h"

#include "sim/Seafloor.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

/**
 * Solutions for rays of linear waves that share nothing with the library but its Seafloor interface: quadratures in long
 * double, and the ray-tube equation of Munk and Arthur in arc length.
 */
namespace swellray::reference
{

using Real = long double;

constexpr Real Gravity = 9.81L;
constexpr Real Pi = 3.14159265358979323846264338327950288L;

/** A place of a ray, and its tube there. */
struct Place
{
  double x = 0.0;      ///< m
  double y = 0.0;      ///< m
  double theta = 0.0;  ///< heading, rad, anticlockwise from +x
  double phase = 0.0;  ///< rad since the start
  double time = 0.0;   ///< s since the start
  double length = 0.0; ///< m since the start
  double width = 1.0;  ///< signed, over the width at the start
  int caustics = 0;    ///< passed since the start
  // Where there is a current; 0 in still water, where the depth and the width say both.
  double wavenumber = 0.0; ///< rad/m
  double height = 0.0;     ///< over that at the start
};

/** Wavenumber of omega^2 = g k tanh(k h) by Newton's method in long double, rad/m. */
Real wavenumber(Real omega, Real depth);

/** Group speed, m/s. */
Real groupSpeed(Real omega, Real depth);

/** Depth in which a wave has this wavenumber, h = atanh(k_inf/k)/k, m. */
Real depthOf(Real omega, Real k);

/** dk/dh at constant omega, rad/m2. */
Real wavenumberSlope(Real omega, Real depth);

/** Integral of each component by adaptive Gauss-Legendre quadrature; relative accuracy 1e-15. */
using Integrand = std::function<std::array<Real, 4>(Real)>;
std::array<Real, 4> integrate(const Integrand& f, Real from, Real to);

/**
 * Ray over straight contours: the depth is h(x) and waves run towards -x, starting at (x0, 0).
 *
 *   K = k sin theta const,  y = int tan theta dx,  S = int k/cos theta dx,  t = int dx/(Cg cos theta),
 *
 * theta from -x towards +y. Snell's law.
 */
class StraightRay
{
public:
  StraightRay(std::function<Real(Real)> depth, double omega, double x0, double theta0);

  /** Place at x < x0, in a tube of parallel rays: width cos theta/cos theta0. */
  Place at(double x) const;

  /** Width at x of the tube of rays that leave (x0, 0) at all angles, m a radian of theta0. */
  double fanWidth(double x) const;

private:
  std::function<Real(Real)> Depth;
  Real Omega;
  Real X0;
  Real Along; // K
};

/**
 * Ray over circular contours around the origin: depth h(r), start at (x0, b), x0 < 0, heading +x.
 * Bouguer's law k r sin(alpha) = M: with f = k^2 r^2 - M^2
 *
 *   phi = int M/(r sqrt f) dr,  s = int k r/sqrt f dr,  S = int k^2 r/sqrt f dr,  t = int k r/(Cg sqrt f) dr
 */
class CircularRay
{
public:
  /** @param kink radius at which h has a kink, m; 0 without one */
  CircularRay(std::function<Real(Real)> depth, double omega, double x0, double b, double kink = 0.0);

  /** Smallest radius, m; 0 where the ray runs into the centre. */
  double nearest() const { return static_cast<double>(this->Nearest); }

  /** Place where the ray is at this radius, on its way in or out again. Its width is not known. */
  Place at(double radius, bool outward) const;

private:
  std::array<Real, 4> way(Real radius) const;

  std::function<Real(Real)> Depth;
  Real Omega;
  Real X0;
  Real B;
  Real Kink;
  Real Momentum; // k b
  Real Nearest = 0.0L;
};

/** A seafloor by its formula. Bit i of a region is set where kink level i is positive. */
struct Formula
{
  std::function<Jet(const Jet& x, const Jet& y, unsigned region)> depth; ///< m, positive in water
  std::vector<std::function<Jet(const Jet& x, const Jet& y)>> kinks;

  unsigned region(double x, double y) const;
};

/** Depth in which a wave has the wavenumber given as a formula. */
Jet depthFormula(double omega, const Jet& k);

/** The Seafloor of a formula, water level 0. */
class FormulaSeafloor final : public Seafloor
{
public:
  FormulaSeafloor(Formula formula, const Rectangle& bounds, double featureLength);

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2& p, unsigned region, BedSample& bed) const override;
  double featureLength() const override { return this->FeatureLength; }
  double resolution() const override { return 0.1 * this->FeatureLength; }
  unsigned kinkCount() const override { return static_cast<unsigned>(this->Depth.kinks.size()); }
  double kinkLevel(unsigned i, const glm::dvec2& p, glm::dvec2& gradient) const override;

private:
  Formula Depth;
  Rectangle Bounds;
  double FeatureLength;
};

/**
 * Ray and tube by the equations of Munk and Arthur 1952 in arc length,
 *
 *   theta' = -C_n/C,  q' = C p,  p' = -(C_nn/C^2) q,
 *
 * n the left normal, by classical Runge-Kutta in equal steps; at a kink with normal nu along the ray p jumps by
 * -[C_nu] (n.nu)^2 q/(C^2 t.nu).
 * @param start its position and heading; q = 1, p = 0
 * @param lengths m travelled at the places wanted, increasing
 * @param step m, upper bound of the steps
 */
std::vector<Place> traceMunkArthur(
  const Formula& formula, double omega, const Place& start, const std::vector<double>& lengths, double step);

}
