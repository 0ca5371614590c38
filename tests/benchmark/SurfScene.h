#pragma once

#include "sim/BuiltinSeafloor.h"
#include "sim/Dispersion.h"
#include "sim/Foam.h"
#include "sim/RayQuantities.h"
#include "sim/WaveHeight.h"
#include "sim/WaveSurface.h"
#include "sim/WaveTracer.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace swellray
{

/** Waves straight onto a beach, so many rays and points a wave. */
class SurfScene
{
public:
  SurfScene(double width, double spacing, double pointsPerWave)
    : Bed(makeBuiltinSeafloor("plane:slope=0.02,x0=-50,x1=450,y0=0,y1=" + std::to_string(width)))
  {
    IncidentWave wave;
    wave.period = 8.0;
    wave.directionFrom = 90.0;
    wave.height = 1.5;
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
      computeHeights(profile, wave, {}, heights);
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
    const std::size_t points = this->Sheet->pointCount();
    for (std::size_t i = 0; i < points; ++i)
    {
      const FoamOrigin origin = this->Surface->foamOrigin(i);
      this->BreakingPhase.push_back(origin.begin);
      this->FoamShare.push_back(origin.share);
    }
    this->Parameter.assign(points, 0.0);
    this->Position.resize(3 * points);
    this->Normal.resize(3 * points);
    this->Depth.resize(points);
    this->Foam.resize(points);
  }

  const WaveSurface& surface() const { return *this->Surface; }
  const Seafloor& bed() const { return *this->Bed; }

  std::size_t points() const { return this->Sheet->pointCount(); }

  void frame(double time, const WaveSection& section)
  {
    SurfaceArrays arrays;
    arrays.position = this->Position.data();
    arrays.normal = this->Normal.data();
    arrays.depth = this->Depth.data();
    this->Surface->displace(time, section, arrays);
    FoamOptions foam;
    foam.period = this->Options.period;
    foam.variation = section.variation();
    foam.wavelength = this->Options.wavelength;
    computeFoam({ this->points(), this->Sheet->Phase.data(), this->BreakingPhase.data(), this->Parameter.data(), nullptr,
                  nullptr, this->FoamShare.data() },
      time, foam, this->Foam.data());
    benchmark::DoNotOptimize(this->Position.data());
    benchmark::DoNotOptimize(this->Foam.data());
  }

private:
  std::unique_ptr<Seafloor> Bed;
  std::unique_ptr<SurfaceSheet> Sheet;
  SurfaceOptions Options;
  std::unique_ptr<WaveSurface> Surface;
  std::vector<double> BreakingPhase, FoamShare, Parameter, Position, Depth;
  std::vector<float> Normal, Foam;
};

}
