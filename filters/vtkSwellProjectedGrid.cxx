#include "vtkSwellProjectedGrid.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "SurfaceSettings.h"
#include "SurfaceWaves.h"
#include "sim/ProjectedGrid.h"

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

#include <exception>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSwellProjectedGrid);

vtkSwellProjectedGrid::vtkSwellProjectedGrid()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Waves(std::make_unique<swellray::SurfaceWaves>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellProjectedGrid::~vtkSwellProjectedGrid() = default;

int vtkSwellProjectedGrid::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkSwellProjectedGrid::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  try
  {
    swellray::setTimeSteps(output, this->TimeRange, this->TimeStep);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

int vtkSwellProjectedGrid::RequestUpdateExtent(
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

int vtkSwellProjectedGrid::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* rays = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    const double time = swellray::requestedTime(outputVector->GetInformationObject(0), this->Time);
    swellray::requirePositive("FoamLife", this->FoamLife);
    swellray::requirePositive("TextureSize", this->TextureSize);
    swellray::GridCamera camera;
    for (int c = 0; c < 3; ++c)
    {
      camera.position[c] = this->CameraPosition[c];
      camera.focalPoint[c] = this->CameraFocalPoint[c];
      camera.viewUp[c] = this->CameraViewUp[c];
    }
    camera.viewAngle = this->ViewAngle;
    camera.width = this->ImageSize[0];
    camera.height = this->ImageSize[1];
    camera.step = this->PixelStep;
    camera.margin = this->Margin;
    camera.validate();
    const std::string spec = swellray::sectionSpec(this->Section, this->SectionParameters);
    const auto section = swellray::makeWaveSection(spec);
    this->Waves->update(inputVector[0], 0, image, this->GetInputArrayToProcess(0, inputVector), *this->Seafloor,
      { swellray::pointsPerWave(this->PointsPerWave, section->pointsPerWave()), this->Seed,
        { this->GroupWaves, this->GroupLull }, false },
      this);
    this->UpdateProgress(0.5);
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }
    const std::vector<const swellray::SurfaceFunction*> functions = this->Waves->functions();
    swellray::SurfaceMotion motion;
    motion.section = section.get();
    motion.foam.life = this->FoamLife;
    const swellray::ProjectedSurface surface =
      swellray::ProjectedGrid(camera, functions.front()->waterLevel())
        .sample(functions, time, motion, swellray::makeExecution(this, 0.5, 1.0));

    const auto count = static_cast<vtkIdType>(surface.position.size());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    vtkPointData* out = output->GetPointData();
    float* normal = swellray::addArray<vtkFloatArray>(out, "Normals", count, 3);
    float* velocity = swellray::addArray<vtkFloatArray>(out, "Velocity", count, 3);
    double* depth = swellray::addArray<vtkDoubleArray>(out, "Depth", count);
    float* foam = swellray::addArray<vtkFloatArray>(out, "Foam", count);
    unsigned char* breaking = swellray::addArray<vtkUnsignedCharArray>(out, "Breaking", count);
    float* texture = swellray::addArray<vtkFloatArray>(out, "TextureCoordinates", count, 2);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      const glm::dvec3& place = surface.position[at];
      points->SetPoint(i, place.x, place.y, place.z);
      for (int c = 0; c < 3; ++c)
      {
        normal[3 * i + c] = static_cast<float>(surface.normal[at][c]);
        velocity[3 * i + c] = static_cast<float>(surface.velocity[at][c]);
      }
      for (int c = 0; c < 2; ++c)
      {
        texture[2 * i + c] = static_cast<float>(place[c] / this->TextureSize);
      }
      depth[i] = surface.depth[at];
      foam[i] = surface.foam[at];
      breaking[i] = surface.breaking[at];
    }
    vtkNew<vtkCellArray> triangles;
    triangles->AllocateExact(
      static_cast<vtkIdType>(surface.triangles.size()), 3 * static_cast<vtkIdType>(surface.triangles.size()));
    for (const auto& triangle : surface.triangles)
    {
      const vtkIdType corners[3] = { triangle[0], triangle[1], triangle[2] };
      triangles->InsertNextCell(3, corners);
    }
    out->SetActiveNormals("Normals");
    out->SetActiveTCoords("TextureCoordinates");
    out->SetActiveScalars("Foam");
    output->SetPoints(points);
    output->SetPolys(triangles);
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

void vtkSwellProjectedGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Section: " << swellray::sectionSpec(this->Section, this->SectionParameters) << "\n";
  os << indent << "PointsPerWave: " << this->PointsPerWave << "\n";
  for (const auto& [name, point] : { std::pair<const char*, const double*>{ "CameraPosition: ", this->CameraPosition },
         { "CameraFocalPoint: ", this->CameraFocalPoint }, { "CameraViewUp: ", this->CameraViewUp } })
  {
    os << indent << name << point[0] << ", " << point[1] << ", " << point[2] << "\n";
  }
  os << indent << "ViewAngle: " << this->ViewAngle << "\n";
  os << indent << "ImageSize: " << this->ImageSize[0] << ", " << this->ImageSize[1] << "\n";
  os << indent << "PixelStep: " << this->PixelStep << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << ", " << this->TimeRange[1] << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "GroupWaves: " << this->GroupWaves << "\n";
  os << indent << "GroupLull: " << this->GroupLull << "\n";
  os << indent << "FoamLife: " << this->FoamLife << "\n";
  os << indent << "TextureSize: " << this->TextureSize << "\n";
}
