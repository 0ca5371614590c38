#include "vtkSwellCrests.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "ObstacleSource.h"
#include "RayArrays.h"
#include "sim/Crests.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSwellCrests);

namespace
{

// Rays that have drifted this far apart, in a shadow or where none is inserted, tell nothing of what is between.
constexpr double GapOverMaxSpacing = 2.0;

using swellray::RayPlace;

bool isOneOf(const char* name, std::initializer_list<const char*> names)
{
  return std::any_of(names.begin(), names.end(), [=](const char* other) { return std::strcmp(name, other) == 0; });
}

double between(double a, double b, double weight)
{
  // A neighbour without weight must not spread its NaN or infinity.
  return weight == 0.0 ? a : weight == 1.0 ? b : a + weight * (b - a);
}

// Degrees in [lowest, lowest + 360), the short way round where they jump.
double angleBetween(double a, double b, double weight, double lowest)
{
  if (!(std::abs(b - a) > 180.0))
  {
    return between(a, b, weight);
  }
  const double value = between(a, b > a ? b - 360.0 : b + 360.0, weight);
  return value < lowest ? value + 360.0 : value >= lowest + 360.0 ? value - 360.0 : value;
}

template <typename Value>
void normalize(Value* vector)
{
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  if (length > 0.0)
  {
    std::transform(vector, vector + 3, vector, [=](Value component) { return static_cast<Value>(component / length); });
  }
}

template <typename Array>
void interpolate(Array* from, Array* to, const std::vector<RayPlace>& places)
{
  using Value = typename Array::ValueType;
  const int components = from->GetNumberOfComponents();
  const char* name = from->GetName() ? from->GetName() : "";
  const bool nautical = std::strcmp(name, "DirectionFrom") == 0;
  const bool angle = nautical || std::strcmp(name, "Longitude") == 0;
  const double lowest = nautical ? 0.0 : -180.0;
  const bool unit = components == 3 && isOneOf(name, { "Direction", "RayDirection" });
  const Value* values = from->GetPointer(0);
  Value* result = to->GetPointer(0);
  swellray::parallelFor(places.size(),
    [=, &places](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Value* first = values + places[i].point * components;
        const Value* second = places[i].weight == 0.0 ? first : first + components;
        Value* target = result + i * components;
        for (int c = 0; c < components; ++c)
        {
          target[c] = static_cast<Value>(angle ? angleBetween(first[c], second[c], places[i].weight, lowest)
                                               : between(first[c], second[c], places[i].weight));
        }
        if (unit)
        {
          normalize(target);
        }
      }
    });
}

void takeNearest(vtkDataArray* from, vtkDataArray* to, const std::vector<RayPlace>& places)
{
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    to->SetTuple(static_cast<vtkIdType>(i), places[i].point + (places[i].weight > 0.5 ? 1 : 0), from);
  }
}

void carryOver(vtkDataArray* from, vtkDataArray* to, const std::vector<RayPlace>& places)
{
  to->SetName(from->GetName());
  to->SetNumberOfComponents(from->GetNumberOfComponents());
  to->SetNumberOfTuples(static_cast<vtkIdType>(places.size()));
  if (auto* doubles = vtkDoubleArray::FastDownCast(from))
  {
    interpolate(doubles, vtkDoubleArray::FastDownCast(to), places);
  }
  else if (auto* floats = vtkFloatArray::FastDownCast(from))
  {
    interpolate(floats, vtkFloatArray::FastDownCast(to), places);
  }
  else
  {
    takeNearest(from, to, places);
  }
}

int everyCrest(int every, vtkPolyData* rays)
{
  const double stepsPerWave = swellray::fieldValue(rays, "StepsPerWave").value_or(1.0);
  const bool onFronts = every == 0 && stepsPerWave > 0.0 && stepsPerWave < 1.0;
  return onFronts ? static_cast<int>(std::lround(1.0 / stepsPerWave)) : (every == 0 ? 1 : every);
}

}

int vtkSwellCrests::RequestData(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    if (!(this->MaxGap >= 0.0))
    {
      throw std::invalid_argument("MaxGap is " + std::to_string(this->MaxGap) + "; it must be 0 (no limit) or more");
    }
    const double maxGap =
      this->MaxGapOfRays ? GapOverMaxSpacing * swellray::fieldValue(input, "MaxSpacing").value_or(0.0) : this->MaxGap;
    const std::vector<std::int64_t> offsets = swellray::rayOffsets(input);
    const auto rays = static_cast<vtkIdType>(offsets.size() - 1);
    const vtkIdType points = input->GetNumberOfPoints();
    const auto phase = swellray::requireDoubles(input->GetPointData(), "Phase", points);
    const auto parameter = swellray::requireDoubles(input->GetCellData(), "LaunchParameter", rays);
    const auto segment = swellray::requireIntegers(input->GetCellData(), "LaunchSegment", rays);

    vtkSmartPointer<vtkDataArray> positions = points > 0 ? input->GetPoints()->GetData() : nullptr;
    if (points > 0 && !vtkDoubleArray::FastDownCast(positions))
    {
      auto copy = vtkSmartPointer<vtkDoubleArray>::New();
      copy->DeepCopy(positions);
      positions = copy;
    }
    swellray::RayLines lines;
    lines.rays = static_cast<std::size_t>(rays);
    lines.offsets = offsets.data();
    lines.positions = points > 0 ? vtkDoubleArray::FastDownCast(positions)->GetPointer(0) : nullptr;
    lines.phase = phase->GetPointer(0);
    const auto scale = swellray::mapScaleOf(input);
    lines.scale = scale ? scale->GetPointer(0) : nullptr;
    lines.launchParameter = parameter->GetPointer(0);
    lines.launchSegment = segment->GetPointer(0);
    const std::shared_ptr<const swellray::Obstacles> obstacles = swellray::obstaclesOf(input);
    const swellray::CrestLines crests =
      swellray::extractCrests(lines, maxGap, everyCrest(this->Every, input), obstacles.get());
    this->UpdateProgress(0.5);

    vtkNew<vtkPoints> crestPoints;
    crestPoints->SetDataTypeToDouble();
    if (points > 0)
    {
      carryOver(positions, crestPoints->GetData(), crests.places);
    }
    output->SetPoints(crestPoints);

    output->SetLines(swellray::linesInOrder(crests.offsets));

    int* number = swellray::addArray<vtkIntArray>(
      output->GetCellData(), "CrestNumber", static_cast<vtkIdType>(crests.number.size()));
    std::transform(
      crests.number.begin(), crests.number.end(), number, [](std::int64_t n) { return static_cast<int>(n); });

    vtkPointData* in = input->GetPointData();
    for (int i = 0; i < in->GetNumberOfArrays() && !this->GetAbortExecute(); ++i)
    {
      if (vtkDataArray* from = in->GetArray(i))
      {
        const auto to = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
        carryOver(from, to, crests.places);
        output->GetPointData()->AddArray(to);
      }
      this->UpdateProgress(0.5 + 0.5 * (i + 1) / in->GetNumberOfArrays());
    }
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellCrests::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaxGap: " << this->MaxGap << "\n";
  os << indent << "MaxGapOfRays: " << (this->MaxGapOfRays ? "on" : "off") << "\n";
  os << indent << "Every: " << this->Every << "\n";
}
