#pragma once

#include "Chart.h"
#include "apps/drawing/ColorMap.h"
#include "apps/drawing/Scale.h"

#include <map>
#include <string>
#include <vector>

namespace swellray::cli
{

/** Line styles, and what the legend says of them. */
enum class LineKind
{
  Contour,
  Crest,
  Ray,
  LeeRay,
  AgroundRay,
  Obstacle,
};

/** A line in pixels. */
struct PixelLine
{
  LineKind kind = LineKind::Ray;
  std::vector<float> points;         ///< x, y each
  std::vector<unsigned char> colors; ///< red, green, blue, opacity each
};

/** The depth of a contour line, written along it. */
struct ContourLabel
{
  double x = 0.0; ///< middle, pixels
  double y = 0.0;
  double angle = 0.0; ///< degrees anticlockwise from +x
  std::string words;
};

/** Colours along the rays. */
struct RayColors
{
  enum class Kind
  {
    Plain,
    Scale,
    States,
  };
  Kind kind = Kind::Plain;
  drawing::Rgb plain{ 0.74, 0.16, 0.12 }; ///< of rays without a scale
  drawing::Range range;
  std::string name; ///< of the quantity
  std::string unit;
  bool above = false; ///< there are values above the range
  bool below = false;
  bool gaps = false; ///< of a map: it has nodes without a value
};

/** Lines of a chart, ready to draw. */
struct ChartLines
{
  std::vector<PixelLine> lines; ///< in the order to draw
  std::vector<ContourLabel> labels;
  std::vector<float> breakers; ///< x, y of the places where drawn rays begin to break
  std::map<LineKind, int> counts;
  int rayStride = 1; ///< every how many rays one is drawn
  int crestStride = 1;
  double contourInterval = 0.0; ///< m; 0 where contours have no common step
  std::array<bool, 4> states{}; ///< which ray states occur
};

/** Colours of the ray states DEAD, ALIVE, FLAT and AGROUND. */
drawing::Rgb stateColor(int state);

/** How the content asks to colour its rays. @throws WorkError where the rays have no such array */
RayColors chooseRayColors(const ChartContent& content);

/** The scale of the map's array. @throws WorkError where the map lacks it */
RayColors chooseMapColors(const ChartContent& content);

/** Turn the content's lines into pixels of the layout. */
ChartLines makeChartLines(const ChartContent& content, const ChartLayout& layout, const RayColors& colors);

}
