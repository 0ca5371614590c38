#pragma once

#include "sim/Execution.h"
#include "sim/RaySheets.h"

#include <vector>

namespace swellray
{

/** A sheet that covers a place. */
struct SheetHit
{
  std::size_t place = 0; ///< its index
  WaveSheet wave;
};

/**
 * The sheets at single places, in the order of the places and, at each, of the triangles.
 * @param wanted places to leave out have 0; null: all are wanted
 */
std::vector<SheetHit> findSheets(const RaySheets& sheets, const std::vector<glm::dvec2>& places,
  const std::vector<char>* wanted, const Execution& execution);

}
