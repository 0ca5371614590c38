#include "sim/BreakingMarch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swellray
{

namespace
{

// Largest loss in a sub-step: its square is the relative error.
constexpr double LossOfAStep = 0.05;
constexpr double MostSteps = 200.0;

// Changes of state in a sub-step; more are not resolved by the points.
constexpr int MostChanges = 4;

// Random waves count as breaking where more than 5 % are broken: Qb = 0.05 at this Hrms/Hm.
const double RandomOnset = std::sqrt(-0.95 / std::log(0.05));
// Of waves of Baldock at this one.
const double HigherOnset = std::sqrt(-1.0 / std::log(0.05));

// A saturated wave stays broken where it is as high as its limit up to rounding: over a flat, for instance.
constexpr double Rounding = 1e-9;

constexpr double SmallestDepth = 1e-9; // m: keeps the ratios finite

double square(double x)
{
  return x * x;
}

}

SurfSample BreakingMarch::Step::at(double w) const
{
  const auto between = [w](double a, double b) { return a + w * (b - a); };
  SurfSample sample;
  sample.depth = between(this->from.depth, this->to.depth);
  sample.wavenumber = between(this->from.wavenumber, this->to.wavenumber);
  sample.groupSpeed = between(this->from.groupSpeed, this->to.groupSpeed);
  sample.slope = between(this->from.slope, this->to.slope);
  sample.lossless = between(this->from.lossless, this->to.lossless);
  return sample;
}

BreakingMarch::BreakingMarch(const SurfRule& rule, const SurfSample& start, const RayLosses& before)
  : Rule(rule)
  , Here(start)
  , Share(before.share)
  , Kf(before.friction)
  , Distance(before.distance)
  , Broken(before.broken)
  , Type(before.type)
{
  this->Here.depth = std::max(this->Here.depth, SmallestDepth);
  if (!this->Broken && this->height() > this->onset(this->Here))
  {
    this->begin(this->Here);
  }
  const double highest = this->limit(this->Here);
  if (this->height() > highest && std::isfinite(this->Here.lossless))
  {
    this->Share = square(highest / this->Here.lossless);
  }
}

double BreakingMarch::limit(const SurfSample& sample) const
{
  switch (this->Rule.breaking)
  {
  case BreakingRule::None:
    return std::numeric_limits<double>::infinity();
  case BreakingRule::Weggel:
    return weggelHeight(sample.depth, sample.slope, this->Rule.period, this->Rule.gravity);
  case BreakingRule::Miche:
    return micheHeight(sample.wavenumber, sample.depth);
  case BreakingRule::BattjesJanssen:
    return this->randomLimit(sample);
  case BreakingRule::Baldock:
    return std::numeric_limits<double>::infinity();
  default:
    return this->Rule.gamma * sample.depth;
  }
}

double BreakingMarch::indexAt(const SurfSample& sample) const
{
  return this->Rule.localGamma ? ruessinkGamma(sample.wavenumber, sample.depth) : this->Rule.gamma;
}

double BreakingMarch::randomLimit(const SurfSample& sample) const
{
  return randomWaveLimit(sample.wavenumber, sample.depth, this->indexAt(sample));
}

double BreakingMarch::randomLossRate(const SurfSample& sample, double share) const
{
  const double height = sample.lossless * std::sqrt(share);
  const double ratio = height / this->randomLimit(sample);
  return this->Rule.breaking == BreakingRule::Baldock ? baldockLossRate(ratio, height / sample.depth, this->Rule.period)
                                                      : randomWaveLossRate(ratio, this->Rule.period);
}

double BreakingMarch::onset(const SurfSample& sample) const
{
  if (!ofRandomWaves(this->Rule.breaking))
  {
    return this->limit(sample);
  }
  return (this->Rule.breaking == BreakingRule::Baldock ? HigherOnset : RandomOnset) * this->randomLimit(sample);
}

double BreakingMarch::stableShare(const SurfSample& sample) const
{
  return square(DallyStableIndex * sample.depth / sample.lossless);
}

double BreakingMarch::height() const
{
  // The height of an infinite wave is not what is left of it.
  return std::isfinite(this->Here.lossless) ? this->Here.lossless * std::sqrt(this->Share)
                                            : std::min(this->Here.lossless, this->limit(this->Here));
}

double BreakingMarch::brokenShare() const
{
  if (!ofRandomWaves(this->Rule.breaking))
  {
    return this->Broken ? 1.0 : 0.0;
  }
  const double ratio = this->height() / this->randomLimit(this->Here);
  return this->Rule.breaking == BreakingRule::Baldock ? higherShare(ratio) : swellray::brokenShare(ratio);
}

void BreakingMarch::begin(const SurfSample& sample)
{
  this->Broken = true;
  this->Distance = 0.0;
  this->Type = breakerType(iribarrenNumber(sample.slope, this->Rule.deepHeight, this->Rule.period, this->Rule.gravity));
}

bool BreakingMarch::limitToDepth()
{
  const double highest = this->Rule.gamma * this->Here.depth;
  const bool tooHigh = this->height() > highest;
  if (tooHigh && std::isfinite(this->Here.lossless))
  {
    this->Share = square(highest / this->Here.lossless);
  }
  return tooHigh;
}

double BreakingMarch::breakingLoss(const SurfSample& middle, double share, double seconds) const
{
  if (this->Rule.breaking == BreakingRule::Dally)
  {
    const double excess = this->Broken ? share - this->stableShare(middle) : 0.0;
    return excess > 0.0 ? -excess * std::expm1(-DallyDecay * middle.groupSpeed / middle.depth * seconds) : 0.0;
  }
  if (ofRandomWaves(this->Rule.breaking))
  {
    const double half = share * std::exp(-0.5 * this->randomLossRate(middle, share) * seconds);
    return -share * std::expm1(-this->randomLossRate(middle, half) * seconds);
  }
  return 0.0;
}

double BreakingMarch::shareAfter(const Step& step, double share, double w0, double w1, double& kf) const
{
  const SurfSample middle = step.at(0.5 * (w0 + w1));
  const double seconds = step.seconds * (w1 - w0);
  const auto rub = [&](double p)
  {
    if (this->Rule.friction > 0.0)
    {
      // Exact for a rate that grows with the height.
      const double left = 1.0 /
        (1.0 +
          0.25 * seconds *
            frictionRate(this->Rule.friction, middle.lossless * std::sqrt(p), middle.wavenumber, middle.depth,
              this->Rule.period, this->Rule.gravity));
      kf *= left;
      p *= left * left;
    }
    if (this->Rule.viscosity > 0.0)
    {
      const double left = std::exp(-0.25 * seconds *
        laminarFrictionRate(
          this->Rule.viscosity, middle.wavenumber, middle.depth, this->Rule.period, this->Rule.gravity));
      kf *= left;
      p *= left * left;
    }
    return p;
  };
  share = rub(share);
  share -= this->breakingLoss(middle, share, seconds);
  share = rub(share);

  const bool limited = this->Broken || ofRandomWaves(this->Rule.breaking);
  const SurfSample end = step.at(w1);
  const double highest = limited ? this->limit(end) : 0.0;
  return limited && end.lossless * std::sqrt(share) > highest ? square(highest / end.lossless) : share;
}

bool BreakingMarch::changes(const Step& step, double share, double w) const
{
  const SurfSample sample = step.at(w);
  const double height = sample.lossless * std::sqrt(share);
  if (!this->Broken)
  {
    return height > this->onset(sample);
  }
  if (this->Rule.breaking == BreakingRule::Dally)
  {
    return share <= this->stableShare(sample);
  }
  return height < this->onset(sample) * (1.0 - Rounding);
}

double BreakingMarch::advanceTo(const Step& step, double w0, double w1)
{
  double kf = this->Kf;
  const double share = this->shareAfter(step, this->Share, w0, w1, kf);
  if (!this->changes(step, share, w1))
  {
    this->Share = share;
    this->Kf = kf;
    this->Distance += (w1 - w0) * step.metres;
    return w1;
  }
  double low = w0;
  double high = w1;
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
  {
    double ignored = 1.0;
    (this->changes(step, this->shareAfter(step, this->Share, w0, middle, ignored), middle) ? high : low) = middle;
  }
  this->Share = this->shareAfter(step, this->Share, w0, high, this->Kf);
  if (this->Broken)
  {
    this->Broken = false;
  }
  else
  {
    this->begin(step.at(high));
  }
  return high;
}

void BreakingMarch::advance(const SurfSample& next, double seconds, double metres)
{
  Step step{ this->Here, next, seconds, metres };
  step.to.depth = std::max(next.depth, SmallestDepth);
  this->Here = step.to;
  // Next to a caustic of infinite height there is nothing to interpolate.
  if (!std::isfinite(step.from.lossless))
  {
    step.from.lossless = step.to.lossless;
  }
  if (!std::isfinite(step.to.lossless))
  {
    step.to.lossless = step.from.lossless;
  }
  if (!std::isfinite(step.to.lossless))
  {
    this->Distance += metres;
    return;
  }

  double rate = 0.0;
  if (this->Rule.breaking == BreakingRule::BattjesJanssen)
  {
    rate = 2.0 / this->Rule.period;
  }
  else if (this->Rule.breaking == BreakingRule::Baldock)
  {
    rate = std::max(this->randomLossRate(step.from, this->Share), this->randomLossRate(step.to, this->Share));
  }
  else if (this->Rule.breaking == BreakingRule::Dally)
  {
    rate = DallyDecay * std::max(step.from.groupSpeed / step.from.depth, step.to.groupSpeed / step.to.depth);
  }
  if (this->Rule.friction > 0.0)
  {
    const auto rubbing = [&](const SurfSample& s) {
      return frictionRate(
        this->Rule.friction, s.lossless, s.wavenumber, s.depth, this->Rule.period, this->Rule.gravity);
    };
    rate += std::max(rubbing(step.from), rubbing(step.to));
  }
  if (this->Rule.viscosity > 0.0)
  {
    const auto rubbing = [&](const SurfSample& s)
    { return laminarFrictionRate(this->Rule.viscosity, s.wavenumber, s.depth, this->Rule.period, this->Rule.gravity); };
    rate += std::max(rubbing(step.from), rubbing(step.to));
  }
  const double wanted = std::ceil(rate * seconds / LossOfAStep);
  const int steps = wanted > 1.0 ? static_cast<int>(std::min(wanted, MostSteps)) : 1;
  double w = 0.0;
  for (int i = 1; i <= steps; ++i)
  {
    const double end = static_cast<double>(i) / steps;
    for (int change = 0; w < end && change < MostChanges; ++change)
    {
      w = this->advanceTo(step, w, end);
    }
    w = end;
  }
}

}
