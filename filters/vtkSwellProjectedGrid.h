#ifndef vtkSwellProjectedGrid_h
#define vtkSwellProjectedGrid_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for what is kept between frames
#include <string> // for the section

namespace swellray
{
class SeafloorField;
class SurfaceWaves;
}

/**
 * @class   vtkSwellProjectedGrid
 * @brief   the breaking-wave surface as a camera samples it, at every n-th pixel
 *
 * Wraps swellray::ProjectedGrid (how it samples and moves: there): the cost of a frame follows the picture, not the scene.
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer with heights of vtkSwellWaveHeight (also read back from a file); of several
 * connections each is a wave of its own, and they are added.
 * Input 1: vtkImageData, the seafloor they were traced over, point array Elevation (m, positive up).
 *
 * Output: vtkPolyData, triangles between the samples on which there are waves, with the point arrays
 * - Normals (float, 3 components, unit): of the surface; the active normals
 * - Velocity (float, 3 components, m/s): of the water
 * - Depth (double, m): of the bed below still water at the undisplaced point
 * - Foam (float): 0 none, 1 where a wave breaks now; the active scalars
 * - Breaking (unsigned char): 1 where a wave that is there now is broken
 * - TextureCoordinates (float, 2 components): of the displaced point, metres over TextureSize; the active ones
 * and the field data of the rays with Section (string), Seed (int) and Time (double, s). After an abort the output is empty.
 *
 * TIME_STEPS as vtkSwellSurface. Frames do not depend on each other.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellProjectedGrid : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellProjectedGrid* New();
  vtkTypeMacro(vtkSwellProjectedGrid, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Vertical section, NAME or NAME:key=value,... (swellray::makeWaveSection); default gonzato-lesaec. */
  vtkSetMacro(Section, std::string);
  vtkGetMacro(Section, std::string);
  ///@}

  ///@{
  /** Parameters of the section, key=value,..., beside those in Section; default none. */
  vtkSetMacro(SectionParameters, std::string);
  vtkGetMacro(SectionParameters, std::string);
  ///@}

  ///@{
  /** Points a wavelength along the rays; 16 or more, or 0 (default): as many as the section asks for. */
  vtkSetMacro(PointsPerWave, double);
  vtkGetMacro(PointsPerWave, double);
  ///@}

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
  /** Time where the pipeline asks for none, s; default 0. */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /** First and last of TIME_STEPS, s; default 0 to 60. */
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

  ///@{
  /** Seconds between TIME_STEPS, > 0; default 0.1. */
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /** Waves that pass a place in a group (swellray::WaveGroups), 2 or more; 0 (default): all waves are alike. */
  vtkSetMacro(GroupWaves, double);
  vtkGetMacro(GroupWaves, double);
  ///@}

  ///@{
  /** Height of the lowest waves of a group over that of the highest, 0 to 1; default 0.3. */
  vtkSetMacro(GroupLull, double);
  vtkGetMacro(GroupLull, double);
  ///@}

  ///@{
  /** What varies from wave to wave is drawn from this; default 1. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
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

  /** Connect the seafloor. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

protected:
  vtkSwellProjectedGrid();
  ~vtkSwellProjectedGrid() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string Section = "gonzato-lesaec";
  std::string SectionParameters;
  double PointsPerWave = 0.0;
  double CameraPosition[3] = { 0.0, 0.0, 10.0 };
  double CameraFocalPoint[3] = { 0.0, 100.0, 0.0 };
  double CameraViewUp[3] = { 0.0, 0.0, 1.0 };
  double ViewAngle = 30.0;
  int ImageSize[2] = { 1024, 768 };
  int PixelStep = 8;
  int Margin = 64;
  double Time = 0.0;
  double TimeRange[2] = { 0.0, 60.0 };
  double TimeStep = 0.1;
  int Seed = 1;
  double GroupWaves = 0.0;
  double GroupLull = 0.3;
  double FoamLife = 8.0;
  double TextureSize = 20.0;

private:
  vtkSwellProjectedGrid(const vtkSwellProjectedGrid&) = delete;
  void operator=(const vtkSwellProjectedGrid&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::unique_ptr<swellray::SurfaceWaves> Waves; // what frames share
};

#endif
