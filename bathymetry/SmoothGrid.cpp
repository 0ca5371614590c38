#include "bathymetry/SmoothGrid.h"

#include <algorithm>
#include <cmath>

namespace swellray
{

namespace
{

constexpr double CutOff = 4.0; // standard deviations; the weight beyond is 6e-5

// Weights of the nodes 0, 1, 2, ... away from the centre.
std::vector<double> gaussian(double sigma, double spacing, std::size_t count)
{
  const double nodes = sigma / spacing;
  const auto reach = static_cast<std::size_t>(std::min(CutOff * nodes, static_cast<double>(count)));
  std::vector<double> weights(reach + 1);
  for (std::size_t k = 0; k <= reach; ++k)
  {
    const double t = static_cast<double>(k) / nodes;
    weights[k] = std::exp(-0.5 * t * t);
  }
  return weights;
}

double average(
  const double* centre, std::size_t index, std::size_t count, std::ptrdiff_t stride, const std::vector<double>& weights)
{
  double sum = weights[0] * centre[0];
  double total = weights[0];
  const std::size_t reach = std::min({ weights.size() - 1, index, count - 1 - index });
  for (std::size_t k = 1; k <= reach; ++k)
  {
    const auto step = static_cast<std::ptrdiff_t>(k) * stride;
    const double pair = centre[-step] + centre[step];
    if (!std::isnan(pair))
    {
      sum += weights[k] * pair;
      total += 2.0 * weights[k];
    }
  }
  return sum / total;
}

}

void smoothGrid(ElevationGrid& grid, double sigma, const Execution& execution)
{
  if (!(sigma > 0.0))
  {
    return;
  }
  const std::vector<double> alongWeights = gaussian(sigma, grid.spacing.x, grid.columns);
  const std::vector<double> acrossWeights = gaussian(sigma, grid.spacing.y, grid.rows);
  std::vector<double> rowsDone(grid.elevation.size());
  const auto columns = static_cast<std::ptrdiff_t>(grid.columns);
  execution.forRange(grid.rows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t n = begin * grid.columns; n < end * grid.columns; ++n)
      {
        rowsDone[n] = average(&grid.elevation[n], n % grid.columns, grid.columns, 1, alongWeights);
      }
    });
  execution.forRange(grid.rows,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t n = begin * grid.columns; n < end * grid.columns; ++n)
      {
        grid.elevation[n] = average(&rowsDone[n], n / grid.columns, grid.rows, columns, acrossWeights);
      }
    });
}

}
