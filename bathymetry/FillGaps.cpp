#include "bathymetry/FillGaps.h"

#include "sim/FillHoles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace swellray
{

namespace
{

// Lengths, in nodes, of the run without data through each node: along its row and along its column.
struct Runs
{
  std::vector<std::uint32_t> along;
  std::vector<std::uint32_t> across;
};

void measureRuns(std::size_t lines, std::size_t lineStep, std::size_t count, std::size_t step,
  const std::vector<double>& values, std::vector<std::uint32_t>& runs)
{
  for (std::size_t line = 0; line < lines; ++line)
  {
    const std::size_t base = line * lineStep;
    for (std::size_t i = 0; i < count;)
    {
      std::size_t end = i;
      while (end < count && std::isnan(values[base + end * step]))
      {
        ++end;
      }
      for (std::size_t j = i; j < end; ++j)
      {
        runs[base + j * step] = static_cast<std::uint32_t>(end - i);
      }
      i = std::max(end, i + 1);
    }
  }
}

// Nodes without data that hang together with `seed`; marks them as seen.
std::vector<std::size_t> gapAt(
  std::size_t seed, std::size_t columns, std::size_t rows, const std::vector<double>& values, std::vector<bool>& seen)
{
  std::vector<std::size_t> gap{ seed };
  seen[seed] = true;
  const auto visit = [&](std::size_t node)
  {
    if (!seen[node] && std::isnan(values[node]))
    {
      seen[node] = true;
      gap.push_back(node);
    }
  };
  for (std::size_t next = 0; next < gap.size(); ++next)
  {
    const std::size_t node = gap[next];
    const std::size_t column = node % columns;
    const std::size_t row = node / columns;
    if (column > 0)
    {
      visit(node - 1);
    }
    if (column + 1 < columns)
    {
      visit(node + 1);
    }
    if (row > 0)
    {
      visit(node - columns);
    }
    if (row + 1 < rows)
    {
      visit(node + columns);
    }
  }
  return gap;
}

}

GapCount fillGaps(ElevationGrid& grid, const glm::dvec2& cell, const std::optional<double>& maxGap)
{
  GapCount count;
  const std::size_t columns = grid.columns;
  const std::size_t rows = grid.rows;
  std::vector<double>& values = grid.elevation;
  const auto missing = [](double value) { return std::isnan(value); };
  const auto total = static_cast<std::size_t>(std::count_if(values.begin(), values.end(), missing));
  if (total == 0 || total == values.size())
  {
    count.left = total;
    return count;
  }
  Runs runs{ std::vector<std::uint32_t>(values.size(), 0), std::vector<std::uint32_t>(values.size(), 0) };
  measureRuns(rows, columns, columns, 1, values, runs.along);
  measureRuns(columns, 1, rows, columns, values, runs.across);

  std::vector<std::size_t> toFill;
  std::vector<bool> seen(values.size(), false);
  for (std::size_t seed = 0; seed < values.size(); ++seed)
  {
    if (seen[seed] || !std::isnan(values[seed]))
    {
      continue;
    }
    const std::vector<std::size_t> gap = gapAt(seed, columns, rows, values, seen);
    bool enclosed = true;
    double width = 0.0;
    for (const std::size_t node : gap)
    {
      const std::size_t column = node % columns;
      const std::size_t row = node / columns;
      enclosed = enclosed && column > 0 && column + 1 < columns && row > 0 && row + 1 < rows;
      width = std::max(width,
        maxGap ? std::min(runs.along[node] * cell.x, runs.across[node] * cell.y)
               : static_cast<double>(std::min(runs.along[node], runs.across[node])));
    }
    constexpr double rounding = 1e-9;
    if (enclosed || width <= maxGap.value_or(DefaultGapCells) * (1.0 + rounding))
    {
      toFill.insert(toFill.end(), gap.begin(), gap.end());
    }
  }
  count.filled = toFill.size();
  count.left = total - toFill.size();
  if (count.filled > 0)
  {
    ElevationGrid whole = grid;
    fillHoles(whole);
    for (const std::size_t node : toFill)
    {
      values[node] = whole.elevation[node];
    }
  }
  return count;
}

}
