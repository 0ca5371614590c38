#include "bathymetry/AveragedRead.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace swellray
{

namespace
{

// Cells read at once, 32 MB of them.
constexpr std::size_t CellsOfStrip = 4194304;

void average(
  const std::vector<double>& strip, std::size_t width, const CellBlock& block, std::size_t rows, AveragedValues& result)
{
  std::vector<double> sums(result.columns);
  std::vector<double> counts(result.columns);
  for (std::size_t row = 0; row < rows; ++row)
  {
    std::fill(sums.begin(), sums.end(), 0.0);
    std::fill(counts.begin(), counts.end(), 0.0);
    for (std::size_t line = 0; line < block.rows; ++line)
    {
      const double* value = strip.data() + (row * block.rows + line) * width;
      for (std::size_t column = 0; column < result.columns; ++column)
      {
        for (std::size_t cell = 0; cell < block.columns; ++cell, ++value)
        {
          if (!std::isnan(*value))
          {
            sums[column] += *value;
            counts[column] += 1.0;
            result.lowest = std::min(*value, result.lowest);
            result.highest = std::max(*value, result.highest);
          }
        }
      }
    }
    for (std::size_t column = 0; column < result.columns; ++column)
    {
      // Without any data 0/0: no number.
      result.values.push_back(sums[column] / counts[column]);
    }
  }
}

}

AveragedValues readAveraged(const RasterSource& source, const RasterWindow& window, const CellBlock& block,
  double nodata, const Execution& execution)
{
  AveragedValues result;
  result.columns = window.columns / block.columns;
  result.rows = window.rows / block.rows;
  result.lowest = std::numeric_limits<double>::infinity();
  result.highest = -result.lowest;
  const std::size_t width = result.columns * block.columns;
  const std::size_t rowsAtOnce = std::max<std::size_t>(1, CellsOfStrip / std::max<std::size_t>(1, width * block.rows));
  result.values.reserve(result.columns * result.rows);
  for (std::size_t row = 0; row < result.rows; row += rowsAtOnce)
  {
    const std::size_t rows = std::min(rowsAtOnce, result.rows - row);
    const RasterWindow strip{ window.firstColumn, window.firstRow + row * block.rows, width, rows * block.rows };
    average(source.read(strip, nodata), width, block, rows, result);
    if (!execution.report(static_cast<double>(row) / static_cast<double>(result.rows)))
    {
      throw std::runtime_error("reading was cancelled");
    }
  }
  return result;
}

}
