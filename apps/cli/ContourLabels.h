#pragma once

#include "ChartLines.h"

#include <string>
#include <vector>

namespace swellray::cli
{

/**
 * Find a place for the label of a contour line: where the line is straight over the length of the words, near its
 * middle, within the map and apart from the labels that stand. The line is cut open there.
 * @param line in pixels; shortened to the part before the label
 * @param labels gets the label
 * @param rest gets the part of the line after the label
 * @return false, and nothing changed, where there is no place
 */
bool labelContour(PixelLine& line, const std::string& words, const ChartLayout& layout,
  std::vector<ContourLabel>& labels, PixelLine& rest);

}
