#pragma once

#include "Console.h"
#include "FilterSettings.h"
#include "RayPlan.h"
#include "Request.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkSwellBreakerLine.h>
#include <vtkSwellContours.h>
#include <vtkSwellCrests.h>
#include <vtkSwellFoam.h>
#include <vtkSwellFoamMap.h>
#include <vtkSwellProjectedGrid.h>
#include <vtkSwellRayTracer.h>
#include <vtkSwellSeafloorReader.h>
#include <vtkSwellSpray.h>
#include <vtkSwellSurface.h>
#include <vtkSwellSurfaceProbe.h>
#include <vtkSwellWaveHeight.h>
#include <vtkTrivialProducer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkImageData;
class vtkPolyData;

namespace swellray::cli
{

/** The filters that one call needs, set up from its request. Each is run by the step that asks for its output. */
class Pipeline
{
public:
  Pipeline(const Request& request, Console& console);

  /** What a user should know about the seafloor: said at once, or left to the caller. */
  enum class Notes
  {
    Say,
    Keep
  };

  /** @throws WorkError; UsageError where the call is wrong about the seafloor */
  vtkSwellSeafloorReader* readSeafloor(Notes notes = Notes::Say);

  vtkPolyData* makeContours(double waterLevel);

  /** Trace at this water level from now on, m. */
  void setWaterLevel(double level);

  /**
   * What traceRays() and computeHeights() will take. To be called before them or not at all; surface, foam and spray are then
   * those of the rays that told it. @throws WorkError
   */
  RayPlan planRays();

  /** Trace, without heights. @throws WorkError */
  vtkPolyData* traceRays();

  /** Heights on the rays that were traced. @throws WorkError */
  vtkPolyData* computeHeights();

  /** Crests of these rays, or of those traced, broken where neighbours are far apart. @throws WorkError */
  vtkPolyData* makeCrests(vtkPolyData* rays = nullptr);

  /** Lines where the waves of the rays that were traced begin to break. @throws WorkError */
  vtkPolyData* makeBreakerLines();

  /** Make surface, foam and spray of another's waves, whose heights there are; on a thread of its own where wanted. */
  void shareWaves(const Pipeline& other);

  /** Breaking-wave surface with foam over the rays that were traced, at a time, s. @throws WorkError */
  vtkPolyData* makeSurface(double time);

  /** Let a camera sample the surface from now on: every `step` pixels of a picture. */
  void seeBy(const scene::SceneCamera& camera, const std::array<int, 2>& size, int step);

  /** That surface at a time, s. @throws WorkError */
  vtkPolyData* makeSeenSurface(double time);

  /** Foam of the same waves on a grid of still water at a time, s. @throws WorkError */
  vtkImageData* makeFoamMap(double time);

  /** Vertical section of the surface from now on, NAME:key=value,... */
  void setProfile(const std::string& profile);

  /** Points a wavelength of the surface from now on, 16 or more; 0: as many as the section asks for. */
  void setPointsPerWave(double points);

  /** Particles a metre of crest and metre by which its water is ahead, and how their velocities scatter, from now on. */
  void setSpray(double rate, std::optional<double> scatter = {});

  /** Spray at a time, s, over the same rays. @throws WorkError */
  vtkPolyData* makeSpray(double time);

  /** The same surface at points with the array Time. @throws WorkError */
  vtkPolyData* probeSurface(vtkPolyData* points);

private:
  // Another wave of the sea.
  struct Component
  {
    vtkNew<vtkSwellRayTracer> tracer;
    vtkNew<vtkSwellWaveHeight> heights;
  };

  void takeLaunch();
  std::vector<vtkAlgorithmOutput*> wavePorts() const;
  vtkAlgorithmOutput* seafloorPort() const;
  void connectWaves(vtkAlgorithm* filter);

  const Request& Asked;
  Console& Screen;
  vtkNew<vtkSwellSeafloorReader> Reader;
  vtkNew<vtkSwellContours> Contours;
  vtkNew<vtkSwellRayTracer> Tracer;
  vtkNew<vtkSwellWaveHeight> Heights;
  vtkNew<vtkSwellCrests> Crests;
  vtkNew<vtkSwellBreakerLine> Breakers;
  vtkNew<vtkSwellSurface> Surface;
  vtkNew<vtkSwellFoam> Foam;
  vtkNew<vtkSwellFoamMap> FoamMap;
  vtkNew<vtkSwellProjectedGrid> Seen;
  vtkNew<vtkSwellSpray> Spray;
  vtkNew<vtkSwellSurfaceProbe> Probe;
  std::vector<std::unique_ptr<Component>> Components;
  std::vector<vtkSmartPointer<vtkTrivialProducer>> Shared; // seafloor and waves of another; empty: they are its own
};

/** Files that a call must not write over: the seafloor, where it is a file, and those drawn. */
std::vector<std::string> inputFiles(const Request& request);

}
