#include "RayArrays.h"

#include "FieldData.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace swellray
{

namespace
{

template <typename Array>
vtkSmartPointer<Array> require(vtkFieldData* attributes, const char* name, vtkIdType n, int components = 1)
{
  vtkDataArray* found = attributes->GetArray(name);
  if (!found || found->GetNumberOfComponents() != components || found->GetNumberOfTuples() != n)
  {
    throw std::invalid_argument(std::string("the input has no array ") + name + " of " +
      (components == 1 ? "one component" : "three components") + "; give it the output of vtkSwellRayTracer");
  }
  if (Array* typed = Array::SafeDownCast(found))
  {
    return typed;
  }
  vtkSmartPointer<Array> copy = vtkSmartPointer<Array>::New();
  copy->DeepCopy(found);
  return copy;
}

}

vtkSmartPointer<vtkDoubleArray> requireDoubles(vtkFieldData* attributes, const char* name, vtkIdType n, int components)
{
  return require<vtkDoubleArray>(attributes, name, n, components);
}

vtkSmartPointer<vtkIntArray> requireIntegers(vtkFieldData* attributes, const char* name, vtkIdType n)
{
  return require<vtkIntArray>(attributes, name, n);
}

vtkSmartPointer<vtkUnsignedCharArray> requireBytes(vtkFieldData* attributes, const char* name, vtkIdType n)
{
  return require<vtkUnsignedCharArray>(attributes, name, n);
}

IncidentWave tracedWave(vtkPolyData* rays)
{
  const char* tracer = "vtkSwellRayTracer";
  IncidentWave wave;
  wave.period = requireFieldValue(rays, "Period", tracer);
  wave.directionFrom = requireFieldValue(rays, "DirectionFrom", tracer);
  wave.height = requireFieldValue(rays, "WaveHeight", tracer);
  wave.offshoreDepth = requireFieldValue(rays, "OffshoreDepth", tracer);
  wave.gravity = requireFieldValue(rays, "Gravity", tracer);
  return wave;
}

vtkSmartPointer<vtkDoubleArray> mapScaleOf(vtkPolyData* rays)
{
  vtkPointData* in = rays->GetPointData();
  return in->HasArray("MapScale") != 0 ? requireDoubles(in, "MapScale", rays->GetNumberOfPoints()) : nullptr;
}

vtkSmartPointer<vtkDoubleArray> positionsOf(vtkPolyData* rays)
{
  vtkDataArray* data = rays->GetPoints() ? rays->GetPoints()->GetData() : nullptr;
  if (auto* doubles = vtkDoubleArray::SafeDownCast(data))
  {
    return doubles;
  }
  auto copy = vtkSmartPointer<vtkDoubleArray>::New();
  copy->SetNumberOfComponents(3);
  if (data)
  {
    copy->DeepCopy(data);
  }
  return copy;
}

std::vector<std::int64_t> rayOffsets(vtkPolyData* rays)
{
  vtkCellArray* lines = rays->GetLines();
  const vtkIdType count = lines->GetNumberOfCells();
  std::vector<std::int64_t> offsets{ 0 };
  offsets.reserve(static_cast<std::size_t>(count) + 1);
  bool inOrder = rays->GetNumberOfCells() == count;
  vtkIdType next = 0;
  for (vtkIdType ray = 0; ray < count && inOrder; ++ray)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCellAtId(ray, size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      inOrder = inOrder && points[i] == next++;
    }
    offsets.push_back(next);
  }
  if (!inOrder || next != rays->GetNumberOfPoints())
  {
    throw std::invalid_argument(
      "the cells of the input are not rays (lines over all points in their order); give it the output of "
      "vtkSwellRayTracer");
  }
  return offsets;
}

vtkSmartPointer<vtkCellArray> linesInOrder(const std::vector<std::size_t>& offsets)
{
  vtkNew<vtkTypeInt64Array> begins;
  begins->SetNumberOfValues(static_cast<vtkIdType>(offsets.size()));
  std::copy(offsets.begin(), offsets.end(), begins->GetPointer(0));
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(offsets.back()));
  std::iota(connectivity->GetPointer(0), connectivity->GetPointer(0) + offsets.back(), vtkTypeInt64(0));
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  lines->SetData(begins, connectivity);
  return lines;
}

}
