#include "vtkSwellStations.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RaySheetInput.h"
#include "SeafloorField.h"

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <exception>
#include <limits>

vtkStandardNewMacro(vtkSwellStations);

vtkSwellStations::vtkSwellStations()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
{
  this->SetNumberOfInputPorts(3);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellStations::~vtkSwellStations() = default;

int vtkSwellStations::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 1 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

int vtkSwellStations::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* rays = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkPolyData* stations = vtkPolyData::GetData(inputVector[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    const std::shared_ptr<const swellray::Seafloor> seafloor =
      this->Seafloor->get(image, this->GetInputArrayToProcess(0, inputVector));
    const vtkIdType count = stations->GetNumberOfPoints();
    output->SetPoints(stations->GetPoints());
    output->GetPointData()->ShallowCopy(stations->GetPointData());
    vtkNew<vtkCellArray> vertices;
    for (vtkIdType i = 0; i < count; ++i)
    {
      vertices->InsertNextCell(1, &i);
    }
    output->SetVerts(vertices);

    vtkPointData* out = output->GetPointData();
    double* elevation = swellray::addArray<vtkDoubleArray>(out, "Elevation", count);
    double* depth = swellray::addArray<vtkDoubleArray>(out, "Depth", count);
    const double level = swellray::fieldValue(rays, "WaterLevel").value_or(this->WaterLevel);
    std::vector<glm::dvec2> places(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      double point[3];
      stations->GetPoint(i, point);
      glm::dvec2& place = places[static_cast<std::size_t>(i)];
      place = { point[0], point[1] };
      const bool known = seafloor->bounds().contains(place) && !seafloor->isHole(place);
      elevation[i] = known ? seafloor->elevation(place) : std::numeric_limits<double>::quiet_NaN();
      depth[i] = level - elevation[i];
    }
    const swellray::RaySheetInput input(rays);
    swellray::addMapArrays(out,
      swellray::sampleRays(input.sheets(), places, input.wetDepths(places, depth).data(),
        static_cast<swellray::CombineRule>(this->CombineRule), swellray::makeExecution(this)));
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellStations::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CombineRule: " << (this->CombineRule == PHASE ? "phase" : "energy") << "\n";
  os << indent << "WaterLevel: " << this->WaterLevel << "\n";
}
