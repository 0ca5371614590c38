#ifndef vtkSwellSpray_h
#define vtkSwellSpray_h

#include "swellrayFiltersModule.h"
#include "vtkPolyData.h"
#include "vtkSwellSurfaceAlgorithm.h"

#include <memory> // for what is kept between frames
#include <vector> // for the waves

namespace swellray
{
class Spray;
}

/**
 * @class   vtkSwellSpray
 * @brief   spray of breaking crests and of waves that strike obstacles, at a time
 *
 * Wraps swellray::Spray (equations there).
 *
 * Inputs, field data and times: vtkSwellSurfaceAlgorithm. Each of several waves throws spray, raised by the others where it was thrown.
 *
 * Output: vtkPolyData, a vertex a particle, with the point arrays
 * - Velocity (float, 3 components, m/s): of the particle, for motion blur; the active vectors
 * - Age (float, s): since it was thrown
 * - Source (unsigned char): 0 a breaking crest, 1 an obstacle
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSpray : public vtkSwellSurfaceAlgorithm
{
public:
  static vtkSwellSpray* New();
  vtkTypeMacro(vtkSwellSpray, vtkSwellSurfaceAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The frame. */
  vtkPolyData* GetOutput() { return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0)); }

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

protected:
  vtkSwellSpray();
  ~vtkSwellSpray() override;

  void MakeFrame(const swellray::SurfaceFrame&, vtkInformationVector**, vtkInformationVector*) override;

  double Rate = 20.0;
  double Steepest = 0.0;
  double Scatter = 0.25;
  double Rebound = 0.7;

private:
  vtkSwellSpray(const vtkSwellSpray&) = delete;
  void operator=(const vtkSwellSpray&) = delete;

  std::vector<std::unique_ptr<const swellray::Spray>> Throwers; // one a wave
  std::size_t ThrowersOf = 0;                                   // the version of the waves that they are of
  double ThrowerSettings[4] = { 0.0, 0.0, 0.0, 0.0 };           // that it was made with
};

#endif
