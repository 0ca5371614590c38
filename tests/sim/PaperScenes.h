#pragma once

#include "sim/WaveTracer.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

/** Small scenes of dynamic wave tracing, and what is counted in them. */
namespace swellray::test
{

// 100 m x 100 m scenes after section 3.4 of Gonzato and Le Saec 1997: a ray a metre, fronts every 0.4 m.
constexpr const char* SteepIsland = "island:slope=0.2,shore-radius=12,toe-radius=20,xc=-15,x0=-50,y0=-50,x1=50,y1=50";

inline IncidentWave smallWave(double directionFrom)
{
  IncidentWave wave;
  wave.period = 4.0;
  wave.height = 0.5;
  wave.directionFrom = directionFrom;
  return wave;
}

inline TraceOptions paperOptions()
{
  TraceOptions options;
  options.spacing = 1.0;
  options.maxSpacing = 1.2;
  options.step = 0.4;
  return options;
}

inline std::size_t countRays(const RayField& field, bool (*wanted)(const RayInfo&))
{
  return static_cast<std::size_t>(std::count_if(field.rays.begin(), field.rays.end(), wanted));
}

inline bool isInserted(const RayInfo& ray)
{
  return ray.parent >= 0;
}

inline bool isLee(const RayInfo& ray)
{
  return ray.lee;
}

// Rays of each front, in the order of lambda.
inline std::map<std::uint32_t, std::vector<std::pair<double, const RayPoint*>>> frontsOf(const RayField& field)
{
  std::map<std::uint32_t, std::vector<std::pair<double, const RayPoint*>>> fronts;
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    for (std::size_t j = field.offsets[i]; j < field.offsets[i + 1]; ++j)
    {
      if (field.points[j].front != BetweenFronts)
      {
        fronts[field.points[j].front].emplace_back(field.rays[i].launchParameter, &field.points[j]);
      }
    }
  }
  for (auto& [front, places] : fronts)
  {
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  return fronts;
}

}
