#include "sim/HamiltonianRay.h"

#include "sim/CurrentDispersion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// What may happen within a step: the edge of the scene, land, a hole, a block, a wall, and kinks of the seafloor.

namespace swellray
{

using namespace rayequations;

namespace
{

// Above this share of the group speed at both ends of a step there is no need to look for a stop within it.
constexpr double SafeShare = 0.25;

// Sine of the angle to a wall below which a ray runs along it.
constexpr double Grazing = 1e-9;

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

  this->findObstacle(event);
  this->findLandOrHole(event);
  this->findStop(event);
  return event;
}

void HamiltonianRay::findObstacle(Event& event) const
{
  if (!this->Medium.obstacles)
  {
    return;
  }
  // The dense output as a polynomial in theta.
  PathPiece path;
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::size_t i = axis == 0 ? X : Y;
    path.coefficients[0][axis] = this->Begin[i];
    path.coefficients[1][axis] = this->Dense[0][i] + this->Dense[1][i];
    path.coefficients[2][axis] = this->Dense[2][i] + this->Dense[3][i] - this->Dense[1][i];
    path.coefficients[3][axis] = -this->Dense[2][i] - 2.0 * this->Dense[3][i];
    path.coefficients[4][axis] = this->Dense[3][i];
  }
  event.wall = this->Medium.obstacles->firstHit(path, event.theta, this->LeavingWall, this->LeavingSide);
  if (event.wall)
  {
    event.kind = Happening::End;
    event.reason = EndReason::StoppedByObstacle;
    event.theta = event.wall->theta;
  }
}

void HamiltonianRay::reflect(const RayPoint& wallPoint)
{
  const State before = this->StepSize > 0.0 ? this->dense(this->LastTheta) : this->Begin;
  State rate;
  Local local;
  ++this->Evaluations;
  if (!(this->Wall->reflection > 0.0) || this->Wall->corner ||
    !evaluate(this->Medium, this->Region, this->DryDepth, before, rate, local))
  {
    return;
  }
  const glm::dvec2 n = this->Wall->normal;
  const glm::dvec2 t(-n.y, n.x);
  const auto mirrored = [&](const glm::dvec2& v) { return v - 2.0 * glm::dot(n, v) * n; };
  const glm::dvec2 k(before[Kx], before[Ky]);
  const glm::dvec2 speed(rate[X], rate[Y]);
  const double towards = glm::dot(n, speed);
  if (!(std::abs(towards) > Grazing * glm::length(speed)))
  {
    return;
  }
  glm::dvec2 newK = mirrored(k);
  if (this->Medium.current)
  {
    const double across = local.scale * glm::dot(t, k);
    const std::optional<double> along =
      solveOnCurrent(this->Medium.angularFrequency, local.depth, this->Medium.gravity, n, across, wallPoint.current);
    if (!along)
    {
      return;
    }
    newK = *along / local.scale * n + glm::dot(t, k) * t;
  }
  State after = before;
  after[Kx] = newK.x;
  after[Ky] = newK.y;
  State newRate;
  evaluate(this->Medium, this->Region, this->DryDepth, after, newRate, local);

  // The neighbour's place and wavenumber when it meets the wall, and from there to the same time again.
  const glm::dvec2 dx(before[DX], before[DY]);
  const double delay = glm::dot(n, dx) / towards;
  const glm::dvec2 dxWall = dx - delay * speed;
  const glm::dvec2 dkWall = glm::dvec2(before[DKx], before[DKy]) - delay * glm::dvec2(rate[Kx], rate[Ky]);
  const glm::dvec2 newSpeed(newRate[X], newRate[Y]);
  const glm::dvec2 newForce(newRate[Kx], newRate[Ky]);
  glm::dvec2 dkNew = mirrored(dkWall);
  if (this->Medium.current)
  {
    // Along the wall the wavenumber is kept, and so is the frequency: dx/dt.dk = dk/dt.dx.
    const double along = glm::dot(t, dkWall);
    dkNew = along * t + (glm::dot(newForce, dxWall) - along * glm::dot(t, newSpeed)) / glm::dot(n, newSpeed) * n;
  }
  RayStart start;
  start.position = wallPoint.position;
  start.wavenumber = newK;
  // A mirror turns left into right: by the negative launch parameter the width keeps its sign.
  start.dPosition = -(dxWall + delay * newSpeed);
  start.dWavenumber = -(dkNew + delay * newForce);
  start.phase = wallPoint.phase;
  start.travelTime = wallPoint.travelTime;
  start.length = before[Length];
  start.caustics = wallPoint.caustics;
  start.wall = this->Wall->wall;
  start.wallSide = this->Wall->side;
  this->Reflected = start;
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
      event.wall.reset();
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
  const double length = (this->End[Length] - this->Begin[Length]) * std::max(this->BeginScale, this->EndScale);
  const double margin = 0.1 * length;
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
      event.wall.reset();
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
