#pragma once

#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"
#include "sim/RayQuantities.h"
#include "sim/WaveHeight.h"
#include "sim/WaveSurface.h"
#include "sim/WaveTracer.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace swellray
{

/** The surface of waves traced over a built-in seafloor, where no ray is inserted. */
class TracedSurface
{
public:
  /** @param spacing of the rays, m */
  TracedSurface(const std::string& seafloor, const IncidentWave& wave, const HeightOptions& losses, double spacing,
    double pointsPerWave)
    : Bed(makeBuiltinSeafloor(seafloor))
  {
    TraceOptions options;
    options.spacing = spacing;
    const RayField field = traceWaves(*this->Bed, wave, options);

    const std::size_t count = field.points.size();
    std::vector<double> position(3 * count), depth(count), phase(count), time(count), wavenumber(count), speed(count),
      direction(3 * count), rayDirection(3 * count), krSpacing(count), krTube(count), shoaling(count);
    std::vector<std::int32_t> caustics(count);
    std::vector<std::uint8_t> state(count);
    RayQuantities quantities;
    quantities.position = position.data();
    quantities.depth = depth.data();
    quantities.phase = phase.data();
    quantities.travelTime = time.data();
    quantities.wavenumber = wavenumber.data();
    quantities.groupSpeed = speed.data();
    quantities.direction = direction.data();
    quantities.rayDirection = rayDirection.data();
    quantities.krSpacing = krSpacing.data();
    quantities.krTube = krTube.data();
    quantities.shoaling = shoaling.data();
    quantities.caustics = caustics.data();
    quantities.state = state.data();
    computeRayQuantities(field, wave, 0.0, quantities);

    std::vector<double> height(count), distance(count), parameter;
    std::vector<std::uint8_t> breaking(count), lee;
    std::vector<std::int32_t> segment, parent;
    std::vector<std::int64_t> offsets(field.offsets.begin(), field.offsets.end());
    RayHeights heights;
    for (std::size_t ray = 0; ray < field.rays.size(); ++ray)
    {
      const std::size_t first = field.offsets[ray];
      RayProfile profile;
      profile.count = field.pointCount(ray);
      profile.position = position.data() + 3 * first;
      profile.travelTime = time.data() + first;
      profile.depth = depth.data() + first;
      profile.wavenumber = wavenumber.data() + first;
      profile.groupSpeed = speed.data() + first;
      profile.shoaling = shoaling.data() + first;
      profile.krSpacing = krSpacing.data() + first;
      profile.krTube = krTube.data() + first;
      profile.state = state.data() + first;
      computeHeights(profile, wave, losses, heights);
      std::copy(heights.height.begin(), heights.height.end(), height.begin() + static_cast<std::ptrdiff_t>(first));
      std::copy(heights.breakingDistance.begin(), heights.breakingDistance.end(),
        distance.begin() + static_cast<std::ptrdiff_t>(first));
      std::copy(
        heights.breaking.begin(), heights.breaking.end(), breaking.begin() + static_cast<std::ptrdiff_t>(first));
      parameter.push_back(field.rays[ray].launchParameter);
      segment.push_back(field.rays[ray].launchSegment);
      parent.push_back(field.rays[ray].parent);
      lee.push_back(field.rays[ray].lee ? 1 : 0);
    }
    SurfaceRays rays;
    rays.sheet.lines.rays = field.rays.size();
    rays.sheet.lines.offsets = offsets.data();
    rays.sheet.lines.positions = position.data();
    rays.sheet.lines.phase = phase.data();
    rays.sheet.lines.launchParameter = parameter.data();
    rays.sheet.lines.launchSegment = segment.data();
    rays.sheet.parent = parent.data();
    rays.sheet.lee = lee.data();
    rays.sheet.direction = direction.data();
    rays.sheet.wavenumber = wavenumber.data();
    rays.sheet.height = height.data();
    rays.sheet.caustics = caustics.data();
    rays.sheet.breaking = breaking.data();
    rays.sheet.state = state.data();
    rays.rayDirection = rayDirection.data();
    rays.breakingDistance = distance.data();
    this->Sheet = std::make_unique<SurfaceSheet>(rays, *this->Bed, 0.0, pointsPerWave);
    this->Options.period = wave.period;
    this->Options.wavelength = wavelengthOf(wave.wavenumber());
    this->Surface = std::make_unique<WaveSurface>(*this->Sheet, *this->Bed, this->Options);
  }

  const Seafloor& bed() const { return *this->Bed; }
  const SurfaceSheet& sheet() const { return *this->Sheet; }
  const SurfaceOptions& options() const { return this->Options; }
  const WaveSurface& surface() const { return *this->Surface; }

private:
  std::unique_ptr<Seafloor> Bed;
  std::unique_ptr<SurfaceSheet> Sheet;
  SurfaceOptions Options;
  std::unique_ptr<WaveSurface> Surface;
};

}
