#include "sim/HamiltonianRay.h"

#include "sim/CurrentDispersion.h"

#include <algorithm>
#include <cmath>
#include <utility>

// What may happen within a step: the edge of the scene, land, a hole, a block, and kinks of the seafloor.

namespace swellray
{

using namespace rayequations;

namespace
{

// Above this share of the group speed at both ends of a step there is no need to look for a stop within it.
constexpr double SafeShare = 0.25;

}

template <typename Sign>
double HamiltonianRay::locate(double low, double high, const Sign& outside) const
{
  for (int i = 0; i < BisectionSteps && high - low > 1e-15; ++i)
  {
    const double middle = 0.5 * (low + high);
    (outside(middle) ? high : low) = middle;
  }
  return high;
}

HamiltonianRay::Event HamiltonianRay::findEvent() const
{
  Event event;
  const Seafloor& seafloor = *this->Medium.seafloor;

  const Rectangle box = seafloor.bounds();
  const auto outside = [&](double theta) { return !box.contains(this->densePosition(theta)); };
  if (outside(1.0))
  {
    event.kind = Happening::End;
    event.reason = EndReason::LeftScene;
    event.theta = this->locate(0.0, 1.0, outside);
  }

  for (unsigned i = 0; i < seafloor.kinkCount(); ++i)
  {
    const bool side = (this->Region >> i & 1u) != 0;
    glm::dvec2 normal;
    const auto crossed = [&](double theta)
    { return (seafloor.kinkLevel(i, this->densePosition(theta), normal) > 0.0) != side; };
    // A ray may clip a curve: look at inner points too.
    double before = 0.0;
    for (const double theta : { 0.25, 0.5, 0.75, 1.0 })
    {
      if (before >= event.theta)
      {
        break;
      }
      if (crossed(theta))
      {
        const double at = this->locate(before, theta, crossed);
        if (at < event.theta || event.kind == Happening::None)
        {
          event.kind = Happening::Kink;
          event.theta = at;
          event.kink = i;
        }
        break;
      }
      before = theta;
    }
  }

  this->findLandOrHole(event);
  this->findStop(event);
  return event;
}

void HamiltonianRay::findStop(Event& event) const
{
  if (!this->Medium.current || std::min(this->BeginShare, this->EndShare) > SafeShare)
  {
    return;
  }
  const auto stopped = [&](double theta)
  {
    const State y = this->dense(theta);
    State rate;
    Local local;
    return evaluate(this->Medium, this->Region, this->DryDepth, y, rate, local) &&
      speedShare(y, rate, local.frequency) < BlockedShare;
  };
  double before = 0.0;
  for (const double part : { 0.25, 0.5, 0.75, 1.0 })
  {
    const double theta = part * event.theta;
    if (stopped(theta))
    {
      event.kind = Happening::End;
      event.reason = EndReason::BlockedByCurrent;
      event.theta = this->locate(before, theta, stopped);
      return;
    }
    before = theta;
  }
}

void HamiltonianRay::findLandOrHole(Event& event) const
{
  const Seafloor& seafloor = *this->Medium.seafloor;
  const glm::dvec2 from(this->Begin[X], this->Begin[Y]);
  const glm::dvec2 to(this->End[X], this->End[Y]);
  const double margin = 0.1 * (this->End[Length] - this->Begin[Length]);
  const Rectangle box{ glm::dvec2(std::min(from.x, to.x), std::min(from.y, to.y)) - margin,
    glm::dvec2(std::max(from.x, to.x), std::max(from.y, to.y)) + margin };
  const bool land = this->Medium.waterLevel - seafloor.highestElevation(box) < this->Medium.agroundDepth;
  const bool holes = seafloor.hasHoles();
  if (!land && !holes)
  {
    return;
  }

  BedSample bed;
  const auto aground = [&](double theta)
  {
    seafloor.evaluate(this->densePosition(theta), this->Region, bed);
    return this->Medium.waterLevel - bed.elevation < this->Medium.agroundDepth;
  };
  const auto inHole = [&](double theta) { return seafloor.isHole(this->densePosition(theta)); };
  const double length = this->End[Length] - this->Begin[Length];
  const int parts = std::max(1, static_cast<int>(std::ceil(length / seafloor.resolution())));
  double before = 0.0;
  for (int i = 1; i <= parts; ++i)
  {
    const double theta = std::min(static_cast<double>(i) / parts, event.theta);
    const bool hitLand = land && aground(theta);
    const bool hitHole = holes && inHole(theta);
    if (hitLand || hitHole)
    {
      event.kind = Happening::End;
      const double landAt = hitLand ? this->locate(before, theta, aground) : 2.0;
      const double holeAt = hitHole ? this->locate(before, theta, inHole) : 2.0;
      event.reason = landAt < holeAt ? EndReason::Aground : EndReason::EnteredHole;
      event.theta = std::min(landAt, holeAt);
      return;
    }
    if (theta >= event.theta)
    {
      return;
    }
    before = theta;
  }
}

void HamiltonianRay::crossKink(unsigned kink)
{
  const glm::dvec2 position(this->Begin[X], this->Begin[Y]);
  glm::dvec2 normal;
  this->Medium.seafloor->kinkLevel(kink, position, normal);
  this->Region ^= 1u << kink;
  const State before = this->BeginRate;
  Local local;
  ++this->Evaluations;
  if (!evaluate(this->Medium, this->Region, this->DryDepth, this->Begin, this->BeginRate, local))
  {
    // Only a form that is not continuous across its own kink comes here.
    this->end(EndReason::Aground);
    return;
  }
  const double approach = normal.x * before[X] + normal.y * before[Y];
  const double offset = normal.x * this->Begin[DX] + normal.y * this->Begin[DY];
  const double size = std::hypot(normal.x, normal.y) * before[Length];
  if (std::abs(approach) > 1e-9 * size)
  {
    const double share = offset / approach;
    for (const auto& [variation, component] : { std::pair{ DX, X }, { DY, Y }, { DKx, Kx }, { DKy, Ky } })
    {
      this->Begin[variation] += (this->BeginRate[component] - before[component]) * share;
    }
    evaluate(this->Medium, this->Region, this->DryDepth, this->Begin, this->BeginRate, local);
    this->RateScale = std::max(this->RateScale, std::hypot(this->Begin[DKx], this->Begin[DKy]));
  }
}

}
