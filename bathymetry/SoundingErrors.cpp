#include "bathymetry/SoundingErrors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>

namespace swellray
{

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Standard deviation over median of the magnitudes, of the normal distribution.
constexpr double DeviationOfMedian = 1.4826;

// Differences on a natural bed have long tails, longer than the normal distribution.
constexpr double OutlierDeviations = 10.0;

// Differences below this share of the range of elevations are rounding, whatever the others are.
constexpr double LeastShareOfRange = 1e-3;

// A median of fewer says little.
constexpr std::size_t FewestForMedian = 6;

constexpr int Tenths = 10;

double valueAt(std::vector<double>& values, double share)
{
  const auto index = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

void compare(const NaturalNeighbours& places, const std::vector<double>& elevations, std::size_t place,
  LeftOutDifferences& differences)
{
  const NaturalNeighbours::Estimate foretold = places.leftOut(place, elevations);
  differences.elevation[place] = elevations[place] - foretold.value;
  differences.bend[place] = differences.elevation[place] / (foretold.distance * foretold.distance);
}

class OutlierSearch
{
public:
  OutlierSearch(NaturalNeighbours& places, const std::vector<double>& elevations, LeftOutDifferences& differences)
    : Places(places)
    , Elevations(elevations)
    , Differences(differences)
    , Round(elevations.size(), 0)
  {
    std::vector<double> sorted = elevations;
    const double high = valueAt(sorted, 0.99);
    const double range = high - valueAt(sorted, 0.01);
    this->Least = std::max(limitOf(differences.elevation), LeastShareOfRange * range);
    this->LeastBend = limitOf(differences.bend);
  }

  std::vector<std::uint32_t> find()
  {
    std::vector<std::uint32_t> candidates;
    for (std::size_t place = 0; place < this->Elevations.size(); ++place)
    {
      if (this->isLarge(place))
      {
        candidates.push_back(static_cast<std::uint32_t>(place));
      }
    }
    std::vector<std::uint32_t> outliers;
    for (std::uint32_t round = 1; !candidates.empty(); ++round)
    {
      std::vector<std::uint32_t> found;
      for (const std::uint32_t place : candidates)
      {
        if (this->isOutlier(place))
        {
          found.push_back(place);
        }
      }
      candidates = this->takeOut(found, round);
      outliers.insert(outliers.end(), found.begin(), found.end());
    }
    std::sort(outliers.begin(), outliers.end());
    return outliers;
  }

private:
  static double limitOf(const std::vector<double>& differences)
  {
    std::vector<double> sizes;
    for (const double difference : differences)
    {
      if (!std::isnan(difference))
      {
        sizes.push_back(std::abs(difference));
      }
    }
    return sizes.empty() ? std::numeric_limits<double>::infinity()
                         : OutlierDeviations * DeviationOfMedian * valueAt(sizes, 0.5);
  }

  bool isLarge(std::size_t place) const
  {
    return std::abs(this->Differences.elevation[place]) > this->Least &&
      std::abs(this->Differences.bend[place]) > this->LeastBend;
  }

  bool isOutlier(std::uint32_t place)
  {
    const double difference = std::abs(this->Differences.elevation[place]);
    this->Places.neighboursOf(place, this->Ring);
    for (const std::uint32_t neighbour : this->Ring)
    {
      // Of two equal ones, side by side, the first is enough.
      const double other = std::abs(this->Differences.elevation[neighbour]);
      if (other > difference || (other == difference && neighbour < place))
      {
        return false;
      }
    }
    this->Around = this->Ring;
    for (const std::uint32_t neighbour : this->Ring)
    {
      this->Places.neighboursOf(neighbour, this->Outer);
      this->Around.insert(this->Around.end(), this->Outer.begin(), this->Outer.end());
    }
    std::sort(this->Around.begin(), this->Around.end());
    this->Around.erase(std::unique(this->Around.begin(), this->Around.end()), this->Around.end());
    this->Sizes.clear();
    for (const std::uint32_t other : this->Around)
    {
      if (other != place && !std::isnan(this->Differences.elevation[other]))
      {
        this->Sizes.push_back(std::abs(this->Differences.elevation[other]));
      }
    }
    return this->Sizes.size() < FewestForMedian ||
      difference > OutlierDeviations * DeviationOfMedian * valueAt(this->Sizes, 0.5);
  }

  // The places whose differences are new and large.
  std::vector<std::uint32_t> takeOut(const std::vector<std::uint32_t>& found, std::uint32_t round)
  {
    std::vector<std::uint32_t> touched;
    for (const std::uint32_t place : found)
    {
      this->Places.neighboursOf(place, this->Ring);
      touched.insert(touched.end(), this->Ring.begin(), this->Ring.end());
      this->Places.remove(place);
      this->Differences.elevation[place] = NotANumber;
      this->Differences.bend[place] = NotANumber;
    }
    std::vector<std::uint32_t> candidates;
    for (const std::uint32_t place : touched)
    {
      if (this->Round[place] == round || std::isnan(this->Differences.elevation[place]))
      {
        continue;
      }
      this->Round[place] = round;
      compare(this->Places, this->Elevations, place, this->Differences);
      if (this->isLarge(place))
      {
        candidates.push_back(place);
      }
    }
    return candidates;
  }

  NaturalNeighbours& Places;
  const std::vector<double>& Elevations;
  LeftOutDifferences& Differences;
  std::vector<std::uint32_t> Round; // in which each was last compared
  double Least = 0.0;
  double LeastBend = 0.0;
  std::vector<std::uint32_t> Ring;
  std::vector<std::uint32_t> Outer;
  std::vector<std::uint32_t> Around;
  std::vector<double> Sizes;
};

}

LeftOutDifferences leftOutDifferences(
  const NaturalNeighbours& places, const std::vector<double>& elevations, const Execution& execution)
{
  LeftOutDifferences differences{ std::vector<double>(elevations.size()), std::vector<double>(elevations.size()) };
  execution.forRange(elevations.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t place = begin; place < end; ++place)
      {
        compare(places, elevations, place, differences);
      }
    });
  return differences;
}

std::vector<std::uint32_t> takeOutliers(
  NaturalNeighbours& places, const std::vector<double>& elevations, LeftOutDifferences& differences)
{
  return OutlierSearch(places, elevations, differences).find();
}

SoundingReport::LeftOut summarize(const std::vector<double>& differences, const std::vector<glm::dvec2>& filePlaces)
{
  SoundingReport::LeftOut error;
  double squares = 0.0;
  for (std::size_t place = 0; place < differences.size(); ++place)
  {
    const double difference = std::abs(differences[place]);
    if (std::isnan(difference))
    {
      continue;
    }
    ++error.count;
    squares += difference * difference;
    if (difference > error.largest || error.count == 1)
    {
      error.largest = difference;
      error.place = filePlaces[place];
    }
  }
  error.rms = error.count > 0 ? std::sqrt(squares / static_cast<double>(error.count)) : 0.0;
  return error;
}

std::vector<double> tenthDifferences(const std::vector<glm::dvec2>& points, const std::vector<double>& elevations,
  double patch, const Execution& execution)
{
  // Only the generator itself is the same on every machine; distributions are not.
  std::mt19937 chance;
  std::map<std::pair<double, double>, int> tenthOf;
  std::vector<int> tenth(points.size());
  for (std::size_t place = 0; place < points.size(); ++place)
  {
    const auto square = std::make_pair(std::floor(points[place].x / patch), std::floor(points[place].y / patch));
    const auto [found, isNew] = tenthOf.emplace(square, 0);
    found->second = isNew ? static_cast<int>(chance() % Tenths) : found->second;
    tenth[place] = found->second;
  }
  std::vector<double> differences(points.size(), NotANumber);
  for (int out = 0; out < Tenths; ++out)
  {
    std::vector<glm::dvec2> kept;
    std::vector<double> keptElevations;
    std::vector<std::uint32_t> left;
    for (std::size_t place = 0; place < points.size(); ++place)
    {
      if (tenth[place] == out)
      {
        left.push_back(static_cast<std::uint32_t>(place));
        continue;
      }
      kept.push_back(points[place]);
      keptElevations.push_back(elevations[place]);
    }
    const NaturalNeighbours others(kept);
    // A walk each few: how the loop is shared out changes nothing.
    constexpr std::size_t stretch = 256;
    execution.forRange((left.size() + stretch - 1) / stretch,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t part = begin; part < end; ++part)
        {
          NaturalNeighbours::Walk walk(others);
          for (std::size_t i = part * stretch; i < std::min(left.size(), (part + 1) * stretch); ++i)
          {
            differences[left[i]] = elevations[left[i]] - walk.at(points[left[i]], keptElevations).value;
          }
        }
      });
  }
  return differences;
}

}
