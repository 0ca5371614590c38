#include "bathymetry/InscribedRectangle.h"

#include <algorithm>
#include <limits>

namespace swellray
{

namespace
{

// The polygon's stretch along y over one slab: what every line of the slab has in common.
struct Slab
{
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

}

Rectangle inscribedRectangle(const std::vector<glm::dvec2>& outline)
{
  std::vector<double> x;
  x.reserve(outline.size());
  for (const glm::dvec2& p : outline)
  {
    x.push_back(p.x);
  }
  std::sort(x.begin(), x.end());
  x.erase(std::unique(x.begin(), x.end()), x.end());
  if (x.size() < 2)
  {
    return {};
  }

  // Between two vertices' x every edge is straight, so that its ends there bound it; the upper and the lower edge
  // are told apart in the middle of the slab.
  std::vector<Slab> slabs(x.size() - 1);
  std::vector<Slab> middles(
    slabs.size(), Slab{ std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() });
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    glm::dvec2 a = outline[i];
    glm::dvec2 b = outline[(i + 1) % outline.size()];
    if (b.x < a.x)
    {
      std::swap(a, b);
    }
    const auto first = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), a.x) - x.begin());
    for (std::size_t s = first; s < slabs.size() && x[s + 1] <= b.x; ++s)
    {
      const auto at = [&](double position) { return a.y + (b.y - a.y) * ((position - a.x) / (b.x - a.x)); };
      const double left = at(x[s]);
      const double right = at(x[s + 1]);
      const double middle = at(0.5 * (x[s] + x[s + 1]));
      if (middle < middles[s].low)
      {
        middles[s].low = middle;
        slabs[s].low = std::max(left, right);
      }
      if (middle > middles[s].high)
      {
        middles[s].high = middle;
        slabs[s].high = std::min(left, right);
      }
    }
  }

  Rectangle best;
  double largest = 0.0;
  for (std::size_t first = 0; first < slabs.size(); ++first)
  {
    Slab common;
    for (std::size_t last = first; last < slabs.size(); ++last)
    {
      common.low = std::max(common.low, slabs[last].low);
      common.high = std::min(common.high, slabs[last].high);
      if (!(common.low < common.high))
      {
        break;
      }
      const double area = (x[last + 1] - x[first]) * (common.high - common.low);
      if (area > largest)
      {
        largest = area;
        best = { { x[first], common.low }, { x[last + 1], common.high } };
      }
    }
  }
  return best;
}

}
