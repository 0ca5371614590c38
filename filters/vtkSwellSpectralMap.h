#ifndef vtkSwellSpectralMap_h
#define vtkSwellSpectralMap_h

#include "swellrayFiltersModule.h"
#include "vtkDataSetAlgorithm.h"

#include <limits> // for the default of OffshoreDepth
#include <memory> // for the seafloor and the current that are kept
#include <vector> // for the spectra

namespace swellray
{
class CurrentField;
class SeafloorField;
struct DirectionalSpectrum;
struct TransferTable;
}

class vtkDoubleArray;

/**
 * @class   vtkSwellSpectralMap
 * @brief   the sea at places, refracted from a directional spectrum offshore
 *
 * Wraps swellray::transformSea: backward rays from each place, one or more a frequency and direction, along which the
 * density of wave action is conserved (equations there and in swellray::BackwardTracer). Directions are nautical: degrees
 * clockwise from north, coming FROM.
 *
 * Input 0: the places: the points of any data set (an image, stations as vtkPolyData, a mesh), m, in the scene's plane.
 * Input 1: vtkImageData, the seafloor, point array Elevation (m, positive up). Optional where input 0 is the seafloor
 * itself.
 *
 * Output: input 0 with these point arrays added, double unless said, NaN on land and in holes:
 * - Depth (m)
 * - SignificantWaveHeight (m; the scalars), PeakPeriod, MeanPeriod (Tm01), ZeroCrossingPeriod (Tm02), EnergyPeriod
 *   (Tm-10) (s), MeanDirectionFrom (nautical degrees), DirectionalSpread (circular standard deviation, degrees)
 * - Breaking (unsigned char): 1 where the sea is limited by the depth
 * and as field data that of the seafloor, and OffshoreSignificantWaveHeight (m), OffshorePeakPeriod (s),
 * OffshoreMeanDirectionFrom, OffshoreDirectionalSpread (degrees) of the spectrum as used, WaterLevel (m), Rays (that the
 * seas are made of), RaySteps (of the integrator, of those that do not come from a file), SwellrayVersion. After an abort the output is empty.
 *
 * The sea offshore is that of BoundaryFileName (the first spectrum of the file), or else of Wind, or else of
 * SignificantHeight and PeakPeriod.
 *
 * With TransferFileName the rays are kept in a file (swellray::TransferTable): places that it has are not traced again,
 * others are added to it. It is checked to belong to the same scene and rays, and brings its own frequencies. It is written
 * every 20 s while rays are traced, and after an abort, so that work that was broken off goes on where it was.
 *
 * Pieces (UPDATE_PIECE_NUMBER of UPDATE_NUMBER_OF_PIECES) share the places, whatever part of them the input could give: each asks
 * for all of the places and of the seafloor, and traces its own (swellray::pieceOf). Images and structured grids are split into blocks that
 * share the points between them, poly-data and unstructured grids by their points. The values do not depend on the number of pieces. A
 * transfer file is for one piece alone.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSpectralMap : public vtkDataSetAlgorithm
{
public:
  static vtkSwellSpectralMap* New();
  vtkTypeMacro(vtkSwellSpectralMap, vtkDataSetAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    PIERSON_MOSKOWITZ = 0,
    JONSWAP = 1,
    TMA = 2
  };

  enum BreakingRules // numbers of vtkSwellWaveHeight
  {
    NO_BREAKING = 0,
    GAMMA_BREAKING = 1,
    BATTJES_JANSSEN_BREAKING = 5,
    BALDOCK_BREAKING = 6
  };

  enum EdgeRules
  {
    EDGE_CONTOURS = 0,
    EDGE_EDGE = 1,
    EDGE_NONE = 2
  };

  ///@{
  /** Shape of the spectrum offshore; default JONSWAP. TMA holds in OffshoreDepth. */
  vtkSetClampMacro(Shape, int, PIERSON_MOSKOWITZ, TMA);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /** Significant wave height Hs offshore, m; > 0, default 2. */
  vtkSetMacro(SignificantHeight, double);
  vtkGetMacro(SignificantHeight, double);
  ///@}

  ///@{
  /** Peak period Tp offshore, s; > 0, default 10. */
  vtkSetMacro(PeakPeriod, double);
  vtkGetMacro(PeakPeriod, double);
  ///@}

  ///@{
  /** Mean direction the sea comes from offshore, nautical degrees; -360 to 360, default 270. */
  vtkSetMacro(DirectionFrom, double);
  vtkGetMacro(DirectionFrom, double);
  ///@}

  ///@{
  /** Circular standard deviation of the directions offshore, degrees; 1 to 80, default 25. */
  vtkSetMacro(Spread, double);
  vtkGetMacro(Spread, double);
  ///@}

  ///@{
  /** Peak enhancement of JONSWAP and TMA; 1 to 20, default 3.3. */
  vtkSetMacro(Peakedness, double);
  vtkGetMacro(Peakedness, double);
  ///@}

  ///@{
  /** Wind at 10 m height, m/s, of a fully developed sea; default 0: the sea is given by height and period. */
  vtkSetMacro(Wind, double);
  vtkGetMacro(Wind, double);
  ///@}

  ///@{
  /** Fetch of the wind, m; default 0: without end. */
  vtkSetMacro(Fetch, double);
  vtkGetMacro(Fetch, double);
  ///@}

  ///@{
  /** Spectral file of the sea offshore (swellray::readSpectra); default none. */
  vtkSetFilePathMacro(BoundaryFileName);
  vtkGetFilePathMacro(BoundaryFileName);
  ///@}

  ///@{
  /** Frequencies, >= 2, default 20, in geometric progression over the band that holds 99.5 % of the energy. */
  vtkSetMacro(NumberOfFrequencies, int);
  vtkGetMacro(NumberOfFrequencies, int);
  ///@}

  ///@{
  /** Lowest and highest frequency, Hz, in place of that band; default 0, 0: the band. */
  vtkSetVector2Macro(FrequencyRange, double);
  vtkGetVector2Macro(FrequencyRange, double);
  ///@}

  ///@{
  /** Directions around the circle, >= 4, default 36. */
  vtkSetMacro(NumberOfDirections, int);
  vtkGetMacro(NumberOfDirections, int);
  ///@}

  ///@{
  /** Rays a direction, >= 1, default 1. */
  vtkSetMacro(RaysPerDirection, int);
  vtkGetMacro(RaysPerDirection, int);
  ///@}

  ///@{
  /** Relative error a step of the rays; above 0 to 0.1, default 1e-5. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * No breaking; Hs at most Gamma h (saturation, default); random waves of Battjes and Janssen or of Baldock et al. along
   * their ways, which are not to be had from a transfer file. Other numbers of vtkSwellWaveHeight are refused.
   */
  vtkSetMacro(BreakingRule, int);
  vtkGetMacro(BreakingRule, int);
  void SetBreakingRuleToNone() { this->SetBreakingRule(NO_BREAKING); }
  void SetBreakingRuleToGamma() { this->SetBreakingRule(GAMMA_BREAKING); }
  void SetBreakingRuleToBattjesJanssen() { this->SetBreakingRule(BATTJES_JANSSEN_BREAKING); }
  void SetBreakingRuleToBaldock() { this->SetBreakingRule(BALDOCK_BREAKING); }
  ///@}

  ///@{
  /**
   * Largest Hs over depth, or of random waves the breaker index; > 0, or 0 (default): 0.6, with Battjes-Janssen by the steepness
   * (Battjes and Stive 1985), with Baldock by the kh of each place (Ruessink et al. 2003).
   */
  vtkSetMacro(Gamma, double);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /** Bottom friction coefficient, m2/s3; >= 0, default 0: none. JONSWAP has 0.038 for swell. */
  vtkSetMacro(Friction, double);
  vtkGetMacro(Friction, double);
  ///@}

  ///@{
  /** Depth in which the sea offshore is given, m; > 0, default infinity: deep water, as is 0. */
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
  /** Steady current: a file or a built-in one, as in vtkSwellRayTracer; default none. */
  vtkSetStringMacro(Current);
  vtkGetStringMacro(Current);
  ///@}

  ///@{
  /** Keep the directional spectrum of each place for GetSpectra(); default off. */
  vtkSetMacro(KeepSpectra, bool);
  vtkGetMacro(KeepSpectra, bool);
  vtkBooleanMacro(KeepSpectra, bool);
  ///@}

  ///@{
  /** File that keeps the rays; default none. */
  vtkSetFilePathMacro(TransferFileName);
  vtkGetFilePathMacro(TransferFileName);
  ///@}

  ///@{
  /** Keep the rays of all places for GetTransferTable(), also without a file; default off. */
  vtkSetMacro(KeepTransfer, bool);
  vtkGetMacro(KeepTransfer, bool);
  vtkBooleanMacro(KeepTransfer, bool);
  ///@}

  /** Connect the seafloor. */
  void SetSeafloorConnection(vtkAlgorithmOutput* seafloor) { this->SetInputConnection(1, seafloor); }

  /**
   * Surface elevation at the places in time, m (swellray::elevationSeries), from the spectra of the last update with KeepSpectra on:
   * a tuple a place, a component a sample, `interval` s apart (> 0), as many as `duration` s take or some more. NaN at dry places.
   * The same seed gives the same records.
   * @return 0 after an error
   */
  int MakeElevations(double duration, double interval, int seed, vtkDoubleArray* elevations);

#ifndef __VTK_WRAP__
  /** Spectra of the places (of the piece), in their order, of the last update with KeepSpectra on; empty ones for dry places. */
  const std::vector<swellray::DirectionalSpectrum>& GetSpectra() const;

  /** Rays of the places, in their order, of the last update with KeepTransfer on or a TransferFileName. */
  const swellray::TransferTable& GetTransferTable() const;
#endif

protected:
  vtkSwellSpectralMap();
  ~vtkSwellSpectralMap() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Shape = JONSWAP;
  double SignificantHeight = 2.0;
  double PeakPeriod = 10.0;
  double DirectionFrom = 270.0;
  double Spread = 25.0;
  double Peakedness = 3.3;
  double Wind = 0.0;
  double Fetch = 0.0;
  char* BoundaryFileName = nullptr;
  int NumberOfFrequencies = 20;
  double FrequencyRange[2] = { 0.0, 0.0 };
  int NumberOfDirections = 36;
  int RaysPerDirection = 1;
  double Tolerance = 1e-5;
  int BreakingRule = GAMMA_BREAKING;
  double Gamma = 0.0;
  double Friction = 0.0;
  double OffshoreDepth = std::numeric_limits<double>::infinity();
  double Gravity = 9.81;
  double WaterLevel = 0.0;
  int Edge = EDGE_CONTOURS;
  double ShoreNormal = 0.0;
  bool UseShoreNormal = false;
  char* Current = nullptr;
  bool KeepSpectra = false;
  char* TransferFileName = nullptr;
  bool KeepTransfer = false;

private:
  vtkSwellSpectralMap(const vtkSwellSpectralMap&) = delete;
  void operator=(const vtkSwellSpectralMap&) = delete;

  std::unique_ptr<swellray::SeafloorField> Seafloor;
  std::unique_ptr<swellray::CurrentField> Water;
  std::unique_ptr<std::vector<swellray::DirectionalSpectrum>> Spectra;
  std::unique_ptr<swellray::TransferTable> Transfer;
};

#endif
