#pragma once

#include "sim/Foam.h"
#include "tests/sim/TracedSurface.h"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace swellray
{

/** Waves straight onto a beach, so many rays and points a wave. */
class SurfScene
{
public:
  SurfScene(double width, double spacing, double pointsPerWave)
    : Traced("plane:slope=0.02,x0=-50,x1=450,y0=0,y1=" + std::to_string(width), waves(), {}, spacing, pointsPerWave)
  {
    const std::size_t points = this->points();
    for (std::size_t i = 0; i < points; ++i)
    {
      const FoamOrigin origin = this->surface().foamOrigin(i);
      this->BreakingPhase.push_back(origin.begin);
      this->FoamShare.push_back(origin.share);
      this->PlungePhase.push_back(origin.plunge);
    }
    this->Parameter.assign(points, 0.0);
    this->Position.resize(3 * points);
    this->Normal.resize(3 * points);
    this->Depth.resize(points);
    this->Foam.resize(points);
  }

  const WaveSurface& surface() const { return this->Traced.surface(); }
  const Seafloor& bed() const { return this->Traced.bed(); }

  std::size_t points() const { return this->Traced.sheet().pointCount(); }

  void frame(double time, const WaveSection& section)
  {
    SurfaceArrays arrays;
    arrays.position = this->Position.data();
    arrays.normal = this->Normal.data();
    arrays.depth = this->Depth.data();
    this->surface().displace(time, section, arrays);
    FoamOptions foam;
    foam.period = this->Traced.options().period;
    foam.variation = section.variation();
    foam.front = section.frontPhase();
    foam.wavelength = this->Traced.options().wavelength;
    computeFoam({ this->points(), this->Traced.sheet().Phase.data(), this->BreakingPhase.data(), this->Parameter.data(),
                  nullptr, nullptr, this->PlungePhase.data(), this->FoamShare.data() },
      time, foam, this->Foam.data());
    benchmark::DoNotOptimize(this->Position.data());
    benchmark::DoNotOptimize(this->Foam.data());
  }

private:
  static IncidentWave waves()
  {
    IncidentWave wave;
    wave.period = 8.0;
    wave.directionFrom = 90.0;
    wave.height = 1.5;
    return wave;
  }

  TracedSurface Traced;
  std::vector<double> BreakingPhase, FoamShare, PlungePhase, Parameter, Position, Depth;
  std::vector<float> Normal, Foam;
};

}
