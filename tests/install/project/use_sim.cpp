#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <cmath>
#include <cstdio>

// A 10 s wave in 10 m of water must satisfy the dispersion relation.
int main()
{
  const double omega = 2.0 * swellray::Pi / 10.0;
  const double depth = 10.0;
  const double k = swellray::solveWavenumber(omega, depth);
  const double residual = swellray::StandardGravity * k * std::tanh(k * depth) / (omega * omega) - 1.0;
  std::printf("wavelength %.3f m, residual %.1e\n", swellray::wavelengthOf(k), residual);
  return std::abs(residual) < 1e-12 ? 0 : 1;
}
