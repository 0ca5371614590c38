#include "vtkSwellSpray.h"

#include "AlgorithmExecution.h"
#include "RayArrays.h"
#include "SurfaceFrame.h"
#include "SurfaceWaves.h"
#include "sim/Spray.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <vector>

vtkStandardNewMacro(vtkSwellSpray);

namespace
{

constexpr std::uint64_t SeedsApart = std::uint64_t{ 1 } << 32;

}

vtkSwellSpray::vtkSwellSpray() = default;

vtkSwellSpray::~vtkSwellSpray() = default;

void vtkSwellSpray::MakeFrame(
  const swellray::SurfaceFrame& frame, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->TakeWaves(frame, inputVector);
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
  if (this->GetAbortExecute())
  {
    return;
  }

  std::vector<swellray::SprayParticle> particles;
  swellray::SurfaceMotion motion;
  motion.section = frame.section;
  for (std::size_t i = 0; i < this->Throwers.size(); ++i)
  {
    auto thrown = this->Throwers[i]->at(frame.time, *frame.section, swellray::makeExecution(this, 0.5, 1.0));
    std::vector<const swellray::SurfaceFunction*> others = this->Waves->functions();
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (!others.empty())
    {
      swellray::SurfaceSum(others).raise(thrown, frame.time, motion, swellray::makeExecution(this, 0.5, 1.0));
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
}

void vtkSwellSpray::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rate: " << this->Rate << "\n";
  os << indent << "Steepest: " << this->Steepest << "\n";
  os << indent << "Scatter: " << this->Scatter << "\n";
  os << indent << "Rebound: " << this->Rebound << "\n";
}
