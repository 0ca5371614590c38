#include "sim/FrontMarch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

// Walls on the way of the front: what they reflect goes on as rays that the wall launches, and what stands between two
// rays parts them.

namespace swellray
{

namespace
{

// Share of the incident height below which a reflected wave is not traced.
constexpr double LowestShare = 0.01;

// Cosine of the turn of a wall beyond which what its two sides reflect is not one wave.
constexpr double LargestBend = 0.7;

}

bool FrontMarch::goesOn(const Ray& ray) const
{
  return ray.state == RayState::Dead && ray.path && ray.path->reflection() &&
    static_cast<std::size_t>(ray.info.reflections) < this->Options.maxReflections &&
    this->heightOf(ray) * ray.path->wall()->reflection >= LowestShare * this->Wave.height;
}

std::int32_t FrontMarch::mirrorSegment(std::int32_t from, std::size_t obstacle)
{
  const auto found = std::find_if(this->Mirrors.begin(), this->Mirrors.end(),
    [=](const Mirror& mirror) { return mirror.from == from && mirror.obstacle == obstacle; });
  const auto index = static_cast<std::int32_t>(found - this->Mirrors.begin());
  if (found == this->Mirrors.end())
  {
    this->Mirrors.push_back({ from, obstacle });
  }
  return this->FirstMirror + index;
}

FrontMarch::Ray FrontMarch::reflectedRay(std::uint32_t index)
{
  const Ray& stopped = this->Rays[index];
  const RayStart& start = *stopped.path->reflection();
  const WallHit& wall = *stopped.path->wall();
  Ray ray;
  ray.info = stopped.info;
  ray.info.parent = static_cast<std::int32_t>(index);
  ray.info.launchSegment = this->mirrorSegment(stopped.info.launchSegment, wall.obstacle);
  ray.info.endReason = EndReason::StepCap;
  ray.info.finalState = RayState::Alive;
  ++ray.info.reflections;
  ray.info.reflection *= wall.reflection;
  ray.wallNormal = wall.normal;
  ray.path = this->makePath(start);
  ray.measure = this->measureOf(start);
  ray.waiting = false;
  RayPoint& point = ray.between[0];
  ray.path->advance(this->Measure, ray.measure, point);
  point.spacingWidth = stopped.place.spacingWidth;
  point.front = BetweenFronts;
  point.state = RayState::Alive;
  ray.betweenCount = 1;
  ray.place = point;
  return ray;
}

void FrontMarch::reflectEnded()
{
  const bool reflects = this->Medium.obstacles && this->Medium.obstacles->anyReflects();
  std::vector<std::uint32_t> stopped;
  for (std::size_t i = 0; reflects && i < this->Order.size(); ++i)
  {
    if (this->goesOn(this->standing(i)))
    {
      stopped.push_back(this->Order[i].ray);
    }
  }
  const double target = this->frontValue();
  const std::size_t before = this->Rays.size();
  // The list grows where a reflected wave meets another wall before this front.
  for (std::size_t i = 0; i < stopped.size(); ++i)
  {
    if (this->Rays.size() >= this->Options.maxRays)
    {
      this->RayCapReached = true;
      break;
    }
    const auto index = static_cast<std::uint32_t>(this->Rays.size());
    Ray ray = this->reflectedRay(stopped[i]);
    const bool onFront = ray.measure > target - 1e-9 * this->FrontStep;
    this->advance(ray, std::max(target, ray.measure));
    if (onFront && ray.state != RayState::Dead)
    {
      ray.launching = true;
      ray.betweenCount = 0;
    }
    if (this->goesOn(ray))
    {
      stopped.push_back(index);
    }
    this->Rays[stopped[i]].reflected = static_cast<std::int32_t>(index);
    this->Rays.push_back(std::move(ray));
    this->remember(index);
  }
  this->settleEnded();
  for (std::size_t i = before; i < this->Rays.size(); ++i)
  {
    this->stand(static_cast<std::uint32_t>(i));
  }
}

void FrontMarch::stand(std::uint32_t index)
{
  const Ray& ray = this->Rays[index];
  if (ray.state == RayState::Dead)
  {
    this->record(index, false);
    this->retire(index);
    return;
  }
  const auto place = [&](std::uint32_t other)
  {
    const RayInfo& info = this->Rays[other].info;
    return std::make_tuple(info.launchSegment, info.launchParameter, other);
  };
  const auto next = std::lower_bound(this->Order.begin(), this->Order.end(), place(index),
    [&](const Standing& standing, const auto& wanted) { return place(standing.ray) < wanted; });
  Standing own{ index };
  if (next != this->Order.end())
  {
    own.linked = this->areNeighbours(ray, this->Rays[next->ray]);
  }
  if (next != this->Order.begin())
  {
    Standing& previous = *std::prev(next);
    previous.linked = this->areNeighbours(this->Rays[previous.ray], ray);
  }
  this->Order.insert(next, own);
}

bool FrontMarch::areNeighbours(const Ray& a, const Ray& b) const
{
  if (a.info.launchSegment != b.info.launchSegment || glm::dot(a.wallNormal, b.wallNormal) < LargestBend)
  {
    return false;
  }
  // No ray that has not met the obstacle comes in between the two.
  const std::int32_t from = this->Mirrors[static_cast<std::size_t>(a.info.launchSegment - this->FirstMirror)].from;
  const auto next =
    this->Family.upper_bound(std::make_tuple(from, a.info.launchParameter, std::numeric_limits<std::uint32_t>::max()));
  return next == this->Family.end() || std::get<0>(*next) != from || std::get<1>(*next) >= b.info.launchParameter;
}

void FrontMarch::remember(std::uint32_t index)
{
  if (this->Medium.obstacles && this->Medium.obstacles->anyReflects())
  {
    const RayInfo& info = this->Rays[index].info;
    this->Family.emplace(info.launchSegment, info.launchParameter, index);
  }
}

FrontMarch::Mirrored FrontMarch::mirror(Ray& ray, RayStart& start, double target) const
{
  std::vector<std::size_t> obstacles;
  for (std::int32_t segment = ray.info.launchSegment; segment >= this->FirstMirror && ray.info.reflections > 0;)
  {
    const Mirror& mirror = this->Mirrors[static_cast<std::size_t>(segment - this->FirstMirror)];
    obstacles.push_back(mirror.obstacle);
    segment = mirror.from;
  }
  for (auto obstacle = obstacles.rbegin(); obstacle != obstacles.rend(); ++obstacle)
  {
    const std::unique_ptr<RayPath> path = this->makePath(start);
    RayPoint point;
    if (path->advance(this->Measure, target, point))
    {
      return Mirrored::NotYet;
    }
    if (!path->reflection() || path->wall()->obstacle != *obstacle)
    {
      return Mirrored::Elsewhere;
    }
    ray.wallNormal = path->wall()->normal;
    start = *path->reflection();
  }
  return Mirrored::Done;
}

void FrontMarch::findBlocked()
{
  if (!this->Medium.obstacles)
  {
    return;
  }
  this->Run.forRange(this->Order.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        Standing& standing = this->Order[i];
        standing.blocked = standing.linked && !this->standing(i).waiting && !this->standing(i + 1).waiting &&
          this->Medium.obstacles->crosses(this->standing(i).place.position, this->standing(i + 1).place.position);
      }
    });
}

// Where a ray that came in between two others went elsewhere, or the wall has a corner, these are no neighbours.
void FrontMarch::splitMirrors()
{
  if (this->Mirrors.empty())
  {
    return;
  }
  std::vector<std::int32_t> segments(this->Rays.size());
  std::transform(
    this->Rays.begin(), this->Rays.end(), segments.begin(), [](const Ray& ray) { return ray.info.launchSegment; });
  std::int32_t next = this->FirstMirror;
  for (std::size_t m = 0; m < this->Mirrors.size(); ++m)
  {
    const std::int32_t from = this->Mirrors[m].from;
    const std::int32_t own = this->FirstMirror + static_cast<std::int32_t>(m);
    const auto members = [&](std::int32_t segment)
    { return this->Family.lower_bound(std::make_tuple(segment, -std::numeric_limits<double>::infinity(), 0U)); };
    std::int64_t before = -1; // the ray that came in before, where it was reflected here
    for (auto member = members(from); member != members(from + 1); ++member)
    {
      const std::uint32_t ray = std::get<2>(*member);
      const std::int32_t child = this->Rays[ray].reflected;
      if (child < 0 || this->Rays[static_cast<std::size_t>(child)].info.launchSegment != own)
      {
        before = -1;
        continue;
      }
      const auto c = static_cast<std::size_t>(child);
      bool joined = false;
      if (before >= 0)
      {
        const auto b = static_cast<std::size_t>(this->Rays[static_cast<std::size_t>(before)].reflected);
        joined = segments[static_cast<std::size_t>(before)] == segments[ray] &&
          glm::dot(this->Rays[b].wallNormal, this->Rays[c].wallNormal) >= LargestBend;
      }
      segments[c] = joined ? next - 1 : next++;
      before = ray;
    }
    // Those inserted between two of them.
    std::vector<std::uint32_t> inserted;
    for (auto member = members(own); member != members(own + 1); ++member)
    {
      const std::uint32_t ray = std::get<2>(*member);
      if (this->Rays[static_cast<std::size_t>(this->Rays[ray].info.parent)].info.launchSegment == own)
      {
        inserted.push_back(ray);
      }
    }
    std::sort(inserted.begin(), inserted.end());
    for (const std::uint32_t ray : inserted)
    {
      segments[ray] = segments[static_cast<std::size_t>(this->Rays[ray].info.parent)];
    }
  }
  for (std::size_t i = 0; i < this->Rays.size(); ++i)
  {
    this->Rays[i].info.launchSegment = segments[i];
  }
}

}
