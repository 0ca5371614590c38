#include "vtkSwellSpray.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "SurfaceSettings.h"
#include "SurfaceWaves.h"
#include "sim/Spray.h"

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

#include <algorithm>
#include <array>
#include <exception>
#include <vector>

vtkStandardNewMacro(vtkSwellSpray);

namespace
{

constexpr std::uint64_t SeedsApart = std::uint64_t{ 1 } << 32;

}

vtkSwellSpray::vtkSwellSpray()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Waves(std::make_unique<swellray::SurfaceWaves>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellSpray::~vtkSwellSpray() = default;

int vtkSwellSpray::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkSwellSpray::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
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

int vtkSwellSpray::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
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

int vtkSwellSpray::RequestData(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* rays = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    const double time = swellray::requestedTime(outputVector->GetInformationObject(0), this->Time);
    const std::string spec = swellray::sectionSpec(this->Section, this->SectionParameters);
    const auto section = swellray::makeWaveSection(spec);
    this->Waves->update(inputVector[0], 0, image, this->GetInputArrayToProcess(0, inputVector), *this->Seafloor,
      { swellray::pointsPerWave(this->PointsPerWave, section->pointsPerWave()), this->Seed,
        { this->GroupWaves, this->GroupLull }, false },
      this);
    const std::array<double, 4> settings{ this->Rate, this->Steepest, this->Scatter, this->Rebound };
    if (this->Throwers.empty() || this->ThrowersOf != this->Waves->version() ||
      !std::equal(settings.begin(), settings.end(), this->ThrowerSettings))
    {
      this->Throwers.clear();
      swellray::SprayOptions options;
      options.rate = this->Rate;
      options.steepest = this->Steepest;
      options.scatter = this->Scatter;
      options.rebound = this->Rebound;
      options.seed = static_cast<std::uint64_t>(this->Seed);
      int connection = 0;
      for (const auto& scene : this->Waves->scenes())
      {
        options.gravity = swellray::tracedWave(vtkPolyData::GetData(inputVector[0], connection++)).gravity;
        this->Throwers.push_back(
          std::make_unique<const swellray::Spray>(scene->surface(), scene->seafloor(), scene->obstacles(), options));
        // Waves throw apart from each other.
        options.seed += SeedsApart;
      }
      std::copy(settings.begin(), settings.end(), this->ThrowerSettings);
      this->ThrowersOf = this->Waves->version();
    }
    this->UpdateProgress(0.5);
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }

    std::vector<swellray::SprayParticle> particles;
    swellray::SurfaceMotion motion;
    motion.section = section.get();
    for (std::size_t i = 0; i < this->Throwers.size(); ++i)
    {
      auto thrown = this->Throwers[i]->at(time, *section, swellray::makeExecution(this, 0.5, 1.0));
      std::vector<const swellray::SurfaceFunction*> others = this->Waves->functions();
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      if (!others.empty())
      {
        swellray::SurfaceSum(others).raise(thrown, time, motion, swellray::makeExecution(this, 0.5, 1.0));
      }
      particles.insert(particles.end(), thrown.begin(), thrown.end());
    }
    const auto count = static_cast<vtkIdType>(particles.size());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    vtkPointData* out = output->GetPointData();
    float* velocity = swellray::addArray<vtkFloatArray>(out, "Velocity", count, 3);
    float* age = swellray::addArray<vtkFloatArray>(out, "Age", count);
    unsigned char* source = swellray::addArray<vtkUnsignedCharArray>(out, "Source", count);
    vtkNew<vtkCellArray> vertices;
    vertices->AllocateExact(count, count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const swellray::SprayParticle& particle = particles[static_cast<std::size_t>(i)];
      points->SetPoint(i, particle.position.x, particle.position.y, particle.position.z);
      for (int c = 0; c < 3; ++c)
      {
        velocity[3 * i + c] = static_cast<float>(particle.velocity[c]);
      }
      age[i] = static_cast<float>(particle.age);
      source[i] = static_cast<unsigned char>(particle.source);
      vertices->InsertNextCell(1, &i);
    }
    out->SetActiveVectors("Velocity");
    output->SetPoints(points);
    output->SetVerts(vertices);
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

void vtkSwellSpray::PrintSelf(ostream& os, vtkIndent indent)
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
  os << indent << "Rate: " << this->Rate << "\n";
  os << indent << "Steepest: " << this->Steepest << "\n";
  os << indent << "Scatter: " << this->Scatter << "\n";
  os << indent << "Rebound: " << this->Rebound << "\n";
}
