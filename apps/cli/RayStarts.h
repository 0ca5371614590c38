#pragma once

#include "Options.h"

#include "bathymetry/Georeference.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace swellray::cli
{

/** Lines or points where rays start, in place of the edges of the scene. */
OptionSpec launchOption(StartRequest& start);

/** The same, and a site from which they are followed back. */
std::vector<OptionSpec> startOptions(StartRequest& start);

/** @throws UsageError where these do not fit the rest of the request */
void checkStart(const Request& request);

/**
 * Launch lines (.geojson, .gpkg, .shp, ...) or launch points (.csv) in the plane of a scene, as vtkSwellRayTracer takes them.
 * @throws WorkError; UsageError where a direction is missing
 */
vtkSmartPointer<vtkPolyData> readLaunch(const Request& request, const Georeference& scene);

/** Rays followed back from a site, written to the output. @throws WorkError */
void runFromSite(const Request& request, Console& console);

/** How often each code occurs in a cell array, as "12 alive, 3 dead". */
std::string tally(vtkPolyData* rays, const char* name, const std::vector<std::string>& words);

/** What the codes of EndReason mean. */
const std::vector<std::string>& endReasonWords();

}
