#ifndef vtkSwellWaveHeight_h
#define vtkSwellWaveHeight_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

/**
 * @class   vtkSwellWaveHeight
 * @brief   wave heights and breaking along traced rays
 *
 * Wraps swellray::computeHeights (equations there): H = H0 Ks Kr with bottom friction and breaking.
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer (also read back from a file), with the point arrays
 * - Depth (m), Wavenumber (rad/m), GroupSpeed (m/s), TravelTime (s), Phase (rad), ShoalingCoefficient, KrSpacing,
 *   KrTube, RayState,
 * the cell array ParentRay (an inserted ray begins with the losses of its parent there)
 * and RayId, the field data CausticPoints where rays touch caustics (then also the cell arrays LaunchParameter, LaunchSegment
 * and LeeRay), and Period (s), DirectionFrom (nautical degrees), WaveHeight (m, the incident height),
 * OffshoreDepth (m) and Gravity (m/s2): the wave is the one that was traced, it cannot be set here.
 *
 * Output: the input, its arrays shared, with these point arrays added
 * - RefractionCoefficient (double): Kr in use
 * - WaveHeight (double, m): crest to trough; with Battjes-Janssen and Baldock the root mean square of a sea's heights, as is then
 *   the incident height
 * - EnergyFlux (double, W/m): along the ray, a metre across it; on a current omega times the flux of wave action
 * - OrbitalVelocity (double, m/s): amplitude near the bed
 * - Breaking (unsigned char): 1 where the wave is broken (of a sea: more than 5 % of the waves), otherwise 0
 * - BreakerType (unsigned char): 0 not broken, 1 spilling, 2 plunging, 3 surging: by the Iribarren number xi_0 where this
 *   breaking began, of the slope along the ray and the height in deep water
 * - BreakingDistance (double, m): way along the ray since breaking began, 0 where it is not broken
 * - FrictionCoefficient (double), only with friction: what it alone has left of the height
 * - BrokenShare (double), only of a sea (Battjes-Janssen, Baldock): share of the waves that are broken, 0 to 1
 * and the field data BreakingRule, CausticRule (strings, as the command line names them) and BreakerIndex (double, gamma in use).
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

  enum CausticRules
  {
    UNIFORM = 0,
    GEOMETRIC = 1,
    CAP = 2
  };

  enum BreakingRules
  {
    NO_BREAKING = 0,
    GAMMA_BREAKING = 1,
    WEGGEL_BREAKING = 2,
    MICHE_BREAKING = 3,
    DALLY_BREAKING = 4,
    BATTJES_JANSSEN_BREAKING = 5,
    BALDOCK_BREAKING = 6
  };

  ///@{
  /** Where the refraction coefficient comes from: the distance of neighbouring rays (default) or the ray tube. */
  vtkSetClampMacro(AmplitudeRule, int, SPACING, TUBE);
  vtkGetMacro(AmplitudeRule, int);
  void SetAmplitudeRuleToSpacing() { this->SetAmplitudeRule(SPACING); }
  void SetAmplitudeRuleToTube() { this->SetAmplitudeRule(TUBE); }
  ///@}

  ///@{
  /**
   * No breaking; saturated at Gamma h (default), at Weggel's or at Miche's limit; Dally, Dean and Dalrymple's decay and
   * reformation; random waves of Battjes and Janssen, or of Baldock et al.
   */
  vtkSetClampMacro(BreakingRule, int, NO_BREAKING, BALDOCK_BREAKING);
  vtkGetMacro(BreakingRule, int);
  void SetBreakingRuleToNone() { this->SetBreakingRule(NO_BREAKING); }
  void SetBreakingRuleToGamma() { this->SetBreakingRule(GAMMA_BREAKING); }
  void SetBreakingRuleToWeggel() { this->SetBreakingRule(WEGGEL_BREAKING); }
  void SetBreakingRuleToMiche() { this->SetBreakingRule(MICHE_BREAKING); }
  void SetBreakingRuleToDally() { this->SetBreakingRule(DALLY_BREAKING); }
  void SetBreakingRuleToBattjesJanssen() { this->SetBreakingRule(BATTJES_JANSSEN_BREAKING); }
  void SetBreakingRuleToBaldock() { this->SetBreakingRule(BALDOCK_BREAKING); }
  ///@}

  ///@{
  /**
   * Breaker index H/h; > 0, or 0 (default): 0.78, for Battjes-Janssen by the steepness (Battjes and Stive 1985), for
   * Baldock of each place by its kh (Ruessink et al. 2003). Used by gamma, dally (there above 0.4), battjes-janssen and baldock, and by
   * all for rays aground.
   */
  vtkSetMacro(Gamma, double);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /** Bottom friction factor fw (Jonsson 1966); >= 0, default 0. */
  vtkSetMacro(Friction, double);
  vtkGetMacro(Friction, double);
  ///@}

  ///@{
  /**
   * Viscosity of water over a smooth bed whose boundary layer is laminar, as in small tanks, m2/s (1e-6 at 20 degrees; Hunt 1952), in place of
   * Friction; >= 0, default 0: no such layer.
   */
  vtkSetMacro(Viscosity, double);
  vtkGetMacro(Viscosity, double);
  ///@}

  ///@{
  /**
   * Height next to caustics: finite at folds by the modulus of the Airy function and capped elsewhere (default),
   * infinite, or capped.
   */
  vtkSetClampMacro(CausticRule, int, UNIFORM, CAP);
  vtkGetMacro(CausticRule, int);
  void SetCausticRuleToUniform() { this->SetCausticRule(UNIFORM); }
  void SetCausticRuleToGeometric() { this->SetCausticRule(GEOMETRIC); }
  void SetCausticRuleToCap() { this->SetCausticRule(CAP); }
  ///@}

  ///@{
  /**
   * Cap of the refraction coefficient at caustics; > 0, default 3. Where the caustics of a ray are folds and higher, their
   * own peak takes its place; not used by the geometric rule.
   */
  vtkSetMacro(MaxRefraction, double);
  vtkGetMacro(MaxRefraction, double);
  ///@}

protected:
  vtkSwellWaveHeight() = default;
  ~vtkSwellWaveHeight() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int AmplitudeRule = SPACING;
  int CausticRule = UNIFORM;
  int BreakingRule = GAMMA_BREAKING;
  double Gamma = 0.0;
  double Friction = 0.0;
  double Viscosity = 0.0;
  double MaxRefraction = 3.0;

private:
  vtkSwellWaveHeight(const vtkSwellWaveHeight&) = delete;
  void operator=(const vtkSwellWaveHeight&) = delete;
};

#endif
