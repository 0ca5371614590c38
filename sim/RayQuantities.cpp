#include "sim/RayQuantities.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace swellray
{

namespace
{

template <typename T>
void put(T* array, std::size_t i, T value)
{
  if (array)
  {
    array[i] = value;
  }
}

void putVector(double* array, std::size_t i, const glm::dvec2& v, double z)
{
  if (array)
  {
    array[3 * i] = v.x;
    array[3 * i + 1] = v.y;
    array[3 * i + 2] = z;
  }
}

}

double shoalingCoefficient(const RayPoint& point, const WaveSpeeds& speeds, double groupSpeedOffshore, double omega)
{
  if (point.current == glm::dvec2(0.0))
  {
    return shoalingCoefficient(groupSpeedOffshore, speeds.groupSpeed); // sigma is omega
  }
  const double k = glm::length(point.wavenumber);
  const double raySpeed = glm::length(speeds.groupSpeed / k * point.wavenumber + point.current);
  return std::sqrt(speeds.phaseSpeed * k * groupSpeedOffshore / (omega * raySpeed));
}

double refractionCoefficient(double widthRatio)
{
  return 1.0 / std::sqrt(std::abs(widthRatio));
}

void computeRayQuantities(const RayField& field, const IncidentWave& wave, double waterLevel,
  const RayQuantities& quantities, const Execution& execution)
{
  wave.validate();
  const double groupSpeedOffshore = wave.groupSpeed();
  const double omega = wave.angularFrequency();
  execution.forRange(field.points.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const RayPoint& point = field.points[i];
        const double k = glm::length(point.wavenumber);
        const WaveSpeeds speeds = waveSpeeds(k, point.depth, wave.gravity);
        putVector(quantities.position, i, point.position, waterLevel);
        putVector(quantities.direction, i, point.wavenumber / k, 0.0);
        putVector(quantities.rayDirection, i, point.rayDirection, 0.0);
        putVector(quantities.current, i, point.current, 0.0);
        put(quantities.depth, i, point.depth);
        put(quantities.phase, i, point.phase);
        put(quantities.travelTime, i, point.travelTime);
        put(quantities.wavenumber, i, k);
        put(quantities.wavelength, i, wavelengthOf(k));
        put(quantities.phaseSpeed, i, speeds.phaseSpeed);
        put(quantities.groupSpeed, i, speeds.groupSpeed);
        put(quantities.directionFrom, i, nauticalFromVector(point.wavenumber));
        put(quantities.krSpacing, i, refractionCoefficient(point.spacingWidth));
        put(quantities.krTube, i, refractionCoefficient(point.tubeWidth));
        put(quantities.tubeWidth, i, point.tubeWidth);
        put(quantities.shoaling, i, shoalingCoefficient(point, speeds, groupSpeedOffshore, omega));
        put(quantities.caustics, i, point.caustics);
        put(quantities.state, i, static_cast<std::uint8_t>(point.state));
        if (quantities.scale)
        {
          quantities.scale[i] = quantities.map ? quantities.map->scale(point.position) : 1.0;
        }
      }
    });
}

}
