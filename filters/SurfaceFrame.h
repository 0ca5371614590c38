#ifndef SurfaceFrame_h
#define SurfaceFrame_h

#include "SurfaceScene.h"

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

namespace swellray
{

/** A frame that a vtkSwellSurfaceAlgorithm is asked for. */
struct SurfaceFrame
{
  vtkPolyData* rays = nullptr;       ///< of the first wave
  vtkImageData* image = nullptr;     ///< the seafloor
  vtkDataArray* elevation = nullptr; ///< of the image, on its points
  double time = 0.0;                 ///< s, finite
  const WaveSection* section = nullptr;
  SurfaceScene::Settings settings;
};

}

#endif
