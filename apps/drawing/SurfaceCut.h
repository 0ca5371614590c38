#pragma once

#include <glm/vec2.hpp>

#include <vector>

class vtkImageData;
class vtkPolyData;

namespace swellray::drawing
{

/** A straight line on the map, m, and places along it. */
struct CutLine
{
  glm::dvec2 from{ 0.0 };
  glm::dvec2 to{ 0.0 };

  double length() const;
};

/** A piece of a surface where a vertical plane cuts it. */
struct CutSegment
{
  glm::dvec2 begin{ 0.0 }; ///< along the line from its beginning, and elevation, m
  glm::dvec2 end{ 0.0 };
  double foam = 0.0; ///< 0 to 1
};

/**
 * Cut a surface of triangles by the vertical plane of a line: one segment a triangle, in no order, whose ends meet those of
 * its neighbours. Pieces that lie beyond the ends of the line are kept.
 * @param surface with the point array Foam, or without
 * @throws std::invalid_argument where the line has no length
 */
std::vector<CutSegment> cutSurface(vtkPolyData* surface, const CutLine& line);

/**
 * Elevation of a seafloor at `count` places from end to end of a line, between the nodes by straight lines; NaN beyond the
 * grid and where it has no data.
 * @param seafloor with the point array Elevation, m
 */
std::vector<double> cutSeafloor(vtkImageData* seafloor, const CutLine& line, int count);

}
