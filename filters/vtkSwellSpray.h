#ifndef vtkSwellSpray_h
#define vtkSwellSpray_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the seafloor and what is kept between frames
#include <string> // for the section
#include <vector> // for the waves

namespace swellray
{
class SeafloorField;
class Spray;
class SurfaceWaves;
}

/**
 * @class   vtkSwellSpray
 * @brief   spray of breaking crests and of waves that strike obstacles, at a time
 *
 * Wraps swellray::Spray (equations there).
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer with heights of vtkSwellWaveHeight (also read back from a file). Of several
 * connections each is a wave of its own that throws spray, raised by the others where it was thrown.
 * Input 1: vtkImageData, the seafloor they were traced over, point array Elevation (m, positive up).
 *
 * Output: vtkPolyData, a vertex a particle, with the point arrays
 * - Velocity (float, 3 components, m/s): of the particle, for motion blur; the active vectors
 * - Age (float, s): since it was thrown
 * - Source (unsigned char): 0 a breaking crest, 1 an obstacle
 * and the field data of the rays with Section (string), Seed (int) and Time (double, s).
 *
 * TIME_STEPS as vtkSwellSurface, with which it shares the sheet: give both the same Section, Seed and PointsPerWave. Frames do
 * not depend on each other.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSpray : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellSpray* New();
  vtkTypeMacro(vtkSwellSpray, vtkPolyDataAlgorithm)
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
  /** Time where the pipeline asks for none, s; default 0. */
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
  /** Particles a metre of crest and metre by which its water is ahead of the wave, >= 0; default 20. */
  vtkSetMacro(Rate, double);
  vtkGetMacro(Rate, double);
  ///@}

  ///@{
  /** H/L at which the water of crests is as fast as the wave; 0 (default): that at which the traced wave breaks. */
  vtkSetMacro(Steepest, double);
  vtkGetMacro(Steepest, double);
  ///@}

  ///@{
  /** Standard deviation of each component of the velocity, of the speed of the water, 0 to 1; default 0.25. */
  vtkSetMacro(Scatter, double);
  vtkGetMacro(Scatter, double);
  ///@}

  ///@{
  /** Speed after an obstacle, of that of the water, 0 to 1; default 0.7. */
  vtkSetMacro(Rebound, double);
  vtkGetMacro(Rebound, double);
  ///@}

  /** Connect the seafloor. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

protected:
  vtkSwellSpray();
  ~vtkSwellSpray() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string Section = "gonzato-lesaec";
  std::string SectionParameters;
  double PointsPerWave = 0.0;
  double Time = 0.0;
  int Seed = 1;
  double GroupWaves = 0.0;
  double GroupLull = 0.3;
  double TimeRange[2] = { 0.0, 60.0 };
  double TimeStep = 0.1;
  double Rate = 20.0;
  double Steepest = 0.0;
  double Scatter = 0.25;
  double Rebound = 0.7;

private:
  vtkSwellSpray(const vtkSwellSpray&) = delete;
  void operator=(const vtkSwellSpray&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::unique_ptr<swellray::SurfaceWaves> Waves;                // what frames share
  std::vector<std::unique_ptr<const swellray::Spray>> Throwers; // one a wave
  std::size_t ThrowersOf = 0;                                   // the version of the waves that they are of
  double ThrowerSettings[4] = { 0.0, 0.0, 0.0, 0.0 };           // that it was made with
};

#endif
