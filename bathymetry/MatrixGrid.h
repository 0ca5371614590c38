#pragma once

#include "bathymetry/ModelGrid.h"

#include <string>

namespace swellray
{

/**
 * A curvilinear grid of three matrices of equal size, one line a row: x, y and elevation of each node, in file
 * coordinates, in either sense of the indices.
 * @throws std::runtime_error where their sizes differ
 */
ModelGrid readMatrixGrid(const std::string& x, const std::string& y, const std::string& z);

/** True for a survey table of the Field Research Facility, Duck: its first line begins with Dist_X Y_<number>. */
bool isFrfTable(const std::string& text);

/**
 * A survey table of the Field Research Facility, Duck: elevations on lines of constant y, which the head of each column
 * names (Y_725), at the distances x that begin each line. Coordinates may be rounded to the digits shown.
 * @throws std::runtime_error on a line that is not as long as the head
 */
ModelGrid readFrfTable(const std::string& text);

/**
 * The bathymetry of a Celeris run: a matrix of elevations, one line a row, the first one at y = 0, and its
 * configuration (JSON) with WIDTH, HEIGHT, dx and dy.
 * @throws std::runtime_error where the configuration does not fit the matrix
 */
ModelGrid readCelerisGrid(const std::string& matrix, const std::string& configuration);

/** True for a JSON object that sets WIDTH, HEIGHT, dx and dy; the first two are handed out. */
bool isCelerisConfiguration(const std::string& text, std::size_t& width, std::size_t& height);

}
