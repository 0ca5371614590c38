#pragma once

#include "bathymetry/CrsChoice.h"
#include "bathymetry/SeafloorOptions.h"
#include "bathymetry/SoundingReport.h"
#include "bathymetry/Soundings.h"
#include "bathymetry/VerticalMeaning.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace swellray
{

/** Soundings as elevations, each place once, and what their coordinates are. */
struct SoundingPlaces
{
  std::vector<glm::dvec2> file;       ///< n file coordinates, by x, then y; longitudes without a jump
  std::vector<double> elevation;      ///< n, m, positive up
  std::vector<std::uint32_t> placeOf; ///< of each sounding its place; NoPlace where it has no value
  CrsChoice crs;
  VerticalMeaning meaning;
  Rectangle extent; ///< file coordinates
  std::vector<std::string> notes;

  static constexpr std::uint32_t NoPlace = 0xffffffffU;
};

/**
 * First part of gridSoundings(): values become elevations, soundings at the very same place one, their mean.
 * Counts go into the report. Throws as gridSoundings() does.
 */
SoundingPlaces findPlaces(const Soundings& soundings, const SeafloorOptions& options, SoundingReport& report);

}
