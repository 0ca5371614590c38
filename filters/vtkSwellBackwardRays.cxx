#include "vtkSwellBackwardRays.h"

#include "AlgorithmExecution.h"
#include "CurrentSource.h"
#include "FieldData.h"
#include "GeoreferenceField.h"
#include "ObstacleSource.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "sim/Angles.h"
#include "sim/BackwardFan.h"
#include "sim/RayQuantities.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSwellBackwardRays);

namespace
{

void setPoints(vtkPolyData* output, const swellray::RayField& field, const swellray::IncidentWave& wave,
  double waterLevel, bool withCurrent)
{
  const auto n = static_cast<vtkIdType>(field.points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(n);
  output->SetPoints(points);
  vtkPointData* out = output->GetPointData();
  const auto add = [=](const char* name, int components = 1)
  { return swellray::addArray<vtkDoubleArray>(out, name, n, components); };
  swellray::RayQuantities quantities;
  quantities.position = vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0);
  quantities.depth = add("Depth");
  quantities.phase = add("Phase");
  quantities.travelTime = add("TravelTime");
  quantities.wavenumber = add("Wavenumber");
  quantities.wavelength = add("Wavelength");
  quantities.phaseSpeed = add("PhaseSpeed");
  quantities.groupSpeed = add("GroupSpeed");
  quantities.direction = add("Direction", 3);
  quantities.rayDirection = add("RayDirection", 3);
  quantities.directionFrom = add("DirectionFrom");
  if (withCurrent)
  {
    quantities.current = add("Current", 3);
  }
  swellray::computeRayQuantities(field, wave, waterLevel, quantities);
}

void setCells(vtkPolyData* output, const swellray::BackwardFan& fan)
{
  const auto n = static_cast<vtkIdType>(fan.origins.size());
  vtkCellData* out = output->GetCellData();
  int* id = swellray::addArray<vtkIntArray>(out, "RayId", n);
  double* here = swellray::addArray<vtkDoubleArray>(out, "SiteDirectionFrom", n);
  double* offshore = swellray::addArray<vtkDoubleArray>(out, "OffshoreDirectionFrom", n);
  double* gain = swellray::addArray<vtkDoubleArray>(out, "EnergyGain", n);
  double* time = swellray::addArray<vtkDoubleArray>(out, "TravelTime", n);
  unsigned char* reason = swellray::addArray<vtkUnsignedCharArray>(out, "EndReason", n);
  for (std::size_t i = 0; i < fan.origins.size(); ++i)
  {
    const swellray::WaveOrigin& origin = fan.origins[i];
    id[i] = static_cast<int>(i);
    here[i] = swellray::wrapDegrees(270.0 - swellray::degrees(fan.headings[i]));
    offshore[i] =
      std::isnan(origin.heading) ? origin.heading : swellray::wrapDegrees(270.0 - swellray::degrees(origin.heading));
    gain[i] = origin.gain;
    time[i] = origin.travelTime;
    reason[i] = static_cast<unsigned char>(origin.reason);
  }
}

}

vtkSwellBackwardRays::vtkSwellBackwardRays()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Water(std::make_unique<swellray::CurrentField>())
  , Walls(std::make_unique<swellray::ObstacleField>())
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellBackwardRays::~vtkSwellBackwardRays()
{
  delete[] this->Current;
  delete[] this->Obstacles;
}

int vtkSwellBackwardRays::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkSwellBackwardRays::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    const swellray::Georeference scene = swellray::georeferenceOf(input);
    if (scene.mercator())
    {
      throw std::invalid_argument("rays from a site are followed back on a plane: read the seafloor as one");
    }
    if (this->NumberOfDirections < 1)
    {
      throw std::invalid_argument(
        "directions at the site must be 1 or more, not " + std::to_string(this->NumberOfDirections));
    }
    swellray::IncidentWave wave;
    wave.period = this->Period;
    wave.offshoreDepth = this->OffshoreDepth != 0.0 ? this->OffshoreDepth : std::numeric_limits<double>::infinity();
    wave.gravity = this->Gravity;
    wave.validate();
    swellray::BackwardOptions options;
    options.waterLevel = this->WaterLevel;
    options.gravity = this->Gravity;
    options.tolerance = this->Tolerance;
    options.agroundDepth = this->AgroundDepth;
    options.offshoreDepth = wave.offshoreDepth;
    options.edge = static_cast<swellray::EdgeRule>(this->Edge);
    options.shoreNormal = this->UseShoreNormal ? std::optional<double>(this->ShoreNormal) : std::nullopt;

    const std::shared_ptr<const swellray::Seafloor> seafloor =
      this->Seafloor->get(input, this->GetInputArrayToProcess(0, inputVector));
    std::shared_ptr<const swellray::Current> current;
    if (this->Current && *this->Current)
    {
      current = this->Water->get(this->Current, scene, seafloor->bounds());
      options.current = current.get();
    }
    std::shared_ptr<const swellray::Obstacles> obstacles;
    if (this->Obstacles && *this->Obstacles)
    {
      obstacles = this->Walls->get(this->Obstacles, scene, seafloor->bounds(), 0.0);
      options.obstacles = obstacles.get();
    }
    const swellray::BackwardTracer tracer(*seafloor, options);
    const swellray::BackwardFan fan =
      swellray::traceFan(tracer, scene.fromFile({ this->Site[0], this->Site[1] }), this->Period,
        static_cast<std::size_t>(this->NumberOfDirections), this->StepsPerWave, swellray::makeExecution(this));

    swellray::dropGeographicGrid(output);
    output->SetLines(swellray::linesInOrder(fan.field.offsets));
    setPoints(output, fan.field, wave, this->WaterLevel, current != nullptr);
    setCells(output, fan);
    swellray::setFieldValue(output, "Period", this->Period);
    swellray::setFieldValue(output, "OffshoreDepth", wave.offshoreDepth);
    swellray::setFieldValue(output, "Gravity", this->Gravity);
    swellray::setFieldValue(output, "WaterLevel", this->WaterLevel);
    swellray::setFieldValue(output, "SiteX", this->Site[0]);
    swellray::setFieldValue(output, "SiteY", this->Site[1]);
    swellray::setFieldString(output, "SwellrayVersion", SWELLRAY_VERSION);
    if (obstacles)
    {
      swellray::setObstacles(output, this->Walls->list());
    }
    swellray::addLongitudeLatitude(output);
    for (const std::string& note : current ? this->Water->notes() : std::vector<std::string>())
    {
      vtkWarningMacro(<< note);
    }
    for (const std::string& note : obstacles ? this->Walls->notes() : std::vector<std::string>())
    {
      vtkWarningMacro(<< note);
    }
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellBackwardRays::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Site: " << this->Site[0] << ", " << this->Site[1] << "\n";
  os << indent << "NumberOfDirections: " << this->NumberOfDirections << "\n";
  os << indent << "Period: " << this->Period << "\n";
  os << indent << "OffshoreDepth: " << this->OffshoreDepth << "\n";
  os << indent << "Gravity: " << this->Gravity << "\n";
  os << indent << "WaterLevel: " << this->WaterLevel << "\n";
  os << indent << "StepsPerWave: " << this->StepsPerWave << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "AgroundDepth: " << this->AgroundDepth << "\n";
  const char* edges[] = { "contours", "edge", "none" };
  os << indent << "Edge: " << edges[this->Edge] << "\n";
  os << indent << "UseShoreNormal: " << (this->UseShoreNormal ? "on" : "off") << "\n";
  os << indent << "ShoreNormal: " << this->ShoreNormal << "\n";
  os << indent << "Current: " << (this->Current ? this->Current : "(none)") << "\n";
  os << indent << "Obstacles: " << (this->Obstacles ? this->Obstacles : "(none)") << "\n";
}
