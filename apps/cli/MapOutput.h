#pragma once

#include "OutputFile.h"
#include "Request.h"

class vtkImageData;
class vtkPolyData;

namespace swellray::cli
{

class Console;

/**
 * Make a map of rays with heights and write it to the file's hidden name: .vti, .nc or .tif by its ending.
 * @throws WorkError
 */
void writeMap(
  vtkPolyData* rays, vtkImageData* seafloor, const OutputFile& file, const Request& request, Console& console);

}
