#pragma once

#include <vtkSmartPointer.h>

#include <array>

class vtkPolyData;

namespace swellray::scene
{

/** How droplets are drawn. */
struct StreakView
{
  std::array<double, 3> eye{ 0.0, 0.0, 0.0 }; ///< m
  double exposure = 0.02;                     ///< s: a droplet is drawn along its way in this time
  double radius = 0.02;                       ///< of a droplet, m
  double wisp = 0.0;                          ///< radius of a wisp of finer droplets as it is thrown, m; 0: none
  double pixel = 1e-3;                        ///< angle of a pixel, rad
};

/**
 * Droplets as an eye or a camera sees them in motion: a rectangle a droplet, turned to the eye, along the way that it goes
 * while the exposure lasts, and as broad as itself, or as a pixel where it is smaller; then it is as much fainter.
 * Some of them, always the same, are wisps of droplets too fine to be drawn, which spread and fade as they fly.
 * @param spray of vtkSwellSpray: points with the array Velocity, m/s, and Age, s, or without
 * @return quadrilaterals with the point arrays Normals, Opacity (0 to 1), Shade (light that comes to them, 0 to 1), Across
 *   and Along (-1 to 1)
 */
vtkSmartPointer<vtkPolyData> streaksOf(vtkPolyData* spray, const StreakView& view);

}
