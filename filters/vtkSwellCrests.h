#ifndef vtkSwellCrests_h
#define vtkSwellCrests_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

/**
 * @class   vtkSwellCrests
 * @brief   crest lines: lines of equal phase over neighbouring rays
 *
 * Wraps swellray::extractCrests: a crest stands where the phase S is 2 pi n (time 0). Where rays have crossed a
 * crest folds back over itself, as it does at sea.
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer (heights added or not), with the point array Phase (rad) and the
 * cell arrays LaunchParameter (m) and LaunchSegment.
 *
 * Output: one poly-line a stretch of crest, in the order of the launch parameter, with
 * - cell array CrestNumber (int): n
 * - every array of numbers on the points of the rays (WaveHeight, Longitude, Latitude, ...): interpolated along the
 *   rays where it holds floating-point numbers (DirectionFrom and Longitude over their jump of 360 degrees, Direction
 *   and RayDirection as unit vectors), otherwise that of the nearer point
 * - the field data of the input.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellCrests : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellCrests* New();
  vtkTypeMacro(vtkSwellCrests, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** A crest breaks where neighbouring rays are further apart than this, m; >= 0, default 0: no limit. */
  vtkSetMacro(MaxGap, double);
  vtkGetMacro(MaxGap, double);
  ///@}

  ///@{
  /** Twice the distance at which rays were inserted (field data MaxSpacing; without it no limit) in place of MaxGap; default off. */
  vtkSetMacro(MaxGapOfRays, vtkTypeBool);
  vtkGetMacro(MaxGapOfRays, vtkTypeBool);
  vtkBooleanMacro(MaxGapOfRays, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Only crests whose number is a multiple of this; >= 0, default 0: every crest, or, where the rays were traced with
   * fewer than one front a wavelength (field data StepsPerWave), the crests that lie on fronts.
   */
  vtkSetMacro(Every, int);
  vtkGetMacro(Every, int);
  ///@}

protected:
  vtkSwellCrests() = default;
  ~vtkSwellCrests() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double MaxGap = 0.0;
  vtkTypeBool MaxGapOfRays = 0;
  int Every = 0;

private:
  vtkSwellCrests(const vtkSwellCrests&) = delete;
  void operator=(const vtkSwellCrests&) = delete;
};

#endif
