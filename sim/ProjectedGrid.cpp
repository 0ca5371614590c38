#include "sim/ProjectedGrid.h"

#include "sim/Angles.h"

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace swellray
{

namespace
{

// Lines of sight that fall by less meet the water so far away that no sample resolves a wave there.
constexpr double LeastFall = 1e-4;

constexpr int MostPixels = 1 << 16;
constexpr double MostSamples = 2e7;

[[noreturn]] void refuse(const char* name, double value, const char* range)
{
  std::ostringstream message;
  message << "the camera of a projected grid: " << name << " must be " << range << ", not " << value;
  throw std::invalid_argument(message.str());
}

/** What waves do to a place, added up. */
struct Motion
{
  glm::dvec2 along{ 0.0 };
  double up = 0.0;
  glm::dmat2 stretch{ 1.0 }; // of the horizontal plane
  glm::dvec2 slope{ 0.0 };
  glm::dvec3 velocity{ 0.0 };
  double depth = 0.0;
  double foam = 0.0;
  bool breaking = false;
  std::size_t sheets = 0;
};

}

void GridCamera::validate() const
{
  for (const auto& [name, point] :
    { std::pair<const char*, glm::dvec3>{ "each coordinate of its position", this->position },
      { "each coordinate of its focal point", this->focalPoint }, { "each component of up", this->viewUp } })
  {
    for (int c = 0; c < 3; ++c)
    {
      if (!std::isfinite(point[c]))
      {
        refuse(name, point[c], "finite");
      }
    }
  }
  if (!(this->viewAngle > 0.0 && this->viewAngle < 180.0))
  {
    refuse("its angle of view", this->viewAngle, "above 0 and below 180 degrees");
  }
  for (const auto& [name, value, least] : { std::tuple<const char*, int, int>{ "the width", this->width, 1 },
         { "the height", this->height, 1 }, { "the step", this->step, 1 }, { "the margin", this->margin, 0 } })
  {
    if (value < least || value > MostPixels)
    {
      refuse(name, value, least > 0 ? "1 to 65536 pixels" : "0 to 65536 pixels");
    }
  }
  const double columns = (this->width + 2.0 * this->margin) / this->step + 1.0;
  const double rows = (this->height + 2.0 * this->margin) / this->step + 1.0;
  if (!(columns * rows <= MostSamples))
  {
    refuse("its number of samples", columns * rows, "20 million or less");
  }
  const glm::dvec3 sight = this->focalPoint - this->position;
  if (!(glm::length(glm::cross(sight, this->viewUp)) > 0.0))
  {
    throw std::invalid_argument(
      "the camera of a projected grid: it must look at another point than its own, and not along up");
  }
}

ProjectedGrid::ProjectedGrid(const GridCamera& camera, double waterLevel)
  : WaterLevel(waterLevel)
{
  camera.validate();
  if (!(camera.position.z > waterLevel))
  {
    refuse("the elevation of its position", camera.position.z, "above the water");
  }
  const glm::dvec3 ahead = glm::normalize(camera.focalPoint - camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, camera.viewUp));
  const glm::dvec3 up = glm::cross(right, ahead);
  const double pixel = 2.0 * std::tan(0.5 * camera.viewAngle * Pi / 180.0) / camera.height;
  const auto samples = [&](int pixels)
  { return static_cast<std::size_t>((pixels + 2 * camera.margin + camera.step - 1) / camera.step) + 1; };
  this->Columns = samples(camera.width);
  this->Rows = samples(camera.height);
  // Where the line of sight of a sample meets the water.
  const auto hit = [&](double column, double row, glm::dvec2& place)
  {
    const double x = column * camera.step - camera.margin - 0.5 * camera.width;
    const double y = 0.5 * camera.height + camera.margin - row * camera.step;
    const glm::dvec3 sight = ahead + pixel * (x * right + y * up);
    const double fall = -sight.z / glm::length(sight);
    if (!(fall > LeastFall))
    {
      return false;
    }
    place = glm::dvec2(camera.position) + (camera.position.z - waterLevel) / -sight.z * glm::dvec2(sight);
    return true;
  };
  this->Samples.resize(this->Rows * this->Columns);
  for (std::size_t row = 0; row < this->Rows; ++row)
  {
    for (std::size_t column = 0; column < this->Columns; ++column)
    {
      Sample& sample = this->Samples[row * this->Columns + column];
      const auto x = static_cast<double>(column);
      const auto y = static_cast<double>(row);
      glm::dvec2 beside;
      glm::dvec2 before;
      // Of the neighbours that towards the camera is the nearer one, and surely on the water.
      if (hit(x, y, sample.place) && hit(x + 1.0, y, beside) && hit(x, y + 1.0, before))
      {
        sample.spacing = std::max(glm::distance(sample.place, beside), glm::distance(sample.place, before));
        ++this->Count;
      }
    }
  }
}

ProjectedSurface ProjectedGrid::sample(const std::vector<const SurfaceFunction*>& waves, double time,
  const SurfaceMotion& motion, const Execution& execution) const
{
  if (waves.empty())
  {
    throw std::invalid_argument("a projected grid needs at least one wave");
  }
  for (const SurfaceFunction* wave : waves)
  {
    if (wave->waterLevel() != this->WaterLevel)
    {
      std::ostringstream message;
      message << "a projected grid on water at " << this->WaterLevel << " m cannot show waves on water at "
              << wave->waterLevel() << " m";
      throw std::invalid_argument(message.str());
    }
  }
  motion.foam.validate();
  std::vector<Motion> moved(this->Samples.size());
  execution.forRange(this->Rows,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<SheetPlace> sheets;
      for (std::size_t i = begin * this->Columns; i < end * this->Columns; ++i)
      {
        const Sample& sample = this->Samples[i];
        Motion& sum = moved[i];
        if (sample.spacing == 0.0)
        {
          continue;
        }
        for (const SurfaceFunction* wave : waves)
        {
          wave->cover(sample.place, sheets);
          for (const SheetPlace& sheet : sheets)
          {
            const double share = resolvedShare(2.0 * Pi / sheet.still.wavenumber, sample.spacing);
            sum.depth = sheet.still.depth;
            ++sum.sheets;
            sum.foam = std::max(sum.foam, wave->foam(sheet, time, motion));
            if (share == 0.0)
            {
              continue;
            }
            bool broken = false;
            const MovedPlace place = wave->move(sheet, time, *motion.section, &broken);
            const glm::dvec2 direction = sheet.still.direction;
            sum.along += share * (glm::dvec2(place.position) - sample.place);
            sum.up += share * (place.position.z - this->WaterLevel);
            sum.stretch += share * (place.normal.z - 1.0) * glm::outerProduct(direction, direction);
            sum.slope -= share * glm::dvec2(place.normal);
            sum.velocity += share * place.velocity;
            sum.breaking = sum.breaking || broken;
          }
        }
        // One wave is held above the bed by move().
        sum.up = sum.sheets > 1 ? std::max(sum.up, std::min(0.0, -sum.depth)) : sum.up;
      }
    });

  ProjectedSurface surface;
  std::vector<std::int64_t> number(moved.size(), -1);
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    const Motion& sum = moved[i];
    if (sum.sheets == 0)
    {
      continue;
    }
    number[i] = static_cast<std::int64_t>(surface.position.size());
    surface.position.emplace_back(this->Samples[i].place + sum.along, this->WaterLevel + sum.up);
    const glm::dvec3 normal =
      glm::cross(glm::dvec3(sum.stretch[0], sum.slope.x), glm::dvec3(sum.stretch[1], sum.slope.y));
    const double size = glm::length(normal);
    surface.normal.push_back(size > 0.0 ? normal / size : glm::dvec3(0.0, 0.0, 1.0));
    surface.velocity.push_back(sum.velocity);
    surface.depth.push_back(sum.depth);
    surface.foam.push_back(static_cast<float>(sum.foam));
    surface.breaking.push_back(sum.breaking ? 1 : 0);
  }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c)
  {
    if (number[a] < 0 || number[b] < 0 || number[c] < 0)
    {
      return;
    }
    const glm::dvec2 ab = this->Samples[b].place - this->Samples[a].place;
    const glm::dvec2 ac = this->Samples[c].place - this->Samples[a].place;
    if (ab.x * ac.y - ab.y * ac.x < 0.0)
    {
      std::swap(b, c);
    }
    surface.triangles.push_back({ number[a], number[b], number[c] });
  };
  for (std::size_t row = 0; row + 1 < this->Rows; ++row)
  {
    for (std::size_t column = 0; column + 1 < this->Columns; ++column)
    {
      const std::size_t i = row * this->Columns + column;
      add(i, i + this->Columns, i + 1);
      add(i + 1, i + this->Columns, i + this->Columns + 1);
    }
  }
  return surface;
}

}
