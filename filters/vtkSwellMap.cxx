#include "vtkSwellMap.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RaySheetInput.h"
#include "SeafloorField.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSwellMap);

namespace
{

// More nodes a side are a mistake in the spacing.
constexpr double MostNodes = 100000.0;

int nodesOver(double length, double spacing)
{
  // A length that is whole spacings but for rounding keeps its last node.
  constexpr double rounding = 1e-9;
  const double nodes = std::floor(length / spacing + rounding) + 1.0;
  if (!(nodes <= MostNodes))
  {
    throw std::invalid_argument("a map of nodes " + std::to_string(spacing) + " m apart over " +
      std::to_string(length) + " m would have more than 100000 of them a side; choose a larger spacing");
  }
  return static_cast<int>(nodes);
}

}

vtkSwellMap::vtkSwellMap()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellMap::~vtkSwellMap() = default;

int vtkSwellMap::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkSwellMap::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* seafloor = inputVector[1]->GetInformationObject(0);
  vtkInformation* output = outputVector->GetInformationObject(0);
  try
  {
    if (!(this->Spacing >= 0.0) || std::isinf(this->Spacing))
    {
      throw std::invalid_argument(
        "Spacing is " + std::to_string(this->Spacing) + " m; it must be 0 (that of the seafloor) or more");
    }
    std::array<int, 6> extent{};
    std::array<double, 3> origin{};
    std::array<double, 3> spacing{};
    seafloor->Get(Pipeline::WHOLE_EXTENT(), extent.data());
    seafloor->Get(vtkDataObject::ORIGIN(), origin.data());
    seafloor->Get(vtkDataObject::SPACING(), spacing.data());
    for (int axis = 0; axis < 2; ++axis)
    {
      int& first = extent[2 * axis];
      int& last = extent[2 * axis + 1];
      origin[axis] += first * spacing[axis];
      last -= first;
      first = 0;
      if (this->Spacing > 0.0)
      {
        last = nodesOver(last * spacing[axis], this->Spacing) - 1;
        spacing[axis] = this->Spacing;
      }
    }
    output->Set(Pipeline::WHOLE_EXTENT(), extent.data(), 6);
    output->Set(vtkDataObject::ORIGIN(), origin.data(), 3);
    output->Set(vtkDataObject::SPACING(), spacing.data(), 3);
    vtkDataObject::SetPointDataActiveScalarInfo(output, VTK_DOUBLE, 1);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

int vtkSwellMap::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* seafloor = inputVector[1]->GetInformationObject(0);
  std::array<int, 6> whole{};
  seafloor->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  seafloor->Set(Pipeline::UPDATE_EXTENT(), whole.data(), 6);
  // The extent of the map says nothing of the rays, and must not pass through them to the seafloor they are traced on.
  inputVector[0]->GetInformationObject(0)->Remove(Pipeline::UPDATE_EXTENT());
  return 1;
}

int vtkSwellMap::RequestData(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* rays = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  try
  {
    const std::shared_ptr<const swellray::Seafloor> seafloor =
      this->Seafloor->get(image, this->GetInputArrayToProcess(0, inputVector));
    vtkInformation* info = outputVector->GetInformationObject(0);
    std::array<int, 6> extent{};
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data());
    output->SetExtent(extent.data());
    output->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
    output->SetSpacing(info->Get(vtkDataObject::SPACING()));

    swellray::MapGrid grid;
    grid.columns = static_cast<std::size_t>(extent[1] + 1);
    grid.rows = static_cast<std::size_t>(extent[3] + 1);
    grid.origin = { output->GetOrigin()[0], output->GetOrigin()[1] };
    grid.spacing = { output->GetSpacing()[0], output->GetSpacing()[1] };

    vtkPointData* out = output->GetPointData();
    const vtkIdType nodes = output->GetNumberOfPoints();
    double* elevation = swellray::addArray<vtkDoubleArray>(out, "Elevation", nodes);
    double* depth = swellray::addArray<vtkDoubleArray>(out, "Depth", nodes);
    std::vector<glm::dvec2> places(static_cast<std::size_t>(nodes));
    const double level = swellray::fieldValue(rays, "WaterLevel").value_or(this->WaterLevel);
    swellray::parallelFor(grid.rows,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t row = begin; row < end; ++row)
        {
          for (std::size_t column = 0; column < grid.columns; ++column)
          {
            const glm::dvec2 node =
              grid.origin + grid.spacing * glm::dvec2(static_cast<double>(column), static_cast<double>(row));
            const std::size_t i = row * grid.columns + column;
            places[i] = node;
            elevation[i] =
              seafloor->isHole(node) ? std::numeric_limits<double>::quiet_NaN() : seafloor->elevation(node);
            depth[i] = level - elevation[i];
          }
        }
      });
    this->UpdateProgress(0.2);

    const swellray::RaySheetInput input(rays);
    this->UpdateProgress(0.4);
    const swellray::RayMap map = swellray::mapRays(input.sheets(), grid, input.wetDepths(places, depth).data(),
      static_cast<swellray::CombineRule>(this->CombineRule), swellray::makeExecution(this, 0.4, 1.0));
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }
    swellray::addMapArrays(out, map);
    out->SetActiveScalars("WaveHeight");
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CombineRule: " << (this->CombineRule == PHASE ? "phase" : "energy") << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "WaterLevel: " << this->WaterLevel << "\n";
}
