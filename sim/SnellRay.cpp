#include "sim/SnellRay.h"

#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace swellray
{

SnellRay::SnellRay(const RayMedium& medium, const RayStart& start, double step, std::size_t maxSteps)
  : Medium(medium)
  , Step(step)
  , MaxSteps(maxSteps)
{
  this->Before.position = start.position;
  this->Before.direction = glm::normalize(start.wavenumber);
  this->Before.depth = medium.depth(start.position);
  this->Before.phase = start.phase;
  this->Before.travelTime = start.travelTime;
  this->Before.length = start.length;
  this->After = this->Before;
  this->LeavingWall = start.wall;
  this->LeavingSide = start.wallSide;
  if (!(this->Before.depth >= medium.agroundDepth))
  {
    this->Reason = EndReason::Aground;
    this->Ended = true;
  }
  else if (medium.seafloor->isHole(start.position))
  {
    this->Reason = EndReason::EnteredHole;
    this->Ended = true;
  }
}

bool SnellRay::advance(FrontMeasure measure, double target, RayPoint& point)
{
  const auto value = [measure](const Place& place)
  {
    switch (measure)
    {
    case FrontMeasure::Phase:
      return place.phase;
    case FrontMeasure::Time:
      return place.travelTime;
    default:
      return place.length;
    }
  };
  while (true)
  {
    if (target <= value(this->After))
    {
      const double span = value(this->After) - value(this->Before);
      this->describe(span > 0.0 ? std::clamp((target - value(this->Before)) / span, 0.0, 1.0) : 1.0, point);
      return true;
    }
    if (this->Terminal || this->Ended || !this->step())
    {
      this->Ended = true;
      this->describe(1.0, point);
      this->reflect();
      return false;
    }
  }
}

bool SnellRay::contourNormal(const glm::dvec2& position, double depth, glm::dvec2& normal, double& slope) const
{
  // Circumscribed radius of the triangle: half a step sees the bed between this point and the next.
  const double radius = 0.5 * this->Step;
  const double sine = 0.5 * std::sqrt(3.0);
  const std::array<glm::dvec2, 3> corner{ position + radius * glm::dvec2(1.0, 0.0),
    position + radius * glm::dvec2(-0.5, sine), position + radius * glm::dvec2(-0.5, -sine) };
  std::array<double, 3> difference{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    difference[i] = this->Medium.depth(corner[i]) - depth;
  }
  std::array<glm::dvec2, 3> crossing;
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    if ((difference[i] < 0.0) != (difference[j] < 0.0))
    {
      crossing[crossings++] = corner[i] + (corner[j] - corner[i]) * (difference[i] / (difference[i] - difference[j]));
    }
  }
  if (crossings != 2)
  {
    return false;
  }
  const glm::dvec2 along = crossing[1] - crossing[0];
  const double length = glm::length(along);
  if (!(length > 0.0))
  {
    return false;
  }
  normal = glm::dvec2(-along.y, along.x) / length;
  const glm::dvec2 gradient = (2.0 / (3.0 * radius * radius)) *
    (difference[0] * (corner[0] - position) + difference[1] * (corner[1] - position) +
      difference[2] * (corner[2] - position));
  slope = glm::length(gradient);
  return true;
}

bool SnellRay::step()
{
  if (this->Steps >= this->MaxSteps)
  {
    this->Reason = EndReason::StepCap;
    return false;
  }
  ++this->Steps;
  this->Evaluations += 5;
  this->Before = this->After;
  const double omega = this->Medium.angularFrequency;
  const glm::dvec2 position = this->Before.position;
  glm::dvec2 direction = this->Before.direction;
  const double depth = this->Before.depth;
  const double k = solveWavenumber(omega, depth, this->Medium.gravity);
  const double depthAhead = this->Medium.depth(position + this->Step * direction);
  glm::dvec2 normal;
  double slope = 0.0;
  if (depthAhead > this->Medium.agroundDepth && this->contourNormal(position, depth, normal, slope))
  {
    // sin i2 / C2 = sin i1 / C1, angles from the normal on the side the ray goes to.
    const double ratio = k / solveWavenumber(omega, depthAhead, this->Medium.gravity);
    const double across = glm::dot(direction, normal);
    const glm::dvec2 tangent = direction - across * normal;
    const double sine = glm::length(tangent);
    if (sine * ratio < 1.0)
    {
      direction = tangent * ratio + normal * std::copysign(std::sqrt(1.0 - sine * sine * ratio * ratio), across);
    }
    else
    {
      // Along the contour Snell's law has no answer: the ray turns back from the deep as the slope here says. To reflect
      // it would be to catch every ray that passes a shoal, at any step.
      const double turn = 1.0 - solveWavenumber(omega, depth + slope * this->Step, this->Medium.gravity) / k;
      direction = glm::normalize(tangent / sine + normal * (across - std::copysign(turn, across)));
    }
  }

  double length = this->Step;
  glm::dvec2 next = position + length * direction;
  const Seafloor& seafloor = *this->Medium.seafloor;
  const Rectangle box = seafloor.bounds();
  if (!box.contains(next))
  {
    double share = 1.0;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double way = next[axis] - position[axis];
      if (next[axis] < box.low[axis])
      {
        share = std::min(share, (box.low[axis] - position[axis]) / way);
      }
      else if (next[axis] > box.high[axis])
      {
        share = std::min(share, (box.high[axis] - position[axis]) / way);
      }
    }
    length *= std::clamp(share, 0.0, 1.0);
    this->Terminal = true;
    this->Reason = EndReason::LeftScene;
  }
  if (this->Medium.obstacles)
  {
    const PathPiece path{ { position, length * direction } };
    if (const auto hit = this->Medium.obstacles->firstHit(path, 1.0, this->LeavingWall, this->LeavingSide))
    {
      length *= hit->theta;
      this->Wall = hit;
      this->Terminal = true;
      this->Reason = EndReason::StoppedByObstacle;
    }
    this->LeavingWall.reset();
  }
  const int parts = std::max(1, static_cast<int>(std::ceil(length / seafloor.resolution())));
  double before = 0.0;
  for (int i = 1; i <= parts; ++i)
  {
    const double at = length * i / parts;
    const auto landAt = [&](double s)
    { return this->Medium.depth(position + s * direction) < this->Medium.agroundDepth; };
    const auto holeAt = [&](double s) { return seafloor.isHole(position + s * direction); };
    const bool land = landAt(at);
    if (land || holeAt(at))
    {
      double low = before;
      double high = at;
      for (int halving = 0; halving < 50; ++halving)
      {
        const double middle = 0.5 * (low + high);
        ((land ? landAt(middle) : holeAt(middle)) ? high : low) = middle;
      }
      length = high;
      this->Wall.reset();
      this->Terminal = true;
      this->Reason = land ? EndReason::Aground : EndReason::EnteredHole;
      break;
    }
    before = at;
  }
  next = position + length * direction;

  this->After.position = next;
  this->After.direction = direction;
  this->After.depth = this->Medium.depth(next);
  this->After.phase = this->Before.phase + k * length;
  this->After.travelTime = this->Before.travelTime + length / waveSpeeds(k, depth, this->Medium.gravity).groupSpeed;
  this->After.length = this->Before.length + length;
  return true;
}

void SnellRay::reflect()
{
  if (!this->Wall || !(this->Wall->reflection > 0.0) || this->Wall->corner)
  {
    return;
  }
  const glm::dvec2 n = this->Wall->normal;
  const double k = solveWavenumber(this->Medium.angularFrequency, this->After.depth, this->Medium.gravity);
  RayStart start;
  start.position = this->After.position;
  start.wavenumber = k * (this->After.direction - 2.0 * glm::dot(n, this->After.direction) * n);
  start.phase = this->After.phase;
  start.travelTime = this->After.travelTime;
  start.length = this->After.length;
  start.wall = this->Wall->wall;
  start.wallSide = this->Wall->side;
  this->Reflected = start;
}

void SnellRay::describe(double share, RayPoint& point)
{
  const auto mix = [share](double a, double b) { return a + share * (b - a); };
  point.position = this->Before.position + share * (this->After.position - this->Before.position);
  point.depth = this->Medium.depth(point.position);
  point.rayDirection = this->After.direction;
  const double depth = std::max(point.depth, this->Medium.agroundDepth);
  point.wavenumber = point.rayDirection * solveWavenumber(this->Medium.angularFrequency, depth, this->Medium.gravity);
  point.phase = mix(this->Before.phase, this->After.phase);
  point.travelTime = mix(this->Before.travelTime, this->After.travelTime);
  point.tubeWidth = std::numeric_limits<double>::quiet_NaN();
  point.caustics = 0;
  this->ReadLength = mix(this->Before.length, this->After.length);
}

}
