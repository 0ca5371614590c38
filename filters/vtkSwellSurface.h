#ifndef vtkSwellSurface_h
#define vtkSwellSurface_h

#include "swellrayFiltersModule.h"
#include "vtkPolyData.h"
#include "vtkSwellSurfaceAlgorithm.h"

#include <memory> // for what is kept between frames

namespace swellray
{
class SurfaceScene;
}

/**
 * @class   vtkSwellSurface
 * @brief   the breaking-wave surface at a time, from rays with heights
 *
 * Wraps swellray::SurfaceSheet and swellray::WaveSurface (equations there): the sheets between neighbouring rays, moved by a
 * vertical section of the sea.
 *
 * Inputs, field data and times: vtkSwellSurfaceAlgorithm. The heights of the waves of further connections are added (swellray::SurfaceSum), except of those that the points do not
 * resolve. Foam, breaking and phases are those of the first.
 *
 * Output: vtkPolyData, triangles wound so that the undisplaced sheet looks up, with these point arrays
 * - Normals (float, 3 components, unit): of the surface; the active normals
 * - Velocity (float, 3 components, m/s): of its particles
 * - Depth (double, m): of the bed below still water under the displaced point; negative on the beach
 * - Phase (double, rad): Phi = S - omega t; crests are at 2 pi n
 * - RayPhase (double, rad): S, the phase that was traced, or the straight one; BreakingPhase (double, rad): S where the breaking that the
 *   point lies in, or within a wavelength behind, began, NaN where there is none; FoamShare (double): of its foam that is left
 *   there, 0 to 1; PlungePhase (double, rad): from that S on until the crest has come down; LaunchParameter (double, m): of the ray
 * - WaveHeight (double, m): as traced
 * - GroupTime (double, s), BrokenShare (double), with groups only: as swellray::WaveSurface has them, for their foam
 * - Breaking (unsigned char): 1 where the wave that is there now is broken, no more than half whole again
 * - RayState (unsigned char)
 * - TextureCoordinates (float, 2 components): of the displaced point, metres over TextureSize; the active ones
 * and the field data SectionVariation (double, wavelengths), SectionFront (double, rad: swellray::WaveSection::frontPhase) and IncidentWavelength (double, m).
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSurface : public vtkSwellSurfaceAlgorithm
{
public:
  static vtkSwellSurface* New();
  vtkTypeMacro(vtkSwellSurface, vtkSwellSurfaceAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The frame. */
  vtkPolyData* GetOutput() { return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0)); }

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

protected:
  vtkSwellSurface();
  ~vtkSwellSurface() override;

  void MakeFrame(const swellray::SurfaceFrame&, vtkInformationVector**, vtkInformationVector*) override;

  int PhaseRule = TRACED;
  vtkTypeBool Still = 0;
  double TextureSize = 20.0;

private:
  vtkSwellSurface(const vtkSwellSurface&) = delete;
  void operator=(const vtkSwellSurface&) = delete;

  std::shared_ptr<const swellray::SurfaceScene> Scene; // what frames share
};

#endif
