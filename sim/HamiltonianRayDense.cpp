#include "sim/HamiltonianRay.h"

#include <algorithm>
#include <cmath>

// Reading a ray within its step, from the dense output.

namespace swellray
{

using namespace rayequations;

namespace
{

// Dense output, Hairer, Norsett and Wanner 1993, II.6.
constexpr double D1 = -12715105075.0 / 11282082432.0;
constexpr double D3 = 87487479700.0 / 32700410799.0;
constexpr double D4 = -10690763975.0 / 1880347072.0;
constexpr double D5 = 701980252875.0 / 199316789632.0;
constexpr double D6 = -1453857185.0 / 822651844.0;
constexpr double D7 = 69997945.0 / 29380423.0;

// Newton's method has converged after a correction of this share of a step: the next one is its square.
constexpr double LastCorrection = 1e-9;

}

void HamiltonianRay::prepareDense(double h, const State& end, const State& lastRate)
{
  const State& k1 = this->BeginRate;
  for (std::size_t i = 0; i < Size; ++i)
  {
    const double difference = end[i] - this->Begin[i];
    const double slope = h * k1[i] - difference;
    this->Dense[0][i] = difference;
    this->Dense[1][i] = slope;
    this->Dense[2][i] = difference - h * lastRate[i] - slope;
    this->Dense[3][i] = h *
      (D1 * k1[i] + D3 * this->Stage[1][i] + D4 * this->Stage[2][i] + D5 * this->Stage[3][i] + D6 * this->Stage[4][i] +
        D7 * lastRate[i]);
  }
}

HamiltonianRay::State HamiltonianRay::dense(double theta) const
{
  State y;
  for (std::size_t i = 0; i < Size; ++i)
  {
    y[i] = this->dense(theta, i);
  }
  return y;
}

double HamiltonianRay::reached(FrontMeasure measure) const
{
  if (measure == FrontMeasure::Time)
  {
    return this->BeginTime + this->LastTheta * this->StepSize;
  }
  const std::size_t component = measure == FrontMeasure::Phase ? Phase : Length;
  return this->LastTheta == 1.0 ? this->End[component] : this->dense(this->LastTheta, component);
}

double HamiltonianRay::locateTarget(FrontMeasure measure, double target) const
{
  double low = this->ReadTheta;
  double high = this->LastTheta;
  if (measure == FrontMeasure::Time)
  {
    return std::clamp((target - this->BeginTime) / this->StepSize, low, high);
  }
  // Newton on the dense polynomial, kept in its bracket; phase and length grow along a ray.
  const std::size_t component = measure == FrontMeasure::Phase ? Phase : Length;
  double theta = low + (high - low) * 0.5;
  const double begin = this->dense(low, component);
  const double total = this->dense(high, component) - begin;
  if (total > 0.0)
  {
    theta = low + (high - low) * std::clamp((target - begin) / total, 0.0, 1.0);
  }
  for (int i = 0; i < BisectionSteps; ++i)
  {
    const double miss = this->dense(theta, component) - target;
    (miss > 0.0 ? high : low) = theta;
    const double newton = theta - miss / this->denseRate(theta, component);
    const bool inside = newton >= low && newton <= high;
    const double next = inside ? newton : 0.5 * (low + high);
    if ((inside && std::abs(next - theta) < LastCorrection) || high - low < 1e-15)
    {
      return next;
    }
    theta = next;
  }
  return theta;
}

void HamiltonianRay::describe(double theta, RayPoint& point)
{
  this->ReadTheta = theta;
  const State y = this->StepSize > 0.0 ? this->dense(theta) : this->Begin;
  point.position = { y[X], y[Y] };
  point.wavenumber = { y[Kx], y[Ky] };
  point.rayDirection = point.wavenumber / std::hypot(y[Kx], y[Ky]);
  const double scale = this->Medium.scale(point.position);
  point.wavenumber *= scale;
  BedSample bed;
  this->Medium.seafloor->evaluate(point.position, this->Region, bed);
  point.depth = this->Medium.waterLevel - bed.elevation;
  point.phase = y[Phase];
  point.travelTime = this->BeginTime + theta * this->StepSize;
  if (this->Medium.current)
  {
    point.current = this->Medium.current->velocity(point.position);
    Frequency frequency;
    const double depth = std::max(point.depth, this->Medium.agroundDepth);
    evaluateFrequency(scale * std::hypot(y[Kx], y[Ky]), depth, this->Medium.gravity, frequency);
    const glm::dvec2 speed = frequency.k * point.rayDirection + point.current;
    point.rayDirection = speed / std::hypot(speed.x, speed.y);
  }
  point.tubeWidth = rayequations::tubeWidth(y, point.rayDirection) / scale;
  point.caustics = this->Caustics;
  if (this->StepSize > 0.0)
  {
    bool negative = this->Negative;
    this->passCaustics(theta, point.caustics, negative, nullptr);
  }
  this->ReadLength = y[Length];
}

}
