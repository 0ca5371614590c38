#ifndef RayArrays_h
#define RayArrays_h

#include "sim/IncidentWave.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkCellArray;
class vtkPolyData;

namespace swellray
{

/** Add an array of n tuples, not set, replacing one of that name; returns its values. */
template <typename Array>
auto* addArray(vtkFieldData* attributes, const char* name, vtkIdType n, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(n);
  attributes->AddArray(array);
  return array->GetPointer(0);
}

/**
 * Array of numbers of this name as doubles; shared, not copied, where it holds doubles.
 * @throws std::invalid_argument where there is none with n tuples of so many components
 */
vtkSmartPointer<vtkDoubleArray> requireDoubles(
  vtkFieldData* attributes, const char* name, vtkIdType n, int components = 1);

/** The same, one a tuple, as integers. */
vtkSmartPointer<vtkIntArray> requireIntegers(vtkFieldData* attributes, const char* name, vtkIdType n);

/** The same, one a tuple, as bytes. */
vtkSmartPointer<vtkUnsignedCharArray> requireBytes(vtkFieldData* attributes, const char* name, vtkIdType n);

/**
 * The wave that was traced, from the field data of the rays.
 * @throws std::invalid_argument where one is missing
 */
IncidentWave tracedWave(vtkPolyData* rays);

/** Length over true length of the map on which the points lie, the array MapScale; null on a plane, which has none. */
vtkSmartPointer<vtkDoubleArray> mapScaleOf(vtkPolyData* rays);

/** Positions of the points as doubles, x, y, z a point; shared, not copied, where they are doubles. */
vtkSmartPointer<vtkDoubleArray> positionsOf(vtkPolyData* rays);

/**
 * Where each ray begins among the points: rays + 1 entries.
 * @throws std::invalid_argument where the cells are not lines over the points in their order
 */
std::vector<std::int64_t> rayOffsets(vtkPolyData* rays);

/** Lines over the points in their order: line i has the points offsets[i] to offsets[i + 1] - 1. */
vtkSmartPointer<vtkCellArray> linesInOrder(const std::vector<std::size_t>& offsets);

}

#endif
