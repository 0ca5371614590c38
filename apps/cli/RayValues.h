#pragma once

#include "Request.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace swellray::cli
{

class Console;

/** Map of rays with heights; how much of the water they reach is said. @throws WorkError */
vtkSmartPointer<vtkImageData> mapOfRays(
  vtkPolyData* rays, vtkImageData* seafloor, const Request& request, Console& console);

/** Columns of a table of them. */
const std::vector<std::string>& stationColumns();

/** The waves of rays with heights at these places. @throws WorkError */
vtkSmartPointer<vtkPolyData> wavesAt(
  vtkPolyData* places, vtkPolyData* rays, vtkImageData* seafloor, const Request& request, Console& console);

}
