#include "sim/StraightPhase.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

constexpr double MostNodes = 1e8;

// Depth on land and next to it, m: lines go on behind an island.
constexpr double LeastDepth = 0.1;

}

StraightPhase::StraightPhase(const Seafloor& seafloor, const IncidentWave& wave, double waterLevel, double spacing)
  : Along(wave.direction())
  , Spacing(spacing)
{
  wave.validate();
  const Rectangle box = seafloor.bounds();
  const glm::dvec2 across(-this->Along.y, this->Along.x);
  glm::dvec2 low(1e300);
  glm::dvec2 high(-1e300);
  for (const glm::dvec2& corner :
    { box.low, box.high, glm::dvec2(box.low.x, box.high.y), glm::dvec2(box.high.x, box.low.y) })
  {
    const glm::dvec2 there(glm::dot(corner, this->Along), glm::dot(corner, across));
    low = glm::min(low, there);
    high = glm::max(high, there);
  }
  const glm::dvec2 nodes = (high - low) / spacing;
  if (!(spacing > 0.0) || !(nodes.x * nodes.y < MostNodes))
  {
    std::ostringstream message;
    message << "straight phase: a spacing of " << spacing << " m makes no grid of this scene; it must be above 0, and "
            << "leave fewer than a hundred million nodes";
    throw std::invalid_argument(message.str());
  }
  this->Origin = low;
  this->Columns = static_cast<std::size_t>(std::ceil(nodes.x)) + 2;
  this->Rows = static_cast<std::size_t>(std::ceil(nodes.y)) + 2;
  this->Phase.resize(this->Columns * this->Rows);
  const double omega = wave.angularFrequency();
  for (std::size_t row = 0; row < this->Rows; ++row)
  {
    double before = 0.0;
    double phase = 0.0;
    for (std::size_t column = 0; column < this->Columns; ++column)
    {
      const glm::dvec2 at = low + spacing * glm::dvec2(static_cast<double>(column), static_cast<double>(row));
      const glm::dvec2 place = glm::clamp(at.x * this->Along + at.y * across, box.low, box.high);
      const double depth = std::max(LeastDepth, waterLevel - seafloor.elevation(place));
      const double k = solveWavenumber(omega, depth, wave.gravity);
      phase += column > 0 ? 0.5 * (before + k) * spacing : 0.0;
      before = k;
      this->Phase[row * this->Columns + column] = phase;
    }
  }
}

double StraightPhase::at(const glm::dvec2& place) const
{
  const glm::dvec2 across(-this->Along.y, this->Along.x);
  const glm::dvec2 there =
    (glm::dvec2(glm::dot(place, this->Along), glm::dot(place, across)) - this->Origin) / this->Spacing;
  const double x = std::clamp(there.x, 0.0, static_cast<double>(this->Columns - 1));
  const double y = std::clamp(there.y, 0.0, static_cast<double>(this->Rows - 1));
  const std::size_t column = std::min(static_cast<std::size_t>(x), this->Columns - 2);
  const std::size_t row = std::min(static_cast<std::size_t>(y), this->Rows - 2);
  const double u = x - static_cast<double>(column);
  const double v = y - static_cast<double>(row);
  const double* const node = this->Phase.data() + row * this->Columns + column;
  return (1.0 - v) * ((1.0 - u) * node[0] + u * node[1]) +
    v * ((1.0 - u) * node[this->Columns] + u * node[this->Columns + 1]);
}

PeacheySea::PeacheySea(const Seafloor& seafloor, const std::vector<PeacheyWave>& waves, double waterLevel,
  double spacing, const PeacheySection::Parameters& parameters)
  : Bed(seafloor)
  , WaterLevel(waterLevel)
  , Section(parameters)
{
  if (waves.empty())
  {
    throw std::invalid_argument("a sea of Peachey needs one wave or more");
  }
  for (const PeacheyWave& each : waves)
  {
    this->Components.push_back({ each.wave.angularFrequency(), each.wave.height, each.phase, each.wave.gravity,
      StraightPhase(seafloor, each.wave, waterLevel, spacing) });
    this->Amplitudes += 0.5 * each.wave.height;
  }
}

double PeacheySea::height(const glm::dvec2& place, double time) const
{
  const double depth = this->WaterLevel - this->Bed.elevation(place);
  if (!(depth > 0.0))
  {
    return 0.0;
  }
  const double lowered = std::min(1.0, depth / (PeacheySection::HighestOfProfile * this->Amplitudes));
  double sum = 0.0;
  for (const Component& component : this->Components)
  {
    const double phase = component.grid.at(place) + component.phase - component.omega * time;
    SectionPlace at;
    at.phase = phase - 2.0 * Pi * std::round(phase / (2.0 * Pi));
    at.height = lowered * component.height;
    at.wavenumber = solveWavenumber(component.omega, depth, component.gravity);
    at.depth = depth;
    sum += this->Section.at({}, at).up;
  }
  return sum;
}

}
