#ifndef vtkSwellSurface_h
#define vtkSwellSurface_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the seafloor and what is kept between frames
#include <string> // for the section

namespace swellray
{
class SeafloorField;
class SurfaceScene;
class SurfaceWaves;
}

/**
 * @class   vtkSwellSurface
 * @brief   the breaking-wave surface at a time, from rays with heights
 *
 * Wraps swellray::SurfaceSheet and swellray::WaveSurface (equations there): the sheets between neighbouring rays, moved by a
 * vertical section of the sea.
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer with heights of vtkSwellWaveHeight (also read back from a file). Further
 * connections are other waves of the sea, traced on their own: their heights are added (swellray::SurfaceSum), except of those
 * that the points do not resolve. Foam, breaking and phases are those of the first.
 * Input 1: vtkImageData, the seafloor they were traced over, point array Elevation (m, positive up).
 *
 * Output: vtkPolyData, triangles wound so that the undisplaced sheet looks up, with these point arrays
 * - Normals (float, 3 components, unit): of the surface; the active normals
 * - Velocity (float, 3 components, m/s): of its particles
 * - Depth (double, m): of the bed below still water under the displaced point; negative on the beach
 * - Phase (double, rad): Phi = S - omega t; crests are at 2 pi n
 * - RayPhase (double, rad): S, the phase that was traced, or the straight one; BreakingPhase (double, rad): S where the breaking that the
 *   point lies in began, NaN where waves are not broken; LaunchParameter (double, m): of the ray
 * - WaveHeight (double, m): as traced
 * - GroupTime (double, s), BrokenShare (double), with groups only: as swellray::WaveSurface has them, for their foam
 * - Breaking (unsigned char): 1 where the wave that is there now is broken
 * - RayState (unsigned char)
 * - TextureCoordinates (float, 2 components): of the displaced point, metres over TextureSize; the active ones
 * and the field data of the rays with Section (string), SectionVariation (double, wavelengths), Seed (int),
 * IncidentWavelength (double, m), with groups GroupWaves and GroupLull (double), and Time (double, s). After an abort the output is empty.
 *
 * The pipeline has TIME_STEPS, so that the play button of ParaView animates it: a frame is that of UPDATE_TIME_STEP, or of
 * Time where none is asked for. Frames do not depend on each other; the sheet is kept between them.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellSurface* New();
  vtkTypeMacro(vtkSwellSurface, vtkPolyDataAlgorithm)
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

  enum PhaseRules
  {
    TRACED = 0,
    STRAIGHT = 1
  };

  ///@{
  /**
   * Phase of the waves: the traced one (default), or integrated along straight lines as Peachey 1986 has it, for
   * comparison (swellray::StraightPhase). With it no wave curls.
   */
  vtkSetClampMacro(PhaseRule, int, TRACED, STRAIGHT);
  vtkGetMacro(PhaseRule, int);
  void SetPhaseRuleToTraced() { this->SetPhaseRule(TRACED); }
  void SetPhaseRuleToStraight() { this->SetPhaseRule(STRAIGHT); }
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

  ///@{
  /** Leave the sheet where it is, on still water; default off. */
  vtkSetMacro(Still, vtkTypeBool);
  vtkGetMacro(Still, vtkTypeBool);
  vtkBooleanMacro(Still, vtkTypeBool);
  ///@}

  ///@{
  /** Side of a tile of the foam's texture, m, > 0; default 20. */
  vtkSetMacro(TextureSize, double);
  vtkGetMacro(TextureSize, double);
  ///@}

  /** Connect the seafloor. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

protected:
  vtkSwellSurface();
  ~vtkSwellSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  std::string Section = "gonzato-lesaec";
  std::string SectionParameters;
  int PhaseRule = TRACED;
  double PointsPerWave = 0.0;
  double Time = 0.0;
  double TimeRange[2] = { 0.0, 60.0 };
  double TimeStep = 0.1;
  int Seed = 1;
  double GroupWaves = 0.0;
  double GroupLull = 0.3;
  vtkTypeBool Still = 0;
  double TextureSize = 20.0;

private:
  vtkSwellSurface(const vtkSwellSurface&) = delete;
  void operator=(const vtkSwellSurface&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::shared_ptr<const swellray::SurfaceScene> Scene; // what frames share
  std::unique_ptr<swellray::SurfaceWaves> Others;
};

#endif
