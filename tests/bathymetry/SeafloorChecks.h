#pragma once

#include "RasterFile.h"

#include "bathymetry/SeafloorReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace swellray::test
{

// Values are stored as doubles and nodes are kept: what is left is rounding.
constexpr double Exact = 1e-9;

// Nodes computed through degrees or by an affine map: rounding of coordinates times the slope.
constexpr double Rounding = 1e-6;

// The cubic spline of the test beds below, sampled 12 and more nodes a radian: 3e-4 of their 5 m.
constexpr double SplineError = 2e-3;

// A bed of 5 m waves, 20 m deep, `length` a radian in the file's coordinates.
inline Bed waves(double length, double x0 = 0.0, double y0 = 0.0)
{
  return [=](const glm::dvec2& p)
  { return -20.0 + 5.0 * std::sin((p.x - x0) / length) * std::cos(0.7 * (p.y - y0) / length); };
}

// Largest difference of a read seafloor from the bed that was written; infinite where no node has a value.
inline double largestError(const Bathymetry& read, const Bed& bed)
{
  double largest = 0.0;
  std::size_t count = 0;
  for (std::size_t row = 0; row < read.grid.rows; ++row)
  {
    for (std::size_t column = 0; column < read.grid.columns; ++column)
    {
      const double z = read.grid.at(column, row);
      if (!std::isnan(z))
      {
        const glm::dvec2 place = read.georeference.toFile(read.grid.node(column, row));
        largest = std::max(largest, std::abs(z - bed(place)));
        ++count;
      }
    }
  }
  return count > 0 ? largest : std::numeric_limits<double>::infinity();
}

inline std::string errorOf(const std::string& path, const SeafloorOptions& options = {})
{
  try
  {
    readSeafloor(path, options);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "no error";
}

inline std::string notesOf(const Bathymetry& read)
{
  std::string all;
  for (const std::string& note : read.report.notes)
  {
    all += note + "\n";
  }
  return all;
}

/** A test with a folder for its files. */
class SeafloorFileTest : public testing::Test
{
protected:
  Folder Files;
};

}
