#ifndef SurfaceScene_h
#define SurfaceScene_h

#include "sim/Obstacles.h"
#include "sim/WaveSurface.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkImageData;
class vtkPolyData;

namespace swellray
{

class SeafloorField;

/** What all frames of a surface share: its sheet, and the arrays of it that do not move. */
class SurfaceScene
{
public:
  /** What a scene is made of besides its data. */
  struct Settings
  {
    double pointsPerWave = 16.0;
    int seed = 1;
    WaveGroups groups;
    bool straight = false; ///< the phase of Peachey 1986

    bool operator==(const Settings& other) const
    {
      return this->pointsPerWave == other.pointsPerWave && this->seed == other.seed && this->groups == other.groups &&
        this->straight == other.straight;
    }
  };

  /**
   * @param rays output of vtkSwellWaveHeight
   * @param algorithm gets the progress, from 0 to 0.5
   * @throws std::invalid_argument naming what is missing; std::runtime_error as SurfaceSheet
   */
  SurfaceScene(
    vtkPolyData* rays, std::shared_ptr<const Seafloor> seafloor, const Settings& settings, vtkAlgorithm* algorithm);

  /**
   * The scene of these data: the one that another filter holds of the same, or a new one.
   * @param elevation of the image, on its points
   * @throws as the constructor
   */
  static std::shared_ptr<const SurfaceScene> of(vtkPolyData* rays, vtkImageData* image, vtkDataArray* elevation,
    SeafloorField& seafloor, const Settings& settings, vtkAlgorithm* algorithm);

  const Seafloor& seafloor() const { return *this->Bed; }

  /** Those that the rays met; null: none. */
  const Obstacles* obstacles() const { return this->Walls.get(); }

  const SurfaceSheet& sheet() const { return *this->Sheet; }
  const WaveSurface& surface() const { return *this->Surface; }
  const SurfaceOptions& options() const { return this->Options; }
  vtkCellArray* triangles() const { return this->Triangles; }

  /** RayPhase, BreakingPhase, FoamShare, PlungePhase, LaunchParameter, WaveHeight, RayState, with groups GroupTime, BrokenShare: one
   *  entry a point. */
  const std::vector<vtkSmartPointer<vtkDataArray>>& arrays() const { return this->Arrays; }

private:
  std::shared_ptr<const Seafloor> Bed;
  std::shared_ptr<const Obstacles> Walls;
  SurfaceOptions Options;
  std::unique_ptr<SurfaceSheet> Sheet;
  std::unique_ptr<WaveSurface> Surface;
  vtkSmartPointer<vtkCellArray> Triangles;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
};

}

#endif
