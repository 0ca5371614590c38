#include "vtkSwellFoam.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "sim/Foam.h"

#include <vtkFloatArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <exception>

vtkStandardNewMacro(vtkSwellFoam);

int vtkSwellFoam::RequestData(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    constexpr const char* owner = "vtkSwellSurface";
    swellray::FoamOptions options;
    options.life = this->Life;
    options.period = swellray::requireFieldValue(input, "Period", owner);
    options.variation = swellray::requireFieldValue(input, "SectionVariation", owner);
    options.wavelength = swellray::requireFieldValue(input, "IncidentWavelength", owner);
    options.seed = static_cast<std::uint64_t>(swellray::requireFieldValue(input, "Seed", owner));
    const double time = swellray::requireFieldValue(input, "Time", owner);
    const vtkIdType count = input->GetNumberOfPoints();
    const auto phase = swellray::requireDoubles(input->GetPointData(), "RayPhase", count);
    const auto breaking = swellray::requireDoubles(input->GetPointData(), "BreakingPhase", count);
    const auto parameter = swellray::requireDoubles(input->GetPointData(), "LaunchParameter", count);

    swellray::FoamPlaces places{ static_cast<std::size_t>(count), phase->GetPointer(0), breaking->GetPointer(0),
      parameter->GetPointer(0) };
    vtkSmartPointer<vtkDoubleArray> foamShare;
    if (input->GetPointData()->HasArray("FoamShare"))
    {
      foamShare = swellray::requireDoubles(input->GetPointData(), "FoamShare", count);
      places.foamShare = foamShare->GetPointer(0);
    }
    options.front = swellray::fieldValue(input, "SectionFront").value_or(0.0);
    vtkSmartPointer<vtkDoubleArray> plungePhase;
    if (input->GetPointData()->HasArray("PlungePhase"))
    {
      plungePhase = swellray::requireDoubles(input->GetPointData(), "PlungePhase", count);
      places.plungePhase = plungePhase->GetPointer(0);
    }
    options.groups.waves = swellray::fieldValue(input, "GroupWaves").value_or(0.0);
    vtkSmartPointer<vtkDoubleArray> groupTime;
    vtkSmartPointer<vtkDoubleArray> brokenShare;
    if (options.groups.any())
    {
      options.groups.lull = swellray::requireFieldValue(input, "GroupLull", owner);
      groupTime = swellray::requireDoubles(input->GetPointData(), "GroupTime", count);
      brokenShare = swellray::requireDoubles(input->GetPointData(), "BrokenShare", count);
      places.groupTime = groupTime->GetPointer(0);
      places.brokenShare = brokenShare->GetPointer(0);
    }

    output->ShallowCopy(input);
    float* foam = swellray::addArray<vtkFloatArray>(output->GetPointData(), "Foam", count);
    swellray::computeFoam(places, time, options, foam, swellray::makeExecution(this));
    output->GetPointData()->SetActiveScalars("Foam");
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellFoam::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Life: " << this->Life << "\n";
}
