#include "sim/Crests.h"

#include "sim/Angles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace swellray
{

namespace
{

// Fronts lie on crests to the accuracy of the integration: a ray that ends on one must not miss it by rounding. rad.
constexpr double PhaseTolerance = 1e-6;

constexpr double crestPhase(std::int64_t number)
{
  return 2.0 * Pi * static_cast<double>(number);
}

struct Candidate
{
  std::size_t order; // of the ray along the incident crest
  RayPlace place;
};

// Number of marked entries in a range, in the time of its logarithm (Fenwick 1994).
class MarkCount
{
public:
  explicit MarkCount(std::size_t size) : Sums(size + 1, 0) {}

  void mark(std::size_t index)
  {
    for (std::size_t i = index + 1; i < this->Sums.size(); i += i & (~i + 1))
    {
      ++this->Sums[i];
    }
  }

  bool any(std::size_t begin, std::size_t end) const { return before(end) > before(begin); }

private:
  std::size_t before(std::size_t index) const
  {
    std::size_t sum = 0;
    for (std::size_t i = index; i > 0; i -= i & (~i + 1))
    {
      sum += this->Sums[i];
    }
    return sum;
  }

  std::vector<std::size_t> Sums;
};

glm::dvec2 positionAt(const RayLines& lines, const RayPlace& place)
{
  const double* a = lines.positions + 3 * place.point;
  return glm::dvec2(a[0], a[1]) + place.weight * glm::dvec2(a[3] - a[0], a[4] - a[1]);
}

// Crests that ray r crosses, first to second; none where first > second.
std::pair<std::int64_t, std::int64_t> crestsOf(const RayLines& lines, std::size_t r)
{
  const std::int64_t begin = lines.offsets[r];
  const std::int64_t end = lines.offsets[r + 1];
  if (end - begin < 2)
  {
    return { 1, 0 };
  }
  const double from = std::ceil((lines.phase[begin] - PhaseTolerance) / (2.0 * Pi));
  const double to = std::floor((lines.phase[end - 1] + PhaseTolerance) / (2.0 * Pi));
  if (!(from <= to) || std::isinf(from) || std::isinf(to))
  {
    return { 1, 0 };
  }
  return { static_cast<std::int64_t>(from), static_cast<std::int64_t>(to) };
}

}

CrestLines extractCrests(const RayLines& lines, double maxGap)
{
  CrestLines crests;
  std::vector<std::size_t> sorted(lines.rays);
  std::iota(sorted.begin(), sorted.end(), std::size_t(0));
  std::sort(sorted.begin(), sorted.end(),
    [&](std::size_t a, std::size_t b)
    {
      return std::make_tuple(lines.launchSegment[a], lines.launchParameter[a], a) <
        std::make_tuple(lines.launchSegment[b], lines.launchParameter[b], b);
    });

  // Sort the crossings into crests by counting.
  std::int64_t lowest = 0;
  std::int64_t highest = -1;
  for (std::size_t r = 0; r < lines.rays; ++r)
  {
    const auto [from, to] = crestsOf(lines, r);
    if (from <= to)
    {
      const bool none = highest < lowest;
      lowest = none ? from : std::min(lowest, from);
      highest = none ? to : std::max(highest, to);
    }
  }
  std::vector<std::size_t> offsets(static_cast<std::size_t>(highest - lowest + 1) + 1, 0);
  for (std::size_t r = 0; r < lines.rays; ++r)
  {
    const auto [from, to] = crestsOf(lines, r);
    for (std::int64_t n = from; n <= to; ++n)
    {
      ++offsets[static_cast<std::size_t>(n - lowest) + 1];
    }
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<Candidate> candidates(offsets.back());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  for (std::size_t order = 0; order < sorted.size(); ++order)
  {
    const std::size_t r = sorted[order];
    const auto [from, to] = crestsOf(lines, r);
    std::int64_t point = lines.offsets[r];
    const std::int64_t last = lines.offsets[r + 1] - 1;
    for (std::int64_t n = from; n <= to; ++n)
    {
      const double phase = crestPhase(n);
      while (point + 1 < last && lines.phase[point + 1] < phase)
      {
        ++point;
      }
      const double rise = lines.phase[point + 1] - lines.phase[point];
      const double weight = rise > 0.0 ? std::clamp((phase - lines.phase[point]) / rise, 0.0, 1.0) : 0.0;
      candidates[next[static_cast<std::size_t>(n - lowest)]++] = { order, { point, weight } };
    }
  }

  // Rays in the order in which they end, to know at each crest which have ended before it.
  const auto lastPhase = [&](std::size_t order)
  {
    const std::size_t r = sorted[order];
    const bool empty = lines.offsets[r + 1] == lines.offsets[r];
    return empty ? std::numeric_limits<double>::infinity() : lines.phase[lines.offsets[r + 1] - 1];
  };
  std::vector<std::size_t> ending(sorted.size());
  std::iota(ending.begin(), ending.end(), std::size_t(0));
  ending.erase(std::remove_if(ending.begin(), ending.end(),
                 [&](std::size_t order) { return !std::isfinite(lastPhase(order)); }),
    ending.end());
  std::sort(
    ending.begin(), ending.end(), [&](std::size_t a, std::size_t b) { return lastPhase(a) < lastPhase(b); });
  MarkCount ended(sorted.size());
  std::size_t endedCount = 0;

  for (std::int64_t n = lowest; n <= highest; ++n)
  {
    while (endedCount < ending.size() && lastPhase(ending[endedCount]) < crestPhase(n) - PhaseTolerance)
    {
      ended.mark(ending[endedCount++]);
    }
    const auto linked = [&](const Candidate& a, const Candidate& b)
    {
      return lines.launchSegment[sorted[a.order]] == lines.launchSegment[sorted[b.order]] &&
        (b.order == a.order + 1 || !ended.any(a.order + 1, b.order)) &&
        (!(maxGap > 0.0) || glm::distance(positionAt(lines, a.place), positionAt(lines, b.place)) <= maxGap);
    };
    const std::size_t end = offsets[static_cast<std::size_t>(n - lowest) + 1];
    std::size_t begin = offsets[static_cast<std::size_t>(n - lowest)];
    while (begin < end)
    {
      std::size_t stop = begin + 1;
      while (stop < end && linked(candidates[stop - 1], candidates[stop]))
      {
        ++stop;
      }
      if (stop - begin > 1)
      {
        for (std::size_t i = begin; i < stop; ++i)
        {
          crests.places.push_back(candidates[i].place);
        }
        crests.number.push_back(n);
        crests.offsets.push_back(crests.places.size());
      }
      begin = stop;
    }
  }
  return crests;
}

}
