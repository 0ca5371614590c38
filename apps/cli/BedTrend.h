#pragma once

#include <optional>

class vtkImageData;

namespace swellray::cli
{

/** How the bed as a whole slopes: the plane that tracing takes for the contours between offshore and the scene. */
struct BedTrend
{
  double facing = 0.0; ///< nautical degrees of the seaward normal of its contours
  double slope = 0.0;  ///< m/m
};

/** Trend of a seafloor's wet part; none where it has none. */
std::optional<BedTrend> bedTrendOf(vtkImageData* seafloor, double waterLevel);

}
