#include "vtkSwellSurface.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "SurfaceFrame.h"
#include "SurfaceSettings.h"
#include "SurfaceWaves.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

vtkStandardNewMacro(vtkSwellSurface);

vtkSwellSurface::vtkSwellSurface() = default;

vtkSwellSurface::~vtkSwellSurface() = default;

void vtkSwellSurface::MakeFrame(
  const swellray::SurfaceFrame& frame, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  swellray::requirePositive("TextureSize", this->TextureSize);
  swellray::SurfaceScene::Settings settings = frame.settings;
  settings.straight = this->PhaseRule == STRAIGHT;
  this->Scene = swellray::SurfaceScene::of(frame.rays, frame.image, frame.elevation, *this->Seafloor, settings, this);
  this->TakeWaves(frame, inputVector, 1);
  if (this->GetAbortExecute())
  {
    return;
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

  scene.surface().displace(frame.time, *frame.section, arrays, swellray::makeExecution(this, 0.5, 0.9));
  if (const swellray::SurfaceSum* others = this->Waves->sum())
  {
    swellray::SurfaceMotion motion;
    motion.section = frame.section;
    others->addTo(arrays, scene.sheet().pointCount(), swellray::pointSpacing(scene.sheet()).data(), frame.time, motion,
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
  swellray::setFieldValue(output, "SectionVariation", frame.section->variation());
  swellray::setFieldValue(output, "SectionFront", frame.section->frontPhase());
  swellray::setFieldValue(output, "IncidentWavelength", scene.options().wavelength);
}

void vtkSwellSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PhaseRule: " << (this->PhaseRule == STRAIGHT ? "straight" : "traced") << "\n";
  os << indent << "Still: " << this->Still << "\n";
  os << indent << "TextureSize: " << this->TextureSize << "\n";
}
