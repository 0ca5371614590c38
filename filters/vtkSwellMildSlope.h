#ifndef vtkSwellMildSlope_h
#define vtkSwellMildSlope_h

#include "swellrayFiltersModule.h"
#include "vtkImageAlgorithm.h"

#include <limits> // for deep water
#include <memory> // for the seafloor

namespace swellray
{
class ObstacleField;
class SeafloorField;
}

/**
 * @class   vtkSwellMildSlope
 * @brief   wave height and direction by the mild-slope equation: with diffraction and reflection
 *
 * Wraps swellray::solveMildSlope (equations there): where rays cross, cast shadows or focus, heights are finite and
 * continuous. One regular wave; with the breaking of Battjes-Janssen or Baldock its height is the root mean square of a sea's.
 *
 * Input 0: vtkImageData, the seafloor, point array Elevation (m, positive up).
 * Input 1: vtkPolyData, optional, points (m, in the scene's plane; their heights do not count).
 *
 * Output 0: vtkImageData, one layer, with these point arrays
 * - Elevation (double, m), Depth (double, m, negative on land); NaN: a hole of the seafloor
 * - WaveHeight (double, m; the scalars), DirectionFrom (double, nautical degrees, of the phase's gradient), Wavelength
 *   (double, m), WavePhase (double, rad, -pi to pi: a crest stands where it is omega t + 2 pi n): NaN on land
 * - Breaking (unsigned char): 1 where the wave breaks
 *
 * Output 1: vtkPolyData, the points of input 1 in their order, one vertex each, with the same point arrays added.
 *
 * Both have the field data of the seafloor and Method (string, "mild-slope"), Period (s), DirectionFrom (nautical degrees), WaveHeight (m),
 * OffshoreDepth (m), Gravity (m/s2), WaterLevel (m), and of the solution MeshColumns, MeshRows (nodes, absorbing layers included),
 * MeshSpacing (m), NodesPerWave (in the shortest wavelength), MinimumDepth (m), Memory (bytes), SolutionSeconds (estimate, one solution on one thread), Solutions
 * (made; with PlanOnly at most), SolutionChange (relative, of the heights in the last one) and Residual.
 *
 * After an abort the outputs are empty. The same for any number of threads.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellMildSlope : public vtkImageAlgorithm
{
public:
  static vtkSwellMildSlope* New();
  vtkTypeMacro(vtkSwellMildSlope, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EdgeRules
  {
    EDGE_CONTOURS = 0,
    EDGE_EDGE = 1,
    EDGE_NONE = 2
  };

  enum Dispersions
  {
    LINEAR = 0,
    NONLINEAR = 1
  };

  ///@{
  /** Period of the wave, s; > 0, default 10. */
  vtkSetMacro(Period, double);
  vtkGetMacro(Period, double);
  ///@}

  ///@{
  /** Direction the wave comes from offshore, nautical degrees; -360 to 360, default 270. */
  vtkSetMacro(DirectionFrom, double);
  vtkGetMacro(DirectionFrom, double);
  ///@}

  ///@{
  /** Incident wave height, crest to trough, m; > 0, default 1. */
  vtkSetMacro(WaveHeight, double);
  vtkGetMacro(WaveHeight, double);
  ///@}

  ///@{
  /** Depth in which direction and height hold, m; > 0, default infinity: deep water, as is 0. */
  vtkSetMacro(OffshoreDepth, double);
  vtkGetMacro(OffshoreDepth, double);
  ///@}

  ///@{
  /** Acceleration of gravity, m/s2; > 0, default 9.81. */
  vtkSetMacro(Gravity, double);
  vtkGetMacro(Gravity, double);
  ///@}

  ///@{
  /** Still-water level (tide), m, positive up, in the datum of the elevations; default 0. */
  vtkSetMacro(WaterLevel, double);
  vtkGetMacro(WaterLevel, double);
  ///@}

  ///@{
  /** How the incident wave is brought to the edges of the scene, as vtkSwellRayTracer has it; default by contours. */
  vtkSetClampMacro(Edge, int, EDGE_CONTOURS, EDGE_NONE);
  vtkGetMacro(Edge, int);
  ///@}

  ///@{
  /** Nautical direction that the offshore contours face, degrees; used where UseShoreNormal is on, default off. */
  vtkSetMacro(ShoreNormal, double);
  vtkGetMacro(ShoreNormal, double);
  vtkSetMacro(UseShoreNormal, vtkTypeBool);
  vtkGetMacro(UseShoreNormal, vtkTypeBool);
  vtkBooleanMacro(UseShoreNormal, vtkTypeBool);
  ///@}

  ///@{
  /** Distance of the nodes of the solution, m; >= 0, default 0: a tenth of the shortest wavelength. */
  vtkSetMacro(NodeSpacing, double);
  vtkGetMacro(NodeSpacing, double);
  ///@}

  ///@{
  /** Distance of the nodes of the map, m; >= 0, default 0: the nodes of the seafloor. */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /** Depth where the coast begins, m; >= 0, default 0: half the depth in which the incident wave breaks. */
  vtkSetMacro(MinimumDepth, double);
  vtkGetMacro(MinimumDepth, double);
  ///@}

  ///@{
  /** The two sides along which the wave runs are walls; default off: they carry the incident wave. */
  vtkSetMacro(SideWalls, vtkTypeBool);
  vtkGetMacro(SideWalls, vtkTypeBool);
  vtkBooleanMacro(SideWalls, vtkTypeBool);
  ///@}

  ///@{
  /** Height of the wave that a coast reflects over that of the one that comes in; 0 (default) to 1. */
  vtkSetMacro(CoastReflection, double);
  vtkGetMacro(CoastReflection, double);
  ///@}

  ///@{
  /** File of walls, as vtkSwellRayTracer takes it; default none. No wave passes an element that they touch. */
  vtkSetStringMacro(Obstacles);
  vtkGetStringMacro(Obstacles);
  ///@}

  ///@{
  /** Height of the wave that an obstacle reflects over that of the incident one, 0 to 1, default 0; its own goes first. */
  vtkSetMacro(Reflection, double);
  vtkGetMacro(Reflection, double);
  ///@}

  ///@{
  /** Wavenumber of linear waves (default), or of waves of their height (Kirby and Dalrymple 1986). */
  vtkSetClampMacro(Dispersion, int, LINEAR, NONLINEAR);
  vtkGetMacro(Dispersion, int);
  void SetDispersionToLinear() { this->SetDispersion(LINEAR); }
  void SetDispersionToNonlinear() { this->SetDispersion(NONLINEAR); }
  ///@}

  ///@{
  /** Breaking: one of vtkSwellWaveHeight::BreakingRules; default 1, H <= gamma h. */
  vtkSetClampMacro(BreakingRule, int, 0, 6);
  vtkGetMacro(BreakingRule, int);
  ///@}

  ///@{
  /** Breaker index H/h; >= 0, default 0: 0.78, with Battjes-Janssen by the steepness, with Baldock by the kh of each place. */
  vtkSetMacro(Gamma, double);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /** Bottom friction factor of Jonsson; >= 0, default 0. */
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
  /** Memory that the solution may take, bytes; default 0: four fifths of the machine's. */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** Only say in the field data what the solution will take; default off. */
  vtkSetMacro(PlanOnly, vtkTypeBool);
  vtkGetMacro(PlanOnly, vtkTypeBool);
  vtkBooleanMacro(PlanOnly, vtkTypeBool);
  ///@}

  /** Connect the points. */
  void SetStationsConnection(vtkAlgorithmOutput* stations) { this->SetInputConnection(1, stations); }

protected:
  vtkSwellMildSlope();
  ~vtkSwellMildSlope() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Period = 10.0;
  double DirectionFrom = 270.0;
  double WaveHeight = 1.0;
  double OffshoreDepth = std::numeric_limits<double>::infinity();
  double Gravity = 9.81;
  double WaterLevel = 0.0;
  int Edge = EDGE_CONTOURS;
  double ShoreNormal = 0.0;
  vtkTypeBool UseShoreNormal = 0;
  double NodeSpacing = 0.0;
  double Spacing = 0.0;
  double MinimumDepth = 0.0;
  vtkTypeBool SideWalls = 0;
  double CoastReflection = 0.0;
  char* Obstacles = nullptr;
  double Reflection = 0.0;
  int Dispersion = LINEAR;
  int BreakingRule = 1;
  double Gamma = 0.0;
  double Friction = 0.0;
  double Viscosity = 0.0;
  double MemoryLimit = 0.0;
  vtkTypeBool PlanOnly = 0;

private:
  vtkSwellMildSlope(const vtkSwellMildSlope&) = delete;
  void operator=(const vtkSwellMildSlope&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::unique_ptr<swellray::ObstacleField> Walls;
};

#endif
