#pragma once

#include "sim/Dispersion.h"
#include "sim/RayPath.h"

#include <array>
#include <cmath>

namespace swellray
{

/**
 * Hamiltonian ray equations of Omega(x, k) = sigma(|k|, h(x)) + k.U(x) with their variational equations.
 *
 *   dx/dt = Cg k/|k| + U,   dk/dt = -sigma_h grad h - (grad U).k                             (1)
 *   d(dx)/dt =  Omega_kk dk + Omega_kx dx,   d(dk)/dt = -Omega_xx dx - Omega_xk dk           (2)
 *   dS/dt = k.dx/dt,   ds/dt = |dx/dt|                                                       (3)
 *
 * dx, dk: derivatives of position and wavenumber by the launch parameter at equal time. The signed width
 * of the ray tube is n.dx, n the left normal of the ray, which on a current is not that of k. Whitham (1974),
 * Linear and Nonlinear Waves, section 11.5; with a current Bretherton and Garrett (1968), Proc. R. Soc. A 302; the
 * variational system as in Cerveny (2001), Seismic Ray Theory, section 4.2.
 *
 * On a conformal map of scale m(x) of the Earth, K = k/m being the wavenumber on the map, they are the same equations of
 *
 *   Omega(x, K) = sigma(m |K|, h(x)) + m K.U(x),   ds/dt = |dx/dt|/m                         (4)
 */
namespace rayequations
{

/** Components of the state. */
enum Component : std::size_t
{
  X,
  Y,
  Kx,
  Ky,
  DX,
  DY,
  DKx,
  DKy,
  Phase,
  Length,
  Size,
};

using State = std::array<double, Size>;

/** What an evaluation finds on its way. */
struct Local
{
  double depth = 0.0;
  Frequency frequency{}; ///< on a map its derivatives by the wavenumber are those by the wavenumber on the map
  double doppler = 0.0;  ///< k.U, rad/s
  double scale = 1.0;    ///< of the map
};

/** Add what the current does to the rates of change. Apart, so that still water does not pay for it. */
void addCurrent(const Current& current, const State& y, State& rate, Local& local);

/** evaluate() on a map of the Earth. Apart, so that a plane does not pay for it. */
bool evaluateOnMap(
  const RayMedium& medium, unsigned region, double dryDepth, const State& y, State& rate, Local& local);

/**
 * Rates of change of the state by time.
 * @return false, with rates untouched, where the depth is not above dryDepth
 */
inline bool evaluate(
  const RayMedium& medium, unsigned region, double dryDepth, const State& y, State& rate, Local& local)
{
  if (medium.map)
  {
    return evaluateOnMap(medium, region, dryDepth, y, rate, local);
  }
  BedSample bed;
  medium.seafloor->evaluate(glm::dvec2(y[X], y[Y]), region, bed);
  const double depth = medium.waterLevel - bed.elevation;
  if (!(depth > dryDepth))
  {
    return false;
  }
  local.depth = depth;
  const double k = std::sqrt(y[Kx] * y[Kx] + y[Ky] * y[Ky]);
  Frequency& f = local.frequency;
  evaluateFrequency(k, depth, medium.gravity, f);

  // Depth grows as the elevation falls.
  const double hx = -bed.gradient.x;
  const double hy = -bed.gradient.y;
  const double inverse = 1.0 / k;
  const double ux = y[Kx] * inverse;
  const double uy = y[Ky] * inverse;

  rate[X] = f.k * ux;
  rate[Y] = f.k * uy;
  rate[Kx] = -f.h * hx;
  rate[Ky] = -f.h * hy;

  const double across = f.k * inverse;
  const double kkxx = f.kk * ux * ux + across * uy * uy;
  const double kkxy = (f.kk - across) * ux * uy;
  const double kkyy = f.kk * uy * uy + across * ux * ux;
  const double dh = hx * y[DX] + hy * y[DY];
  const double dk = ux * y[DKx] + uy * y[DKy];
  rate[DX] = kkxx * y[DKx] + kkxy * y[DKy] + f.kh * ux * dh;
  rate[DY] = kkxy * y[DKx] + kkyy * y[DKy] + f.kh * uy * dh;
  const double alongBed = f.hh * dh + f.kh * dk;
  rate[DKx] = -(alongBed * hx - f.h * (bed.xx * y[DX] + bed.xy * y[DY]));
  rate[DKy] = -(alongBed * hy - f.h * (bed.xy * y[DX] + bed.yy * y[DY]));

  rate[Phase] = k * f.k;
  rate[Length] = f.k;
  if (medium.current)
  {
    addCurrent(*medium.current, y, rate, local);
  }
  return true;
}

/** Signed width of the ray tube: left normal of the ray, of the unit vector `direction`, times dx. */
inline double tubeWidth(const State& y, const glm::dvec2& direction)
{
  return direction.x * y[DY] - direction.y * y[DX];
}

/** Speed of the energy along the wavenumber over the group speed: 1 without a current. */
inline double speedShare(const State& y, const State& rate, const Frequency& frequency)
{
  return rate[Phase] / (std::hypot(y[Kx], y[Ky]) * frequency.k);
}

}

}
