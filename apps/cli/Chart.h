#pragma once

#include "apps/drawing/ColorMap.h"
#include "sim/Obstacles.h"

#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace swellray::cli
{

/** What the frame of a chart counts. */
enum class ChartFrame
{
  Auto,      ///< degrees where the grid is in longitude and latitude, metres otherwise
  Metric,    ///< metres or kilometres from the scene's origin
  Graticule, ///< longitude and latitude, with lines over the map
};

/** Everything that a chart shows; pointers may be null but for the seafloor. */
struct ChartContent
{
  vtkImageData* seafloor = nullptr; ///< point array Elevation
  vtkPolyData* contours = nullptr;  ///< cell array Depth
  vtkPolyData* rays = nullptr;
  vtkPolyData* crests = nullptr; ///< cell array CrestNumber
  vtkImageData* map = nullptr;   ///< whose array mapBy is drawn on the water in place of its depth
  std::string mapBy;
  std::vector<Obstacle> obstacles;
  double waterLevel = 0.0;                              ///< m
  std::string colorBy;                                  ///< point array of the rays; empty: one colour
  const drawing::ColorMap* colors = &drawing::rayMap(); ///< of that array and of the map
  ChartFrame frame = ChartFrame::Auto;
  std::string title;
};

/** Rectangle in pixels, from the lower left corner of the picture. */
struct PixelBox
{
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

/** Where the parts of a chart lie. */
struct ChartLayout
{
  int width = 0; ///< of the picture, pixels
  int height = 0;
  double unit = 0.0; ///< size of the type, pixels; every other size follows it
  PixelBox map;
  PixelBox column; ///< beside the map: arrows, colour scales, legend, scale bar
};

/**
 * Lay out a chart.
 * @param size of the picture, pixels; none: 1600 wide and as high as the scene asks for
 * @param aspect height of the scene over its width
 */
ChartLayout layOutChart(const std::optional<std::array<int, 2>>& size, double aspect);

/** Draw a chart: red, green, blue, unsigned char, the lower row first. @throws WorkError where there is no display */
vtkSmartPointer<vtkImageData> drawChart(const ChartContent& content, const ChartLayout& layout);

}
