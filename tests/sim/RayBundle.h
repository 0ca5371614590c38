#pragma once

#include "sim/Angles.h"
#include "sim/Obstacles.h"
#include "sim/RayField.h"
#include "sim/WaveSurface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace swellray::bundles
{

inline constexpr double Wavelength = 40.0;
inline constexpr double K = 2.0 * Pi / Wavelength;
inline constexpr double Period = 8.0;

/** z = -depth + slope x. */
class Slope : public Seafloor
{
public:
  Slope(double depth, double slope)
    : Depth(depth)
    , Rise(slope)
  {
  }
  Rectangle bounds() const override { return { { -1000.0, -1000.0 }, { 1000.0, 1000.0 } }; }
  void evaluate(const glm::dvec2& p, unsigned, BedSample& bed) const override
  {
    bed = {};
    bed.elevation = -this->Depth + this->Rise * p.x;
    bed.gradient = { this->Rise, 0.0 };
  }
  double featureLength() const override { return 10.0; }
  double resolution() const override { return 10.0; }

private:
  double Depth;
  double Rise;
};

/** Rays as plain arrays, made ray by ray. */
struct Bundle
{
  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<double> Positions, Phase, Parameter, Direction, Wavenumber, Height, Distance;
  std::vector<std::int32_t> Segment, Parent, Caustics;
  std::vector<std::uint8_t> Lee, Breaking, State;
  std::vector<std::uint8_t> Ends;   // EndReason a ray; used with Walls
  const Obstacles* Walls = nullptr; // that stop the rays

  void begin(double parameter, std::int32_t parent = -1)
  {
    this->Parameter.push_back(parameter);
    this->Segment.push_back(0);
    this->Parent.push_back(parent);
    this->Lee.push_back(0);
    this->Offsets.push_back(this->Offsets.back());
  }

  void add(const glm::dvec2& place, double phase, const glm::dvec2& direction, double height = 1.0,
    double brokenFor = 0.0, RayState state = RayState::Alive, double wavenumber = K)
  {
    this->Positions.insert(this->Positions.end(), { place.x, place.y, 0.0 });
    this->Direction.insert(this->Direction.end(), { direction.x, direction.y, 0.0 });
    this->Phase.push_back(phase);
    this->Wavenumber.push_back(wavenumber);
    this->Height.push_back(height);
    this->Distance.push_back(brokenFor);
    this->Caustics.push_back(0);
    this->Breaking.push_back(brokenFor > 0.0 ? 1 : 0);
    this->State.push_back(static_cast<std::uint8_t>(state));
    ++this->Offsets.back();
  }

  SurfaceRays rays() const
  {
    SurfaceRays rays;
    rays.sheet.lines.rays = this->Parameter.size();
    rays.sheet.lines.offsets = this->Offsets.data();
    rays.sheet.lines.positions = this->Positions.data();
    rays.sheet.lines.phase = this->Phase.data();
    rays.sheet.lines.launchParameter = this->Parameter.data();
    rays.sheet.lines.launchSegment = this->Segment.data();
    rays.sheet.parent = this->Parent.data();
    rays.sheet.lee = this->Lee.data();
    rays.sheet.direction = this->Direction.data();
    rays.sheet.wavenumber = this->Wavenumber.data();
    rays.sheet.height = this->Height.data();
    rays.sheet.caustics = this->Caustics.data();
    rays.sheet.breaking = this->Breaking.data();
    rays.sheet.state = this->State.data();
    rays.sheet.endReason = this->Ends.empty() ? nullptr : this->Ends.data();
    rays.sheet.obstacles = this->Walls;
    rays.rayDirection = this->Direction.data();
    rays.breakingDistance = this->Distance.data();
    return rays;
  }
};

/** Straight rays toward +x, 5 m apart, from x = 0 to 120, a point each `step` metres. */
inline Bundle straight(double step, int rays = 5)
{
  Bundle bundle;
  for (int i = 0; i < rays; ++i)
  {
    bundle.begin(5.0 * i);
    for (double x = 0.0; x < 120.0 + 1e-9; x += step)
    {
      bundle.add({ x, 5.0 * i }, K * x, { 1.0, 0.0 });
    }
  }
  return bundle;
}

/** The same with breaking from x = 60 m on. */
inline Bundle breaking()
{
  Bundle bundle;
  for (int i = 0; i < 3; ++i)
  {
    bundle.begin(5.0 * i);
    for (double x = 0.0; x < 120.5; x += 2.0)
    {
      const double height = x < 60.0 ? 2.0 : 2.0 - 0.03 * (x - 60.0);
      bundle.add({ x, 5.0 * i }, K * x, { 1.0, 0.0 }, height, std::max(0.0, x - 60.0));
    }
  }
  return bundle;
}

/** A sheet of rays and the surface over it. */
struct Surface
{
  Surface(const Bundle& bundle, const Seafloor& seafloor, double pointsPerWave = 16.0, double waterLevel = 0.0)
    : Sheet(bundle.rays(), seafloor, waterLevel, pointsPerWave)
  {
    this->Options.period = Period;
    this->Options.wavelength = Wavelength;
    this->Options.waterLevel = waterLevel;
    this->Moved = std::make_unique<WaveSurface>(this->Sheet, seafloor, this->Options);
  }

  void at(double time, const std::string& section, const Execution& execution = {})
  {
    const std::size_t count = this->Sheet.pointCount();
    this->Position.assign(3 * count, 0.0);
    this->Normal.assign(3 * count, 0.0f);
    this->Velocity.assign(3 * count, 0.0f);
    this->Depth.assign(count, 0.0);
    this->Phase.assign(count, 0.0);
    this->Broken.assign(count, 0);
    this->Moved->displace(time, *makeWaveSection(section),
      { this->Position.data(), this->Normal.data(), this->Velocity.data(), this->Depth.data(), this->Phase.data(),
        this->Broken.data() },
      execution);
  }

  SurfaceSheet Sheet;
  SurfaceOptions Options;
  std::unique_ptr<WaveSurface> Moved;
  std::vector<double> Position, Depth, Phase;
  std::vector<float> Normal, Velocity;
  std::vector<std::uint8_t> Broken;
};

}
