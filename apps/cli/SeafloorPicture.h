#pragma once

#include "apps/drawing/ColorMap.h"

#include <vtkSmartPointer.h>

class vtkImageData;

namespace swellray::cli
{

/** What the colours of the seafloor mean. */
struct SeafloorColors
{
  double waterLevel = 0.0; ///< m
  double deepest = 1.0;    ///< depth of the last colour of water, m
  double highest = 1.0;    ///< height over the water of the last colour of land, m
  drawing::Rgb shore{};    ///< of the line between water and land
  int shoreWidth = 2;      ///< pixels
};

/** Colour of the places without data. */
drawing::Rgb noDataColor();

/** Greatest depth and height of a seafloor, m; 0 where it has no water or no land. */
struct DepthRange
{
  double deepest = 0.0;
  double highest = 0.0;
  bool hasHoles = false;
};
DepthRange depthRange(vtkImageData* seafloor, double waterLevel);

/**
 * Picture of a seafloor, columns x rows pixels over its whole extent: water and land by colour, shaded by a
 * light from the north-west, grey where there are no data.
 * @param seafloor point array Elevation, m
 * @return unsigned char, 3 components, south row first
 */
vtkSmartPointer<vtkImageData> seafloorPicture(
  vtkImageData* seafloor, const SeafloorColors& colors, int columns, int rows);

}
