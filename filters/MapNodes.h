#ifndef MapNodes_h
#define MapNodes_h

#include "sim/RayMap.h"
#include "sim/Seafloor.h"

class vtkImageData;
class vtkInformation;

namespace swellray
{

/**
 * Say what nodes a map over a seafloor has: those of the seafloor, or some this far apart over its extent.
 * @param spacing m; 0: that of the seafloor
 * @throws std::invalid_argument on a bad spacing, or one that gives more than 100000 nodes a side
 */
void setMapNodes(vtkInformation* seafloor, vtkInformation* map, double spacing);

/** Give the image the nodes that its information says. */
MapGrid makeMapNodes(vtkInformation* info, vtkImageData* map);

/** Add Elevation and Depth (NaN in a hole) to the point arrays; returns the depths. */
const double* addMapDepths(vtkImageData* map, const MapGrid& grid, const Seafloor& seafloor, double waterLevel);

}

#endif
