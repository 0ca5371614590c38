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
  std::vector<double> slope;     ///< the same over the mean distance of the neighbours
};

LeftOutDifferences leftOutDifferences(
  const NaturalNeighbours& places, const std::vector<double>& elevations, const Execution& execution);

/**
 * Places whose difference from their neighbours is larger than 10 robust standard deviations (1.4826 times the median),
 * in elevation of all the places and of the neighbours and their neighbours, and in slope of all the places; larger than
 * a thousandth of the range of elevations (1 to 99 %); and larger than those of all their neighbours. They are taken out
 * and the neighbours are compared again, until there are no more: a wrong sounding makes its neighbours look wrong.
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
 * not surround it. The tenths are drawn by chance, the same for the same number of places.
 */
std::vector<double> tenthDifferences(
  const std::vector<glm::dvec2>& points, const std::vector<double>& elevations, const Execution& execution);

}
