#include "vtkSwellSurfaceProbe.h"

#include "AlgorithmExecution.h"
#include "RayArrays.h"
#include "SurfaceFrame.h"
#include "SurfaceWaves.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkSwellSurfaceProbe);

vtkSwellSurfaceProbe::vtkSwellSurfaceProbe()
{
  this->SetNumberOfInputPorts(3);
}

void vtkSwellSurfaceProbe::MakeFrame(
  const swellray::SurfaceFrame& frame, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* asked = vtkPolyData::GetData(inputVector[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  swellray::SurfaceMotion motion;
  motion.section = frame.section;
  motion.foam.life = this->FoamLife;
  motion.foam.validate();
  this->TakeWaves(frame, inputVector);

  const vtkIdType count = asked->GetNumberOfPoints();
  std::vector<glm::dvec2> places(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    asked->GetPoint(i, point);
    places[static_cast<std::size_t>(i)] = { point[0], point[1] };
  }
  std::vector<double> times(1, frame.time);
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
}

void vtkSwellSurfaceProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FoamLife: " << this->FoamLife << "\n";
}
