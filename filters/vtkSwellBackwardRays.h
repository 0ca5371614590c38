#ifndef vtkSwellBackwardRays_h
#define vtkSwellBackwardRays_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <limits> // for the default of OffshoreDepth
#include <memory> // for the seafloor and the current that are kept

namespace swellray
{
class CurrentField;
class ObstacleField;
class SeafloorField;
}

/**
 * @class   vtkSwellBackwardRays
 * @brief   the ways by which waves come to a site, a fan of directions followed back to offshore
 *
 * Wraps swellray::BackwardTracer (equations there). Directions are nautical: degrees clockwise from north, coming FROM.
 *
 * Input 0: vtkImageData, the seafloor, as in vtkSwellRayTracer; on a plane.
 *
 * Output: one poly-line a direction, in the sense of the wave, ending at the site. Point arrays, double with one component unless said:
 * Depth (m), Phase (rad), TravelTime (s), both from where the way begins, Wavenumber (rad/m), Wavelength (m), PhaseSpeed,
 * GroupSpeed (m/s, relative to the water), Direction, RayDirection (3 components, unit vectors, going to), DirectionFrom (nautical
 * degrees), Current (3 components, m/s) where there is one, Longitude and Latitude (degrees) where they are known.
 *
 * Cell arrays: RayId (int), SiteDirectionFrom (double, nautical degrees, at the site), OffshoreDirectionFrom (double,
 * nautical degrees; NaN where no wave from offshore gets to the site in this direction), EnergyGain (double: E(f, direction) at the
 * site over that offshore, 0 where none gets there), TravelTime (double, s), EndReason (unsigned char, as in
 * vtkSwellRayTracer: what ended the ray at its other end, followed back).
 *
 * Field data: that of the input, and Period (s), OffshoreDepth (m), Gravity (m/s2), WaterLevel (m), SiteX, SiteY (in the
 * coordinates of the seafloor's file), SwellrayVersion.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellBackwardRays : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellBackwardRays* New();
  vtkTypeMacro(vtkSwellBackwardRays, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EdgeRules
  {
    EDGE_CONTOURS = 0,
    EDGE_EDGE = 1,
    EDGE_NONE = 2
  };

  ///@{
  /** The site, in the coordinates of the seafloor's file (longitude and latitude where it is in degrees); default 0, 0. */
  vtkSetVector2Macro(Site, double);
  vtkGetVector2Macro(Site, double);
  ///@}

  ///@{
  /** Directions at the site, evenly around the circle from north on; >= 1, default 72. */
  vtkSetMacro(NumberOfDirections, int);
  vtkGetMacro(NumberOfDirections, int);
  ///@}

  ///@{
  /** Period of the waves, s; > 0, default 10. */
  vtkSetMacro(Period, double);
  vtkGetMacro(Period, double);
  ///@}

  ///@{
  /** Depth in which offshore directions hold, m; > 0, default infinity: deep water, as is 0. */
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
  /** Points a wavelength; > 0, default 8. */
  vtkSetMacro(StepsPerWave, double);
  vtkGetMacro(StepsPerWave, double);
  ///@}

  ///@{
  /** Relative error of an integration step; > 0 to 0.1, default 1e-8. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Depth at which a ray is aground, m; > 0, default 0.1. */
  vtkSetMacro(AgroundDepth, double);
  vtkGetMacro(AgroundDepth, double);
  ///@}

  ///@{
  /** Refraction between offshore and the edge of the scene; default EDGE_CONTOURS. */
  vtkSetClampMacro(Edge, int, EDGE_CONTOURS, EDGE_NONE);
  vtkGetMacro(Edge, int);
  ///@}

  ///@{
  /** Seaward normal of the contours offshore, nautical degrees, where UseShoreNormal is on; otherwise of the scene. */
  vtkSetMacro(ShoreNormal, double);
  vtkGetMacro(ShoreNormal, double);
  vtkSetMacro(UseShoreNormal, bool);
  vtkGetMacro(UseShoreNormal, bool);
  vtkBooleanMacro(UseShoreNormal, bool);
  ///@}

  ///@{
  /** Steady current, as in vtkSwellRayTracer; default none. */
  vtkSetStringMacro(Current);
  vtkGetStringMacro(Current);
  ///@}

  ///@{
  /** File of walls at which rays end, as in vtkSwellRayTracer; default none. */
  vtkSetStringMacro(Obstacles);
  vtkGetStringMacro(Obstacles);
  ///@}

protected:
  vtkSwellBackwardRays();
  ~vtkSwellBackwardRays() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Site[2] = { 0.0, 0.0 };
  int NumberOfDirections = 72;
  double Period = 10.0;
  double OffshoreDepth = std::numeric_limits<double>::infinity();
  double Gravity = 9.81;
  double WaterLevel = 0.0;
  double StepsPerWave = 8.0;
  double Tolerance = 1e-8;
  double AgroundDepth = 0.1;
  int Edge = EDGE_CONTOURS;
  double ShoreNormal = 0.0;
  bool UseShoreNormal = false;
  char* Current = nullptr;
  char* Obstacles = nullptr;

private:
  vtkSwellBackwardRays(const vtkSwellBackwardRays&) = delete;
  void operator=(const vtkSwellBackwardRays&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::unique_ptr<swellray::CurrentField> Water;
  std::unique_ptr<swellray::ObstacleField> Walls;
};

#endif
