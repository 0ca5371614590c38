#include "sim/WaveTracer.h"

#include "sim/Dispersion.h"
#include "sim/FrontMarch.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

// Waves across a scene beyond which phases lose their digits.
constexpr double MostWaves = 1e6;

// Share of the incident height at which a ray is aground.
constexpr double AgroundShare = 0.05;

std::string number(double value)
{
  std::string text = std::to_string(value);
  const std::size_t last = text.find_last_not_of('0');
  text.erase(text[last] == '.' ? last : last + 1);
  return text;
}

std::string shortNumber(double value)
{
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

void requirePositive(const char* name, double value, const char* unit)
{
  if (!(value > 0.0) || !std::isfinite(value))
  {
    throw std::invalid_argument(std::string(name) + " must be above 0" + unit + ", not " + number(value));
  }
}

}

void TraceOptions::validate() const
{
  if (!std::isfinite(this->waterLevel))
  {
    throw std::invalid_argument("water level must be a finite number of metres");
  }
  if (this->spacing)
  {
    requirePositive("spacing", *this->spacing, " m");
  }
  if (this->maxSpacing)
  {
    requirePositive("max spacing", *this->maxSpacing, " m");
  }
  if (this->stepsPerWave)
  {
    requirePositive("steps per wave", *this->stepsPerWave, "");
  }
  if (this->step)
  {
    requirePositive("step", *this->step, " m");
  }
  requirePositive("tolerance", this->tolerance, "");
  if (this->tolerance > 0.1)
  {
    throw std::invalid_argument("tolerance must be at most 0.1, not " + number(this->tolerance));
  }
  if (this->flatHeight && (!(*this->flatHeight >= 0.0) || !std::isfinite(*this->flatHeight)))
  {
    throw std::invalid_argument("flat height must be 0 m or above, not " + number(*this->flatHeight));
  }
  if (this->agroundDepth)
  {
    requirePositive("aground depth", *this->agroundDepth, " m");
  }
  if (this->shoreNormal && !std::isfinite(*this->shoreNormal))
  {
    throw std::invalid_argument("shore normal must be a finite number of degrees");
  }
  if (this->current && this->scheme == TraceScheme::Snell)
  {
    throw std::invalid_argument("the snell scheme knows no current: take the ode scheme, or no current");
  }
  if (this->map && this->scheme == TraceScheme::Snell)
  {
    throw std::invalid_argument("the snell scheme knows no ellipsoid: take the ode scheme, or the plane");
  }
  if (!this->launchLines.empty() && !this->launchPlaces.empty())
  {
    throw std::invalid_argument("rays start from lines or from points, not from both");
  }
  if (this->maxRays == 0 || this->maxFronts == 0 || this->maxPoints == 0)
  {
    throw std::invalid_argument("the caps on rays, fronts and points must be above 0");
  }
}

RayField traceWaves(
  const Seafloor& seafloor, const IncidentWave& wave, const TraceOptions& options, const Execution& execution)
{
  wave.validate();
  options.validate();
  const double wavelength = wavelengthOf(wave.wavenumber());
  const double diagonal = glm::length(seafloor.bounds().size());
  if (diagonal > MostWaves * wavelength)
  {
    throw std::invalid_argument("a wave of " + shortNumber(wavelength) + " m is too short for a scene of " +
      shortNumber(diagonal) + " m: the period must be longer, or the scene smaller");
  }
  RayMedium medium;
  medium.seafloor = &seafloor;
  medium.waterLevel = options.waterLevel;
  medium.gravity = wave.gravity;
  medium.angularFrequency = wave.angularFrequency();
  medium.agroundDepth = options.agroundDepth.value_or(AgroundShare * wave.height);
  medium.current = options.current;
  medium.obstacles = options.obstacles && !options.obstacles->empty() ? options.obstacles : nullptr;
  medium.map = options.map;
  if (medium.current)
  {
    requireCover(*medium.current, seafloor.bounds());
  }
  const LaunchLine line(seafloor, options.waterLevel, wave, medium.agroundDepth,
    { options.edge, options.shoreNormal, options.current, medium.obstacles, options.map, options.source,
      options.launchLines, options.launchPlaces });
  if (!(line.length() > 0.0))
  {
    throw std::runtime_error(options.source ? "the waves from this point come in nowhere over water: it must lie "
                                              "outside of the scene, over water between the two"
                                            : "a wave from " + number(wave.directionFrom) +
          " degrees comes in nowhere over water: choose another direction, crop or water level");
  }
  IncidentWave first = wave;
  first.directionFrom = line.directionFrom();
  RayField field = FrontMarch(medium, first, options, line, execution).run();
  field.directionFrom = line.directionFrom();
  field.sourceDistance = line.sourceDistance();
  return field;
}

}
