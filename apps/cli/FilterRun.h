#pragma once

#include "Console.h"

#include <string>

class vtkAlgorithm;

namespace swellray::cli
{

/** Keep VTK from printing: what it has to say comes through runFilter(). */
void silenceVtk();

/**
 * Bring a filter up to date, showing its progress and passing its warnings on.
 * @throws WorkError with the first error that the filter reported
 */
void runFilter(vtkAlgorithm* filter, const std::string& task, Console& console);

}
