#pragma once

#include "apps/drawing/ColorMap.h"
#include "apps/drawing/Scale.h"

#include <vtkSmartPointer.h>

#include <string>

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

/** A quantity on the water, drawn in place of its depth. */
struct WaterField
{
  vtkImageData* map = nullptr; ///< in the plane of the seafloor; null: the depth is drawn
  std::string array;           ///< of its points
  drawing::Range range;
  const drawing::ColorMap* colors = nullptr;
};

/** Colour of water where the field has no value. */
drawing::Rgb noValueColor();

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
 * light from the north-west, grey where there are no data. A field on the water is not shaded: its colours are its values.
 * @param seafloor point array Elevation, m
 * @return unsigned char, 3 components, south row first
 */
vtkSmartPointer<vtkImageData> seafloorPicture(
  vtkImageData* seafloor, const SeafloorColors& colors, const WaterField& field, int columns, int rows);

}
