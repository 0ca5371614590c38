#ifndef vtkSwellSurfaceProbe_h
#define vtkSwellSurfaceProbe_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the seafloor and the waves
#include <string> // for the section

namespace swellray
{
class SeafloorField;
class SurfaceWaves;
}

/**
 * @class   vtkSwellSurfaceProbe
 * @brief   the breaking-wave surface at points and times of one's own, without a mesh
 *
 * Wraps swellray::SurfaceFunction (equations there): what a buoy records, or a hull meets.
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer with heights of vtkSwellWaveHeight (also read back from a file); of several
 * connections each is a wave of its own, and they are added.
 * Input 1: vtkImageData, the seafloor they were traced over, point array Elevation (m, positive up).
 * Input 2: vtkPolyData, points (m, in the scene's plane; their heights do not count), optionally with the point array Time (s).
 *
 * Output: the points of input 2 in their order, one vertex each, with the point arrays
 * - SurfaceElevation (double, m): of the topmost sheet of water; this and the next four are NaN where no wave comes
 * - Normals (float, 3 components, unit): of the surface; the active normals
 * - Velocity (float, 3 components, m/s): of the water there
 * - Depth (double, m): of the bed below still water
 * - Foam (float, 0 to 1)
 * - Breaking (unsigned char): 1 where a wave that is there is broken
 * - Waves (int): sheets that cross there and are added
 * - Time (double, s)
 * and the field data of the rays with Section (string) and Seed (int).
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSurfaceProbe : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellSurfaceProbe* New();
  vtkTypeMacro(vtkSwellSurfaceProbe, vtkPolyDataAlgorithm)
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
  /** Time where a point asks for none, s; default 0. */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
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

  /** Connect the seafloor. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

  /** Connect the points. */
  void SetPointsConnection(vtkAlgorithmOutput* points) { this->SetInputConnection(2, points); }

protected:
  vtkSwellSurfaceProbe();
  ~vtkSwellSurfaceProbe() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string Section = "gonzato-lesaec";
  std::string SectionParameters;
  double PointsPerWave = 0.0;
  double Time = 0.0;
  int Seed = 1;
  double GroupWaves = 0.0;
  double GroupLull = 0.3;
  double FoamLife = 8.0;

private:
  vtkSwellSurfaceProbe(const vtkSwellSurfaceProbe&) = delete;
  void operator=(const vtkSwellSurfaceProbe&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::unique_ptr<swellray::SurfaceWaves> Waves; // what calls share
};

#endif
