#include "vtkSwellSurfaceProbe.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "SurfaceSettings.h"
#include "SurfaceWaves.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkSwellSurfaceProbe);

vtkSwellSurfaceProbe::vtkSwellSurfaceProbe()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Waves(std::make_unique<swellray::SurfaceWaves>())
{
  this->SetNumberOfInputPorts(3);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellSurfaceProbe::~vtkSwellSurfaceProbe() = default;

int vtkSwellSurfaceProbe::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 1 ? "vtkImageData" : "vtkPolyData");
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkSwellSurfaceProbe::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* rays = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkPolyData* asked = vtkPolyData::GetData(inputVector[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    const std::string spec = swellray::sectionSpec(this->Section, this->SectionParameters);
    const auto section = swellray::makeWaveSection(spec);
    swellray::SurfaceMotion motion;
    motion.section = section.get();
    motion.foam.life = this->FoamLife;
    motion.foam.validate();
    this->Waves->update(inputVector[0], 0, image, this->GetInputArrayToProcess(0, inputVector), *this->Seafloor,
      { swellray::pointsPerWave(this->PointsPerWave, section->pointsPerWave()), this->Seed,
        { this->GroupWaves, this->GroupLull }, false },
      this);

    const vtkIdType count = asked->GetNumberOfPoints();
    std::vector<glm::dvec2> places(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      double point[3];
      asked->GetPoint(i, point);
      places[static_cast<std::size_t>(i)] = { point[0], point[1] };
    }
    std::vector<double> times(1, this->Time);
    if (asked->GetPointData()->GetArray("Time"))
    {
      const auto array = swellray::requireDoubles(asked->GetPointData(), "Time", count);
      times.assign(array->GetPointer(0), array->GetPointer(0) + count);
    }
    for (const double time : times)
    {
      if (!std::isfinite(time))
      {
        throw std::invalid_argument("a Time is not finite");
      }
    }
    const std::vector<swellray::SurfaceValue> values =
      this->Waves->sum()->at(places, times, motion, swellray::makeExecution(this, 0.5, 1.0));

    output->SetPoints(asked->GetPoints());
    vtkPointData* out = output->GetPointData();
    out->ShallowCopy(asked->GetPointData());
    double* elevation = swellray::addArray<vtkDoubleArray>(out, "SurfaceElevation", count);
    float* normal = swellray::addArray<vtkFloatArray>(out, "Normals", count, 3);
    float* velocity = swellray::addArray<vtkFloatArray>(out, "Velocity", count, 3);
    double* depth = swellray::addArray<vtkDoubleArray>(out, "Depth", count);
    float* foam = swellray::addArray<vtkFloatArray>(out, "Foam", count);
    unsigned char* breaking = swellray::addArray<vtkUnsignedCharArray>(out, "Breaking", count);
    int* waves = swellray::addArray<vtkIntArray>(out, "Waves", count);
    double* at = swellray::addArray<vtkDoubleArray>(out, "Time", count);
    vtkNew<vtkCellArray> vertices;
    for (vtkIdType i = 0; i < count; ++i)
    {
      const swellray::SurfaceValue& value = values[static_cast<std::size_t>(i)];
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      elevation[i] = value.covered ? value.elevation : none;
      depth[i] = value.covered ? value.depth : none;
      for (int c = 0; c < 3; ++c)
      {
        normal[3 * i + c] = static_cast<float>(value.covered ? value.normal[c] : none);
        velocity[3 * i + c] = static_cast<float>(value.covered ? value.velocity[c] : none);
      }
      foam[i] = static_cast<float>(value.covered ? value.foam : none);
      breaking[i] = value.breaking ? 1 : 0;
      waves[i] = static_cast<int>(value.sheets);
      at[i] = times[times.size() == 1 ? 0 : static_cast<std::size_t>(i)];
      vertices->InsertNextCell(1, &i);
    }
    out->SetActiveNormals("Normals");
    output->SetVerts(vertices);
    output->GetFieldData()->ShallowCopy(rays->GetFieldData());
    swellray::setFieldString(output, "Section", spec);
    swellray::setFieldInteger(output, "Seed", this->Seed);
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellSurfaceProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Section: " << swellray::sectionSpec(this->Section, this->SectionParameters) << "\n";
  os << indent << "PointsPerWave: " << this->PointsPerWave << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "GroupWaves: " << this->GroupWaves << "\n";
  os << indent << "GroupLull: " << this->GroupLull << "\n";
  os << indent << "FoamLife: " << this->FoamLife << "\n";
}
