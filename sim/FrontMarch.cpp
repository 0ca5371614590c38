#include "sim/FrontMarch.h"

#include "sim/Angles.h"
#include "sim/Dispersion.h"
#include "sim/HamiltonianRay.h"
#include "sim/SnellRay.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace swellray
{

namespace
{

// Default launch spacing: a share of the launch width, within these numbers of rays.
constexpr double FewestRays = 100.0;
constexpr double MostRays = 2000.0;

// Fronts a wavelength, halved until the launched rays have no more points than this between them.
constexpr double UsualStepsPerWave = 8.0;
constexpr double MostLaunchedPoints = 1.5e6;

// Cosine of the turn from the incident direction (120 degrees) at which a walk along the shore ends: a crest does not
// wrap around an island for ever.
constexpr double LargestTurn = -0.5;

}

FrontMarch::FrontMarch(const RayMedium& medium, const IncidentWave& wave, const TraceOptions& options,
  const LaunchLine& line, const Execution& execution)
  : Medium(medium)
  , Wave(wave)
  , Options(options)
  , Line(line)
  , Run(execution)
{
  const double wavelength = 2.0 * Pi / wave.wavenumber();
  const double width = line.length();
  if (line.raySpacing())
  {
    this->Spacing = *line.raySpacing();
  }
  else if (options.spacing)
  {
    this->Spacing = *options.spacing;
  }
  else
  {
    const double wanted = std::ceil(width / std::min(width / FewestRays, 0.5 * wavelength));
    this->Spacing = width / std::clamp(wanted, FewestRays, MostRays);
  }
  this->MaxSpacing = options.maxSpacing.value_or(1.5 * this->Spacing);
  double steps = options.stepsPerWave.value_or(UsualStepsPerWave);
  if (!options.stepsPerWave)
  {
    const double waves = glm::length(medium.seafloor->bounds().size()) / wavelength;
    while (steps * waves * width / this->Spacing > MostLaunchedPoints)
    {
      steps *= 0.5;
    }
  }
  this->SnellStep = options.step.value_or(wavelength / steps);
  if (options.step)
  {
    this->Measure = FrontMeasure::Length;
    this->FrontStep = *options.step;
  }
  else
  {
    this->FrontStep = 2.0 * Pi / steps;
    this->StepsPerWave = steps;
  }
}

RayField FrontMarch::run()
{
  this->launchAll();
  const Rectangle box = this->Medium.seafloor->bounds();
  const double diagonal = glm::length(box.size());
  const double expected = std::max(
    1.0, 1.5 * diagonal / this->FrontStep * (this->Measure == FrontMeasure::Phase ? this->Wave.wavenumber() : 1.0));
  for (this->Front = 0; this->anyOnWater(); ++this->Front)
  {
    if (this->Front >= this->Options.maxFronts || this->Points >= this->Options.maxPoints)
    {
      this->StepCapReached = true;
      this->finishRemaining(EndReason::StepCap);
      break;
    }
    if (!this->Run.report(1.0 - std::exp(-2.0 * this->Front / expected)))
    {
      this->Cancelled = true;
      this->finishRemaining(EndReason::Cancelled);
      break;
    }
    const double target = this->frontValue();
    this->Records.emplace_back();
    this->Run.forRange(this->Order.size(),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->advance(this->standing(i), target);
        }
      });
    this->reflectEnded();
    this->insertRays();
    this->settleShore();
    this->findBlocked();
    this->measureSpacing();
    this->markFlat();
    this->recordFront();
  }
  return this->collect();
}

std::unique_ptr<RayPath> FrontMarch::makePath(const RayStart& start) const
{
  if (this->Options.scheme == TraceScheme::Snell)
  {
    return std::make_unique<SnellRay>(this->Medium, start, this->SnellStep);
  }
  return std::make_unique<HamiltonianRay>(this->Medium, start, this->Options.tolerance);
}

RayStart FrontMarch::launch(double lambda, int& segment) const
{
  const LaunchPoint point = this->Line.at(lambda);
  segment = point.segment;
  RayStart start;
  start.position = point.position;
  start.wavenumber = point.wavenumber;
  start.dPosition = point.dPosition;
  start.dWavenumber = point.dWavenumber;
  start.phase = point.phase;
  return start;
}

double FrontMarch::measureOf(const RayStart& start) const
{
  return this->Measure == FrontMeasure::Phase ? start.phase : start.length;
}

double FrontMarch::frontValue() const
{
  return this->Front * this->FrontStep;
}

void FrontMarch::launchAll()
{
  const double width = this->Line.length();
  double count = std::max(1.0, std::floor(width / this->Spacing * (1.0 + 1e-12)));
  if (count > static_cast<double>(this->Options.maxRays))
  {
    count = static_cast<double>(this->Options.maxRays);
    this->RayCapReached = true;
  }
  const double margin = std::max(0.0, 0.5 * (width - count * this->Spacing));
  const auto rays = static_cast<std::size_t>(count);
  this->Rays.resize(rays);
  this->Order.resize(rays);
  this->Run.forRange(rays,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        Ray& ray = this->Rays[i];
        const double share = (static_cast<double>(i) + 0.5) * this->Spacing;
        ray.info.launchParameter = std::min(margin + share, width);
        const RayStart start = this->launch(ray.info.launchParameter, ray.info.launchSegment);
        ray.path = this->makePath(start);
        ray.measure = this->measureOf(start);
        RayPoint& point = ray.between[0];
        ray.path->advance(this->Measure, ray.measure, point);
        point.spacingWidth = (point.rayDirection.x * start.dPosition.y - point.rayDirection.y * start.dPosition.x) /
          this->Medium.scale(start.position);
        point.front = BetweenFronts;
        point.state = RayState::Alive;
        ray.betweenCount = 1;
        ray.place = point;
      }
    });
  for (std::size_t i = 0; i < rays; ++i)
  {
    this->Order[i].ray = static_cast<std::uint32_t>(i);
    this->Order[i].linked = i + 1 < rays && this->Rays[i].info.launchSegment == this->Rays[i + 1].info.launchSegment;
    this->FirstMirror = std::max(this->FirstMirror, this->Rays[i].info.launchSegment + 1);
    this->remember(static_cast<std::uint32_t>(i));
  }
}

void FrontMarch::advance(Ray& ray, double target) const
{
  ray.launching = false;
  if (ray.waiting)
  {
    if (ray.measure > target)
    {
      return;
    }
    ray.waiting = false;
    if (ray.measure > target - 1e-9 * this->FrontStep)
    {
      ray.launching = true;
      ray.betweenCount = 0;
    }
  }
  ray.place.front = this->Front;
  if (ray.state == RayState::Aground)
  {
    this->walkOn(ray, target);
    return;
  }
  if (ray.path->advance(this->Measure, target, ray.place))
  {
    ray.measure = target;
    return;
  }
  ray.measure = this->Measure == FrontMeasure::Phase ? ray.place.phase : ray.path->length();
  ray.info.endReason = ray.path->endReason();
  const bool aground = ray.info.endReason == EndReason::Aground;
  RayPoint& end = ray.between[ray.betweenCount++];
  end = ray.place;
  end.front = BetweenFronts;
  end.state = aground ? RayState::Aground : RayState::Dead;
  ray.state = end.state;
  if (aground)
  {
    ray.walk = ShorelineWalk(this->Medium, ray.place);
    this->walkOn(ray, target);
  }
}

void FrontMarch::walkOn(Ray& ray, double target) const
{
  const double ahead = std::max(0.0, target - ray.measure);
  const double k = ray.walk.wavenumber();
  const double distance = this->Measure == FrontMeasure::Phase ? ahead / k : ahead;
  const glm::dvec2 from = ray.walk.position();
  if (!ray.walk.advance(distance) || glm::dot(ray.walk.direction(), this->Wave.direction()) < LargestTurn ||
    (this->Medium.obstacles && this->Medium.obstacles->crosses(from, ray.walk.position())))
  {
    ray.state = RayState::Dead;
    return;
  }
  ray.measure = target;
  ray.place.position = ray.walk.position();
  ray.place.rayDirection = ray.walk.direction();
  ray.place.wavenumber = k * ray.walk.direction();
  ray.place.current = glm::dvec2(0.0);
  ray.place.depth = this->Medium.agroundDepth;
  ray.place.phase += k * distance;
  ray.place.travelTime += distance / ray.walk.groupSpeed();
}

void FrontMarch::settleEnded()
{
  std::vector<Standing> kept;
  kept.reserve(this->Order.size());
  for (const Standing& standing : this->Order)
  {
    Ray& ray = this->Rays[standing.ray];
    if (ray.state != RayState::Dead)
    {
      kept.push_back(standing);
      continue;
    }
    // Who stood on either side of a ray that is gone are no neighbours.
    if (!kept.empty())
    {
      kept.back().linked = false;
    }
    this->record(standing.ray, false);
    this->retire(standing.ray);
  }
  this->Order.swap(kept);
}

double FrontMarch::shoreStep() const
{
  const double k = solveWavenumber(this->Medium.angularFrequency, this->Medium.agroundDepth, this->Medium.gravity);
  return this->Measure == FrontMeasure::Phase ? this->FrontStep / k : this->FrontStep;
}

void FrontMarch::settleShore()
{
  const std::size_t count = this->Order.size();
  const double closed = 2.0 * this->shoreStep();
  const auto aground = [&](std::size_t i) { return this->standing(i).state == RayState::Aground; };
  const auto place = [&](std::size_t i) { return this->standing(i).place.position; };
  const auto apart = [&](std::size_t i, std::size_t j)
  { return this->distance(this->standing(i).place, this->standing(j).place); };
  std::vector<bool> dead(count, false);
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool left = i > 0 && this->Order[i - 1].linked && aground(i - 1);
    const bool right = i + 1 < count && this->Order[i].linked && aground(i + 1);
    if (left && right && !this->standing(i).waiting)
    {
      // A ray on the water ends only when the shore has closed in on it.
      dead[i] = aground(i) || apart(i - 1, i + 1) < closed;
    }
    else if (right && aground(i))
    {
      // Two that meet behind an island have closed the front. What ran aground between them does not come back.
      const glm::dvec2 way = place(i + 1) - place(i);
      if (apart(i, i + 1) < closed && glm::dot(this->standing(i).walk.direction(), way) > 0.0 &&
        glm::dot(this->standing(i + 1).walk.direction(), way) < 0.0)
      {
        dead[i] = true;
        dead[i + 1] = true;
        this->Order[i].linked = false;
      }
    }
  }

  std::vector<Standing> kept;
  kept.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Standing& standing = this->Order[i];
    if (!dead[i])
    {
      kept.push_back(standing);
      continue;
    }
    Ray& ray = this->Rays[standing.ray];
    if (ray.state != RayState::Aground)
    {
      ray.info.endReason = EndReason::BetweenAground;
    }
    ray.state = RayState::Dead;
    this->record(standing.ray, true);
    this->retire(standing.ray);
    // Its neighbours close up, where it had both.
    if (!kept.empty())
    {
      kept.back().linked = kept.back().linked && standing.linked;
    }
  }
  this->Order.swap(kept);
}

bool FrontMarch::anyOnWater() const
{
  return std::any_of(this->Order.begin(), this->Order.end(),
    [&](const Standing& standing)
    {
      const Ray& ray = this->Rays[standing.ray];
      return ray.waiting || isOnWater(ray.state);
    });
}

void FrontMarch::finishRemaining(EndReason reason)
{
  for (const Standing& standing : this->Order)
  {
    Ray& ray = this->Rays[standing.ray];
    if (isOnWater(ray.state))
    {
      ray.info.endReason = reason;
    }
  }
}

}
