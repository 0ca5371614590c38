#ifndef vtkSwellFoam_h
#define vtkSwellFoam_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

/**
 * @class   vtkSwellFoam
 * @brief   foam of the waves that broke at every point of a surface
 *
 * Wraps swellray::computeFoam (equation there).
 *
 * Input: vtkPolyData of vtkSwellSurface, moved or still (also read back from a file), with the point arrays RayPhase (rad),
 * BreakingPhase (rad) and LaunchParameter (m) and the field data Period (s), Time (s), SectionVariation (wavelengths), Seed
 * and IncidentWavelength (m); FoamShare where it is there, otherwise 1; PlungePhase (rad) and
 * SectionFront (rad) where they are there, otherwise fronts of waves are clear; of waves in groups also GroupTime (s), BrokenShare, GroupWaves and GroupLull.
 *
 * Output: the input, its arrays shared, with the point array
 * - Foam (float): 0 none, 1 where a wave breaks now; the active scalars
 */
class SWELLRAYFILTERS_EXPORT vtkSwellFoam : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellFoam* New();
  vtkTypeMacro(vtkSwellFoam, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Time until foam is gone, s, > 0; default 8. */
  vtkSetMacro(Life, double);
  vtkGetMacro(Life, double);
  ///@}

protected:
  vtkSwellFoam() = default;
  ~vtkSwellFoam() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Life = 8.0;

private:
  vtkSwellFoam(const vtkSwellFoam&) = delete;
  void operator=(const vtkSwellFoam&) = delete;
};

#endif
