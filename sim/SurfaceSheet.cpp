#include "sim/SurfaceSheet.h"

#include "sim/Angles.h"
#include "sim/RayField.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

namespace swellray
{

namespace
{

// Points of a ray that are nearer to each other than this are one, rad.
constexpr double SmallestStep = 1e-6;

// Depth of points on the shore, at least, m: keeps the wave finite.
constexpr double SmallestDepth = 1e-3;

// The beach is looked for by this many Newton steps, none longer than so many depths over the slope.
constexpr int BeachSteps = 12;

double finiteOr(double value, double otherwise)
{
  return std::isfinite(value) ? value : std::isfinite(otherwise) ? otherwise : 0.0;
}

glm::dvec2 vectorAt(const double* triples, std::int64_t i)
{
  return { triples[3 * i], triples[3 * i + 1] };
}

}

SurfaceSheet::SurfaceSheet(const SurfaceRays& rays, const Seafloor& seafloor, double waterLevel, double pointsPerWave,
  const Execution& execution, std::size_t maxPoints)
{
  if (!(pointsPerWave > 0.0) || std::isinf(pointsPerWave))
  {
    std::ostringstream message;
    message << "a surface cannot have " << pointsPerWave << " points a wavelength; it must be above 0";
    throw std::invalid_argument(message.str());
  }
  this->layOut(rays, 2.0 * Pi / pointsPerWave, maxPoints);
  this->fill(rays, seafloor, waterLevel, execution);
  this->weave(rays.maxSpacing, rays.sheet.obstacles);
  this->reachBeach(seafloor, waterLevel);
  this->Places = {};
}

void SurfaceSheet::layOut(const SurfaceRays& rays, double step, std::size_t maxPoints)
{
  const RayLines& lines = rays.sheet.lines;
  const std::uint8_t* state = rays.sheet.state;
  constexpr auto aground = static_cast<std::uint8_t>(RayState::Aground);
  for (std::size_t ray = 0; ray < lines.rays; ++ray)
  {
    const std::int64_t first = lines.offsets[ray];
    const std::int64_t last = lines.offsets[ray + 1] - 1;
    const auto begin = static_cast<std::int64_t>(this->Places.size());
    const auto add = [&](std::int64_t before, double phase)
    {
      const bool fresh = static_cast<std::int64_t>(this->Places.size()) == begin;
      if (fresh || phase > this->Places.back().phase + SmallestStep)
      {
        this->Places.push_back({ before, phase });
      }
    };
    for (std::int64_t i = first; i < last; ++i)
    {
      const double from = lines.phase[i];
      const double to = lines.phase[i + 1];
      // Its ends are kept, and where it runs aground.
      if (i == first || (state[i] == aground && state[i - 1] != aground))
      {
        add(i, from);
      }
      for (double n = std::ceil((from - SmallestStep) / step); n * step < to - SmallestStep; n += 1.0)
      {
        add(i, std::max(from, n * step));
      }
      if (this->Places.size() > maxPoints)
      {
        std::ostringstream message;
        message << "the surface would have more than " << maxPoints
                << " points; crop the scene, or ask for fewer points a wave or a wider ray spacing";
        throw std::runtime_error(message.str());
      }
    }
    if (last >= first)
    {
      // The end of a ray matters more than a point just before it.
      if (static_cast<std::int64_t>(this->Places.size()) > begin + 1 &&
        !(lines.phase[last] > this->Places.back().phase + SmallestStep))
      {
        this->Places.pop_back();
      }
      add(std::max(first, last - 1), lines.phase[last]);
    }
    this->Offsets.push_back(static_cast<std::int64_t>(this->Places.size()));
    this->LaunchParameter.push_back(lines.launchParameter[ray]);
    this->LaunchSegment.push_back(lines.launchSegment[ray]);
    this->Parent.push_back(rays.sheet.parent[ray]);
    this->Lee.push_back(rays.sheet.lee[ray]);
    if (rays.sheet.reflections)
    {
      this->Reflections.push_back(rays.sheet.reflections[ray]);
    }
    if (rays.sheet.obstacles)
    {
      this->EndReasons.push_back(rays.sheet.endReason[ray]);
    }
  }
}

void SurfaceSheet::fill(
  const SurfaceRays& rays, const Seafloor& seafloor, double waterLevel, const Execution& execution)
{
  const std::size_t count = this->Places.size();
  this->Position.resize(3 * count);
  this->Direction.resize(3 * count);
  for (std::vector<double>* values :
    { &this->Phase, &this->Height, &this->Wavenumber, &this->Depth, &this->Slope, &this->BreakingDistance })
  {
    values->resize(count);
  }
  this->Caustics.resize(count);
  this->Breaking.resize(count);
  this->State.resize(count);
  this->Shore.resize(count);
  const SheetRays& sheet = rays.sheet;
  const std::int64_t originals = sheet.lines.rays > 0 ? sheet.lines.offsets[sheet.lines.rays] : 0;
  constexpr auto aground = static_cast<std::uint8_t>(RayState::Aground);
  execution.forRange(count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::int64_t a = this->Places[i].before;
        const std::int64_t b = std::min(a + 1, originals - 1);
        const double span = sheet.lines.phase[b] - sheet.lines.phase[a];
        const double w = span > 0.0 ? std::clamp((this->Places[i].phase - sheet.lines.phase[a]) / span, 0.0, 1.0) : 0.0;
        const auto linear = [&](const double* values) {
          return w == 0.0 ? values[a] : w == 1.0 ? values[b] : values[a] + w * (values[b] - values[a]);
        };
        glm::dvec2 place = vectorAt(sheet.lines.positions, a);
        if (w > 0.0)
        {
          const glm::dvec2 chord = vectorAt(sheet.lines.positions, b) - place;
          glm::dvec2 bend(0.0);
          if (sheet.state[a] != aground)
          {
            // Hermite's cubic in the phase, as far as it goes off the chord.
            const auto rate = [&](std::int64_t point)
            {
              const glm::dvec2 ray = vectorAt(rays.rayDirection, point);
              return span / (sheet.wavenumber[point] * glm::dot(ray, vectorAt(sheet.direction, point))) * ray;
            };
            bend = w * (1.0 - w) * ((1.0 - w) * (rate(a) - chord) - w * (rate(b) - chord));
          }
          place += w * chord + bend;
        }
        const glm::dvec2 toward = (1.0 - w) * vectorAt(sheet.direction, a) + w * vectorAt(sheet.direction, b);
        const double size = glm::length(toward);
        const glm::dvec2 direction = size > 0.0 ? toward / size : vectorAt(sheet.direction, a);
        const BedSample bed = seafloor.bed(place);
        this->Position[3 * i] = place.x;
        this->Position[3 * i + 1] = place.y;
        this->Position[3 * i + 2] = waterLevel;
        this->Direction[3 * i] = direction.x;
        this->Direction[3 * i + 1] = direction.y;
        this->Direction[3 * i + 2] = 0.0;
        this->Phase[i] = this->Places[i].phase;
        this->Height[i] = finiteOr(linear(sheet.height), w < 0.5 ? sheet.height[b] : sheet.height[a]);
        this->Wavenumber[i] = linear(sheet.wavenumber);
        this->Depth[i] = std::max(SmallestDepth, waterLevel - bed.elevation);
        this->Slope[i] = glm::dot(bed.gradient, direction);
        const std::int64_t nearest = w > 0.5 ? b : a;
        // On the way to where it runs aground a ray is on the water.
        this->State[i] = sheet.state[w == 1.0 ? b : a];
        this->Shore[i] = sheet.state[a] == aground || this->State[i] == aground ? 1 : 0;
        this->Caustics[i] = sheet.caustics[nearest];
        // Breaking begins between two points: from there on the way tells.
        const double way = sheet.breaking[b] ? rays.breakingDistance[b] - (1.0 - w) * span / sheet.wavenumber[b] : 0.0;
        const bool sinceA = sheet.breaking[a] && sheet.breaking[b];
        this->Breaking[i] = sinceA || (w == 0.0 && sheet.breaking[a]) || (!sheet.breaking[a] && way > 0.0) ? 1 : 0;
        this->BreakingDistance[i] = sinceA ? linear(rays.breakingDistance)
          : w == 0.0                       ? rays.breakingDistance[a]
                                           : std::max(0.0, way);
      }
    });
}

void SurfaceSheet::weave(double maxSpacing, const Obstacles* obstacles)
{
  SheetRays sheet;
  sheet.lines.rays = this->Offsets.size() - 1;
  sheet.lines.offsets = this->Offsets.data();
  sheet.lines.positions = this->Position.data();
  sheet.lines.phase = this->Phase.data();
  sheet.lines.launchParameter = this->LaunchParameter.data();
  sheet.lines.launchSegment = this->LaunchSegment.data();
  sheet.parent = this->Parent.data();
  sheet.lee = this->Lee.data();
  sheet.reflections = this->Reflections.empty() ? nullptr : this->Reflections.data();
  sheet.endReason = this->EndReasons.empty() ? nullptr : this->EndReasons.data();
  sheet.obstacles = this->EndReasons.empty() ? nullptr : obstacles;
  sheet.direction = this->Direction.data();
  sheet.wavenumber = this->Wavenumber.data();
  sheet.height = this->Height.data();
  sheet.caustics = this->Caustics.data();
  sheet.breaking = this->Breaking.data();
  // No triangle lies along the shore alone, nor where a ray of it ends.
  std::vector<std::uint8_t> state = this->State;
  for (std::size_t i = 0; i < state.size(); ++i)
  {
    state[i] = this->Shore[i] ? static_cast<std::uint8_t>(RayState::Aground) : state[i];
  }
  sheet.state = state.data();
  this->Triangles = RaySheets(sheet, maxSpacing).triangles();
  for (Triangle& triangle : this->Triangles)
  {
    this->turnUp(triangle);
  }
}

void SurfaceSheet::turnUp(Triangle& triangle) const
{
  const glm::dvec2 a = vectorAt(this->Position.data(), triangle[0]);
  const glm::dvec2 ab = vectorAt(this->Position.data(), triangle[1]) - a;
  const glm::dvec2 ac = vectorAt(this->Position.data(), triangle[2]) - a;
  if (ab.x * ac.y - ab.y * ac.x < 0.0)
  {
    std::swap(triangle[1], triangle[2]);
  }
}

void SurfaceSheet::reachBeach(const Seafloor& seafloor, double waterLevel)
{
  const auto onShore = [&](std::int64_t i) { return this->Shore[static_cast<std::size_t>(i)] != 0; };

  // Edges along the shore that only one triangle has.
  const auto points = static_cast<std::int64_t>(this->Phase.size());
  const auto keyOf = [&](std::int64_t a, std::int64_t b) { return std::min(a, b) * points + std::max(a, b); };
  std::unordered_map<std::int64_t, int> uses;
  const auto forShoreEdges = [&](const auto& visit)
  {
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        const std::int64_t a = this->Triangles[t][corner];
        const std::int64_t b = this->Triangles[t][(corner + 1) % 3];
        if (onShore(a) && onShore(b))
        {
          visit(a, b);
        }
      }
    }
  };
  std::vector<std::array<std::int64_t, 2>> edges;
  forShoreEdges([&](std::int64_t a, std::int64_t b) { ++uses[keyOf(a, b)]; });
  forShoreEdges(
    [&](std::int64_t a, std::int64_t b)
    {
      if (uses[keyOf(a, b)] == 1)
      {
        edges.push_back({ a, b });
      }
    });

  std::unordered_map<std::int64_t, std::int64_t> beachOf;
  const auto beach = [&](std::int64_t point)
  {
    const auto known = beachOf.find(point);
    if (known != beachOf.end())
    {
      return known->second;
    }
    const auto i = static_cast<std::size_t>(point);
    const double aim = waterLevel + 0.5 * this->Height[i];
    const glm::dvec2 start = vectorAt(this->Position.data(), point);
    glm::dvec2 place = start;
    double elevation = waterLevel - this->Depth[i];
    for (int step = 0; step < BeachSteps; ++step)
    {
      const BedSample bed = seafloor.bed(place);
      elevation = bed.elevation;
      const double square = glm::dot(bed.gradient, bed.gradient);
      if (!(square > 0.0) || std::abs(aim - elevation) < 1e-6)
      {
        break;
      }
      place += bed.gradient * ((aim - elevation) / square);
    }
    // A beach that is far off, or out of the scene, is none of this wave's.
    constexpr double flattest = 0.003;
    const bool reached = elevation > aim - 1e-3 && seafloor.bounds().contains(place) &&
      glm::distance(place, start) < (aim - waterLevel + this->Depth[i]) / flattest;
    std::int64_t twin = -1;
    if (reached)
    {
      twin = static_cast<std::int64_t>(this->Phase.size());
      this->BeachBase.push_back(point);
      this->Position.insert(this->Position.end(), { place.x, place.y, elevation });
      for (std::vector<double>* values : { &this->Phase, &this->Wavenumber, &this->Slope, &this->BreakingDistance })
      {
        values->push_back((*values)[i]);
      }
      const std::array<double, 3> direction{ this->Direction[3 * i], this->Direction[3 * i + 1], 0.0 };
      this->Direction.insert(this->Direction.end(), direction.begin(), direction.end());
      this->Height.push_back(0.0);
      this->Depth.push_back(waterLevel - elevation);
      this->Caustics.push_back(this->Caustics[i]);
      this->Breaking.push_back(this->Breaking[i]);
      this->State.push_back(this->State[i]);
      this->Shore.push_back(1);
    }
    beachOf.emplace(point, twin);
    return twin;
  };
  for (const auto& [a, b] : edges)
  {
    const std::int64_t beachA = beach(a);
    const std::int64_t beachB = beach(b);
    if (beachA >= 0 && beachB >= 0)
    {
      for (Triangle triangle : { Triangle{ a, beachA, b }, Triangle{ b, beachA, beachB } })
      {
        this->turnUp(triangle);
        this->Triangles.push_back(triangle);
      }
    }
  }
}

}
