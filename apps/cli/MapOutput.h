#pragma once

#include "OutputFile.h"
#include "Request.h"

class vtkImageData;

namespace swellray::cli
{

class Console;

/**
 * Write a map to the file's hidden name: .vti, .nc or .tif by its ending; the latter two with the arrays that are known
 * quantities.
 * @throws WorkError
 */
void writeMap(vtkImageData* map, const OutputFile& file, const Request& request, Console& console);

}
