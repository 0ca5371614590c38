#pragma once

#include "Refinement.h"
#include "WaveControls.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkSwellCrests.h>
#include <vtkSwellFoam.h>
#include <vtkSwellRayTracer.h>
#include <vtkSwellStations.h>
#include <vtkSwellSurface.h>
#include <vtkSwellWaveHeight.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

class vtkImageData;
class vtkPolyData;

namespace swellray::view
{

/** Rays of one setting of the controls. */
struct TracedWaves
{
  WaveControls controls;
  int coarseness = 1;                ///< 1: the finest
  double seconds = 0.0;              ///< that tracing took
  vtkSmartPointer<vtkPolyData> rays; ///< with heights; null where there are none
  vtkSmartPointer<vtkPolyData> crests;
  std::string failure; ///< why there are none, in a line
};

/** The sea surface at a time. */
struct SurfaceFrame
{
  double time = 0.0;                    ///< s
  vtkSmartPointer<vtkPolyData> surface; ///< with Foam; null where there is none
  std::string failure;
};

/** The waves at a place. Values that are not known there are NaN. */
struct WavesAt
{
  double x = 0.0; ///< m
  double y = 0.0;
  double elevation = 0.0;     ///< m
  double depth = 0.0;         ///< m
  double height = 0.0;        ///< m
  double directionFrom = 0.0; ///< nautical degrees
  double period = 0.0;        ///< s
  double wavelength = 0.0;    ///< m
  vtkIdType ray = -1;         ///< cell of the ray that came nearest; -1: none came
  double refraction = 0.0;    ///< of that ray there: coefficients
  double shoaling = 0.0;
  double travelTime = 0.0; ///< from the edge of the scene, s
};

/**
 * The waves that a window shows, without the window: what is traced, kept and refined.
 *
 * All work is done by one thread of its own, which uses the filters and their threads. Of the controls that are set it
 * traces the latest: coarsely first, so that a trace is done within a frame, then finer, and gives up at once when
 * others are set. The finest rays of recent settings are kept. Results wait until poll() takes them over.
 */
class WaveModel
{
public:
  /** How the filters are set up, but for what the controls and the refinement set. */
  struct Setup
  {
    vtkImageData* seafloor = nullptr; ///< point array Elevation, m
    std::function<void(vtkSwellRayTracer*)> tracer;
    std::function<void(vtkSwellWaveHeight*)> heights;
    std::function<void(vtkSwellSurface*, vtkSwellFoam*)> surface;
    double frame = 1.0 / 60.0;             ///< time for a first trace, s
    vtkIdType mostSurfacePoints = 1500000; ///< a larger sea surface is not made
  };

  explicit WaveModel(const Setup& setup);
  ~WaveModel();
  WaveModel(const WaveModel&) = delete;
  WaveModel& operator=(const WaveModel&) = delete;

  /** Show the waves of these controls. */
  void setControls(const WaveControls& controls);
  const WaveControls& controls() const { return this->Controls; }

  /** Make the sea surface at a time, s, of the finest rays; asked again before it is begun, the later time counts. */
  void requestSurface(double time);

  /** Tell the waves at a place, m, of the rays that are there then. */
  void requestWavesAt(double x, double y);

  /** What a poll brought. */
  struct News
  {
    bool waves = false;
    bool surface = false;
    bool wavesAt = false;
    explicit operator bool() const { return this->waves || this->surface || this->wavesAt; }
  };

  /** Take over what is done. */
  News poll();

  const TracedWaves& waves() const { return this->Waves; }
  const SurfaceFrame& surface() const { return this->Surface; }
  const std::optional<WavesAt>& wavesAt() const { return this->Place; }

  /** The waves of the latest controls are there, and as fine as they get. */
  bool isRefined() const;

private:
  struct Wanted
  {
    WaveControls controls;
    std::optional<double> surface;
    std::optional<std::pair<double, double>> place;
  };

  void work();
  bool isOutdated() const; // what is being made is needed no longer
  bool isWaiting() const;
  // What the thread does.
  TracedWaves trace(const WaveControls& controls, int coarseness);
  void publish(const TracedWaves& waves);
  void keep(const TracedWaves& waves);
  const TracedWaves* kept(const WaveControls& controls) const;
  SurfaceFrame makeSurface(const TracedWaves& waves, double time);
  WavesAt lookUp(const TracedWaves& waves, double x, double y);
  std::string run(vtkAlgorithm* filter);

  // Of the window's thread.
  WaveControls Controls;
  TracedWaves Waves;
  SurfaceFrame Surface;
  std::optional<WavesAt> Place;

  // Between the threads.
  mutable std::mutex Mutex;
  std::condition_variable Call;
  std::atomic<unsigned> Generation{ 0 }; // of the controls
  std::atomic<bool> Stopped{ false };
  Wanted Asked;
  std::optional<TracedWaves> DoneWaves;
  std::optional<SurfaceFrame> DoneSurface;
  std::optional<WavesAt> DonePlace;

  // Of the working thread.
  vtkNew<vtkImageData> Seafloor;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellCrests> Crests;
  vtkNew<vtkSwellSurface> Sea;
  vtkNew<vtkSwellFoam> Foam;
  vtkNew<vtkSwellStations> Stations;
  vtkIdType MostSurfacePoints;
  Refinement Steps;
  double FinestSpacing = 0.0; // of rays, m
  double FinestFronts = 0.0;  // a wavelength
  std::optional<double> SetSpacing;
  double Tolerance = 0.0;
  unsigned TracedGeneration = 0;
  bool GivesUp = true; // what is being made, when other controls are set
  TracedWaves Current;
  std::list<TracedWaves> Kept; // the latest first

  std::thread Worker;
};

}
