#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace swellray
{

/** Indices of a regular row, first to last (last excluded). */
struct Span
{
  std::size_t first = 0;
  std::size_t last = 0;
};

/** Indices between two coordinates in a regular row of nodes, and a node more at either end. */
inline Span spanOf(double low, double high, double origin, double spacing, std::size_t count)
{
  const auto end = static_cast<double>(count);
  const double first = std::clamp(std::floor((low - origin) / spacing), 0.0, end);
  const double last = std::clamp(std::ceil((high - origin) / spacing) + 1.0, 0.0, end);
  return { static_cast<std::size_t>(first), static_cast<std::size_t>(std::max(first, last)) };
}

/** Items of each bin: those of bin b are items[offsets[b]] to items[offsets[b + 1] - 1], in their order. */
struct Bins
{
  std::vector<std::size_t> offsets;
  std::vector<std::size_t> items;
};

/** Sort items by counting. @param spanOfItem the bins that an item falls into */
template <typename SpanOf>
Bins sortIntoBins(std::size_t bins, std::size_t items, const SpanOf& spanOfItem)
{
  Bins sorted;
  sorted.offsets.assign(bins + 1, 0);
  for (std::size_t i = 0; i < items; ++i)
  {
    const Span span = spanOfItem(i);
    for (std::size_t bin = span.first; bin < span.last; ++bin)
    {
      ++sorted.offsets[bin + 1];
    }
  }
  std::partial_sum(sorted.offsets.begin(), sorted.offsets.end(), sorted.offsets.begin());
  sorted.items.resize(sorted.offsets.back());
  std::vector<std::size_t> next(sorted.offsets.begin(), sorted.offsets.end() - 1);
  for (std::size_t i = 0; i < items; ++i)
  {
    const Span span = spanOfItem(i);
    for (std::size_t bin = span.first; bin < span.last; ++bin)
    {
      sorted.items[next[bin]++] = i;
    }
  }
  return sorted;
}

}
