#include "sim/FrontMarch.h"

#include "sim/Angles.h"
#include "sim/CurrentDispersion.h"
#include "sim/Dispersion.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

// Oversampling of the front: where neighbours are too far apart a ray is inserted between them
// (Gonzato and Le Saec 1997, section 3.3).

namespace swellray
{

namespace
{

// Neighbours that started this much closer (in spacings) than the launched rays are refined no further. Between rays
// on the water: what such a tube carries, spread over more than the spacing, is below a tenth of the incident energy density.
// At the edge of a shadow the lee rays take over, and go on until they are flat.
constexpr double FinestGap = 1.0 / 8.0;
constexpr double FinestShadowGap = 0.5;
constexpr double FinestLeeGap = 1e-6;

// Each pass over a front halves the gaps that are too wide.
constexpr int InsertionPasses = 12;

}

double FrontMarch::distance(const RayPoint& a, const RayPoint& b) const
{
  return glm::length(b.position - a.position) / this->Medium.scale(0.5 * (a.position + b.position));
}

bool FrontMarch::wantsInsertion(std::size_t at, Insertion& kind) const
{
  if (!this->Order[at].linked)
  {
    return false;
  }
  const Ray& a = this->standing(at);
  const Ray& b = this->standing(at + 1);
  if (a.waiting || b.waiting || !(this->distance(a.place, b.place) > this->MaxSpacing) ||
    (this->Medium.obstacles && this->Medium.obstacles->crosses(a.place.position, b.place.position)))
  {
    return false;
  }
  const double gap = std::abs(b.info.launchParameter - a.info.launchParameter) / this->Spacing;
  const bool retrace = this->Options.insertion == InsertionRule::Retrace && !a.info.lee && !b.info.lee;
  if (isOnWater(a.state) && isOnWater(b.state))
  {
    kind = retrace ? Insertion::Retrace : Insertion::Interpolate;
    const double finest = a.info.lee || b.info.lee ? FinestLeeGap : FinestGap;
    return !(a.state == RayState::Flat && b.state == RayState::Flat) && gap > finest;
  }
  if (isOnWater(a.state) == isOnWater(b.state))
  {
    return false;
  }
  // One is aground: refine only where the other one moves away from the coast.
  const Ray& shore = isOnWater(a.state) ? b : a;
  const Ray& water = isOnWater(a.state) ? a : b;
  if (!(glm::dot(water.place.rayDirection, shore.walk.seaward()) > 0.0))
  {
    return false;
  }
  if (retrace && gap > FinestShadowGap)
  {
    kind = Insertion::Retrace;
    return true;
  }
  kind = Insertion::Lee;
  return this->Options.leeRays && water.state != RayState::Flat && gap > FinestLeeGap && water.info.reflections == 0;
}

std::optional<double> FrontMarch::wavenumberAt(const glm::dvec2& position, const glm::dvec2& direction) const
{
  const RayMedium& medium = this->Medium;
  const double depth = std::max(medium.depth(position), medium.agroundDepth);
  return medium.current
    ? solveOnCurrent(medium.angularFrequency, depth, medium.gravity, direction, 0.0, medium.current->velocity(position))
    : solveWavenumber(medium.angularFrequency, depth, medium.gravity);
}

std::optional<RayStart> FrontMarch::startBetween(const Ray& a, const Ray& b) const
{
  const glm::dvec2 directionA = glm::normalize(a.place.wavenumber);
  const glm::dvec2 directionB = glm::normalize(b.place.wavenumber);
  glm::dvec2 direction = directionA + directionB;
  const double size = glm::length(direction);
  if (!(size > 0.0))
  {
    return {};
  }
  direction /= size;
  RayStart start;
  start.position = 0.5 * (a.place.position + b.place.position);
  const std::optional<double> found = this->wavenumberAt(start.position, direction);
  if (!found)
  {
    return {};
  }
  const double k = *found / this->Medium.scale(start.position);
  start.wavenumber = k * direction;
  // The tube between the two, by differences.
  const double gap = b.info.launchParameter - a.info.launchParameter;
  const double sign = a.info.reflections % 2 == 0 ? 1.0 : -1.0; // as the mirror turns it
  start.dPosition = sign * (b.place.position - a.place.position) / gap;
  start.dWavenumber = sign * k * (directionB - directionA) / gap;
  start.phase = 0.5 * (a.place.phase + b.place.phase);
  start.travelTime = 0.5 * (a.place.travelTime + b.place.travelTime);
  start.length = this->frontValue();
  start.caustics = std::min(a.place.caustics, b.place.caustics);
  return start;
}

void FrontMarch::makeInsertion(InsertionJob& job, double target) const
{
  const Ray& a = this->standing(job.after);
  const Ray& b = this->standing(job.after + 1);
  Ray& ray = job.ray;
  ray.waiting = false;
  ray.info.launchParameter = 0.5 * (a.info.launchParameter + b.info.launchParameter);
  ray.info.launchSegment = a.info.launchSegment;
  ray.info.parent = static_cast<std::int32_t>(this->Order[job.after].ray);
  ray.info.lee = job.kind == Insertion::Lee || a.info.lee || b.info.lee;
  ray.info.reflections = a.info.reflections;
  ray.info.reflection = a.info.reflection;
  ray.wallNormal = a.wallNormal;

  RayStart start;
  if (job.kind == Insertion::Retrace)
  {
    int segment = 0;
    start = this->launch(ray.info.launchParameter, segment);
    if (this->measureOf(start) > target)
    {
      return;
    }
    const Mirrored mirrored = this->mirror(ray, start, target);
    if (mirrored != Mirrored::Done)
    {
      job.severed = mirrored == Mirrored::Elsewhere;
      return;
    }
  }
  else
  {
    const std::optional<RayStart> between = this->startBetween(a, b);
    // What would run back against the incident wave is no diffraction into the lee.
    if (!between || (job.kind == Insertion::Lee && glm::dot(between->wavenumber, this->Wave.direction()) < 0.0))
    {
      return;
    }
    start = *between;
    if (this->Medium.depth(start.position) < this->Medium.agroundDepth ||
      this->Medium.seafloor->isHole(start.position) ||
      (this->Medium.obstacles && this->Medium.obstacles->inside(start.position)))
    {
      return;
    }
  }
  ray.measure = this->measureOf(start);
  ray.path = this->makePath(start);
  this->advance(ray, std::max(target, ray.measure));
  // It begins on this front: what lies before is not shown.
  ray.betweenCount = 0;
  job.keep = job.kind == Insertion::Retrace ? ray.state != RayState::Dead : isOnWater(ray.state);
  job.severed = job.kind == Insertion::Retrace && ray.state == RayState::Dead;
}

void FrontMarch::insertRays()
{
  if (this->Options.insertion == InsertionRule::None)
  {
    return;
  }
  const double target = this->frontValue();
  for (int pass = 0; pass < InsertionPasses; ++pass)
  {
    std::vector<InsertionJob> jobs;
    for (std::size_t i = 0; i + 1 < this->Order.size(); ++i)
    {
      Insertion kind = Insertion::Retrace;
      if (this->wantsInsertion(i, kind))
      {
        if (this->Rays.size() + jobs.size() >= this->Options.maxRays)
        {
          this->RayCapReached = true;
          break;
        }
        jobs.emplace_back();
        jobs.back().after = i;
        jobs.back().kind = kind;
      }
    }
    if (jobs.empty())
    {
      return;
    }
    this->Run.forRange(jobs.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->makeInsertion(jobs[i], target);
        }
      });

    bool inserted = false;
    std::vector<Standing> order;
    order.reserve(this->Order.size() + jobs.size());
    auto job = jobs.begin();
    for (std::size_t i = 0; i < this->Order.size(); ++i)
    {
      order.push_back(this->Order[i]);
      if (job == jobs.end() || job->after != i)
      {
        continue;
      }
      if (job->keep)
      {
        order.push_back({ static_cast<std::uint32_t>(this->Rays.size()), true });
        this->Rays.push_back(std::move(job->ray));
        this->remember(static_cast<std::uint32_t>(this->Rays.size() - 1));
        inserted = true;
      }
      else
      {
        if (job->ray.path)
        {
          this->Steps += job->ray.path->steps();
          this->Evaluations += job->ray.path->evaluations();
        }
        if (job->severed)
        {
          order.back().linked = false;
        }
      }
      ++job;
    }
    this->Order.swap(order);
    if (!inserted)
    {
      return;
    }
  }
}

}
