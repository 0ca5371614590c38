#include "sim/RayMap.h"

#include "sim/Angles.h"
#include "sim/Caustic.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace swellray
{

namespace
{

// Rows of a map that one piece of work covers.
constexpr std::size_t RowsAtOnce = 8;

// Below this share of its parts a mean direction is rounding.
constexpr double NoMean = 1e-12;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// A sheet that covers a place.
struct Hit
{
  std::size_t place = 0;
  WaveSheet wave;
};

void resize(RayMap& map, std::size_t places)
{
  map.height.assign(places, NotANumber);
  map.directionFrom.assign(places, NotANumber);
  map.wavelength.assign(places, NotANumber);
  map.breaking.assign(places, 0);
  map.lee.assign(places, 0);
  map.count.assign(places, 0);
}

// What the branches of fold caustics add to the sum of rays: for each sheet that has touched a caustic, with the sheet of
// one caustic less that is nearest in phase before it.
std::complex<double> foldCorrection(const WaveSheet* sheets, std::size_t count)
{
  std::complex<double> correction = 0.0;
  for (const WaveSheet* behind = sheets; behind != sheets + count; ++behind)
  {
    const WaveSheet* before = nullptr;
    for (const WaveSheet* other = sheets; other != sheets + count; ++other)
    {
      const bool fits = other->caustics + 1 == behind->caustics && other->reflections == behind->reflections &&
        other->phase < behind->phase;
      before = fits && (!before || other->phase > before->phase) ? other : before;
    }
    if (before)
    {
      const std::complex<double> rays =
        std::polar(before->height, before->phase) + std::polar(behind->height, behind->phase - 0.5 * Pi);
      correction += std::polar(1.0, -0.5 * Pi * before->caustics) *
        (foldWave({ before->height, before->phase }, { behind->height, behind->phase }) - rays);
    }
  }
  return correction;
}

// Hits of a place stay in the order of the triangles, so that sums are the same for any number of threads.
void combineHits(std::vector<Hit>& hits, CombineRule rule, RayMap& map)
{
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.place < b.place; });
  std::vector<WaveSheet> waves;
  for (std::size_t i = 0; i < hits.size();)
  {
    const std::size_t place = hits[i].place;
    waves.clear();
    for (; i < hits.size() && hits[i].place == place; ++i)
    {
      waves.push_back(hits[i].wave);
    }
    const CombinedWave wave = combineSheets(waves.data(), waves.size(), rule);
    map.height[place] = wave.height;
    map.directionFrom[place] = wave.directionFrom;
    map.wavelength[place] = wave.wavelength;
    map.breaking[place] = wave.breaking ? 1 : 0;
    map.lee[place] = wave.lee ? 1 : 0;
    map.count[place] = wave.count;
  }
}

// Indices of a regular row of nodes between two coordinates, first to last (last excluded), a node more at either end:
// places are looked at a little inwards.
struct Span
{
  std::size_t first = 0;
  std::size_t last = 0;
};

Span spanOf(double low, double high, double origin, double spacing, std::size_t count)
{
  const auto end = static_cast<double>(count);
  const double first = std::clamp(std::floor((low - origin) / spacing), 0.0, end);
  const double last = std::clamp(std::ceil((high - origin) / spacing) + 1.0, 0.0, end);
  return { static_cast<std::size_t>(first), static_cast<std::size_t>(std::max(first, last)) };
}

// Items of each bin, by counting: those of bin b are items[offsets[b]] to items[offsets[b + 1] - 1], in their order.
struct Bins
{
  std::vector<std::size_t> offsets;
  std::vector<std::size_t> items;
};

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

void validate(const MapGrid& grid)
{
  if (grid.columns == 0 || grid.rows == 0 || !(grid.spacing.x > 0.0) || !(grid.spacing.y > 0.0))
  {
    std::ostringstream message;
    message << "a map of " << grid.columns << " x " << grid.rows << " nodes " << grid.spacing.x << " and "
            << grid.spacing.y << " m apart cannot be made; it needs nodes, and distances above 0";
    throw std::invalid_argument(message.str());
  }
}

}

CombinedWave combineSheets(const WaveSheet* sheets, std::size_t count, CombineRule rule)
{
  CombinedWave combined;
  combined.count = static_cast<std::int32_t>(count);
  if (count == 0)
  {
    combined.height = combined.directionFrom = combined.wavelength = NotANumber;
    return combined;
  }
  const WaveSheet* highest = std::max_element(
    sheets, sheets + count, [](const WaveSheet& a, const WaveSheet& b) { return a.height < b.height; });
  combined.breaking = highest->broken;
  combined.lee = highest->lee;
  combined.directionFrom = nauticalFromVector(highest->wavenumber);
  combined.wavelength = 2.0 * Pi / glm::length(highest->wavenumber);
  combined.height = highest->height;
  // One wave needs no mean, and next to an infinite or no wave at all no other counts.
  if (count == 1 || !(highest->height > 0.0) || std::isinf(highest->height))
  {
    return combined;
  }

  double energy = 0.0;
  double wavenumber = 0.0;
  glm::dvec2 direction(0.0);
  std::complex<double> sum = 0.0;
  for (const WaveSheet* sheet = sheets; sheet != sheets + count; ++sheet)
  {
    const double squared = sheet->height * sheet->height;
    const double k = glm::length(sheet->wavenumber);
    energy += squared;
    wavenumber += squared * k;
    direction += squared * sheet->wavenumber / k;
    sum += std::polar(sheet->height, sheet->phase - 0.5 * Pi * sheet->caustics);
  }
  combined.height = rule == CombineRule::Energy ? std::sqrt(energy) : std::abs(sum + foldCorrection(sheets, count));
  combined.wavelength = 2.0 * Pi * energy / wavenumber;
  if (glm::length(direction) > NoMean * energy)
  {
    combined.directionFrom = nauticalFromVector(direction);
  }
  return combined;
}

RayMap mapRays(
  const RaySheets& sheets, const MapGrid& grid, const double* depth, CombineRule rule, const Execution& execution)
{
  validate(grid);
  RayMap map;
  resize(map, grid.columns * grid.rows);
  const std::vector<RaySheets::Triangle>& triangles = sheets.triangles();
  const std::size_t bands = (grid.rows + RowsAtOnce - 1) / RowsAtOnce;
  const double bandHeight = grid.spacing.y * static_cast<double>(RowsAtOnce);
  const Bins bins = sortIntoBins(bands, triangles.size(),
    [&](std::size_t i)
    {
      const Rectangle box = sheets.box(triangles[i]);
      // The node above a band's last one belongs to the next band.
      return spanOf(box.low.y - grid.spacing.y, box.high.y, grid.origin.y, bandHeight, bands);
    });

  execution.forRange(bands,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Hit> hits;
      Hit hit;
      for (std::size_t band = begin; band < end; ++band)
      {
        hits.clear();
        const std::size_t lastRow = std::min(grid.rows, (band + 1) * RowsAtOnce);
        for (std::size_t at = bins.offsets[band]; at < bins.offsets[band + 1]; ++at)
        {
          const RaySheets::Triangle& triangle = triangles[bins.items[at]];
          const Rectangle box = sheets.box(triangle);
          const Span columns = spanOf(box.low.x, box.high.x, grid.origin.x, grid.spacing.x, grid.columns);
          const Span rows = spanOf(box.low.y, box.high.y, grid.origin.y, grid.spacing.y, grid.rows);
          for (std::size_t row = std::max(rows.first, band * RowsAtOnce); row < std::min(rows.last, lastRow); ++row)
          {
            for (std::size_t column = columns.first; column < columns.last; ++column)
            {
              hit.place = row * grid.columns + column;
              const glm::dvec2 index(static_cast<double>(column), static_cast<double>(row));
              if ((!depth || depth[hit.place] > 0.0) &&
                sheets.wave(triangle, sheets.inwards(grid.origin + grid.spacing * index), hit.wave))
              {
                hits.push_back(hit);
              }
            }
          }
        }
        combineHits(hits, rule, map);
      }
    });
  return map;
}

RayMap sampleRays(const RaySheets& sheets, const std::vector<glm::dvec2>& places, const double* depth, CombineRule rule,
  const Execution& execution)
{
  RayMap map;
  resize(map, places.size());
  const std::vector<RaySheets::Triangle>& triangles = sheets.triangles();
  if (places.empty() || triangles.empty())
  {
    return map;
  }
  // The places in strips of equal y, the triangles looked at in pieces that are put together in their order.
  const Rectangle& bounds = sheets.bounds();
  const std::size_t strips = std::min<std::size_t>(places.size(), 4096);
  const double height = std::max(bounds.size().y, 1.0) / static_cast<double>(strips);
  std::vector<glm::dvec2> inside(places.size());
  std::transform(
    places.begin(), places.end(), inside.begin(), [&](const glm::dvec2& place) { return sheets.inwards(place); });
  const Bins bins = sortIntoBins(strips, places.size(),
    [&](std::size_t i)
    {
      const bool asked = bounds.contains(inside[i]) && (!depth || depth[i] > 0.0);
      if (!asked)
      {
        return Span();
      }
      const auto strip = std::min(strips - 1, static_cast<std::size_t>((inside[i].y - bounds.low.y) / height));
      return Span{ strip, strip + 1 };
    });

  constexpr std::size_t TrianglesAtOnce = 65536;
  const std::size_t pieces = (triangles.size() + TrianglesAtOnce - 1) / TrianglesAtOnce;
  std::vector<std::vector<Hit>> found(pieces);
  execution.forRange(pieces,
    [&](std::size_t begin, std::size_t end)
    {
      Hit hit;
      for (std::size_t t = begin * TrianglesAtOnce; t < std::min(end * TrianglesAtOnce, triangles.size()); ++t)
      {
        const Rectangle box = sheets.box(triangles[t]);
        const Span span = spanOf(box.low.y, box.high.y, bounds.low.y, height, strips);
        for (std::size_t at = bins.offsets[span.first]; at < bins.offsets[span.last]; ++at)
        {
          hit.place = bins.items[at];
          if (box.contains(inside[hit.place]) && sheets.wave(triangles[t], inside[hit.place], hit.wave))
          {
            found[t / TrianglesAtOnce].push_back(hit);
          }
        }
      }
    });
  std::vector<Hit> hits;
  for (const std::vector<Hit>& piece : found)
  {
    hits.insert(hits.end(), piece.begin(), piece.end());
  }
  combineHits(hits, rule, map);
  return map;
}

}
