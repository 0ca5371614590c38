#ifndef vtkSwellSeaFunction_h
#define vtkSwellSeaFunction_h

#include "swellrayFiltersModule.h"
#include "vtkImplicitFunction.h"

#include <memory> // for the surface

namespace swellray
{
class SeaSurface;
}

/**
 * @class   vtkSwellSeaFunction
 * @brief   the surface of a sea as an implicit function: z - h(x, y, t)
 *
 * Wraps swellray::SeaSurface. Above 0 in the air, below in the water, 0 on the surface, m; to be sampled, cut, clipped or
 * contoured with. vtkSwellSea hands it out (GetFunction()), set up; without one its value is z.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSeaFunction : public vtkImplicitFunction
{
public:
  static vtkSwellSeaFunction* New();
  vtkTypeMacro(vtkSwellSeaFunction, vtkImplicitFunction)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override;
  void EvaluateGradient(double x[3], double gradient[3]) override;

  ///@{
  /** Time, s; default 0. */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /** Size of what need not be told apart, m: waves shorter than twice that are left out; default 0. */
  vtkSetMacro(Footprint, double);
  vtkGetMacro(Footprint, double);
  ///@}

  /**
   * Where a ray first meets the surface, by ray marching.
   * @param origin m
   * @param direction of any length
   * @param farthest m
   * @param pixel angle of what cannot be told apart, rad
   * @return distance, m; below 0 where it does not up to `farthest`
   */
  double March(const double origin[3], const double direction[3], double farthest, double pixel);

#ifndef __VTK_WRAP__
  void SetSurface(std::shared_ptr<const swellray::SeaSurface> surface);
  const std::shared_ptr<const swellray::SeaSurface>& GetSurface() const
  {
    return this->Surface;
  }
#endif

protected:
  vtkSwellSeaFunction();
  ~vtkSwellSeaFunction() override;

  double Time = 0.0;
  double Footprint = 0.0;

private:
  vtkSwellSeaFunction(const vtkSwellSeaFunction&) = delete;
  void operator=(const vtkSwellSeaFunction&) = delete;

  std::shared_ptr<const swellray::SeaSurface> Surface;
};

#endif
