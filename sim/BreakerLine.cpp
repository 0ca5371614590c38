#include "sim/BreakerLine.h"

#include "sim/Breaking.h"
#include "sim/SurfZone.h"
#include "sim/WaveHeight.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace swellray
{

namespace
{

// A distance that is that of the points but for rounding began at the first of them.
constexpr double Rounding = 1e-9;

glm::dvec2 vectorAt(const double* values, const RayPlace& place)
{
  const double* a = values + 3 * place.point;
  return glm::dvec2(a[0], a[1]) + place.weight * glm::dvec2(a[3] - a[0], a[4] - a[1]);
}

double valueAt(const double* values, const RayPlace& place)
{
  const double a = values[place.point];
  return place.weight == 0.0 ? a : a + place.weight * (values[place.point + 1] - a);
}

double scaleAt(const BreakerRays& rays, std::int64_t point)
{
  return rays.scale ? rays.scale[point] : 1.0;
}

// Places at which a ray begins to break, in its order.
std::vector<RayPlace> onsetsOf(const BreakerRays& rays, std::size_t ray)
{
  std::vector<RayPlace> onsets;
  for (std::int64_t i = rays.offsets[ray] + 1; i < rays.offsets[ray + 1]; ++i)
  {
    const double distance = rays.breakingDistance[i];
    if (rays.breaking[i] == 0 || !(distance > 0.0))
    {
      continue;
    }
    const double* const a = rays.positions + 3 * (i - 1);
    // As heights are marched (WaveHeight).
    const double length = std::hypot(a[3] - a[0], a[4] - a[1]) / std::sqrt(scaleAt(rays, i - 1) * scaleAt(rays, i));
    if (rays.breaking[i - 1] == 0 || distance < length * (1.0 - Rounding))
    {
      onsets.push_back({ i - 1, length > 0.0 ? std::clamp(1.0 - distance / length, 0.0, 1.0) : 0.0 });
    }
  }
  return onsets;
}

double heightAt(const BreakerRays& rays, bool random, const RayPlace& place)
{
  const std::int64_t i = place.point;
  const double before = rays.shoaling[i] * rays.refraction[i];
  const double after = rays.shoaling[i + 1] * rays.refraction[i + 1];
  if (random || !(before > 0.0) || !std::isfinite(before) || !std::isfinite(after))
  {
    return valueAt(rays.height, place);
  }
  return rays.height[i] * (before + place.weight * (after - before)) / before;
}

class LineMaker
{
public:
  LineMaker(const BreakerRays& rays, const Seafloor& seafloor, const BreakerSea& sea, BreakerLines& lines)
    : Rays(rays)
    , Bed(seafloor)
    , Sea(sea)
    , DeepHeight(deepWaterHeight(sea.wave))
    , Lines(lines)
  {
  }

  void add(std::int32_t number, const RayPlace* first, const RayPlace* last)
  {
    for (const RayPlace* place = first; place != last; ++place)
    {
      const glm::dvec2 along = vectorAt(this->Rays.positions, place + 1 == last ? *place : place[1]) -
        vectorAt(this->Rays.positions, place == first ? *place : place[-1]);
      this->describe(*place, along);
    }
    this->Lines.number.push_back(number);
    this->Lines.offsets.push_back(this->Lines.places.size());
  }

private:
  void describe(const RayPlace& place, const glm::dvec2& along)
  {
    const double height = heightAt(this->Rays, this->Sea.random, place);
    const double depth = valueAt(this->Rays.depth, place);
    const double k = valueAt(this->Rays.wavenumber, place);
    const glm::dvec2 wave = glm::normalize(vectorAt(this->Rays.direction, place));
    const glm::dvec2 uphill =
      scaleAt(this->Rays, place.point) * this->Bed.bed(vectorAt(this->Rays.positions, place)).gradient;
    const double slope = glm::length(uphill);
    const double period = this->Sea.wave.period;
    const double gravity = this->Sea.wave.gravity;
    const double angle = slope > 0.0 ? std::atan2(uphill.x * wave.y - uphill.y * wave.x, glm::dot(uphill, wave))
                                     : std::numeric_limits<double>::quiet_NaN();
    const double iribarren = iribarrenNumber(slope, this->DeepHeight, period, gravity);
    const WaveSetUp rise = waveSetUp(height, depth, k);
    const double significant = this->Sea.random ? std::sqrt(2.0) * height : height;
    const double flux = longshoreEnergyFlux(significant, valueAt(this->Rays.groupSpeed, place), angle, gravity);

    BreakerLines& lines = this->Lines;
    lines.places.push_back(place);
    lines.height.push_back(height);
    lines.depth.push_back(depth);
    lines.angle.push_back(angle);
    lines.iribarrenOffshore.push_back(iribarren);
    lines.iribarrenBreaking.push_back(iribarrenNumber(slope, height, period, gravity));
    lines.type.push_back(static_cast<std::uint8_t>(breakerType(iribarren)));
    lines.typeAtBreaking.push_back(static_cast<std::uint8_t>(breakerTypeAtBreaking(lines.iribarrenBreaking.back())));
    // The crest is across the wave: the angle to it is a right angle less that to the wave.
    lines.peelAngle.push_back(
      std::atan2(std::fabs(glm::dot(along, wave)), std::fabs(along.x * wave.y - along.y * wave.x)));
    lines.vortexRatio.push_back(swellray::vortexRatio(glm::dot(uphill, wave)));
    lines.setDown.push_back(swellray::setDown(height, depth, k));
    lines.setUp.push_back(rise.stillWaterLine);
    lines.maximumSetUp.push_back(rise.maximum);
    lines.longshoreFlux.push_back(flux);
    lines.longshoreTransport.push_back(swellray::longshoreTransport(flux, gravity));
  }

  const BreakerRays& Rays;
  const Seafloor& Bed;
  const BreakerSea& Sea;
  double DeepHeight;
  BreakerLines& Lines;
};

}

BreakerLines extractBreakerLines(
  const BreakerRays& rays, const Seafloor& seafloor, const BreakerSea& sea, double maxGap)
{
  sea.wave.validate();
  std::vector<std::size_t> sorted(rays.rays);
  std::iota(sorted.begin(), sorted.end(), std::size_t(0));
  std::sort(sorted.begin(), sorted.end(),
    [&](std::size_t a, std::size_t b)
    {
      return std::make_tuple(rays.launchSegment[a], rays.launchParameter[a], a) <
        std::make_tuple(rays.launchSegment[b], rays.launchParameter[b], b);
    });
  std::vector<std::vector<RayPlace>> onsets(rays.rays);
  std::size_t most = 0;
  for (std::size_t ray = 0; ray < rays.rays; ++ray)
  {
    onsets[ray] = onsetsOf(rays, ray);
    most = std::max(most, onsets[ray].size());
  }

  BreakerLines lines;
  LineMaker maker(rays, seafloor, sea, lines);
  std::vector<RayPlace> run;
  for (std::size_t number = 0; number < most; ++number)
  {
    const auto finish = [&]
    {
      if (run.size() > 1)
      {
        maker.add(static_cast<std::int32_t>(number) + 1, run.data(), run.data() + run.size());
      }
      run.clear();
    };
    std::int32_t segment = 0;
    for (const std::size_t ray : sorted)
    {
      const std::int64_t first = rays.offsets[ray];
      if (onsets[ray].size() <= number)
      {
        const bool beginsInSurf = first < rays.offsets[ray + 1] && rays.breaking[first] != 0;
        if (!beginsInSurf)
        {
          finish();
        }
        continue;
      }
      const RayPlace& place = onsets[ray][number];
      const glm::dvec2 here = vectorAt(rays.positions, place);
      const glm::dvec2 before = run.empty() ? here : vectorAt(rays.positions, run.back());
      const bool apart = (maxGap > 0.0 && glm::distance(before, here) > maxGap * scaleAt(rays, place.point)) ||
        (rays.obstacles && rays.obstacles->crosses(before, here));
      if (apart || rays.launchSegment[ray] != segment)
      {
        finish();
      }
      segment = rays.launchSegment[ray];
      run.push_back(place);
    }
    finish();
  }
  return lines;
}

}
