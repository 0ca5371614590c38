#include "bathymetry/LevelRegions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace swellray
{

namespace
{

/** Disjoint sets of nodes (Tarjan 1975). */
class Sets
{
public:
  explicit Sets(std::size_t size)
    : Parent(size)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0U);
  }

  std::uint32_t find(std::size_t node)
  {
    auto at = static_cast<std::uint32_t>(node);
    while (this->Parent[at] != at)
    {
      this->Parent[at] = this->Parent[this->Parent[at]];
      at = this->Parent[at];
    }
    return at;
  }

  void join(std::size_t a, std::size_t b)
  {
    const std::uint32_t rootA = this->find(a);
    const std::uint32_t rootB = this->find(b);
    this->Parent[std::max(rootA, rootB)] = std::min(rootA, rootB);
  }

private:
  std::vector<std::uint32_t> Parent;
};

// Each pair of neighbours along x and along y that both have a value.
template <typename Visit>
void visitNeighbours(const ElevationGrid& grid, const Visit& visit)
{
  for (std::size_t i = 0; i < grid.elevation.size(); ++i)
  {
    const bool known = !std::isnan(grid.elevation[i]);
    if (known && (i + 1) % grid.columns != 0 && !std::isnan(grid.elevation[i + 1]))
    {
      visit(i, i + 1);
    }
    if (known && i + grid.columns < grid.elevation.size() && !std::isnan(grid.elevation[i + grid.columns]))
    {
      visit(i, i + grid.columns);
    }
  }
}

}

std::vector<std::uint8_t> sidesOfLevel(const ElevationGrid& grid, double level, double relief)
{
  const std::size_t count = grid.elevation.size();
  std::vector<std::uint8_t> above(count);
  bool flat = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    above[i] = grid.elevation[i] >= level ? 1 : 0;
    flat = flat || std::abs(grid.elevation[i] - level) < relief;
  }
  if (!flat)
  {
    return above;
  }

  Sets regions(count);
  visitNeighbours(grid,
    [&](std::size_t a, std::size_t b)
    {
      if (above[a] == above[b])
      {
        regions.join(a, b);
      }
    });
  std::vector<std::uint8_t> noise(count, 1); // of a region, at its root
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!(std::abs(grid.elevation[i] - level) < relief))
    {
      noise[regions.find(i)] = 0;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    noise[i] = noise[regions.find(i)];
  }

  Sets clusters(count);
  visitNeighbours(grid,
    [&](std::size_t a, std::size_t b)
    {
      if (noise[a] != 0 && noise[b] != 0)
      {
        clusters.join(a, b);
      }
    });
  std::vector<std::uint8_t> atLand(count, 0); // of a cluster, at its root
  visitNeighbours(grid,
    [&](std::size_t a, std::size_t b)
    {
      if (noise[a] != noise[b] && above[noise[a] != 0 ? b : a] != 0)
      {
        atLand[clusters.find(noise[a] != 0 ? a : b)] = 1;
      }
    });
  for (std::size_t i = 0; i < count; ++i)
  {
    above[i] = noise[i] != 0 ? atLand[clusters.find(i)] : above[i];
  }
  return above;
}

}
