#pragma once

#include "bathymetry/NaturalNeighbours.h"
#include "bathymetry/SoundingReport.h"
#include "sim/Execution.h"

#include <cstdint>
#include <vector>

namespace swellray
{

/** Elevations of places less those that their natural neighbours foretell without them. */
struct LeftOutDifferences
{
  std::vector<double> elevation; ///< m; NaN where nothing is foretold
  std::vector<double> bend;      ///< the same over the square of the neighbours' mean distance, as on a smooth bed, 1/m
};

LeftOutDifferences leftOutDifferences(
  const NaturalNeighbours& places, const std::vector<double>& elevations, const Execution& execution);

/**
 * Places whose difference from their neighbours is larger than 10 robust standard deviations (1.4826 times the median):
 * of the differences of all places, of those of the neighbours and their neighbours, and, over the square of the
 * neighbours' distance, of all; larger than a thousandth of the range of elevations (1 to 99 %); and larger than those of
 * all their neighbours. They are taken out and the neighbours are compared again, until there are no more: a wrong
 * sounding makes its neighbours look wrong.
 *
 * @param places without the outliers afterwards
 * @param differences of leftOutDifferences(); afterwards without the outliers, whose own are then NaN
 * @return the outliers, ascending
 */
std::vector<std::uint32_t> takeOutliers(
  NaturalNeighbours& places, const std::vector<double>& elevations, LeftOutDifferences& differences);

/** Root mean square and largest of differences that are numbers. */
SoundingReport::LeftOut summarize(const std::vector<double>& differences, const std::vector<glm::dvec2>& filePlaces);

/**
 * Elevation of each place less the one foretold by nine tenths of the places that it is not among; NaN where these do
 * not surround it. Tenths are drawn by chance, always the same, patch by patch: of a survey along lines, stretches of a
 * line are left out whole, so that what is between the lines is measured, not what is along them.
 *
 * @param patch side of the squares that are left out as one, m, > 0
 */
std::vector<double> tenthDifferences(const std::vector<glm::dvec2>& points, const std::vector<double>& elevations,
  double patch, const Execution& execution);

}
