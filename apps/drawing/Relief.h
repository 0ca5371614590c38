#pragma once

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkPolyData;

namespace swellray::drawing
{

/**
 * The seafloor as a surface: quadrilaterals with normals and the point array Elevation (m); none where there are no data.
 * @param seafloor point array Elevation, m
 * @param mostNodes nodes are left out evenly until there are no more than this
 */
vtkSmartPointer<vtkPolyData> reliefOf(vtkImageData* seafloor, vtkIdType mostNodes);

/**
 * How many times heights are to be exaggerated for relief to be seen: 1, 2, 5, 10, ...
 * @param width of the scene, m
 * @param relief highest less lowest elevation, m
 */
double exaggerationFor(double width, double relief);

}
