#include "vtkSwellSurface.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "SurfaceScene.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSwellSurface);

namespace
{

// More would be a mistake in the step.
constexpr double MostTimeSteps = 1e6;

constexpr double FewestPointsPerWave = 16.0;

// NAME:key=value,... of a name, which may have some already, and further parameters.
std::string sectionSpec(const std::string& name, const std::string& parameters)
{
  return parameters.empty() ? name : name + (name.find(':') == std::string::npos ? ":" : ",") + parameters;
}

void requirePositive(const char* name, double value)
{
  if (!(value > 0.0) || std::isinf(value))
  {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + "; it must be above 0 and finite");
  }
}

}

vtkSwellSurface::vtkSwellSurface()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellSurface::~vtkSwellSurface() = default;

int vtkSwellSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkSwellSurface::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  try
  {
    requirePositive("TimeStep", this->TimeStep);
    const double length = this->TimeRange[1] - this->TimeRange[0];
    if (!(length >= 0.0) || std::isinf(length))
    {
      throw std::invalid_argument("TimeRange ends before it begins");
    }
    // A range that is whole steps but for rounding keeps its last.
    constexpr double rounding = 1e-9;
    const double steps = std::floor(length / this->TimeStep + rounding) + 1.0;
    if (steps > MostTimeSteps)
    {
      throw std::invalid_argument("TimeRange has more than a million steps; choose a larger TimeStep");
    }
    std::vector<double> times(static_cast<std::size_t>(steps));
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      times[i] = this->TimeRange[0] + static_cast<double>(i) * this->TimeStep;
    }
    vtkInformation* info = outputVector->GetInformationObject(0);
    info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    const std::array<double, 2> range{ times.front(), times.back() };
    info->Set(Pipeline::TIME_RANGE(), range.data(), 2);
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
  // Rays and seafloor are the same at all times, and must not be made again for another frame.
  for (int port = 0; port < 2; ++port)
  {
    inputVector[port]->GetInformationObject(0)->Remove(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
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
    vtkInformation* info = outputVector->GetInformationObject(0);
    const double time = info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
      ? info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
      : this->Time;
    if (!std::isfinite(time))
    {
      throw std::invalid_argument("Time is not finite");
    }
    requirePositive("TextureSize", this->TextureSize);
    if (this->PointsPerWave != 0.0 && !(this->PointsPerWave >= FewestPointsPerWave))
    {
      throw std::invalid_argument("PointsPerWave is " + std::to_string(this->PointsPerWave) +
        "; it must be 16 or more, or 0 for as many as the section asks for");
    }
    const std::string spec = sectionSpec(this->Section, this->SectionParameters);
    const auto section = swellray::makeWaveSection(spec);
    const double pointsPerWave = this->PointsPerWave > 0.0 ? this->PointsPerWave : section->pointsPerWave();
    if (!this->Scene || this->SceneOf[0] != rays->GetMTime() || this->SceneOf[1] != image->GetMTime() ||
      this->ScenePointsPerWave != pointsPerWave || this->SceneSeed != this->Seed ||
      this->ScenePhaseRule != this->PhaseRule)
    {
      this->Scene = std::make_unique<const swellray::SurfaceScene>(rays,
        this->Seafloor->get(image, this->GetInputArrayToProcess(0, inputVector)), pointsPerWave, this->Seed,
        this->PhaseRule == STRAIGHT, this);
      this->SceneOf[0] = rays->GetMTime();
      this->SceneOf[1] = image->GetMTime();
      this->ScenePointsPerWave = pointsPerWave;
      this->SceneSeed = this->Seed;
      this->ScenePhaseRule = this->PhaseRule;
    }
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
  os << indent << "Section: " << sectionSpec(this->Section, this->SectionParameters) << "\n";
  os << indent << "PhaseRule: " << (this->PhaseRule == STRAIGHT ? "straight" : "traced") << "\n";
  os << indent << "PointsPerWave: " << this->PointsPerWave << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << ", " << this->TimeRange[1] << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Still: " << this->Still << "\n";
  os << indent << "TextureSize: " << this->TextureSize << "\n";
}
