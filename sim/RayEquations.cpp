#include "sim/RayEquations.h"

#include <cmath>

namespace swellray::rayequations
{

namespace
{

void addFlow(const CurrentSample& c, const State& y, State& rate, Local& local)
{
  const auto alongWave = [&y](const glm::dvec2& u) { return y[Kx] * u.x + y[Ky] * u.y; };
  rate[X] += c.velocity.x;
  rate[Y] += c.velocity.y;
  rate[Kx] -= alongWave(c.dx);
  rate[Ky] -= alongWave(c.dy);
  rate[DX] += c.dx.x * y[DX] + c.dy.x * y[DY];
  rate[DY] += c.dx.y * y[DX] + c.dy.y * y[DY];
  const double mixed = alongWave(c.dxy);
  rate[DKx] -= alongWave(c.dxx) * y[DX] + mixed * y[DY] + c.dx.x * y[DKx] + c.dx.y * y[DKy];
  rate[DKy] -= mixed * y[DX] + alongWave(c.dyy) * y[DY] + c.dy.x * y[DKx] + c.dy.y * y[DKy];
  local.doppler = alongWave(c.velocity);
  rate[Phase] += local.doppler;
  rate[Length] = std::sqrt(rate[X] * rate[X] + rate[Y] * rate[Y]);
}

/** The current in metres of the map a second, m U. */
CurrentSample onMap(const CurrentSample& c, const ScaleSample& m)
{
  CurrentSample u;
  u.velocity = m.scale * c.velocity;
  u.dx = m.gradient.x * c.velocity + m.scale * c.dx;
  u.dy = m.gradient.y * c.velocity + m.scale * c.dy;
  u.dxx = m.xx * c.velocity + 2.0 * m.gradient.x * c.dx + m.scale * c.dxx;
  u.dxy = m.xy * c.velocity + m.gradient.x * c.dy + m.gradient.y * c.dx + m.scale * c.dxy;
  u.dyy = m.yy * c.velocity + 2.0 * m.gradient.y * c.dy + m.scale * c.dyy;
  return u;
}

}

void addCurrent(const Current& current, const State& y, State& rate, Local& local)
{
  CurrentSample c;
  current.evaluate(glm::dvec2(y[X], y[Y]), c);
  addFlow(c, y, rate, local);
}

bool evaluateOnMap(const RayMedium& medium, unsigned region, double dryDepth, const State& y, State& rate, Local& local)
{
  const glm::dvec2 place(y[X], y[Y]);
  BedSample bed;
  medium.seafloor->evaluate(place, region, bed);
  const double depth = medium.waterLevel - bed.elevation;
  if (!(depth > dryDepth))
  {
    return false;
  }
  ScaleSample m;
  medium.map->evaluate(place, m);
  local.depth = depth;
  local.scale = m.scale;
  const double size = std::sqrt(y[Kx] * y[Kx] + y[Ky] * y[Ky]); // K
  Frequency& f = local.frequency;
  evaluateFrequency(m.scale * size, depth, medium.gravity, f);
  const double speed = f.k; // Cg
  // Derivatives by K, and by m.
  const double mk = f.kk * size * m.scale + f.k; // d2 sigma/dK dm
  const double mm = f.kk * size * size;
  const double mh = f.kh * size;
  const double slope = f.k * size; // d sigma/dm
  f.k *= m.scale;
  f.kk *= m.scale * m.scale;
  f.kh *= m.scale;

  const double hx = -bed.gradient.x;
  const double hy = -bed.gradient.y;
  const double inverse = 1.0 / size;
  const double ux = y[Kx] * inverse;
  const double uy = y[Ky] * inverse;
  rate[X] = f.k * ux;
  rate[Y] = f.k * uy;
  rate[Kx] = -(f.h * hx + slope * m.gradient.x);
  rate[Ky] = -(f.h * hy + slope * m.gradient.y);

  const double across = f.k * inverse;
  const double kkxx = f.kk * ux * ux + across * uy * uy;
  const double kkxy = (f.kk - across) * ux * uy;
  const double kkyy = f.kk * uy * uy + across * ux * ux;
  const double dh = hx * y[DX] + hy * y[DY];
  const double dm = m.gradient.x * y[DX] + m.gradient.y * y[DY];
  const double dk = ux * y[DKx] + uy * y[DKy];
  const double faster = f.kh * dh + mk * dm;
  rate[DX] = kkxx * y[DKx] + kkxy * y[DKy] + faster * ux;
  rate[DY] = kkxy * y[DKx] + kkyy * y[DKy] + faster * uy;
  const double alongBed = f.hh * dh + mh * dm + f.kh * dk;
  const double alongScale = mh * dh + mm * dm + mk * dk;
  rate[DKx] = -(alongBed * hx - f.h * (bed.xx * y[DX] + bed.xy * y[DY]) + alongScale * m.gradient.x +
    slope * (m.xx * y[DX] + m.xy * y[DY]));
  rate[DKy] = -(alongBed * hy - f.h * (bed.xy * y[DX] + bed.yy * y[DY]) + alongScale * m.gradient.y +
    slope * (m.xy * y[DX] + m.yy * y[DY]));

  rate[Phase] = size * f.k;
  rate[Length] = speed;
  if (medium.current)
  {
    CurrentSample c;
    medium.current->evaluate(place, c);
    addFlow(onMap(c, m), y, rate, local);
    rate[Length] /= m.scale;
  }
  return true;
}

}
