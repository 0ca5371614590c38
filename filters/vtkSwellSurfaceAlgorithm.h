#ifndef vtkSwellSurfaceAlgorithm_h
#define vtkSwellSurfaceAlgorithm_h

#include "swellrayFiltersModule.h"
#include "vtkDataObjectAlgorithm.h"

#include <memory> // for what is kept between frames
#include <string> // for the section

namespace swellray
{
struct SurfaceFrame;
class SeafloorField;
class SurfaceWaves;
}

/**
 * @class   vtkSwellSurfaceAlgorithm
 * @brief   base of what is made of the breaking-wave surface at a time
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer with heights of vtkSwellWaveHeight (also read back from a file); of several
 * connections each is a wave of its own.
 * Input 1: vtkImageData, the seafloor they were traced over, point array Elevation (m, positive up).
 *
 * The output has the field data of the first rays with Section (string), Seed (int), with groups GroupWaves and GroupLull
 * (double), and Time (double, s). After an abort it is empty.
 *
 * The pipeline has TIME_STEPS, so that the play button of ParaView animates it: a frame is that of UPDATE_TIME_STEP, or of
 * Time where none is asked for. Frames do not depend on each other; what they share is kept between them. What belongs
 * together needs the same Section, Seed, PointsPerWave and groups.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSurfaceAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSwellSurfaceAlgorithm, vtkDataObjectAlgorithm) void PrintSelf(
    ostream& os, vtkIndent indent) override;

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

  /** Connect the seafloor. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

protected:
  vtkSwellSurfaceAlgorithm();
  ~vtkSwellSurfaceAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /** Fill the output with the frame, but for what the base says of it; early return after an abort. Errors are thrown. */
  virtual void MakeFrame(
    const swellray::SurfaceFrame& frame, vtkInformationVector** inputVector, vtkInformationVector* outputVector) = 0;

  /** Bring Waves up to date with the connections of the rays from this one on. */
  void TakeWaves(const swellray::SurfaceFrame& frame, vtkInformationVector** inputVector, int first = 0);

  std::string Section = "gonzato-lesaec";
  std::string SectionParameters;
  double PointsPerWave = 0.0;
  double Time = 0.0;
  double TimeRange[2] = { 0.0, 60.0 };
  double TimeStep = 0.1;
  int Seed = 1;
  double GroupWaves = 0.0;
  double GroupLull = 0.3;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::unique_ptr<swellray::SurfaceWaves> Waves; // what frames share

private:
  vtkSwellSurfaceAlgorithm(const vtkSwellSurfaceAlgorithm&) = delete;
  void operator=(const vtkSwellSurfaceAlgorithm&) = delete;
};

#endif
