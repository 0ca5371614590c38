#ifndef vtkSwellWaveHeight_h
#define vtkSwellWaveHeight_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

/**
 * @class   vtkSwellWaveHeight
 * @brief   wave heights and breaking along traced rays
 *
 * Wraps swellray::computeHeights (equations there): H = H0 Ks Kr with breaking.
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer (also read back from a file), with the point arrays
 * - Depth (m), Wavenumber (rad/m), GroupSpeed (m/s), ShoalingCoefficient, KrSpacing, KrTube, RayState,
 * and the field data Period (s), DirectionFrom (nautical degrees), WaveHeight (m, the incident height),
 * OffshoreDepth (m) and Gravity (m/s2): the wave is the one that was traced, it cannot be set here.
 *
 * Output: the input, its arrays shared, with these point arrays added
 * - RefractionCoefficient (double): Kr in use
 * - WaveHeight (double, m): crest to trough
 * - EnergyFlux (double, W/m): along the ray, a metre of crest
 * - OrbitalVelocity (double, m/s): amplitude near the bed
 * - Breaking (unsigned char): 1 where the wave is broken, otherwise 0
 *
 * Changing an option here does not trace again. After an abort the output is empty.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellWaveHeight : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellWaveHeight* New();
  vtkTypeMacro(vtkSwellWaveHeight, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum AmplitudeRules
  {
    SPACING = 0,
    TUBE = 1
  };

  enum BreakingRules
  {
    NO_BREAKING = 0,
    GAMMA_BREAKING = 1
  };

  ///@{
  /** Where the refraction coefficient comes from: the distance of neighbouring rays (default) or the ray tube. */
  vtkSetClampMacro(AmplitudeRule, int, SPACING, TUBE);
  vtkGetMacro(AmplitudeRule, int);
  void SetAmplitudeRuleToSpacing() { this->SetAmplitudeRule(SPACING); }
  void SetAmplitudeRuleToTube() { this->SetAmplitudeRule(TUBE); }
  ///@}

  ///@{
  /** No breaking, or H <= Gamma h from the first breaking on (default). */
  vtkSetClampMacro(BreakingRule, int, NO_BREAKING, GAMMA_BREAKING);
  vtkGetMacro(BreakingRule, int);
  void SetBreakingRuleToNone() { this->SetBreakingRule(NO_BREAKING); }
  void SetBreakingRuleToGamma() { this->SetBreakingRule(GAMMA_BREAKING); }
  ///@}

  ///@{
  /** Breaker index H/h; > 0, default 0.78. */
  vtkSetMacro(Gamma, double);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /** Cap of the refraction coefficient at caustics; > 0, default 3. */
  vtkSetMacro(MaxRefraction, double);
  vtkGetMacro(MaxRefraction, double);
  ///@}

protected:
  vtkSwellWaveHeight() = default;
  ~vtkSwellWaveHeight() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int AmplitudeRule = SPACING;
  int BreakingRule = GAMMA_BREAKING;
  double Gamma = 0.78;
  double MaxRefraction = 3.0;

private:
  vtkSwellWaveHeight(const vtkSwellWaveHeight&) = delete;
  void operator=(const vtkSwellWaveHeight&) = delete;
};

#endif
