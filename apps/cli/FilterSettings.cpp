#include "FilterSettings.h"

#include <vtkSwellFoam.h>
#include <vtkSwellFoamMap.h>
#include <vtkSwellProjectedGrid.h>
#include <vtkSwellRayTracer.h>
#include <vtkSwellSeafloorReader.h>
#include <vtkSwellSpray.h>
#include <vtkSwellSurface.h>
#include <vtkSwellSurfaceProbe.h>
#include <vtkSwellWaveHeight.h>

namespace swellray::cli
{

namespace
{

int edgeOf(EdgeRule rule)
{
  switch (rule)
  {
  case EdgeRule::Edge:
    return vtkSwellRayTracer::EDGE_EDGE;
  case EdgeRule::None:
    return vtkSwellRayTracer::EDGE_NONE;
  default:
    return vtkSwellRayTracer::EDGE_CONTOURS;
  }
}

int insertionOf(InsertionRule rule)
{
  switch (rule)
  {
  case InsertionRule::None:
    return vtkSwellRayTracer::INSERT_NONE;
  case InsertionRule::Interpolate:
    return vtkSwellRayTracer::INSERT_INTERPOLATE;
  default:
    return vtkSwellRayTracer::INSERT_RETRACE;
  }
}

}

void setUp(vtkSwellSeafloorReader* reader, const SeafloorRequest& seafloor)
{
  const SeafloorOptions& options = seafloor.options;
  reader->SetFileName(seafloor.source.c_str());
  reader->SetWaterLevel(options.waterLevel);
  reader->SetPositive(options.positive == Positive::Up ? vtkSwellSeafloorReader::UP
      : options.positive == Positive::Down             ? vtkSwellSeafloorReader::DOWN
                                                       : vtkSwellSeafloorReader::AUTO);
  reader->SetEarth(
    options.earth == EarthModel::Ellipsoid ? vtkSwellSeafloorReader::ELLIPSOID : vtkSwellSeafloorReader::PLANE);
  reader->SetCRS(options.crs.empty() ? nullptr : options.crs.c_str());
  reader->SetVariable(options.variable.empty() ? nullptr : options.variable.c_str());
  reader->SetSmooth(options.smooth);
  if (options.crop)
  {
    const auto& crop = *options.crop;
    reader->UseCropOn();
    reader->SetCrop(crop[0], crop[1], crop[2], crop[3]);
  }
  if (options.resample)
  {
    reader->SetResample(*options.resample);
  }
  if (options.nodata)
  {
    reader->UseNoDataOn();
    reader->SetNoData(*options.nodata);
  }
  if (options.maxGap)
  {
    reader->SetMaxGap(*options.maxGap);
  }
  reader->SetDropOutliers(options.dropOutliers);
  reader->SetCrossValidate(options.crossValidate);
}

void setUp(vtkSwellRayTracer* tracer, const RayRequest& rays, double waterLevel)
{
  tracer->SetPeriod(rays.wave.period);
  tracer->SetDirectionFrom(rays.wave.directionFrom);
  tracer->SetSource(rays.source == RayRequest::Source::Storm ? vtkSwellRayTracer::STORM
      : rays.source == RayRequest::Source::Point             ? vtkSwellRayTracer::POINT
                                                             : vtkSwellRayTracer::PLANE_WAVE);
  tracer->SetSourcePosition(rays.sourcePosition[0], rays.sourcePosition[1]);
  tracer->SetWaveHeight(rays.wave.height);
  tracer->SetOffshoreDepth(rays.wave.offshoreDepth);
  tracer->SetGravity(rays.wave.gravity);
  tracer->SetWaterLevel(waterLevel);
  const TraceOptions& trace = rays.trace;
  tracer->SetSpacing(trace.spacing.value_or(0.0));
  tracer->SetMaxSpacing(trace.maxSpacing.value_or(0.0));
  tracer->SetStepsPerWave(trace.stepsPerWave.value_or(0.0));
  tracer->SetStep(trace.step.value_or(0.0));
  tracer->SetScheme(trace.scheme == TraceScheme::Snell ? vtkSwellRayTracer::SNELL : vtkSwellRayTracer::ODE);
  tracer->SetTolerance(trace.tolerance);
  tracer->SetInsertion(insertionOf(trace.insertion));
  tracer->SetLeeRays(trace.leeRays);
  if (trace.flatHeight)
  {
    tracer->SetFlatHeight(*trace.flatHeight);
  }
  tracer->SetAgroundDepth(trace.agroundDepth.value_or(0.0));
  tracer->SetEdge(edgeOf(trace.edge));
  if (trace.shoreNormal)
  {
    tracer->UseShoreNormalOn();
    tracer->SetShoreNormal(*trace.shoreNormal);
  }
  tracer->SetCurrent(rays.current.empty() ? nullptr : rays.current.c_str());
  tracer->SetObstacles(rays.obstacles.empty() ? nullptr : rays.obstacles.c_str());
  tracer->SetReflection(rays.reflection.value_or(0.0));
  if (rays.maxReflections)
  {
    tracer->SetMaximumReflections(*rays.maxReflections);
  }
  tracer->SetMaximumNumberOfRays(static_cast<vtkIdType>(trace.maxRays));
  tracer->SetMaximumNumberOfFronts(static_cast<vtkIdType>(trace.maxFronts));
}

void setUp(vtkSwellWaveHeight* heights, const HeightOptions& options)
{
  heights->SetAmplitudeRule(
    options.amplitude == AmplitudeRule::Tube ? vtkSwellWaveHeight::TUBE : vtkSwellWaveHeight::SPACING);
  heights->SetBreakingRule(static_cast<int>(options.breaking));
  heights->SetGamma(options.gamma.value_or(0.0));
  heights->SetFriction(options.friction);
  heights->SetViscosity(options.viscosity);
  heights->SetCausticRule(static_cast<int>(options.caustics));
  heights->SetMaxRefraction(options.maxRefraction);
}

namespace
{

// What everything that is made of the surface has.
void setFrame(vtkSwellSurfaceAlgorithm* filter, const SurfaceRequest& options)
{
  filter->SetSection(options.profile);
  filter->SetPointsPerWave(options.pointsPerWave.value_or(0.0));
  filter->SetSeed(options.seed);
  filter->SetGroupWaves(options.groupWaves.value_or(0.0));
  if (options.groupLull)
  {
    filter->SetGroupLull(*options.groupLull);
  }
}

}

void setUp(vtkSwellSurface* surface, const SurfaceRequest& options)
{
  setFrame(surface, options);
  surface->SetPhaseRule(options.straightPhase ? vtkSwellSurface::STRAIGHT : vtkSwellSurface::TRACED);
}

void setUp(vtkSwellSpray* spray, const SurfaceRequest& options)
{
  setFrame(spray, options);
  spray->SetSteepest(options.spraySteepness.value_or(0.0));
  if (options.sprayRate)
  {
    spray->SetRate(*options.sprayRate);
  }
}

void setUp(vtkSwellFoamMap* foam, const SurfaceRequest& options)
{
  setFrame(foam, options);
  foam->SetSpacing(options.foamSpacing.value_or(0.0));
  if (options.foamLife)
  {
    foam->SetFoamLife(*options.foamLife);
  }
}

void setUp(vtkSwellProjectedGrid* grid, const SurfaceRequest& options)
{
  setFrame(grid, options);
  if (options.foamLife)
  {
    grid->SetFoamLife(*options.foamLife);
  }
}

void setUp(vtkSwellSurfaceProbe* probe, const SurfaceRequest& options)
{
  setFrame(probe, options);
  if (options.foamLife)
  {
    probe->SetFoamLife(*options.foamLife);
  }
}

void setUp(vtkSwellFoam* foam, const SurfaceRequest& options)
{
  if (options.foamLife)
  {
    foam->SetLife(*options.foamLife);
  }
}

}
