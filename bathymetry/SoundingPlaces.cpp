#include "bathymetry/SoundingPlaces.h"

#include "bathymetry/NaturalNeighbours.h"
#include "bathymetry/RasterSource.h"
#include "bathymetry/Text.h"
#include "bathymetry/ToMetres.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace swellray
{

namespace
{

// No unit of length makes coordinates on Earth larger; the predicates of triangulation overflow at the root of the
// largest double.
constexpr double FarthestPlace = 1e12;

void check(const Soundings& soundings)
{
  const std::size_t n = soundings.z.size();
  if (soundings.x.size() != n || soundings.y.size() != n)
  {
    throw std::invalid_argument("soundings have " + std::to_string(soundings.x.size()) + " x, " +
      std::to_string(soundings.y.size()) + " y and " + std::to_string(n) + " z; these must be as many");
  }
  if (n >= SoundingPlaces::NoPlace)
  {
    throw std::runtime_error("it has " + std::to_string(n) + " soundings, more than can be gridded at once");
  }
  const auto& offsets = soundings.cellOffsets;
  if (offsets.empty() && soundings.cellNodes.empty())
  {
    return;
  }
  if (offsets.empty() || offsets.front() != 0 || offsets.back() != soundings.cellNodes.size() ||
    !std::is_sorted(offsets.begin(), offsets.end()))
  {
    throw std::invalid_argument("the offsets of the cells do not fit their nodes");
  }
  const std::size_t corners = soundings.cornerX.empty() ? n : soundings.cornerX.size();
  if (soundings.cornerX.size() != soundings.cornerY.size() || (!soundings.cornerX.empty() && offsets.size() != n + 1))
  {
    throw std::invalid_argument(
      "the corners of the cells must have x and y, and there must be a cell for each sounding");
  }
  if (std::any_of(soundings.cellNodes.begin(), soundings.cellNodes.end(),
        [corners](std::uint32_t node) { return node >= corners; }))
  {
    throw std::invalid_argument("a cell names a node that is none of the " + std::to_string(corners));
  }
}

// Longitudes counted on from the widest stretch without soundings, so that none lies a turn away from its neighbours.
void unwrap(std::vector<double>& x)
{
  constexpr std::size_t bins = 360;
  std::array<bool, bins> taken{};
  for (double& longitude : x)
  {
    longitude -= 360.0 * std::floor(longitude / 360.0);
    taken[std::min(bins - 1, static_cast<std::size_t>(longitude))] = true;
  }
  std::size_t begin = 0; // first bin after the widest stretch
  std::size_t widest = 0;
  std::size_t empty = 0;
  for (std::size_t i = 0; i < 2 * bins; ++i)
  {
    if (!taken[i % bins])
    {
      ++empty;
      continue;
    }
    if (empty > widest)
    {
      widest = empty;
      begin = i % bins;
    }
    empty = 0;
  }
  for (double& longitude : x)
  {
    longitude += longitude < static_cast<double>(begin) ? 360.0 : 0.0;
    longitude -= begin >= bins / 2 ? 360.0 : 0.0;
  }
}

Rectangle boxOf(const std::vector<glm::dvec2>& points)
{
  Rectangle box{ points.front(), points.front() };
  for (const glm::dvec2& point : points)
  {
    box.low = glm::min(box.low, point);
    box.high = glm::max(box.high, point);
  }
  return box;
}

// Soundings at the very same place become one.
void merge(SoundingPlaces& places, SoundingReport& report)
{
  const std::size_t n = places.file.size();
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  const auto& file = places.file;
  std::sort(order.begin(), order.end(),
    [&file](std::uint32_t a, std::uint32_t b) {
      return file[a].x != file[b].x ? file[a].x < file[b].x : file[a].y != file[b].y ? file[a].y < file[b].y : a < b;
    });

  std::vector<glm::dvec2> merged;
  std::vector<double> elevation;
  std::vector<std::uint32_t> placeOf(n);
  merged.reserve(n);
  elevation.reserve(n);
  for (std::size_t i = 0; i < n;)
  {
    double low = places.elevation[order[i]];
    double high = low;
    double sum = 0.0;
    std::size_t end = i;
    for (; end < n && file[order[end]] == file[order[i]]; ++end)
    {
      const double z = places.elevation[order[end]];
      low = std::min(low, z);
      high = std::max(high, z);
      sum += z;
      placeOf[order[end]] = static_cast<std::uint32_t>(merged.size());
    }
    merged.push_back(file[order[i]]);
    elevation.push_back(sum / static_cast<double>(end - i));
    report.duplicates += end - i - 1;
    report.duplicateSpread = std::max(report.duplicateSpread, high - low);
    i = end;
  }
  places.file = std::move(merged);
  places.elevation = std::move(elevation);
  for (std::uint32_t& place : places.placeOf)
  {
    place = place == SoundingPlaces::NoPlace ? place : placeOf[place];
  }
}

// Of longitudes and latitudes asked for by a crop, only what one plane map can hold around it.
bool nearCrop(const SeafloorOptions& options, double x, double y)
{
  const auto& crop = *options.crop;
  return std::abs(std::remainder(x - 0.5 * (crop[0] + crop[2]), 360.0)) < 0.5 * WidestScene &&
    std::abs(y - 0.5 * (crop[1] + crop[3])) < 0.5 * WidestScene;
}

}

SoundingPlaces findPlaces(const Soundings& soundings, const SeafloorOptions& options, SoundingReport& report)
{
  check(soundings);
  SoundingPlaces places;
  places.meaning = understandVertical(soundings.vertical, options.positive);
  places.notes = soundings.notes;
  places.notes.insert(places.notes.end(), places.meaning.notes.begin(), places.meaning.notes.end());
  NoDataMark missing;
  missing.add(options.nodata.value_or(std::numeric_limits<double>::quiet_NaN()), false);
  const bool cropped = options.crop && options.earth == EarthModel::Plane && isLongitudes(options.crs, soundings.crs);

  places.placeOf.assign(soundings.size(), SoundingPlaces::NoPlace);
  std::vector<double> x;
  std::size_t marks = 0;
  constexpr double usualMark = -9999.0;
  for (std::size_t i = 0; i < soundings.size(); ++i)
  {
    if (!std::isfinite(soundings.x[i] + soundings.y[i]) || missing(soundings.z[i]))
    {
      ++report.missing;
      continue;
    }
    if (std::abs(soundings.x[i]) > FarthestPlace || std::abs(soundings.y[i]) > FarthestPlace)
    {
      throw std::runtime_error("it has a sounding at " + text(soundings.x[i]) + ", " + text(soundings.y[i]) +
        ", which is no place on Earth in any unit");
    }
    const double elevation = places.meaning.factor * soundings.z[i];
    if (std::abs(elevation) > FarthestElevation)
    {
      throw std::runtime_error("it has an elevation of " + text(elevation) +
        " m, farther from the sea's level than any place on Earth; if " + text(soundings.z[i]) +
        " marks missing data, say --nodata " + text(soundings.z[i], 17));
    }
    if (cropped && !nearCrop(options, soundings.x[i], soundings.y[i]))
    {
      continue;
    }
    marks += soundings.z[i] == usualMark ? 1 : 0;
    places.placeOf[i] = static_cast<std::uint32_t>(places.file.size());
    places.file.emplace_back(soundings.x[i], soundings.y[i]);
    places.elevation.push_back(elevation);
  }
  report.count = places.file.size();
  if (places.file.empty())
  {
    throw std::runtime_error(
      cropped && report.missing < soundings.size() ? "crop lies far from all of its soundings" : "it has no soundings");
  }
  if (marks > 0)
  {
    places.notes.push_back(
      std::to_string(marks) + " soundings hold -9999, which often marks missing data: if so, say --nodata -9999");
  }

  places.extent = boxOf(places.file);
  // The slope decides before longitudes are counted on and places merged: it needs places of its own.
  const auto slope = [&places]
  {
    SoundingPlaces own;
    own.file = places.file;
    own.elevation = places.elevation;
    SoundingReport unsaid;
    merge(own, unsaid);
    return NaturalNeighbours(own.file).rmsSlope(own.elevation);
  };
  places.crs = chooseCrs(options.crs, soundings.crs, soundings.crsSource, places.extent, slope, places.notes);
  if (isLongitudes({}, places.crs.crs))
  {
    x.reserve(places.file.size());
    for (const glm::dvec2& place : places.file)
    {
      x.push_back(place.x);
    }
    unwrap(x);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      places.file[i].x = x[i];
    }
    places.extent = boxOf(places.file);
  }
  merge(places, report);
  return places;
}

}
