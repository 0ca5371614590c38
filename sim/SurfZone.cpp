#include "sim/SurfZone.h"

#include <cmath>
#include <limits>

namespace swellray
{

double setDown(double height, double depth, double wavenumber)
{
  return -height * height * wavenumber / (8.0 * std::sinh(2.0 * wavenumber * depth));
}

WaveSetUp waveSetUp(double height, double depth, double wavenumber)
{
  const double gamma = height / depth;
  const double rise = 1.0 / (1.0 + 8.0 / (3.0 * gamma * gamma));
  const double atLine = setDown(height, depth, wavenumber) + rise * depth;
  return { atLine, atLine / (1.0 - rise) };
}

double longshoreEnergyFlux(double significantHeight, double groupSpeed, double angle, double gravity)
{
  return SeaWaterDensity * gravity * significantHeight * significantHeight * groupSpeed * std::sin(2.0 * angle) / 16.0;
}

double longshoreTransport(double longshoreFlux, double gravity)
{
  constexpr double Coefficient = 0.39;
  constexpr double SandDensity = 2650.0; // quartz, kg/m3
  constexpr double Porosity = 0.4;
  return Coefficient * longshoreFlux / ((SandDensity - SeaWaterDensity) * gravity * (1.0 - Porosity));
}

double vortexRatio(double slope)
{
  constexpr double Steepest = 1.0 / 8.0;
  constexpr double Flattest = 1.0 / 40.0;
  return slope >= Flattest && slope <= Steepest ? vortexRatioLine(slope) : std::numeric_limits<double>::quiet_NaN();
}

double vortexRatioLine(double slope)
{
  return 0.065 / slope + 0.821;
}

}
