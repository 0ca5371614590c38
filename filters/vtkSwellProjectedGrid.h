#ifndef vtkSwellProjectedGrid_h
#define vtkSwellProjectedGrid_h

#include "swellrayFiltersModule.h"
#include "vtkPolyData.h"
#include "vtkSwellSurfaceAlgorithm.h"

/**
 * @class   vtkSwellProjectedGrid
 * @brief   the breaking-wave surface as a camera samples it, at every n-th pixel
 *
 * Wraps swellray::ProjectedGrid (how it samples and moves: there): the cost of a frame follows the picture, not the scene.
 *
 * Inputs, field data and times: vtkSwellSurfaceAlgorithm. Several waves are added.
 *
 * Output: vtkPolyData, triangles between the samples on which there are waves, with the point arrays
 * - Normals (float, 3 components, unit): of the surface; the active normals
 * - Velocity (float, 3 components, m/s): of the water
 * - Depth (double, m): of the bed below still water at the undisplaced point
 * - Foam (float): 0 none, 1 where a wave breaks now; the active scalars
 * - Breaking (unsigned char): 1 where a wave that is there now is broken
 * - TextureCoordinates (float, 2 components): of the displaced point, metres over TextureSize; the active ones
 */
class SWELLRAYFILTERS_EXPORT vtkSwellProjectedGrid : public vtkSwellSurfaceAlgorithm
{
public:
  static vtkSwellProjectedGrid* New();
  vtkTypeMacro(vtkSwellProjectedGrid, vtkSwellSurfaceAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The frame. */
  vtkPolyData* GetOutput() { return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0)); }

  ///@{
  /** Where the camera is, m in the scene's plane and above its zero; above the water; default (0, 0, 10). */
  vtkSetVector3Macro(CameraPosition, double);
  vtkGetVector3Macro(CameraPosition, double);
  ///@}

  ///@{
  /** What it looks at, m; default (0, 100, 0). */
  vtkSetVector3Macro(CameraFocalPoint, double);
  vtkGetVector3Macro(CameraFocalPoint, double);
  ///@}

  ///@{
  /** What is up in its picture; default (0, 0, 1). */
  vtkSetVector3Macro(CameraViewUp, double);
  vtkGetVector3Macro(CameraViewUp, double);
  ///@}

  ///@{
  /** From the lower to the upper edge of the picture, degrees, above 0 to below 180; default 30. */
  vtkSetMacro(ViewAngle, double);
  vtkGetMacro(ViewAngle, double);
  ///@}

  ///@{
  /** Width and height of the picture, pixels; default 1024 x 768. */
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

  ///@{
  /** Pixels from sample to sample, 1 or more; default 8. */
  vtkSetMacro(PixelStep, int);
  vtkGetMacro(PixelStep, int);
  ///@}

  ///@{
  /** Pixels that are sampled beyond the edges of the picture, from where waves may lean in; default 64. */
  vtkSetMacro(Margin, int);
  vtkGetMacro(Margin, int);
  ///@}

  ///@{
  /** Time until foam is gone, s, > 0; default 8. */
  vtkSetMacro(FoamLife, double);
  vtkGetMacro(FoamLife, double);
  ///@}

  ///@{
  /** Side of a tile of the foam's texture, m, > 0; default 20. */
  vtkSetMacro(TextureSize, double);
  vtkGetMacro(TextureSize, double);
  ///@}

protected:
  vtkSwellProjectedGrid() = default;
  ~vtkSwellProjectedGrid() override = default;

  void MakeFrame(const swellray::SurfaceFrame&, vtkInformationVector**, vtkInformationVector*) override;

  double CameraPosition[3] = { 0.0, 0.0, 10.0 };
  double CameraFocalPoint[3] = { 0.0, 100.0, 0.0 };
  double CameraViewUp[3] = { 0.0, 0.0, 1.0 };
  double ViewAngle = 30.0;
  int ImageSize[2] = { 1024, 768 };
  int PixelStep = 8;
  int Margin = 64;
  double FoamLife = 8.0;
  double TextureSize = 20.0;

private:
  vtkSwellProjectedGrid(const vtkSwellProjectedGrid&) = delete;
  void operator=(const vtkSwellProjectedGrid&) = delete;
};

#endif
