#pragma once

#include "sim/RayMap.h"
#include "sim/WaveHeight.h"
#include "sim/WaveTracer.h"

namespace swellray::validation
{

/** Waves traced over a seafloor, with their heights, as the arrays of which maps are made. */
class TracedField
{
public:
  /** Heights are those without breaking, whatever the options say. */
  TracedField(const Seafloor& seafloor, const IncidentWave& wave, const TraceOptions& trace, HeightOptions options);

  const RayField& rays() const { return this->Field; }
  const std::vector<double>& heights() const { return this->Height; }

  /** Waves at places. */
  RayMap at(const std::vector<glm::dvec2>& places, CombineRule rule) const;

  /** Heights at places by the sum of the geometric waves of all sheets and nothing else. */
  std::vector<double> plainSum(const std::vector<glm::dvec2>& places) const;

private:
  SheetRays sheetRays() const;

  RayField Field;
  std::vector<std::int64_t> Offsets;
  std::vector<double> Position, Direction, Phase, Wavenumber, Refraction, Tube, Height, Lambda;
  std::vector<std::int32_t> Segment, Parent, Caustics;
  std::vector<std::uint8_t> Lee, End, Breaking, State;
};

}
