#include "sim/RayEquations.h"

#include <cmath>

namespace swellray::rayequations
{

void addCurrent(const Current& current, const State& y, State& rate, Local& local)
{
  CurrentSample c;
  current.evaluate(glm::dvec2(y[X], y[Y]), c);
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

}
