#pragma once

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace swellray::scene
{

/** Rays that a scene shows at most; of more, every so many are taken. */
constexpr int MostRayLines = 300;

/**
 * Rays as lines over the water: some of them where there are many, and of their points as many as a bend needs.
 * @param rays poly-lines of vtkSwellRayTracer
 * @param height of the lines, m
 * @return lines alone, without arrays
 */
vtkSmartPointer<vtkPolyData> rayLines(vtkPolyData* rays, double height);

}
