#include "sim/SpectralTransfer.h"

#include "sim/Angles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

// Change of the offshore heading between neighbouring rays up to which they are taken to have the same way.
constexpr double LargestChange = radians(75.0);

/** Means of a function of the heading that is linear between nodes, as weights of its values there. */
class NodeMeans
{
public:
  explicit NodeMeans(const SpectralGrid& grid)
    : Nodes(grid.headings)
    , Circle(grid.isCircle())
  {
  }

  /** Add the weights of the mean between two headings, any distance apart, to the row. */
  void add(double from, double to, double weight, double* row) const
  {
    const double low = std::min(from, to);
    const double width = std::abs(to - from);
    constexpr double Narrow = 1e-9;
    if (width < Narrow)
    {
      this->addPoint(0.5 * (from + to), weight, row);
      return;
    }
    // Over each piece between nodes the mean of a linear function is its value in the middle.
    double a = low;
    const double end = low + width;
    while (a < end)
    {
      const double b = std::min(end, a + this->toNextNode(a));
      this->addPoint(0.5 * (a + b), weight * (b - a) / width, row);
      a = b;
    }
  }

private:
  double turned(double heading) const
  {
    const double first = this->Nodes.front();
    double t = heading - first - 2.0 * Pi * std::floor((heading - first) / (2.0 * Pi));
    return first + (t >= 2.0 * Pi ? 0.0 : t);
  }

  double toNextNode(double heading) const
  {
    const double t = this->turned(heading);
    const auto next = std::upper_bound(this->Nodes.begin(), this->Nodes.end(), t);
    const double node = next == this->Nodes.end() ? this->Nodes.front() + 2.0 * Pi : *next;
    return std::max(node - t, 1e-12);
  }

  void addPoint(double heading, double weight, double* row) const
  {
    const double t = this->turned(heading);
    const std::size_t count = this->Nodes.size();
    const auto next =
      static_cast<std::size_t>(std::upper_bound(this->Nodes.begin(), this->Nodes.end(), t) - this->Nodes.begin());
    const std::size_t before = next - 1;
    if (next == count && !this->Circle)
    {
      return; // outside of the sector that is known
    }
    const double end = next == count ? this->Nodes.front() + 2.0 * Pi : this->Nodes[next];
    const double share = (t - this->Nodes[before]) / (end - this->Nodes[before]);
    row[before] += weight * (1.0 - share);
    row[next % count] += weight * share;
  }

  const std::vector<double>& Nodes;
  bool Circle;
};

}

double SpectralRays::width() const
{
  const double bin = (grid.headings.back() - grid.headings.front()) / static_cast<double>(grid.headings.size() - 1);
  return bin / static_cast<double>(perDirection);
}

double SpectralRays::heading(std::size_t i) const
{
  const double part = static_cast<double>(i % perDirection) - 0.5 * static_cast<double>(perDirection - 1);
  return grid.headings[i / perDirection] + part * this->width();
}

void SpectralRays::validate() const
{
  grid.validate();
  if (perDirection == 0)
  {
    throw std::invalid_argument("at least one ray a direction is needed");
  }
  const double bin = this->width() * static_cast<double>(perDirection);
  for (std::size_t j = 0; j + 1 < grid.headings.size(); ++j)
  {
    constexpr double Uneven = 1e-6;
    if (std::abs(grid.headings[j + 1] - grid.headings[j] - bin) > Uneven * bin)
    {
      throw std::invalid_argument("the directions of rays must be equally spaced");
    }
  }
}

std::vector<SpectralOrigins> traceOrigins(const BackwardTracer& tracer, const SpectralRays& rays,
  const std::vector<glm::dvec2>& places, const Execution& execution)
{
  rays.validate();
  const std::size_t frequencies = rays.grid.frequencies.size();
  const std::size_t directions = rays.directionCount();
  std::vector<SpectralOrigins> result(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    SpectralOrigins& origins = result[i];
    origins.place = places[i];
    origins.depth = tracer.depth(places[i]);
    if (origins.depth > 0.0)
    {
      origins.headings.resize(frequencies * directions);
      origins.gains.resize(frequencies * directions);
    }
  }
  std::vector<std::size_t> steps(places.size() * frequencies, 0);
  // Work is dealt out place by frequency, in batches between which progress is told.
  constexpr std::size_t Batches = 100;
  const std::size_t items = places.size() * frequencies;
  for (std::size_t batch = 0; batch < Batches; ++batch)
  {
    const std::size_t first = items * batch / Batches;
    const std::size_t last = items * (batch + 1) / Batches;
    execution.forRange(last - first,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t item = first + begin; item < first + end; ++item)
        {
          SpectralOrigins& origins = result[item / frequencies];
          const std::size_t f = item % frequencies;
          for (std::size_t j = 0; j < directions && !origins.headings.empty(); ++j)
          {
            const WaveOrigin origin = tracer.trace(origins.place, rays.grid.frequencies[f], rays.heading(j));
            origins.headings[f * directions + j] = origin.heading;
            origins.gains[f * directions + j] = std::isnan(origin.heading) ? 0.0 : origin.gain;
            steps[item] += origin.steps;
          }
        }
      });
    if (!execution.report(static_cast<double>(batch + 1) / Batches))
    {
      break;
    }
  }
  for (std::size_t item = 0; item < items; ++item)
  {
    result[item / frequencies].steps += steps[item];
  }
  return result;
}

SpectralTransfer::SpectralTransfer(
  const SpectralRays& rays, const SpectralGrid& offshore, const SpectralOrigins& origins)
  : Directions(rays.grid.headings.size())
  , OffshoreDirections(offshore.headings.size())
  , Grid(rays.grid)
{
  rays.validate();
  offshore.validate();
  const std::size_t frequencies = rays.grid.frequencies.size();
  if (offshore.frequencies != rays.grid.frequencies)
  {
    throw std::invalid_argument("the spectrum offshore and the rays must have the same frequencies");
  }
  this->Rows.assign(frequencies * this->Directions * this->OffshoreDirections, 0.0);
  this->Sums.assign(frequencies * this->OffshoreDirections * 3, 0.0);
  if (origins.headings.empty())
  {
    return;
  }
  const std::size_t count = rays.directionCount();
  const bool circle = rays.grid.isCircle();
  const NodeMeans means(offshore);
  const double part = 1.0 / static_cast<double>(rays.perDirection);
  for (std::size_t f = 0; f < frequencies; ++f)
  {
    const double* from = origins.headings.data() + f * count;
    const double* gain = origins.gains.data() + f * count;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (std::isnan(from[i]))
      {
        continue;
      }
      double* row = this->Rows.data() + (f * this->Directions + i / rays.perDirection) * this->OffshoreDirections;
      for (const int side : { -1, 1 })
      {
        // The half of its part on this side: as far as midway to the neighbour, where that one came the same way.
        double end = from[i];
        const bool last = side < 0 ? i == 0 : i + 1 == count;
        if (!last || circle)
        {
          const double neighbour = from[(side < 0 ? i + count - 1 : i + 1) % count];
          const double change = std::remainder(neighbour - from[i], 2.0 * Pi);
          if (std::abs(change) < LargestChange) // false for NaN
          {
            end = from[i] + 0.5 * change;
          }
        }
        means.add(from[i], end, 0.5 * part * gain[i], row);
      }
    }
    const double bin = rays.width() * static_cast<double>(rays.perDirection);
    for (std::size_t j = 0; j < this->Directions; ++j)
    {
      const double* row = this->Rows.data() + (f * this->Directions + j) * this->OffshoreDirections;
      const double east = std::cos(rays.grid.headings[j]);
      const double north = std::sin(rays.grid.headings[j]);
      for (std::size_t m = 0; m < this->OffshoreDirections; ++m)
      {
        double* sums = this->Sums.data() + (f * this->OffshoreDirections + m) * 3;
        sums[0] += bin * row[m];
        sums[1] += bin * row[m] * east;
        sums[2] += bin * row[m] * north;
      }
    }
  }
}

void SpectralTransfer::apply(const std::vector<double>& offshore, DirectionalSpectrum& result) const
{
  const std::size_t frequencies = this->Grid.frequencies.size();
  if (offshore.size() != frequencies * this->OffshoreDirections)
  {
    throw std::invalid_argument("the spectrum offshore does not have the size of its grid");
  }
  result.grid = this->Grid;
  result.density.assign(frequencies * this->Directions, 0.0);
  for (std::size_t f = 0; f < frequencies; ++f)
  {
    const double* density = offshore.data() + f * this->OffshoreDirections;
    for (std::size_t j = 0; j < this->Directions; ++j)
    {
      const double* row = this->Rows.data() + (f * this->Directions + j) * this->OffshoreDirections;
      double sum = 0.0;
      for (std::size_t m = 0; m < this->OffshoreDirections; ++m)
      {
        sum += row[m] * density[m];
      }
      result.density[f * this->Directions + j] = sum;
    }
  }
}

}
