#ifndef vtkSwellFoamMap_h
#define vtkSwellFoamMap_h

#include "swellrayFiltersModule.h"
#include "vtkImageAlgorithm.h"

#include <memory> // for what is kept between frames
#include <string> // for the section

namespace swellray
{
class SeafloorField;
class StillFoam;
class SurfaceWaves;
}

/**
 * @class   vtkSwellFoamMap
 * @brief   foam on a regular grid of still water, at a time
 *
 * Wraps swellray::StillFoam (where it is defined): the foam of vtkSwellFoam where it floats, as a texture seen from above.
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer with heights of vtkSwellWaveHeight (also read back from a file); of several
 * connections each is a wave of its own, and the most foam counts.
 * Input 1: vtkImageData, the seafloor they were traced over, point array Elevation (m, positive up).
 *
 * Output: vtkImageData, one layer, with the point array
 * - Foam (double): 0 none to 1 where a wave breaks now, NaN where no wave comes; the scalars
 * and the field data of the rays with Section (string), Seed (int) and Time (double, s). After an abort the output is empty.
 *
 * TIME_STEPS as vtkSwellSurface: give both the same Section, Seed and PointsPerWave. Frames do not depend on each other;
 * what is over a node is kept between them.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellFoamMap : public vtkImageAlgorithm
{
public:
  static vtkSwellFoamMap* New();
  vtkTypeMacro(vtkSwellFoamMap, vtkImageAlgorithm)
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
  /** Distance of the nodes, m; >= 0, default 0: the nodes of the seafloor. */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
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

  /** Connect the seafloor. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

protected:
  vtkSwellFoamMap();
  ~vtkSwellFoamMap() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string Section = "gonzato-lesaec";
  std::string SectionParameters;
  double PointsPerWave = 0.0;
  double Spacing = 0.0;
  double Time = 0.0;
  double TimeRange[2] = { 0.0, 60.0 };
  double TimeStep = 0.1;
  int Seed = 1;
  double GroupWaves = 0.0;
  double GroupLull = 0.3;
  double FoamLife = 8.0;

private:
  vtkSwellFoamMap(const vtkSwellFoamMap&) = delete;
  void operator=(const vtkSwellFoamMap&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::unique_ptr<swellray::SurfaceWaves> Waves; // what frames share
  std::unique_ptr<const swellray::StillFoam> Nodes;
  std::size_t NodesOf = 0;                              // the version of the waves that they are of
  double NodesAt[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }; // and their grid
};

#endif
