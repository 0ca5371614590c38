#pragma once

#include "apps/drawing/ColorMap.h"

class vtkImageData;

namespace swellray::scene
{

/** Colours of a scene that others draw: the seafloor by its elevation, as on charts, and water by its foam. */
class SceneColors
{
public:
  /**
   * @param seafloor point array Elevation, m
   * @param waterLevel m
   */
  SceneColors(vtkImageData* seafloor, double waterLevel);

  /** Colour of the bed at an elevation, m. */
  drawing::Rgb bed(double elevation) const;

  /** Colour of water under a share of foam, 0 to 1. */
  static drawing::Rgb water(double foam);

  /** How much of the bed is hidden by water without foam. */
  static constexpr double WaterOpacity = 0.8;

  double lowest() const { return this->Lowest; }   ///< elevation, m
  double highest() const { return this->Highest; } ///< elevation, m

private:
  double Level = 0.0;
  double Lowest = 0.0;
  double Highest = 0.0;
};

}
