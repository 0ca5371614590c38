#include "sim/SurfaceSum.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

// A face this steep counts as no steeper.
constexpr double LeastRise = 1e-9;

// The normal of (x, y, z + f(x, y)) of that of (x, y, z) and that of z = f.
glm::dvec3 sheared(const glm::dvec3& normal, const glm::dvec3& wave)
{
  return { glm::dvec2(normal) + normal.z / std::max(wave.z, LeastRise) * glm::dvec2(wave), normal.z };
}

}

SurfaceSum::SurfaceSum(std::vector<const SurfaceFunction*> waves)
  : Waves(std::move(waves))
{
  if (this->Waves.empty())
  {
    throw std::invalid_argument("a sum of surfaces needs at least one");
  }
  this->WaterLevel = this->Waves.front()->waterLevel();
  for (const SurfaceFunction* wave : this->Waves)
  {
    if (wave->waterLevel() != this->WaterLevel)
    {
      throw std::invalid_argument(
        "waves of different water levels cannot be added: " + std::to_string(this->WaterLevel) + " and " +
        std::to_string(wave->waterLevel()) + " m; trace them at one level");
    }
  }
}

std::vector<SurfaceValue> SurfaceSum::at(const std::vector<glm::dvec2>& places, const std::vector<double>& times,
  const SurfaceMotion& motion, const Execution& execution) const
{
  std::vector<SurfaceValue> sum = this->Waves.front()->at(places, times, motion, execution);
  for (std::size_t w = 1; w < this->Waves.size(); ++w)
  {
    const std::vector<SurfaceValue> values = this->Waves[w]->at(places, times, motion, execution);
    for (std::size_t i = 0; i < sum.size(); ++i)
    {
      SurfaceValue& total = sum[i];
      const SurfaceValue& value = values[i];
      if (!total.covered || !value.covered)
      {
        total = total.covered ? total : value;
        continue;
      }
      total.elevation = std::max(total.elevation + value.elevation - this->WaterLevel, this->WaterLevel - total.depth);
      total.normal = glm::normalize(sheared(total.normal, value.normal));
      total.velocity += value.velocity;
      total.foam = std::max(total.foam, value.foam);
      total.breaking = total.breaking || value.breaking;
      total.sheets += value.sheets;
    }
  }
  return sum;
}

void SurfaceSum::addTo(const SurfaceArrays& arrays, std::size_t count, const double* spacing, double time,
  const SurfaceMotion& motion, const Execution& execution) const
{
  execution.forRange(count,
    [&](std::size_t begin, std::size_t end)
    {
      SurfaceMotion used = motion;
      for (std::size_t i = begin; i < end; ++i)
      {
        double* position = arrays.position + 3 * i;
        float* normal = arrays.normal + 3 * i;
        float* velocity = arrays.velocity + 3 * i;
        used.spacing = spacing[i];
        glm::dvec3 direction(normal[0], normal[1], normal[2]);
        double up = 0.0;
        for (const SurfaceFunction* wave : this->Waves)
        {
          const SurfaceValue value = wave->at({ position[0], position[1] }, time, used);
          if (!value.covered)
          {
            continue;
          }
          up += value.elevation - this->WaterLevel;
          direction = sheared(direction, value.normal);
          for (int c = 0; c < 3; ++c)
          {
            velocity[c] += static_cast<float>(value.velocity[c]);
          }
        }
        // What lies on the bed stays there.
        position[2] = std::max(position[2] + up, std::min(position[2], this->WaterLevel - arrays.depth[i]));
        const double size = glm::length(direction);
        for (int c = 0; c < 3 && size > 0.0; ++c)
        {
          normal[c] = static_cast<float>(direction[c] / size);
        }
      }
    });
}

void SurfaceSum::raise(
  std::vector<SprayParticle>& particles, double time, const SurfaceMotion& motion, const Execution& execution) const
{
  execution.forRange(particles.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        SprayParticle& particle = particles[i];
        // Nothing holds it back along the way.
        const glm::dvec2 start = glm::dvec2(particle.position) - particle.age * glm::dvec2(particle.velocity);
        for (const SurfaceFunction* wave : this->Waves)
        {
          const SurfaceValue value = wave->at(start, time - particle.age, motion);
          particle.position.z += value.covered ? value.elevation - this->WaterLevel : 0.0;
        }
      }
    });
}

std::vector<double> pointSpacing(const SurfaceSheet& sheet)
{
  std::vector<double> spacing(sheet.pointCount(), 0.0);
  for (const SurfaceSheet::Triangle& triangle : sheet.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto a = static_cast<std::size_t>(triangle[c]);
      const auto b = static_cast<std::size_t>(triangle[(c + 1) % 3]);
      const double apart = glm::distance(glm::dvec2(sheet.Position[3 * a], sheet.Position[3 * a + 1]),
        glm::dvec2(sheet.Position[3 * b], sheet.Position[3 * b + 1]));
      spacing[a] = std::max(spacing[a], apart);
      spacing[b] = std::max(spacing[b], apart);
    }
  }
  return spacing;
}

}
