#include "vtkSwellFoamMap.h"

#include "AlgorithmExecution.h"
#include "MapNodes.h"
#include "RayArrays.h"
#include "SurfaceFrame.h"
#include "SurfaceSettings.h"
#include "SurfaceWaves.h"
#include "sim/StillFoam.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <array>
#include <exception>
#include <vector>

vtkStandardNewMacro(vtkSwellFoamMap);

vtkSwellFoamMap::vtkSwellFoamMap() = default;

vtkSwellFoamMap::~vtkSwellFoamMap() = default;

int vtkSwellFoamMap::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

int vtkSwellFoamMap::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  try
  {
    swellray::setMapNodes(
      inputVector[1]->GetInformationObject(0), outputVector->GetInformationObject(0), this->Spacing);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

int vtkSwellFoamMap::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* seafloor = inputVector[1]->GetInformationObject(0);
  std::array<int, 6> whole{};
  seafloor->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  seafloor->Set(Pipeline::UPDATE_EXTENT(), whole.data(), 6);
  for (int i = 0; i < inputVector[0]->GetNumberOfInformationObjects(); ++i)
  {
    // The extent of the map says nothing of the rays.
    inputVector[0]->GetInformationObject(i)->Remove(Pipeline::UPDATE_EXTENT());
  }
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

void vtkSwellFoamMap::MakeFrame(
  const swellray::SurfaceFrame& frame, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  swellray::requirePositive("FoamLife", this->FoamLife);
  this->TakeWaves(frame, inputVector);
  const swellray::MapGrid grid = swellray::makeMapNodes(outputVector->GetInformationObject(0), output);
  const std::array<double, 6> at{ grid.origin.x, grid.origin.y, grid.spacing.x, grid.spacing.y,
    static_cast<double>(grid.columns), static_cast<double>(grid.rows) };
  if (!this->Nodes || this->NodesOf != this->Waves->version() || !std::equal(at.begin(), at.end(), this->NodesAt))
  {
    std::vector<glm::dvec2> places(grid.columns * grid.rows);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      places[i] = grid.origin +
        grid.spacing * glm::dvec2(static_cast<double>(i % grid.columns), static_cast<double>(i / grid.columns));
    }
    this->Nodes = std::make_unique<const swellray::StillFoam>(
      this->Waves->functions(), places, swellray::makeExecution(this, 0.5, 0.9));
    this->NodesOf = this->Waves->version();
    std::copy(at.begin(), at.end(), this->NodesAt);
  }
  this->UpdateProgress(0.9);
  if (this->GetAbortExecute())
  {
    return;
  }
  std::vector<float> foam(grid.columns * grid.rows);
  this->Nodes->at(
    frame.time, this->FoamLife, frame.section->variation(), foam.data(), swellray::makeExecution(this, 0.9, 1.0));
  double* values =
    swellray::addArray<vtkDoubleArray>(output->GetPointData(), "Foam", static_cast<vtkIdType>(foam.size()));
  std::copy(foam.begin(), foam.end(), values);
  output->GetPointData()->SetActiveScalars("Foam");
}

void vtkSwellFoamMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "FoamLife: " << this->FoamLife << "\n";
}
