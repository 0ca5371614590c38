#include "vtkSwellProjectedGrid.h"

#include "AlgorithmExecution.h"
#include "RayArrays.h"
#include "SurfaceFrame.h"
#include "SurfaceSettings.h"
#include "SurfaceWaves.h"
#include "sim/ProjectedGrid.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSwellProjectedGrid);

void vtkSwellProjectedGrid::MakeFrame(
  const swellray::SurfaceFrame& frame, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
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
  this->TakeWaves(frame, inputVector);
  if (this->GetAbortExecute())
  {
    return;
  }
  const std::vector<const swellray::SurfaceFunction*> functions = this->Waves->functions();
  swellray::SurfaceMotion motion;
  motion.section = frame.section;
  motion.foam.life = this->FoamLife;
  const swellray::ProjectedSurface surface =
    swellray::ProjectedGrid(camera, functions.front()->waterLevel())
      .sample(functions, frame.time, motion, swellray::makeExecution(this, 0.5, 1.0));

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
}

void vtkSwellProjectedGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& [name, point] : { std::pair<const char*, const double*>{ "CameraPosition: ", this->CameraPosition },
         { "CameraFocalPoint: ", this->CameraFocalPoint }, { "CameraViewUp: ", this->CameraViewUp } })
  {
    os << indent << name << point[0] << ", " << point[1] << ", " << point[2] << "\n";
  }
  os << indent << "ViewAngle: " << this->ViewAngle << "\n";
  os << indent << "ImageSize: " << this->ImageSize[0] << ", " << this->ImageSize[1] << "\n";
  os << indent << "PixelStep: " << this->PixelStep << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "FoamLife: " << this->FoamLife << "\n";
  os << indent << "TextureSize: " << this->TextureSize << "\n";
}
