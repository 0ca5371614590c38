#pragma once

#include "sim/Angles.h"
#include "sim/sections/WaveSection.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

/** A wave of 2 m and 9 s on a bed of 3 %, unless a test says otherwise. */
inline swellray::SectionPlace placeOf(double height, double wavelength, double depth, double slope = 0.03)
{
  swellray::SectionPlace place;
  place.height = height;
  place.wavenumber = 2.0 * swellray::Pi / wavelength;
  place.depth = depth;
  place.slope = slope;
  place.ripeness = std::min(1.0, height / depth / 0.78);
  return place;
}

/** The crest of the same wave at the same place, not broken. */
inline swellray::CrestState crestOf(const swellray::SectionPlace& place, double plunge = 0.0, double plungeHeight = 0.0)
{
  swellray::CrestState crest;
  crest.height = place.height;
  crest.wavenumber = place.wavenumber;
  crest.depth = place.depth;
  crest.ripeness = plunge > 0.0 ? 1.0 : place.ripeness;
  crest.plunge = plunge;
  crest.plungeHeight = plungeHeight;
  crest.slope = place.slope;
  return crest;
}

/** The surface of one wave, from the trough behind to the one ahead: m from its crest, m above still water. */
inline std::vector<glm::dvec2> curveOf(const swellray::WaveSection& section, swellray::SectionPlace place,
  const swellray::CrestState& crest, int intervals = 2000)
{
  std::vector<glm::dvec2> curve;
  for (int i = 0; i <= intervals; ++i)
  {
    place.phase = swellray::Pi * (2.0 * i / intervals - 1.0);
    const swellray::SectionPoint point = section.at(crest, place);
    curve.push_back({ place.phase / place.wavenumber + point.along, point.up });
  }
  return curve;
}

/** Mean level of a curve: the area under it over its length. */
inline double meanLevel(const std::vector<glm::dvec2>& curve)
{
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    area += 0.5 * (curve[i].y + curve[i - 1].y) * (curve[i].x - curve[i - 1].x);
  }
  return area / (curve.back().x - curve.front().x);
}

/** How far a curve runs backwards, m: 0 for one that is a function. */
inline double overhang(const std::vector<glm::dvec2>& curve)
{
  double back = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    back += std::max(0.0, curve[i - 1].x - curve[i].x);
  }
  return back;
}

inline glm::dvec2 highest(const std::vector<glm::dvec2>& curve)
{
  return *std::max_element(
    curve.begin(), curve.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; });
}

inline glm::dvec2 lowest(const std::vector<glm::dvec2>& curve)
{
  return *std::min_element(
    curve.begin(), curve.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; });
}
