#include "sim/HamiltonianRay.h"

#include "sim/Angles.h"
#include "sim/CurrentDispersion.h"

#include <algorithm>
#include <cmath>

namespace swellray
{

using namespace rayequations;

namespace
{

// Dormand and Prince 1980, RK5(4)7M.
constexpr double A21 = 1.0 / 5.0;
constexpr double A31 = 3.0 / 40.0;
constexpr double A32 = 9.0 / 40.0;
constexpr double A41 = 44.0 / 45.0;
constexpr double A42 = -56.0 / 15.0;
constexpr double A43 = 32.0 / 9.0;
constexpr double A51 = 19372.0 / 6561.0;
constexpr double A52 = -25360.0 / 2187.0;
constexpr double A53 = 64448.0 / 6561.0;
constexpr double A54 = -212.0 / 729.0;
constexpr double A61 = 9017.0 / 3168.0;
constexpr double A62 = -355.0 / 33.0;
constexpr double A63 = 46732.0 / 5247.0;
constexpr double A64 = 49.0 / 176.0;
constexpr double A65 = -5103.0 / 18656.0;
constexpr double B1 = 35.0 / 384.0;
constexpr double B3 = 500.0 / 1113.0;
constexpr double B4 = 125.0 / 192.0;
constexpr double B5 = -2187.0 / 6784.0;
constexpr double B6 = 11.0 / 84.0;
// Difference to the embedded formula of order 4.
constexpr double E1 = 71.0 / 57600.0;
constexpr double E3 = -71.0 / 16695.0;
constexpr double E4 = 71.0 / 1920.0;
constexpr double E5 = -17253.0 / 339200.0;
constexpr double E6 = 22.0 / 525.0;
constexpr double E7 = -1.0 / 40.0;
// Step size control (Hairer, Norsett and Wanner 1993, II.4).
constexpr double Safety = 0.9;
constexpr double ErrorExponent = 0.17;
constexpr double MemoryExponent = 0.04;
constexpr double SmallestFactor = 0.2;
constexpr double LargestFactor = 5.0;

// The tube is a derivative of the ray: it needs fewer digits for the same use.
constexpr double TubeWeight = 1e-3;

// kh above which a wave does not feel the bottom: sech^2(kh) < 1e-8.
constexpr double DeepWater = 10.0;

// A step below this share of a wavelength makes no progress any more.
constexpr double SmallestStep = 1e-9;

glm::dvec2 rayDirection(const State& rate, double scale)
{
  return glm::dvec2(rate[X], rate[Y]) / (scale * rate[Length]);
}

}

HamiltonianRay::HamiltonianRay(const RayMedium& medium, const RayStart& start, double tolerance, std::size_t maxSteps)
  : Medium(medium)
  , Tolerance(tolerance)
  , MaxSteps(maxSteps)
  , DryDepth(0.25 * medium.agroundDepth)
{
  this->Begin = { start.position.x, start.position.y, start.wavenumber.x, start.wavenumber.y, start.dPosition.x,
    start.dPosition.y, start.dWavenumber.x, start.dWavenumber.y, start.phase, start.length };
  this->End = this->Begin;
  this->BeginTime = start.travelTime;
  this->Caustics = start.caustics;
  this->Region = medium.seafloor->region(start.position);
  this->LeavingWall = start.wall;
  this->LeavingSide = start.wallSide;

  Local local;
  ++this->Evaluations;
  if (!evaluate(medium, this->Region, this->DryDepth, this->Begin, this->BeginRate, local) ||
    local.depth < medium.agroundDepth)
  {
    this->BeginDepth = medium.depth(start.position);
    this->EndDepth = this->BeginDepth;
    this->end(EndReason::Aground);
    return;
  }
  if (medium.seafloor->isHole(start.position))
  {
    this->BeginDepth = this->EndDepth = local.depth;
    this->end(EndReason::EnteredHole);
    return;
  }
  this->BeginDepth = this->EndDepth = local.depth;
  this->BeginScale = this->EndScale = local.scale;
  this->EndRate = this->BeginRate;
  this->BeginShare = speedShare(this->Begin, this->BeginRate, local.frequency);
  if (this->BeginShare < BlockedShare)
  {
    this->end(EndReason::BlockedByCurrent);
    return;
  }
  this->Negative = rayequations::tubeWidth(this->Begin, rayDirection(this->BeginRate, local.scale)) < 0.0;
  const double k = std::hypot(this->Begin[Kx], this->Begin[Ky]);
  this->WidthScale = std::max(std::hypot(this->Begin[DX], this->Begin[DY]), 1e-12);
  this->RateScale = std::max(std::hypot(this->Begin[DKx], this->Begin[DKy]), this->WidthScale * k * k / (2.0 * Pi));
  // A quarter of a wavelength to begin with.
  this->NextStep = 0.5 * Pi / (k * local.frequency.k);
}

bool HamiltonianRay::advance(FrontMeasure measure, double target, RayPoint& point)
{
  while (true)
  {
    if (target <= this->reached(measure))
    {
      const double theta = this->StepSize > 0.0 ? this->locateTarget(measure, target) : 0.0;
      this->describe(theta, point);
      return true;
    }
    if (this->Terminal || this->Ended)
    {
      const bool first = !this->Ended;
      this->Ended = true;
      this->describe(this->LastTheta, point);
      if (first && this->Wall)
      {
        this->reflect(point);
      }
      return false;
    }
    if (!this->step())
    {
      this->describe(this->LastTheta, point);
      return false;
    }
  }
}

void HamiltonianRay::end(EndReason reason)
{
  this->Reason = reason;
  this->Ended = true;
}

bool HamiltonianRay::tryStep(double h, Trial& trial)
{
  const State& y = this->Begin;
  const State& k1 = this->BeginRate;
  State& k2 = this->Stage[0];
  State& k3 = this->Stage[1];
  State& k4 = this->Stage[2];
  State& k5 = this->Stage[3];
  State& k6 = this->Stage[4];
  State s;
  const auto rates = [&](State& rate)
  {
    ++this->Evaluations;
    return evaluate(this->Medium, this->Region, this->DryDepth, s, rate, trial.local);
  };

  for (std::size_t i = 0; i < Size; ++i)
  {
    s[i] = y[i] + h * A21 * k1[i];
  }
  if (!rates(k2))
  {
    return false;
  }
  for (std::size_t i = 0; i < Size; ++i)
  {
    s[i] = y[i] + h * (A31 * k1[i] + A32 * k2[i]);
  }
  if (!rates(k3))
  {
    return false;
  }
  for (std::size_t i = 0; i < Size; ++i)
  {
    s[i] = y[i] + h * (A41 * k1[i] + A42 * k2[i] + A43 * k3[i]);
  }
  if (!rates(k4))
  {
    return false;
  }
  for (std::size_t i = 0; i < Size; ++i)
  {
    s[i] = y[i] + h * (A51 * k1[i] + A52 * k2[i] + A53 * k3[i] + A54 * k4[i]);
  }
  if (!rates(k5))
  {
    return false;
  }
  for (std::size_t i = 0; i < Size; ++i)
  {
    s[i] = y[i] + h * (A61 * k1[i] + A62 * k2[i] + A63 * k3[i] + A64 * k4[i] + A65 * k5[i]);
  }
  if (!rates(k6))
  {
    return false;
  }
  for (std::size_t i = 0; i < Size; ++i)
  {
    s[i] = y[i] + h * (B1 * k1[i] + B3 * k3[i] + B4 * k4[i] + B5 * k5[i] + B6 * k6[i]);
  }
  if (!rates(trial.lastRate))
  {
    return false;
  }
  trial.end = s;
  State error;
  for (std::size_t i = 0; i < Size; ++i)
  {
    error[i] = h * (E1 * k1[i] + E3 * k3[i] + E4 * k4[i] + E5 * k5[i] + E6 * k6[i] + E7 * trial.lastRate[i]);
  }
  trial.error = this->errorNorm(error, s) / this->Tolerance;
  return true;
}

double HamiltonianRay::errorNorm(const State& error, const State& end) const
{
  const double k2 = end[Kx] * end[Kx] + end[Ky] * end[Ky];
  const double position = (error[X] * error[X] + error[Y] * error[Y]) * k2 / (4.0 * Pi * Pi);
  const double wavenumber = (error[Kx] * error[Kx] + error[Ky] * error[Ky]) / k2;
  const double phase = error[Phase] * error[Phase] / (4.0 * Pi * Pi);
  const double width = (error[DX] * error[DX] + error[DY] * error[DY]) / (this->WidthScale * this->WidthScale);
  const double rate = (error[DKx] * error[DKx] + error[DKy] * error[DKy]) / (this->RateScale * this->RateScale);
  const double ray = std::max({ position, wavenumber, phase });
  const double tube = TubeWeight * TubeWeight * std::max(width, rate);
  return std::sqrt(std::max(ray, tube));
}

double HamiltonianRay::longestStep() const
{
  const double speed = this->BeginScale * this->BeginRate[Length]; // on the map
  double feature = this->Medium.seafloor->featureLength();
  double reach = 32.0 * feature;
  if (this->Medium.current)
  {
    feature = std::min(feature, this->Medium.current->featureLength());
    reach = std::min(reach, this->Medium.current->featureLength());
  }
  const double k = this->BeginScale * std::hypot(this->Begin[Kx], this->Begin[Ky]);
  if (k * this->BeginDepth > DeepWater)
  {
    // Where nothing within reach is felt by the wave, steps may be as long as that reach.
    const glm::dvec2 here(this->Begin[X], this->Begin[Y]);
    const double highest = this->Medium.seafloor->highestElevation({ here - reach, here + reach });
    if (k * (this->Medium.waterLevel - highest) > DeepWater)
    {
      return reach / speed;
    }
  }
  return feature / speed;
}

bool HamiltonianRay::step()
{
  if (this->StepSize > 0.0)
  {
    // Leave the finished step behind.
    this->passCaustics(this->LastTheta, this->Caustics, this->Negative, &this->Touched);
    this->Begin = this->End;
    this->BeginRate = this->EndRate;
    this->BeginTime += this->StepSize;
    this->BeginDepth = this->EndDepth;
    this->BeginShare = this->EndShare;
    this->BeginScale = this->EndScale;
    this->StepSize = 0.0;
    this->LastTheta = 0.0;
    this->ReadTheta = 0.0;
    this->LeavingWall.reset();
    if (this->KinkAhead >= 0)
    {
      this->crossKink(static_cast<unsigned>(this->KinkAhead));
      this->KinkAhead = -1;
    }
  }
  if (this->Steps >= this->MaxSteps)
  {
    this->end(EndReason::StepCap);
    return false;
  }

  const double k = std::hypot(this->Begin[Kx], this->Begin[Ky]);
  const double smallest = SmallestStep * 2.0 * Pi / (k * this->BeginScale * this->BeginRate[Length]);
  double h = std::min(this->NextStep, this->longestStep());
  Trial trial;
  bool toKink = false;
  while (true)
  {
    if (!(h >= smallest))
    {
      // The step shrinks to nothing only in front of a wall of land.
      this->StepSize = 0.0;
      this->LastTheta = 0.0;
      this->End = this->Begin;
      this->end(EndReason::Aground);
      return false;
    }
    const bool wet = this->tryStep(h, trial);
    if (!wet || !(trial.error <= 1.0))
    {
      h *= wet && std::isfinite(trial.error) ? std::max(SmallestFactor, Safety * std::pow(trial.error, -0.2)) : 0.5;
      toKink = false;
      this->KinkAhead = -1;
      continue;
    }
    this->StepSize = h;
    this->EndScale = trial.local.scale;
    if (this->Medium.current)
    {
      this->EndShare = speedShare(trial.end, trial.lastRate, trial.local.frequency);
    }
    this->prepareDense(h, trial.end, trial.lastRate);
    this->End = trial.end;
    this->LastTheta = 1.0;
    if (toKink)
    {
      break;
    }
    const Event event = this->findEvent();
    if (event.kind == Happening::Kink)
    {
      // Make the step again so that it ends on the kink.
      this->KinkAhead = static_cast<int>(event.kink);
      h *= event.theta;
      toKink = true;
      if (h < smallest)
      {
        this->StepSize = 0.0;
        this->End = this->Begin;
        this->LastTheta = 0.0;
        this->crossKink(event.kink);
        this->KinkAhead = -1;
        h = smallest * 4.0;
        toKink = false;
      }
      continue;
    }
    if (event.kind == Happening::End)
    {
      this->LastTheta = event.theta;
      this->Terminal = true;
      this->Reason = event.reason;
      this->Wall = event.wall;
    }
    break;
  }

  const double error = std::max(trial.error, 1e-10);
  const double factor = Safety * std::pow(error, -ErrorExponent) * std::pow(this->LastError, MemoryExponent);
  const double next = h * std::clamp(factor, SmallestFactor, LargestFactor);
  // A step cut short by a kink says nothing about the size of the next one.
  this->NextStep = toKink ? std::max(next, this->NextStep) : next;
  this->LastError = std::max(error, 1e-4);
  this->EndRate = trial.lastRate;
  this->EndDepth = trial.local.depth;
  this->WidthScale = std::max(this->WidthScale, std::hypot(trial.end[DX], trial.end[DY]));
  this->RateScale = std::max(this->RateScale, std::hypot(trial.end[DKx], trial.end[DKy]));
  const Frequency& f = trial.local.frequency;
  double drift = (f.sigma + trial.local.doppler) / this->Medium.angularFrequency - 1.0;
  if (!this->Medium.current)
  {
    drift *= f.sigma / (std::hypot(trial.end[Kx], trial.end[Ky]) * f.k); // of the wavenumber
  }
  this->DispersionError = std::max(this->DispersionError, std::abs(drift));
  ++this->Steps;
  return true;
}

}
