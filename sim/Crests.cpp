#include "sim/Crests.h"

#include "sim/Angles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>

namespace swellray
{

namespace
{

// Fronts lie on crests to the accuracy of the integration: a ray that ends on one must not miss it by rounding. rad.
constexpr double PhaseTolerance = 1e-6;

// Ten million waves, several times around the Earth: what is beyond is no phase. rad.
constexpr double LargestPhase = 2e7 * Pi;

constexpr double crestPhase(std::int64_t index, std::int64_t every)
{
  return 2.0 * Pi * static_cast<double>(index * every);
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
  explicit MarkCount(std::size_t size)
    : Sums(size + 1, 0)
  {
  }

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

double scaleAt(const RayLines& lines, const RayPlace& place)
{
  return lines.scale ? lines.scale[place.point] : 1.0;
}

std::size_t pointCount(const RayLines& lines, std::size_t ray)
{
  return static_cast<std::size_t>(lines.offsets[ray + 1] - lines.offsets[ray]);
}

double lastPhase(const RayLines& lines, std::size_t ray)
{
  return lines.phase[lines.offsets[ray + 1] - 1];
}

struct Range
{
  std::int64_t first = 0;
  std::int64_t last = -1;

  std::size_t size() const { return static_cast<std::size_t>(this->last - this->first + 1); }
};

// Crests that a ray crosses, by their number over `every`.
Range crestsOf(const RayLines& lines, std::size_t ray, std::int64_t every)
{
  if (pointCount(lines, ray) < 2)
  {
    return {};
  }
  const double from = lines.phase[lines.offsets[ray]];
  const double to = lastPhase(lines, ray);
  for (const double phase : { from, to })
  {
    if (!(std::fabs(phase) < LargestPhase))
    {
      std::ostringstream message;
      message << "ray " << ray << ": a phase of " << phase << " rad is none of a wave; it must be within "
              << LargestPhase;
      throw std::runtime_error(message.str());
    }
  }
  const double step = crestPhase(1, every);
  const Range range{ static_cast<std::int64_t>(std::ceil((from - PhaseTolerance) / step)),
    static_cast<std::int64_t>(std::floor((to + PhaseTolerance) / step)) };
  return range.first <= range.last ? range : Range();
}

// Where rays cross crests: those of crest `numbers.first + i` from offsets[i] on, in the order of the rays.
struct Crossings
{
  Range numbers;
  std::vector<std::size_t> offsets{ 0 };
  std::vector<Candidate> candidates;
};

Crossings findCrossings(const RayLines& lines, const std::vector<std::size_t>& sorted, std::int64_t every)
{
  Crossings crossings;
  std::vector<Range> ranges(sorted.size());
  Range& numbers = crossings.numbers;
  for (std::size_t order = 0; order < sorted.size(); ++order)
  {
    const Range& range = ranges[order] = crestsOf(lines, sorted[order], every);
    if (range.size() > 0)
    {
      const bool none = numbers.size() == 0;
      numbers.first = none ? range.first : std::min(numbers.first, range.first);
      numbers.last = none ? range.last : std::max(numbers.last, range.last);
    }
  }

  std::vector<std::size_t>& offsets = crossings.offsets;
  offsets.resize(numbers.size() + 1, 0);
  for (const Range& range : ranges)
  {
    for (std::int64_t n = range.first; n <= range.last; ++n)
    {
      ++offsets[static_cast<std::size_t>(n - numbers.first) + 1];
    }
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());

  crossings.candidates.resize(offsets.back());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  for (std::size_t order = 0; order < sorted.size(); ++order)
  {
    std::int64_t point = lines.offsets[sorted[order]];
    const std::int64_t last = lines.offsets[sorted[order] + 1] - 1;
    for (std::int64_t n = ranges[order].first; n <= ranges[order].last; ++n)
    {
      const double phase = crestPhase(n, every);
      while (point + 1 < last && lines.phase[point + 1] < phase)
      {
        ++point;
      }
      const double rise = lines.phase[point + 1] - lines.phase[point];
      const double weight = rise > 0.0 ? std::clamp((phase - lines.phase[point]) / rise, 0.0, 1.0) : 0.0;
      crossings.candidates[next[static_cast<std::size_t>(n - numbers.first)]++] = { order, { point, weight } };
    }
  }
  return crossings;
}

}

double trueDistance(const RayLines& lines, std::int64_t a, std::int64_t b)
{
  const double* const from = lines.positions + 3 * a;
  const double* const to = lines.positions + 3 * b;
  const double onMap = std::hypot(to[0] - from[0], to[1] - from[1]);
  return lines.scale ? onMap / std::sqrt(lines.scale[a] * lines.scale[b]) : onMap;
}

CrestLines extractCrests(const RayLines& lines, double maxGap, std::int64_t every, const Obstacles* obstacles)
{
  if (every < 1)
  {
    throw std::invalid_argument("crests: every " + std::to_string(every) + "th cannot be drawn; it must be 1 or more");
  }
  std::vector<std::size_t> sorted(lines.rays);
  std::iota(sorted.begin(), sorted.end(), std::size_t(0));
  std::sort(sorted.begin(), sorted.end(),
    [&](std::size_t a, std::size_t b)
    {
      return std::make_tuple(lines.launchSegment[a], lines.launchParameter[a], a) <
        std::make_tuple(lines.launchSegment[b], lines.launchParameter[b], b);
    });
  const Crossings crossings = findCrossings(lines, sorted, every);

  // Rays in the order in which they end, to know at each crest which have ended before it.
  std::vector<std::size_t> ending;
  for (std::size_t order = 0; order < sorted.size(); ++order)
  {
    if (pointCount(lines, sorted[order]) > 0)
    {
      ending.push_back(order);
    }
  }
  const auto end = [&](std::size_t order) { return lastPhase(lines, sorted[order]); };
  std::sort(ending.begin(), ending.end(), [&](std::size_t a, std::size_t b) { return end(a) < end(b); });
  MarkCount ended(sorted.size());
  std::size_t endedCount = 0;

  const auto linked = [&](const Candidate& a, const Candidate& b)
  {
    return lines.launchSegment[sorted[a.order]] == lines.launchSegment[sorted[b.order]] &&
      (b.order == a.order + 1 || !ended.any(a.order + 1, b.order)) &&
      (!(maxGap > 0.0) ||
        glm::distance(positionAt(lines, a.place), positionAt(lines, b.place)) <= maxGap * scaleAt(lines, a.place)) &&
      !(obstacles && obstacles->crosses(positionAt(lines, a.place), positionAt(lines, b.place)));
  };
  CrestLines crests;
  for (std::size_t i = 0; i < crossings.numbers.size(); ++i)
  {
    const std::int64_t index = crossings.numbers.first + static_cast<std::int64_t>(i);
    while (endedCount < ending.size() && end(ending[endedCount]) < crestPhase(index, every) - PhaseTolerance)
    {
      ended.mark(ending[endedCount++]);
    }
    const Candidate* const stop = crossings.candidates.data() + crossings.offsets[i + 1];
    const Candidate* first = crossings.candidates.data() + crossings.offsets[i];
    while (first != stop)
    {
      const Candidate* last = first;
      while (last + 1 != stop && linked(*last, last[1]))
      {
        ++last;
      }
      if (last != first)
      {
        std::transform(first, last + 1, std::back_inserter(crests.places),
          [](const Candidate& candidate) { return candidate.place; });
        crests.number.push_back(index * every);
        crests.offsets.push_back(crests.places.size());
      }
      first = last + 1;
    }
  }
  return crests;
}

}
