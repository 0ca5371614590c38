#ifndef vtkSwellMap_h
#define vtkSwellMap_h

#include "swellrayFiltersModule.h"
#include "vtkImageAlgorithm.h"

#include <memory> // for the seafloor

namespace swellray
{
class SeafloorField;
}

/**
 * @class   vtkSwellMap
 * @brief   wave height and direction on a regular grid, from rays
 *
 * Wraps swellray::RaySheets and swellray::mapRays (how rays make sheets, and sheets one wave: there).
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer with heights of vtkSwellWaveHeight (also read back from a file).
 * Input 1: vtkImageData, the seafloor they were traced over, point array Elevation (m, positive up).
 *
 * Output: vtkImageData, one layer, with these point arrays
 * - Elevation (double, m), Depth (double, m, negative on land); NaN: a hole of the seafloor
 * - WaveHeight (double, m; the scalars), DirectionFrom (double, nautical degrees), Wavelength (double, m): NaN on land,
 *   inside of obstacles and where no ray came
 * - Breaking (unsigned char): 1 where the highest wave is broken
 * - LeeRay (unsigned char): 1 where the highest wave comes by rays that model diffraction
 * - RayCount (int): sheets of rays, 0 where none came
 * and the field data of the rays. After an abort the output is empty.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellMap : public vtkImageAlgorithm
{
public:
  static vtkSwellMap* New();
  vtkTypeMacro(vtkSwellMap, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum CombineRules
  {
    ENERGY = 0,
    PHASE = 1
  };

  ///@{
  /**
   * How sheets that overlap make one height: their energies are added (default), or they interfere, with strips along
   * fold caustics and beams around cusps and foci, where they have height on the dark side too (RayCount 0).
   */
  vtkSetClampMacro(CombineRule, int, ENERGY, PHASE);
  vtkGetMacro(CombineRule, int);
  void SetCombineRuleToEnergy() { this->SetCombineRule(ENERGY); }
  void SetCombineRuleToPhase() { this->SetCombineRule(PHASE); }
  ///@}

  ///@{
  /** Distance of the nodes, m; >= 0, default 0: the nodes of the seafloor. */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /** Still-water level, m, positive up; default 0. The field data WaterLevel of the rays goes first. */
  vtkSetMacro(WaterLevel, double);
  vtkGetMacro(WaterLevel, double);
  ///@}

  /** Connect the seafloor. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

protected:
  vtkSwellMap();
  ~vtkSwellMap() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int CombineRule = ENERGY;
  double Spacing = 0.0;
  double WaterLevel = 0.0;

private:
  vtkSwellMap(const vtkSwellMap&) = delete;
  void operator=(const vtkSwellMap&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
};

#endif
