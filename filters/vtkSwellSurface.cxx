#include "vtkSwellSurface.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "SurfaceScene.h"
#include "SurfaceSettings.h"
#include "SurfaceWaves.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <exception>
#include <string>

vtkStandardNewMacro(vtkSwellSurface);

vtkSwellSurface::vtkSwellSurface()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Others(std::make_unique<swellray::SurfaceWaves>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellSurface::~vtkSwellSurface() = default;

int vtkSwellSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkSwellSurface::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
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

int vtkSwellSurface::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
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

int vtkSwellSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* rays = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    const double time = swellray::requestedTime(outputVector->GetInformationObject(0), this->Time);
    swellray::requirePositive("TextureSize", this->TextureSize);
    const std::string spec = swellray::sectionSpec(this->Section, this->SectionParameters);
    const auto section = swellray::makeWaveSection(spec);
    vtkDataArray* elevation = this->GetInputArrayToProcess(0, inputVector);
    swellray::SurfaceScene::Settings settings{ swellray::pointsPerWave(this->PointsPerWave, section->pointsPerWave()),
      this->Seed, { this->GroupWaves, this->GroupLull }, this->PhaseRule == STRAIGHT };
    this->Scene = swellray::SurfaceScene::of(rays, image, elevation, *this->Seafloor, settings, this);
    settings.straight = false;
    this->Others->update(inputVector[0], 1, image, elevation, *this->Seafloor, settings, this);
    this->UpdateProgress(0.5);
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }

    const swellray::SurfaceScene& scene = *this->Scene;
    const auto count = static_cast<vtkIdType>(scene.sheet().pointCount());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    vtkPointData* out = output->GetPointData();
    swellray::SurfaceArrays arrays;
    arrays.position = static_cast<double*>(points->GetVoidPointer(0));
    arrays.normal = swellray::addArray<vtkFloatArray>(out, "Normals", count, 3);
    arrays.velocity = swellray::addArray<vtkFloatArray>(out, "Velocity", count, 3);
    arrays.depth = swellray::addArray<vtkDoubleArray>(out, "Depth", count);
    arrays.phase = swellray::addArray<vtkDoubleArray>(out, "Phase", count);
    arrays.breaking = swellray::addArray<vtkUnsignedCharArray>(out, "Breaking", count);
    for (const auto& array : scene.arrays())
    {
      out->AddArray(array);
    }
    float* texture = swellray::addArray<vtkFloatArray>(out, "TextureCoordinates", count, 2);
    out->SetActiveNormals("Normals");
    out->SetActiveTCoords("TextureCoordinates");

    scene.surface().displace(time, *section, arrays, swellray::makeExecution(this, 0.5, 0.9));
    if (const swellray::SurfaceSum* others = this->Others->sum())
    {
      swellray::SurfaceMotion motion;
      motion.section = section.get();
      others->addTo(arrays, scene.sheet().pointCount(), swellray::pointSpacing(scene.sheet()).data(), time, motion,
        swellray::makeExecution(this, 0.9, 1.0));
    }
    if (this->Still)
    {
      std::copy(scene.sheet().Position.begin(), scene.sheet().Position.end(), arrays.position);
    }
    swellray::parallelFor(static_cast<std::size_t>(count),
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          texture[2 * i] = static_cast<float>(arrays.position[3 * i] / this->TextureSize);
          texture[2 * i + 1] = static_cast<float>(arrays.position[3 * i + 1] / this->TextureSize);
        }
      });
    output->SetPoints(points);
    output->SetPolys(scene.triangles());

    output->GetFieldData()->ShallowCopy(rays->GetFieldData());
    swellray::setFieldString(output, "Section", spec);
    swellray::setFieldValue(output, "SectionVariation", section->variation());
    swellray::setFieldInteger(output, "Seed", this->Seed);
    swellray::setFieldValue(output, "IncidentWavelength", scene.options().wavelength);
    if (this->GroupWaves > 0.0)
    {
      swellray::setFieldValue(output, "GroupWaves", this->GroupWaves);
      swellray::setFieldValue(output, "GroupLull", this->GroupLull);
    }
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

void vtkSwellSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Section: " << swellray::sectionSpec(this->Section, this->SectionParameters) << "\n";
  os << indent << "PhaseRule: " << (this->PhaseRule == STRAIGHT ? "straight" : "traced") << "\n";
  os << indent << "PointsPerWave: " << this->PointsPerWave << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << ", " << this->TimeRange[1] << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "GroupWaves: " << this->GroupWaves << "\n";
  os << indent << "GroupLull: " << this->GroupLull << "\n";
  os << indent << "Still: " << this->Still << "\n";
  os << indent << "TextureSize: " << this->TextureSize << "\n";
}
