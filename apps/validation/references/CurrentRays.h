#pragma once

#include "ReferenceSolutions.h"

#include "sim/Current.h"

/**
 * Rays of waves of absolute period T on steady currents over a flat bed, by what each current keeps: quadratures in long
 * double. Heights follow from the flux of wave action (Bretherton and Garrett 1968). Places have a width, a wavenumber and a
 * height over that at the start.
 */
namespace swellray::reference
{

/** A current by its formula, with the derivatives that a Jet brings. */
class FormulaCurrent final : public Current
{
public:
  using Component = std::function<Jet(const Jet& x, const Jet& y)>;

  FormulaCurrent(Component u, Component v, double featureLength);

  double featureLength() const override { return this->FeatureLength; }
  void evaluate(const glm::dvec2& p, CurrentSample& sample) const override;

private:
  Component U;
  Component V;
  double FeatureLength;
};

/** What the water is like. */
struct CurrentScene
{
  double period = 10.0;  ///< absolute, s
  double depth = 4000.0; ///< m; tanh kh is 1 to the last digit unless set
};

/**
 * Wavenumber of sigma(k) + k u = omega that carries energy along, u the current along the wave, by Newton's method from
 * still water (sigma is concave, so that every step stays on one side of the root).
 */
Real wavenumberOnCurrent(const CurrentScene& scene, Real u);

/** Shear jet V = V0 exp(-(x/w)^2) along y: ky, omega and the flux of action along x are kept. */
class JetRay
{
public:
  /**
   * @param from x of the start, m, y there 0; before the jet, x < 0
   * @param angle of the wavenumber at the start, degrees from +x
   */
  JetRay(const CurrentScene& scene, double speed, double width, double from, double angle);

  bool turns() const { return this->Turns; }
  /** Where the ray turns back, m. */
  double turning() const { return static_cast<double>(this->Turning); }
  /** Heading of the ray at the start, rad. */
  double heading() const;

  /** Place at x, on the way to it from the start or, where the ray turns, back again; tube of rays moved along y. */
  Place at(Real x, bool back = false) const;

private:
  struct Rates
  {
    Real k;
    Real kx;
    Real sigma;
    Real group;
    Real vx;
    Real vy;
  };

  Real current(Real x) const;
  Rates rates(Real x) const;
  std::array<Real, 4> way(Real x) const;

  CurrentScene Scene;
  Real Omega;
  Real Speed;
  Real Width;
  Real From;
  Real Ky = 0.0L;
  bool Turns = false;
  Real Turning = 0.0L;
};

/** Eddy U_phi = U0 (r/R) exp((1 - r^2/R^2)/2): omega and the angular momentum x ky - y kx are kept. */
class EddyRay
{
public:
  /** Start at (from, b), from < 0, b != 0, the wavenumber along +x. */
  EddyRay(const CurrentScene& scene, double speed, double radius, double from, double b);

  /**
   * Place by the way w, r = nearest + w^2, negative before the ray is nearest to the centre and positive behind; tube of
   * rays that start at other b, by differences.
   */
  Place at(Real w) const;

  /** w at the start, below 0. */
  Real start() const { return -std::sqrt(std::hypot(this->From, this->B) - this->Nearest); }

private:
  struct Rates
  {
    Real k;
    Real kr;
    Real kphi;
    Real sigma;
    Real group;
    Real rotation; // U_phi/r
  };

  EddyRay moved(double by) const;
  Rates rates(Real r) const;
  std::array<Real, 4> way(Real w) const;
  Place place(Real w) const;

  CurrentScene Scene;
  Real Omega;
  Real Speed;
  Real Radius;
  Real From;
  Real B;
  Real Momentum = 0.0L;
  Real Nearest = 0.0L;
};

/**
 * Current along +x and the wave, U = U1 (1 + tanh((x - middle)/width))/2, upwelling making up for what the water lacks:
 * omega is kept. In deep water H/H0 = sqrt(c0^2/(c (c + 2U))), c = c0 (1 + sqrt(1 + 4U/c0))/2 (Longuet-Higgins and
 * Stewart 1961).
 */
class CollinearRay
{
public:
  CollinearRay(const CurrentScene& scene, double speed, double middle, double width, double from);

  double current(double x) const;
  FormulaCurrent formula() const;
  Place at(Real x) const;

private:
  CurrentScene Scene;
  Real Speed;
  Real Middle;
  Real Width;
  Real From;
};

}
