#pragma once

#include "sim/Angles.h"
#include "sim/Current.h"
#include "sim/Dispersion.h"
#include "sim/HamiltonianRay.h"
#include "sim/RayQuantities.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace swellray::testing
{

/** A flat bed of any extent. */
class FlatBed final : public Seafloor
{
public:
  FlatBed(const Rectangle& bounds, double depth)
    : Bounds(bounds)
    , Depth(depth)
  {
  }

  Rectangle bounds() const override { return this->Bounds; }
  void evaluate(const glm::dvec2&, unsigned, BedSample& bed) const override
  {
    bed = BedSample();
    bed.elevation = -this->Depth;
  }
  double featureLength() const override { return 1e6; }
  double resolution() const override { return 100.0; }
  double highestElevation(const Rectangle&) const override { return -this->Depth; }

private:
  Rectangle Bounds;
  double Depth;
};

/** Along x and growing with x by a tanh between two values: upwelling makes up for what the water lacks. */
class CollinearCurrent final : public Current
{
public:
  CollinearCurrent(double from, double to, double middle, double width)
    : From(from)
    , To(to)
    , Middle(middle)
    , Width(width)
  {
  }

  double at(double x) const { return this->From + (this->To - this->From) * 0.5 * (1.0 + this->t(x)); }
  double featureLength() const override { return this->Width; }
  void evaluate(const glm::dvec2& p, CurrentSample& sample) const override
  {
    const double t = this->t(p.x);
    const double half = 0.5 * (this->To - this->From);
    sample = CurrentSample();
    sample.velocity.x = this->at(p.x);
    sample.dx.x = half * (1.0 - t * t) / this->Width;
    sample.dxx.x = -2.0 * half * t * (1.0 - t * t) / (this->Width * this->Width);
  }

private:
  double t(double x) const { return std::tanh((x - this->Middle) / this->Width); }

  double From;
  double To;
  double Middle;
  double Width;
};

// Deeper than any wave here feels: sech^2(kh) is 0 to the last bit.
constexpr double DeepBed = 4000.0;

inline RayMedium mediumWith(const Seafloor& seafloor, const Current& current, double period)
{
  RayMedium medium;
  medium.seafloor = &seafloor;
  medium.angularFrequency = 2.0 * Pi / period;
  medium.current = &current;
  return medium;
}

/** H/H0 of a ray that starts with the height 1 in still water, its tube as wide as 1 there. */
inline double amplification(const RayPoint& point, const RayMedium& medium, double groupSpeedAtStart)
{
  const WaveSpeeds speeds = waveSpeeds(glm::length(point.wavenumber), point.depth, medium.gravity);
  return shoalingCoefficient(point, speeds, groupSpeedAtStart, medium.angularFrequency) *
    refractionCoefficient(point.tubeWidth);
}

}
