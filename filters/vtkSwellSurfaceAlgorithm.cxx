#include "vtkSwellSurfaceAlgorithm.h"

#include "FieldData.h"
#include "SeafloorField.h"
#include "SurfaceFrame.h"
#include "SurfaceSettings.h"
#include "SurfaceWaves.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPolyData.h>

#include <exception>

vtkSwellSurfaceAlgorithm::vtkSwellSurfaceAlgorithm()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Waves(std::make_unique<swellray::SurfaceWaves>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellSurfaceAlgorithm::~vtkSwellSurfaceAlgorithm() = default;

int vtkSwellSurfaceAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 1 ? "vtkImageData" : "vtkPolyData");
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkSwellSurfaceAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkSwellSurfaceAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  try
  {
    swellray::setTimeSteps(outputVector->GetInformationObject(0), this->TimeRange, this->TimeStep);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

int vtkSwellSurfaceAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      swellray::askAtNoTime(inputVector[port]->GetInformationObject(i));
    }
  }
  return 1;
}

void vtkSwellSurfaceAlgorithm::TakeWaves(
  const swellray::SurfaceFrame& frame, vtkInformationVector** inputVector, int first)
{
  this->Waves->update(inputVector[0], first, frame.image, frame.elevation, *this->Seafloor, frame.settings, this);
  this->UpdateProgress(0.5);
}

int vtkSwellSurfaceAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  try
  {
    const std::string spec = swellray::sectionSpec(this->Section, this->SectionParameters);
    const auto section = swellray::makeWaveSection(spec);
    swellray::SurfaceFrame frame;
    frame.rays = vtkPolyData::GetData(inputVector[0]);
    frame.image = vtkImageData::GetData(inputVector[1]);
    frame.elevation = this->GetInputArrayToProcess(0, inputVector);
    frame.time = swellray::requestedTime(outputVector->GetInformationObject(0), this->Time);
    frame.section = section.get();
    frame.settings.pointsPerWave = swellray::pointsPerWave(this->PointsPerWave, section->pointsPerWave());
    frame.settings.seed = this->Seed;
    frame.settings.groups = { this->GroupWaves, this->GroupLull };

    output->GetFieldData()->ShallowCopy(frame.rays->GetFieldData());
    swellray::setFieldString(output, "Section", spec);
    swellray::setFieldInteger(output, "Seed", this->Seed);
    if (this->GroupWaves > 0.0)
    {
      swellray::setFieldValue(output, "GroupWaves", this->GroupWaves);
      swellray::setFieldValue(output, "GroupLull", this->GroupLull);
    }
    swellray::setFieldValue(output, "Time", frame.time);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), frame.time);
    this->MakeFrame(frame, inputVector, outputVector);
    if (this->GetAbortExecute())
    {
      output->Initialize();
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

void vtkSwellSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Section: " << swellray::sectionSpec(this->Section, this->SectionParameters) << "\n";
  os << indent << "PointsPerWave: " << this->PointsPerWave << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << ", " << this->TimeRange[1] << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "GroupWaves: " << this->GroupWaves << "\n";
  os << indent << "GroupLull: " << this->GroupLull << "\n";
}
