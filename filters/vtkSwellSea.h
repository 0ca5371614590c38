#ifndef vtkSwellSea_h
#define vtkSwellSea_h

#include "swellrayFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <limits> // for the default of Depth
#include <memory> // for the surface

namespace swellray
{
class SeaSurface;
}
class vtkImageData;
class vtkSwellSeaFunction;

/**
 * @class   vtkSwellSea
 * @brief   the surface of a sea away from the shore, in motion
 *
 * Wraps swellray::SeaSurface (Thon, Dischler and Ghazanfarpour 2000; equations there): trochoids of the waves of greatest
 * amplitude, and turbulence for the shorter ones, of a spectrum given by height and period, or by a wind.
 *
 * Output 0: vtkPolyData, the patch as triangles, points displaced in z, facets wound so that they look up, with the point
 * arrays
 * - SurfaceHeight (double, m above the mean level; the scalars)
 * - Normals (3 floats), TextureCoordinates (2 floats, 0 to 1 over the patch)
 *
 * Output 1: vtkImageData, ImagePixels x ImagePixels points in the middles of their pixels, with the point arrays
 * - SurfaceHeight (float, m; the scalars), Normals (3 floats); empty where ImagePixels is 0
 *
 * Both as field data: Time (s), Seed, Size (m), SignificantWaveHeight (m), PeakPeriod (s), HighestFrequency (Hz, fmax of the
 * trochoids), TurbulenceMultiplier, TurbulenceAmplitude (m), SwellrayVersion. Waves that the spacing of points does not
 * resolve are left out. Times of the pipeline (UPDATE_TIME_STEP) go before Time; TIME_STEPS are those of TimeRange and TimeStep.
 *
 * GetFunction() is the same surface as an implicit function, after an update.
 */
class SWELLRAYFILTERS_EXPORT vtkSwellSea : public vtkPolyDataAlgorithm
{
public:
  static vtkSwellSea* New();
  vtkTypeMacro(vtkSwellSea, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    PIERSON_MOSKOWITZ = 0,
    JONSWAP = 1,
    TMA = 2
  };

  enum Spreadings
  {
    HASSELMANN = 0,
    THON = 1,
    COSINE_POWER = 2,
    WRAPPED_NORMAL = 3
  };

  ///@{
  /** Shape of the spectrum; default JONSWAP. TMA needs a Depth. */
  vtkSetClampMacro(Shape, int, PIERSON_MOSKOWITZ, TMA);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /** Significant wave height Hs, m; > 0, default 2. */
  vtkSetMacro(SignificantHeight, double);
  vtkGetMacro(SignificantHeight, double);
  ///@}

  ///@{
  /** Peak period Tp, s; > 0, default 8. */
  vtkSetMacro(PeakPeriod, double);
  vtkGetMacro(PeakPeriod, double);
  ///@}

  ///@{
  /** Mean direction the sea comes from, nautical degrees; default 270. */
  vtkSetMacro(DirectionFrom, double);
  vtkGetMacro(DirectionFrom, double);
  ///@}

  ///@{
  /** How directions spread: after Hasselmann et al. 1980 (default), as printed in 2000, or by Spread. */
  vtkSetClampMacro(Spreading, int, HASSELMANN, WRAPPED_NORMAL);
  vtkGetMacro(Spreading, int);
  ///@}

  ///@{
  /** Circular standard deviation of the directions, degrees; 1 to 80, default 25; of COSINE_POWER and WRAPPED_NORMAL. */
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
  /** Depth, the same everywhere, m; > 0, default infinity, for which 0 stands too. */
  vtkSetMacro(Depth, double);
  vtkGetMacro(Depth, double);
  ///@}

  ///@{
  /** Acceleration of gravity, m/s2; > 0, default 9.81. */
  vtkSetMacro(Gravity, double);
  vtkGetMacro(Gravity, double);
  ///@}

  ///@{
  /** Number of trochoids, 1 to 4096; default 256. */
  vtkSetMacro(Components, int);
  vtkGetMacro(Components, int);
  ///@}

  ///@{
  /** Factor on the steepness that shapes the trochoids; >= 0, default 1; 0: cosines. */
  vtkSetMacro(Sharpness, double);
  vtkGetMacro(Sharpness, double);
  ///@}

  ///@{
  /** Add turbulence; default on. */
  vtkSetMacro(Turbulence, bool);
  vtkGetMacro(Turbulence, bool);
  vtkBooleanMacro(Turbulence, bool);
  ///@}

  ///@{
  /** The surface repeats over squares of the side Size; default off. */
  vtkSetMacro(Tile, bool);
  vtkGetMacro(Tile, bool);
  vtkBooleanMacro(Tile, bool);
  ///@}

  ///@{
  /** South-west corner of the patch, m; default 0, 0. */
  vtkSetVector2Macro(Corner, double);
  vtkGetVector2Macro(Corner, double);
  ///@}

  ///@{
  /** Side of the patch, m; > 0, default 200. */
  vtkSetMacro(Size, double);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /** Distance of the points of the mesh, m; > 0 to Size; default 0: a 256th of Size. */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /** Pixels a side of the image; 0 (default, no image) or 2 to 8192. */
  vtkSetMacro(ImagePixels, int);
  vtkGetMacro(ImagePixels, int);
  ///@}

  ///@{
  /** Time, s, where the pipeline asks for none; default 0. */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /** First and last of the times that the output offers, s; default 0 to 60. */
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

  ///@{
  /** Distance of these times, s; > 0, default 0.5. */
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /** What is random is drawn from this; default 1. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  /** The surface as an implicit function, of the last update and at its time. */
  vtkSwellSeaFunction* GetFunction() { return this->Function; }

protected:
  vtkSwellSea();
  ~vtkSwellSea() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Shape = JONSWAP;
  double SignificantHeight = 2.0;
  double PeakPeriod = 8.0;
  double DirectionFrom = 270.0;
  int Spreading = HASSELMANN;
  double Spread = 25.0;
  double Peakedness = 3.3;
  double Wind = 0.0;
  double Fetch = 0.0;
  double Depth = std::numeric_limits<double>::infinity();
  double Gravity = 9.81;
  int Components = 256;
  double Sharpness = 1.0;
  bool Turbulence = true;
  bool Tile = false;
  double Corner[2] = { 0.0, 0.0 };
  double Size = 200.0;
  double Spacing = 0.0;
  int ImagePixels = 0;
  double Time = 0.0;
  double TimeRange[2] = { 0.0, 60.0 };
  double TimeStep = 0.5;
  int Seed = 1;

private:
  vtkSwellSea(const vtkSwellSea&) = delete;
  void operator=(const vtkSwellSea&) = delete;

  std::shared_ptr<const swellray::SeaSurface> makeSurface() const;
  void makeMesh(vtkPolyData* mesh, double time);
  void makeImage(vtkImageData* image, double time);

  std::shared_ptr<const swellray::SeaSurface> Surface;
  vtkMTimeType SurfaceTime = 0;
  vtkSwellSeaFunction* Function;
};

#endif
