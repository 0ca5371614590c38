#ifndef vtkSwellRayTracer_h
#define vtkSwellRayTracer_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <limits> // for the default of OffshoreDepth
#include <memory> // for the seafloor and the current that are kept

namespace swellray
{
class CurrentField;
class Georeference;
class ObstacleField;
class SeafloorField;
class WaveSource;
}

/**
 * @class   vtkSwellRayTracer
 * @brief   trace refracted wave rays over a seafloor, front by front
 *
 * Wraps swellray::traceWaves (Hamiltonian rays with ray tubes, dynamic wave tracing; equations there). Directions
 * are nautical: degrees clockwise from north, coming FROM.
 *
 * Input 0: vtkImageData with one layer of at least 4 x 4 nodes, axes east and north, point array Elevation (m,
 * positive up, NaN: a hole). It is interpolated by a C2 spline; where the field data SeafloorForm names a built-in
 * form and the elevations are those of the form, the formula is taken instead. Either is kept until the elevations
 * change, so that tracing another wave does not build it again. Where its field data say that it lies on the ellipsoid
 * (vtkSwellSeafloorReader), rays are traced there: points are in the metres of its Mercator map, all other lengths true
 * ones, directions true ones anyhow.
 *
 * Input 1, optional: vtkPolyData, where rays start in place of the edges of the scene, m, in its plane. Its lines are launch lines,
 * with rays at equal parts of the incident crest; without lines its points are launch points, a ray each, with the direction of the
 * point array DirectionFrom (1, nautical degrees, of the wave at the point; NaN or no array: of the incident wave).
 *
 * Output: one poly-line a ray, also for rays of a single point, its points on the still-water level. Point arrays,
 * double with one component unless said:
 * - Depth (m), Phase (rad), TravelTime (s), Wavenumber (rad/m), Wavelength (m)
 * - PhaseSpeed, GroupSpeed (m/s, relative to the water)
 * - Direction (3 components, unit vector of the wavenumber, going to), RayDirection (the same of the ray)
 * - DirectionFrom (nautical degrees)
 * - KrSpacing (refraction coefficient from neighbouring rays; NaN without a neighbour), KrTube (from the ray tube;
 *   infinite at a caustic, NaN where there is no tube), TubeWidth (signed, over the width offshore)
 * - ShoalingCoefficient, Caustics (int: passed so far)
 * - Current (3 components, m/s) where there is one
 * - MapScale (length on the map over true length) on the ellipsoid
 * - RayState (unsigned char): 0 DEAD, 1 ALIVE, 2 FLAT, 3 AGROUND
 * - Longitude, Latitude (degrees) where the input says how to map back, unless LongitudeLatitude is off.
 *
 * Cell arrays: RayId (int), LaunchParameter (double, m along the incident crest), ParentRay (int, -1 for a launched
 * ray), LeeRay (unsigned char, 1: a model of diffraction), FinalState (unsigned char, as RayState), EndReason
 * (unsigned char: 0 step cap, 1 left the scene, 2 entered a hole, 3 aground, 4 between two aground rays, 5 cancelled,
 * 6 blocked by a current, 7 stopped by an obstacle), LaunchSegment (int: rays of different segments are no neighbours).
 *
 * With obstacles also Reflections (int: by obstacles, so far) and ReflectionCoefficient (double: product of theirs). A
 * reflected ray is a cell of its own; its ParentRay is the one that the wall stopped.
 *
 * Field data: that of the input, and Period (s), DirectionFrom (nautical degrees; from a source where the wave first meets the scene),
 * SourceDistance (m, from the source to there), LaunchPoints (int, where rays start from points; LaunchParameter then counts them), WaveHeight (m, incident),
 * OffshoreDepth (m, infinite: deep), Gravity (m/s2), WaterLevel (m), LaunchSpacing, MaxSpacing, LaunchWidth (m: as
 * used), StepsPerWave (as used, 0: fronts of equal length), Fronts, RaySteps (steps of all rays), RayCapReached,
 * StepCapReached (int), DispersionError (largest | |k|/k(h) - 1 | on a ray, with a current | (sigma + k.U)/omega - 1 |) and
 * SwellrayVersion. With obstacles they go along: ObstaclePoints (2 components, m), ObstacleOffsets (int: where each
 * begins), ObstacleRings (unsigned char, 1: closed) and ObstacleReflection.
 * Where rays touch caustics also CausticPoints, a tuple for each such place with the components RayId,
 * Number (of the caustics of that ray, from 1), X, Y (m), RayDirectionX, RayDirectionY (unit vector), Phase (rad),
 * TravelTime (s), WavenumberX, WavenumberY (rad/m), PhaseRate (along the ray, rad/m), WidthRate (of TubeWidth along the ray, 1/m), FanWavenumber
 * (rad/m), AlongRate, AlongChange (1/m; NaN without neighbours) and Scale (of the map of the Earth, 1 on a plane): swellray::RayCaustic.
 *
 * A cap that is reached, a grid too coarse for the wave, and gaps in a current are said by a warning. After an abort the output holds
 * the rays as far as they were traced, those cut short with EndReason 5.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellRayTracer : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellRayTracer* New();
  vtkTypeMacro(vtkSwellRayTracer, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Schemes
  {
    ODE = 0,
    SNELL = 1
  };

  enum InsertionRules
  {
    INSERT_NONE = 0,
    INSERT_RETRACE = 1,
    INSERT_INTERPOLATE = 2
  };

  enum Sources
  {
    PLANE_WAVE = 0,
    STORM = 1,
    POINT = 2
  };

  enum EdgeRules
  {
    EDGE_CONTOURS = 0,
    EDGE_EDGE = 1,
    EDGE_NONE = 2
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
  /**
   * Where the wave comes from: from DirectionFrom, a plane wave (default); from a storm far away, along the geodesics of the Earth
   * (swellray::GeodesicSource); or from a point of the plane, with circular crests. Height and crest are then those
   * where the wave first meets the scene.
   */
  vtkSetClampMacro(Source, int, PLANE_WAVE, POINT);
  vtkGetMacro(Source, int);
  void SetSourceToPlaneWave() { this->SetSource(PLANE_WAVE); }
  void SetSourceToStorm() { this->SetSource(STORM); }
  void SetSourceToPoint() { this->SetSource(POINT); }
  ///@}

  ///@{
  /** Of a storm longitude and latitude, degrees; of a point x and y in the coordinates of the seafloor's file; default 0, 0. */
  vtkSetVector2Macro(SourcePosition, double);
  vtkGetVector2Macro(SourcePosition, double);
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
  /** Launch spacing along the incident crest, m; default 0: chosen from the scene. */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /** Distance of neighbours above which a ray is inserted, m; default 0: 1.5 times the launch spacing. */
  vtkSetMacro(MaxSpacing, double);
  vtkGetMacro(MaxSpacing, double);
  ///@}

  ///@{
  /** Fronts a wavelength; default 0: 8, or fewer in a scene of very many points. Not used where Step is set. */
  vtkSetMacro(StepsPerWave, double);
  vtkGetMacro(StepsPerWave, double);
  ///@}

  ///@{
  /** Fronts of equal length instead of equal phase, m; default 0: equal phase. */
  vtkSetMacro(Step, double);
  vtkGetMacro(Step, double);
  ///@}

  ///@{
  /** Adaptive integration of the ray equations (default), or Snell's law across each step of fixed length. */
  vtkSetClampMacro(Scheme, int, ODE, SNELL);
  vtkGetMacro(Scheme, int);
  void SetSchemeToOde() { this->SetScheme(ODE); }
  void SetSchemeToSnell() { this->SetScheme(SNELL); }
  ///@}

  ///@{
  /** Relative tolerance of an integration step; > 0, default 1e-8. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * How a ray is inserted between neighbours further apart than MaxSpacing: traced afresh from the launch line
   * (default, exact), interpolated between them, or not at all.
   */
  vtkSetClampMacro(Insertion, int, INSERT_NONE, INSERT_INTERPOLATE);
  vtkGetMacro(Insertion, int);
  void SetInsertionToNone() { this->SetInsertion(INSERT_NONE); }
  void SetInsertionToRetrace() { this->SetInsertion(INSERT_RETRACE); }
  void SetInsertionToInterpolate() { this->SetInsertion(INSERT_INTERPOLATE); }
  ///@}

  ///@{
  /** Model diffraction into the lee by inserted rays; default on. */
  vtkSetMacro(LeeRays, vtkTypeBool);
  vtkGetMacro(LeeRays, vtkTypeBool);
  vtkBooleanMacro(LeeRays, vtkTypeBool);
  ///@}

  ///@{
  /** Wave height below which a ray is FLAT: traced, but not refined, m; default -1: a tenth of the incident height. */
  vtkSetMacro(FlatHeight, double);
  vtkGetMacro(FlatHeight, double);
  ///@}

  ///@{
  /** Depth at which a ray is aground, m; default 0: 5 % of the incident height. */
  vtkSetMacro(AgroundDepth, double);
  vtkGetMacro(AgroundDepth, double);
  ///@}

  ///@{
  /**
   * How the wave comes from offshore to the edges of the scene: refracted over straight contours with one normal for
   * the scene (default), over contours parallel to each edge, or with the direction as given.
   */
  vtkSetClampMacro(Edge, int, EDGE_CONTOURS, EDGE_NONE);
  vtkGetMacro(Edge, int);
  void SetEdgeToContours() { this->SetEdge(EDGE_CONTOURS); }
  void SetEdgeToEdge() { this->SetEdge(EDGE_EDGE); }
  void SetEdgeToNone() { this->SetEdge(EDGE_NONE); }
  ///@}

  ///@{
  /** Take ShoreNormal for the normal of the contours; default off: that of the plane fitted to the wet depths. */
  vtkSetMacro(UseShoreNormal, vtkTypeBool);
  vtkGetMacro(UseShoreNormal, vtkTypeBool);
  vtkBooleanMacro(UseShoreNormal, vtkTypeBool);
  ///@}

  ///@{
  /** Direction in which the normal of the contours points out to sea, nautical degrees; default 270. */
  vtkSetMacro(ShoreNormal, double);
  vtkGetMacro(ShoreNormal, double);
  ///@}

  ///@{
  /**
   * Steady current on which the waves travel: a built-in one (jet:V0=2,w=200, in the metres of the scene), a .vti
   * with a point array Current (2 or 3 components, m/s) or arrays u and v, or a raster with two variables or bands u
   * and v; it must cover the scene. Default none: still water. The period is absolute; heights and directions offshore
   * hold in still water. Not with the Snell scheme.
   */
  vtkSetStringMacro(Current);
  vtkGetStringMacro(Current);
  ///@}

  ///@{
  /**
   * File of walls that stand in the water: polygons and lines (GeoJSON, GeoPackage, Shapefile, ...) in any CRS. Rays
   * stop at them, or are reflected. Default none.
   */
  vtkSetStringMacro(Obstacles);
  vtkGetStringMacro(Obstacles);
  ///@}

  ///@{
  /**
   * Height of the wave that an obstacle reflects over that of the incident one, 0 to 1, default 0; a feature's own
   * property `reflection` goes first.
   */
  vtkSetMacro(Reflection, double);
  vtkGetMacro(Reflection, double);
  ///@}

  ///@{
  /** How often one wave is reflected by obstacles at most; >= 0, default 10. */
  vtkSetMacro(MaximumReflections, int);
  vtkGetMacro(MaximumReflections, int);
  ///@}

  ///@{
  /**
   * Add Longitude and Latitude; default on. On a geographic grid they cost about a third of the time of tracing:
   * switch them off where the rays are only looked at.
   */
  vtkSetMacro(LongitudeLatitude, vtkTypeBool);
  vtkGetMacro(LongitudeLatitude, vtkTypeBool);
  vtkBooleanMacro(LongitudeLatitude, vtkTypeBool);
  ///@}

  /** Connect launch lines or points. */
  void SetLaunchConnection(vtkAlgorithmOutput* launch) { this->SetInputConnection(1, launch); }

  ///@{
  /** Cap on the number of rays, inserted ones included; > 0, default 200,000. */
  vtkSetMacro(MaximumNumberOfRays, vtkIdType);
  vtkGetMacro(MaximumNumberOfRays, vtkIdType);
  ///@}

  ///@{
  /** Cap on the number of fronts; > 0, default 100,000. */
  vtkSetMacro(MaximumNumberOfFronts, vtkIdType);
  vtkGetMacro(MaximumNumberOfFronts, vtkIdType);
  ///@}

protected:
  vtkSwellRayTracer();
  ~vtkSwellRayTracer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Period = 10.0;
  double DirectionFrom = 270.0;
  int Source = PLANE_WAVE;
  double SourcePosition[2] = { 0.0, 0.0 };
  double WaveHeight = 1.0;
  double OffshoreDepth = std::numeric_limits<double>::infinity();
  double Gravity = 9.81;
  double WaterLevel = 0.0;
  double Spacing = 0.0;
  double MaxSpacing = 0.0;
  double StepsPerWave = 0.0;
  double Step = 0.0;
  int Scheme = ODE;
  double Tolerance = 1e-8;
  int Insertion = INSERT_RETRACE;
  vtkTypeBool LeeRays = 1;
  double FlatHeight = -1.0;
  double AgroundDepth = 0.0;
  int Edge = EDGE_CONTOURS;
  vtkTypeBool UseShoreNormal = 0;
  double ShoreNormal = 270.0;
  char* Current = nullptr;
  char* Obstacles = nullptr;
  double Reflection = 0.0;
  int MaximumReflections = 10;
  vtkTypeBool LongitudeLatitude = 1;
  vtkIdType MaximumNumberOfRays = 200000;
  vtkIdType MaximumNumberOfFronts = 100000;

private:
  vtkSwellRayTracer(const vtkSwellRayTracer&) = delete;
  void operator=(const vtkSwellRayTracer&) = delete;

  std::unique_ptr<const swellray::WaveSource> makeSource(const swellray::Georeference& scene) const;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::unique_ptr<swellray::CurrentField> Water;
  std::unique_ptr<swellray::ObstacleField> Walls;
};

#endif
