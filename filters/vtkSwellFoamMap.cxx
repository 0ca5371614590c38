#include "vtkSwellFoamMap.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "MapNodes.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "SurfaceSettings.h"
#include "SurfaceWaves.h"
#include "sim/StillFoam.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <array>
#include <exception>
#include <vector>

vtkStandardNewMacro(vtkSwellFoamMap);

vtkSwellFoamMap::vtkSwellFoamMap()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Waves(std::make_unique<swellray::SurfaceWaves>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellFoamMap::~vtkSwellFoamMap() = default;

int vtkSwellFoamMap::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkSwellFoamMap::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  try
  {
    swellray::setMapNodes(inputVector[1]->GetInformationObject(0), output, this->Spacing);
    swellray::setTimeSteps(output, this->TimeRange, this->TimeStep);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

int vtkSwellFoamMap::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* seafloor = inputVector[1]->GetInformationObject(0);
  std::array<int, 6> whole{};
  seafloor->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  seafloor->Set(Pipeline::UPDATE_EXTENT(), whole.data(), 6);
  swellray::askAtNoTime(seafloor);
  for (int i = 0; i < inputVector[0]->GetNumberOfInformationObjects(); ++i)
  {
    // The extent of the map says nothing of the rays.
    vtkInformation* rays = inputVector[0]->GetInformationObject(i);
    rays->Remove(Pipeline::UPDATE_EXTENT());
    swellray::askAtNoTime(rays);
  }
  return 1;
}

int vtkSwellFoamMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* rays = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  try
  {
    const double time = swellray::requestedTime(outputVector->GetInformationObject(0), this->Time);
    swellray::requirePositive("FoamLife", this->FoamLife);
    const std::string spec = swellray::sectionSpec(this->Section, this->SectionParameters);
    const auto section = swellray::makeWaveSection(spec);
    this->Waves->update(inputVector[0], 0, image, this->GetInputArrayToProcess(0, inputVector), *this->Seafloor,
      { swellray::pointsPerWave(this->PointsPerWave, section->pointsPerWave()), this->Seed,
        { this->GroupWaves, this->GroupLull }, false },
      this);
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
      output->Initialize();
      return 1;
    }
    std::vector<float> foam(grid.columns * grid.rows);
    this->Nodes->at(time, this->FoamLife, section->variation(), foam.data(), swellray::makeExecution(this, 0.9, 1.0));
    double* values =
      swellray::addArray<vtkDoubleArray>(output->GetPointData(), "Foam", static_cast<vtkIdType>(foam.size()));
    std::copy(foam.begin(), foam.end(), values);
    output->GetPointData()->SetActiveScalars("Foam");
    output->GetFieldData()->ShallowCopy(rays->GetFieldData());
    swellray::setFieldString(output, "Section", spec);
    swellray::setFieldInteger(output, "Seed", this->Seed);
    swellray::setFieldValue(output, "Time", time);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellFoamMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Section: " << swellray::sectionSpec(this->Section, this->SectionParameters) << "\n";
  os << indent << "PointsPerWave: " << this->PointsPerWave << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << ", " << this->TimeRange[1] << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "GroupWaves: " << this->GroupWaves << "\n";
  os << indent << "GroupLull: " << this->GroupLull << "\n";
  os << indent << "FoamLife: " << this->FoamLife << "\n";
}
