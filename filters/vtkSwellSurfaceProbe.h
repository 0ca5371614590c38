#ifndef vtkSwellSurfaceProbe_h
#define vtkSwellSurfaceProbe_h

#include "swellrayFiltersModule.h"
#include "vtkPolyData.h"
#include "vtkSwellSurfaceAlgorithm.h"

/**
 * @class   vtkSwellSurfaceProbe
 * @brief   the breaking-wave surface at points and times of one's own, without a mesh
 *
 * Wraps swellray::SurfaceFunction (equations there): what a buoy records, or a hull meets.
 *
 * Inputs, field data and times: vtkSwellSurfaceAlgorithm. Several waves are added.
 *
 * Input 2: vtkPolyData, points (m, in the scene's plane; their heights do not count), optionally with the point array Time (s),
 * otherwise at the time of the frame.
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
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSurfaceProbe : public vtkSwellSurfaceAlgorithm
{
public:
  static vtkSwellSurfaceProbe* New();
  vtkTypeMacro(vtkSwellSurfaceProbe, vtkSwellSurfaceAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The frame. */
  vtkPolyData* GetOutput() { return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0)); }

  ///@{
  /** Time until foam is gone, s, > 0; default 8. */
  vtkSetMacro(FoamLife, double);
  vtkGetMacro(FoamLife, double);
  ///@}

  /** Connect the points. */
  void SetPointsConnection(vtkAlgorithmOutput* points) { this->SetInputConnection(2, points); }

protected:
  vtkSwellSurfaceProbe();
  ~vtkSwellSurfaceProbe() override = default;

  void MakeFrame(const swellray::SurfaceFrame&, vtkInformationVector**, vtkInformationVector*) override;

  double FoamLife = 8.0;

private:
  vtkSwellSurfaceProbe(const vtkSwellSurfaceProbe&) = delete;
  void operator=(const vtkSwellSurfaceProbe&) = delete;
};

#endif
