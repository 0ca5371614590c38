#include "sim/FrontMarch.h"

#include "sim/Angles.h"
#include "sim/CausticRates.h"

#include <glm/geometric.hpp>

// What is kept of every front, and the rays that it becomes in the end.

namespace swellray
{

namespace
{

// Cells a wavelength below which a grid is too coarse for the wave.
constexpr double FewestCells = 5.0;

}

void FrontMarch::record(std::uint32_t index, bool withPlace)
{
  Ray& ray = this->Rays[index];
  std::vector<Record>& records = this->Records.back();
  for (int i = 0; i < ray.betweenCount; ++i)
  {
    records.push_back({ index, ray.between[i] });
  }
  ray.betweenCount = 0;
  if (withPlace)
  {
    ray.place.state = ray.state;
    records.push_back({ index, ray.place });
    ++this->Points;
  }
}

void FrontMarch::retire(std::uint32_t index)
{
  Ray& ray = this->Rays[index];
  ray.info.finalState = ray.state;
  if (ray.path)
  {
    ray.info.dispersionError = ray.path->dispersionError();
    ray.caustics = ray.info.lee ? std::vector<RayCaustic>() : ray.path->caustics();
    this->Steps += ray.path->steps();
    this->Evaluations += ray.path->evaluations();
    ray.path.reset();
  }
}

void FrontMarch::recordFront()
{
  for (const Standing& standing : this->Order)
  {
    if (!this->Rays[standing.ray].waiting)
    {
      this->record(standing.ray, true);
    }
  }
}

RayField FrontMarch::collect()
{
  this->splitMirrors();
  for (const Standing& standing : this->Order)
  {
    // A ray the march did not come to has its launch point.
    if (this->Rays[standing.ray].waiting)
    {
      this->Records.emplace_back();
      this->record(standing.ray, false);
    }
    this->retire(standing.ray);
  }

  RayField field;
  field.fronts = this->Front;
  field.spacing = this->Spacing;
  field.maxSpacing = this->MaxSpacing;
  field.stepsPerWave = this->StepsPerWave;
  field.launchWidth = this->Line.length();
  field.rayCapReached = this->RayCapReached;
  field.stepCapReached = this->StepCapReached;
  field.cancelled = this->Cancelled;
  field.steps = this->Steps;
  field.evaluations = this->Evaluations;
  field.rays.reserve(this->Rays.size());
  for (Ray& ray : this->Rays)
  {
    field.stepCapReached = field.stepCapReached || ray.info.endReason == EndReason::StepCap;
    field.rays.push_back(ray.info);
    for (RayCaustic& caustic : ray.caustics)
    {
      caustic.ray = static_cast<std::int32_t>(field.rays.size()) - 1;
      field.caustics.push_back(caustic);
    }
  }
  findCausticRates(field);
  this->Rays.clear();

  std::vector<std::size_t> next(field.rays.size() + 1, 0);
  for (const std::vector<Record>& records : this->Records)
  {
    for (const Record& record : records)
    {
      ++next[record.ray + 1];
    }
  }
  for (std::size_t i = 1; i < next.size(); ++i)
  {
    next[i] += next[i - 1];
  }
  field.offsets = next;
  field.points.resize(next.back());
  const double cell = this->Medium.seafloor->cellSize();
  for (std::vector<Record>& records : this->Records)
  {
    for (const Record& record : records)
    {
      const RayPoint& point = record.point;
      const double k = glm::length(point.wavenumber);
      if (cell > 0.0 && k * point.depth < Pi && point.depth > 2.0 * this->Wave.height)
      {
        ++field.refractingPoints;
        field.coarsePoints += 2.0 * Pi / k < FewestCells * cell ? 1 : 0;
      }
      field.points[next[record.ray]++] = point;
    }
    std::vector<Record>().swap(records);
  }
  return field;
}

}
