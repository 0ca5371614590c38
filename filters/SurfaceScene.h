#ifndef SurfaceScene_h
#define SurfaceScene_h

#include "sim/WaveSurface.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkPolyData;

namespace swellray
{

/** What all frames of a surface share: its sheet, and the arrays of it that do not move. */
class SurfaceScene
{
public:
  /**
   * @param rays output of vtkSwellWaveHeight
   * @param straight the phase of Peachey 1986 in place of the traced one
   * @param algorithm gets the progress, from 0 to 0.5
   * @throws std::invalid_argument naming what is missing; std::runtime_error as SurfaceSheet
   */
  SurfaceScene(vtkPolyData* rays, std::shared_ptr<const Seafloor> seafloor, double pointsPerWave, int seed,
    bool straight, vtkAlgorithm* algorithm);

  const SurfaceSheet& sheet() const { return *this->Sheet; }
  const WaveSurface& surface() const { return *this->Surface; }
  const SurfaceOptions& options() const { return this->Options; }
  vtkCellArray* triangles() const { return this->Triangles; }

  /** RayPhase, BreakingPhase, LaunchParameter, WaveHeight, RayState: one entry a point. */
  const std::vector<vtkSmartPointer<vtkDataArray>>& arrays() const { return this->Arrays; }

private:
  std::shared_ptr<const Seafloor> Bed;
  SurfaceOptions Options;
  std::unique_ptr<SurfaceSheet> Sheet;
  std::unique_ptr<WaveSurface> Surface;
  vtkSmartPointer<vtkCellArray> Triangles;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
};

}

#endif
