#pragma once

#include "OutputFile.h"
#include "Request.h"
#include "StationTable.h"

class vtkDataObject;

namespace swellray::cli
{

class Console;
class Pipeline;

/**
 * Write the surface at the points of a file to the table's hidden name: at the times of their column, otherwise each point at
 * the time, or the times, of the request, after one another, with a column Time.
 * @param scene georeference of the points
 * @throws WorkError
 */
void writeSurfaceTable(Pipeline& pipeline, const StationTable& points, vtkDataObject* scene, const OutputFile& file,
  const Request& request, Console& console);

}
