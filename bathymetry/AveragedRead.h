#pragma once

#include "bathymetry/RasterSource.h"
#include "sim/Execution.h"

#include <cstddef>
#include <vector>

namespace swellray
{

/** Cells of a raster that become one node: columns x rows. */
struct CellBlock
{
  std::size_t columns = 1;
  std::size_t rows = 1;
};

/** Values of a window, block by block, and their extremes. */
struct AveragedValues
{
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> values; ///< columns x rows, first row first; NaN where no cell of a block has data
  double lowest = 0.0;        ///< of the cells, not of their means; NaN without data
  double highest = 0.0;
};

/**
 * Means of the cells of a window over whole blocks; cells at its far sides that fill no block are left out, and cells
 * without data take no part. The raster is read in strips of some rows: memory is that of the result and a strip.
 *
 * @param nodata further value, as stored, that stands for no data; NaN: none
 * @throws std::runtime_error where the file cannot be read or the caller cancels
 */
AveragedValues readAveraged(const RasterSource& source, const RasterWindow& window, const CellBlock& block,
  double nodata, const Execution& execution);

}
