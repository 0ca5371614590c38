#include "sim/SheetSearch.h"

#include "sim/Bins.h"

#include <algorithm>

namespace swellray
{

std::vector<SheetHit> findSheets(const RaySheets& sheets, const std::vector<glm::dvec2>& places,
  const std::vector<char>* wanted, const Execution& execution)
{
  std::vector<SheetHit> hits;
  const std::vector<RaySheets::Triangle>& triangles = sheets.triangles();
  if (places.empty() || triangles.empty())
  {
    return hits;
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
      const bool asked = bounds.contains(inside[i]) && (!wanted || (*wanted)[i] != 0);
      if (!asked)
      {
        return Span();
      }
      const auto strip = std::min(strips - 1, static_cast<std::size_t>((inside[i].y - bounds.low.y) / height));
      return Span{ strip, strip + 1 };
    });

  constexpr std::size_t TrianglesAtOnce = 65536;
  const std::size_t pieces = (triangles.size() + TrianglesAtOnce - 1) / TrianglesAtOnce;
  std::vector<std::vector<SheetHit>> found(pieces);
  execution.forRange(pieces,
    [&](std::size_t begin, std::size_t end)
    {
      SheetHit hit;
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
  for (const std::vector<SheetHit>& piece : found)
  {
    hits.insert(hits.end(), piece.begin(), piece.end());
  }
  std::stable_sort(hits.begin(), hits.end(), [](const SheetHit& a, const SheetHit& b) { return a.place < b.place; });
  return hits;
}

}
