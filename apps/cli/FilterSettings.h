#pragma once

#include "Request.h"

class vtkSwellFoam;
class vtkSwellFoamMap;
class vtkSwellProjectedGrid;
class vtkSwellRayTracer;
class vtkSwellSeafloorReader;
class vtkSwellSpray;
class vtkSwellSurface;
class vtkSwellSurfaceProbe;
class vtkSwellWaveHeight;

namespace swellray::cli
{

/** Set a filter up as the request asks. */
void setUp(vtkSwellSeafloorReader* reader, const SeafloorRequest& seafloor);
void setUp(vtkSwellRayTracer* tracer, const RayRequest& rays, double waterLevel);
void setUp(vtkSwellWaveHeight* heights, const HeightOptions& options);
void setUp(vtkSwellSurface* surface, const SurfaceRequest& options);
void setUp(vtkSwellSpray* spray, const SurfaceRequest& options);
void setUp(vtkSwellFoamMap* foam, const SurfaceRequest& options);
void setUp(vtkSwellProjectedGrid* grid, const SurfaceRequest& options);
void setUp(vtkSwellSurfaceProbe* probe, const SurfaceRequest& options);
void setUp(vtkSwellFoam* foam, const SurfaceRequest& options);

}
