#ifndef vtkSwellBreakerLine_h
#define vtkSwellBreakerLine_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory>

namespace swellray
{
class SeafloorField;
}

/**
 * @class   vtkSwellBreakerLine
 * @brief   lines where waves begin to break, and what breaks there
 *
 * Wraps swellray::extractBreakerLines (equations and sources there, in sim/Breaking.h and sim/SurfZone.h).
 *
 * Input 0: vtkPolyData, rays of vtkSwellWaveHeight (also read back from a file) with the arrays it reads and adds, the
 * point arrays Direction and GroupSpeed, the cell arrays LaunchParameter (m) and LaunchSegment, and its field data.
 * Input 1: vtkImageData, the seafloor over which they were traced, point array Elevation (m, positive up).
 *
 * Output: one poly-line a stretch of breaker line, in the order of the launch parameter, with the point arrays
 * - BreakerHeight (double, m), BreakerDepth (double, m): where breaking begins
 * - BreakerAngle (double, degrees): from the way up the bed to that of the wave, anticlockwise; its size is the angle
 *   between crest and contour; NaN on a flat bed
 * - IribarrenNumber (double): xi_0, of the bed's slope and the height in deep water
 * - BreakerIribarrenNumber (double): xi_b, of the slope and the height at breaking
 * - BreakerType (unsigned char): 1 spilling, 2 plunging, 3 surging, by xi_0
 * - BreakerTypeAtBreaking (unsigned char): the same by xi_b
 * - PeelAngle (double, degrees): between crest and breaker line, 0 (closes out) to 90
 * - VortexRatio (double): length over width of the hollow under the lip; NaN for slopes outside 1:8 to 1:40
 * - SetDown (double, m) at breaking; SetUp (double, m) at the still-water line, MaximumSetUp (double, m)
 * - LongshoreEnergyFlux (double, W/m), LongshoreTransport (double, m3/s of sand with its pores): positive to the left
 *   looking up the bed
 * - Longitude, Latitude (double, degrees) where the rays are georeferenced
 * the cell array BreakerNumber (int): 1 where waves break first along their rays, 2 the second time, ... and the field
 * data of the rays.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellBreakerLine : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellBreakerLine* New();
  vtkTypeMacro(vtkSwellBreakerLine, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The seafloor, port 1. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

  ///@{
  /** A line ends where neighbouring rays break further apart than this, m; >= 0, default 0: no limit. */
  vtkSetMacro(MaxGap, double);
  vtkGetMacro(MaxGap, double);
  ///@}

  ///@{
  /** Four times the distance at which rays were inserted (field data MaxSpacing; without it no limit) in place of MaxGap; default off. */
  vtkSetMacro(MaxGapOfRays, vtkTypeBool);
  vtkGetMacro(MaxGapOfRays, vtkTypeBool);
  vtkBooleanMacro(MaxGapOfRays, vtkTypeBool);
  ///@}

protected:
  vtkSwellBreakerLine();
  ~vtkSwellBreakerLine() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double MaxGap = 0.0;
  vtkTypeBool MaxGapOfRays = 0;

private:
  vtkSwellBreakerLine(const vtkSwellBreakerLine&) = delete;
  void operator=(const vtkSwellBreakerLine&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
};

#endif
