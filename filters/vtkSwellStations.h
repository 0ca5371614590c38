#ifndef vtkSwellStations_h
#define vtkSwellStations_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the seafloor

namespace swellray
{
class SeafloorField;
}

/**
 * @class   vtkSwellStations
 * @brief   wave height and direction at points, from rays
 *
 * Wraps swellray::RaySheets and swellray::sampleRays: the values of vtkSwellMap at places of one's own.
 *
 * Input 0: vtkPolyData, rays of vtkSwellRayTracer with heights of vtkSwellWaveHeight (also read back from a file).
 * Input 1: vtkImageData, the seafloor they were traced over, point array Elevation (m, positive up).
 * Input 2: vtkPolyData, points (m, in the scene's plane; their heights do not count).
 *
 * Output: the points of input 2 in their order, one vertex each, with the point arrays of vtkSwellMap added
 * (Elevation and Depth are NaN outside the seafloor, the waves also on land and where no ray came), and the field data
 * of the rays.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellStations : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellStations* New();
  vtkTypeMacro(vtkSwellStations, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum CombineRules
  {
    ENERGY = 0,
    PHASE = 1
  };

  ///@{
  /** How sheets that overlap make one height: their energies are added (default), or they interfere. */
  vtkSetClampMacro(CombineRule, int, ENERGY, PHASE);
  vtkGetMacro(CombineRule, int);
  void SetCombineRuleToEnergy() { this->SetCombineRule(ENERGY); }
  void SetCombineRuleToPhase() { this->SetCombineRule(PHASE); }
  ///@}

  ///@{
  /** Still-water level, m, positive up; default 0. The field data WaterLevel of the rays goes first. */
  vtkSetMacro(WaterLevel, double);
  vtkGetMacro(WaterLevel, double);
  ///@}

  /** Connect the seafloor. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

  /** Connect the points. */
  void SetStationsConnection(vtkAlgorithmOutput* stations) { this->SetInputConnection(2, stations); }

protected:
  vtkSwellStations();
  ~vtkSwellStations() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int CombineRule = ENERGY;
  double WaterLevel = 0.0;

private:
  vtkSwellStations(const vtkSwellStations&) = delete;
  void operator=(const vtkSwellStations&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
};

#endif
