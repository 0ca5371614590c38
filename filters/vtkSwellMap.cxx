#include "vtkSwellMap.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "MapNodes.h"
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
#include <exception>
#include <vector>

vtkStandardNewMacro(vtkSwellMap);

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
  vtkInformation* seafloor = inputVector[1]->GetInformationObject(0);
  vtkInformation* output = outputVector->GetInformationObject(0);
  try
  {
    swellray::setMapNodes(seafloor, output, this->Spacing);
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
    const swellray::MapGrid grid = swellray::makeMapNodes(outputVector->GetInformationObject(0), output);
    const double level = swellray::fieldValue(rays, "WaterLevel").value_or(this->WaterLevel);
    const double* depth = swellray::addMapDepths(output, grid, *seafloor, level);
    std::vector<glm::dvec2> places(grid.columns * grid.rows);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      places[i] = grid.origin +
        grid.spacing * glm::dvec2(static_cast<double>(i % grid.columns), static_cast<double>(i / grid.columns));
    }
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
    vtkPointData* out = output->GetPointData();
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
