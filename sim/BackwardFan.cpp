#include "sim/BackwardFan.h"

#include "sim/Angles.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace swellray
{

BackwardFan traceFan(const BackwardTracer& tracer, const glm::dvec2& place, double period, std::size_t count,
  double stepsPerWave, const Execution& execution)
{
  if (!(period > 0.0) || !std::isfinite(period))
  {
    throw std::invalid_argument("period must be above 0 s");
  }
  if (count == 0 || !(stepsPerWave > 0.0) || !std::isfinite(stepsPerWave))
  {
    throw std::invalid_argument("directions and steps a wave must be above 0");
  }
  BackwardFan fan;
  fan.headings.resize(count);
  fan.origins.resize(count);
  std::vector<std::vector<RayPoint>> ways(count);
  execution.forRange(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        fan.headings[i] = headingFromNautical(360.0 * static_cast<double>(i) / static_cast<double>(count));
        fan.origins[i] = tracer.trace(place, 1.0 / period, fan.headings[i], stepsPerWave, ways[i]);
      }
    });
  RayField& field = fan.field;
  field.stepsPerWave = stepsPerWave;
  for (std::size_t i = 0; i < count; ++i)
  {
    RayInfo info;
    info.endReason = fan.origins[i].reason;
    info.launchSegment = static_cast<std::int32_t>(i);
    field.rays.push_back(info);
    field.points.insert(field.points.end(), ways[i].begin(), ways[i].end());
    field.offsets.push_back(field.points.size());
  }
  if (field.points.empty())
  {
    std::ostringstream message;
    message << "no wave can be at the site, x " << place.x << ", y " << place.y
            << " m: it must lie within the scene and in water (depth there: " << tracer.depth(place) << " m)";
    throw std::invalid_argument(message.str());
  }
  return fan;
}

}
