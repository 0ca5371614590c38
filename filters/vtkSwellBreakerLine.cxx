#include "vtkSwellBreakerLine.h"

#include "FieldData.h"
#include "GeoreferenceField.h"
#include "ObstacleSource.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "sim/Angles.h"
#include "sim/BreakerLine.h"
#include "sim/Breaking.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSwellBreakerLine);

namespace
{

// A line aslant to the crests has its places further apart than the rays; beyond this it is another line.
constexpr double GapOverMaxSpacing = 4.0;

void addDoubles(vtkPointData* data, const char* name, const std::vector<double>& values, double factor = 1.0)
{
  double* array = swellray::addArray<vtkDoubleArray>(data, name, static_cast<vtkIdType>(values.size()));
  std::transform(values.begin(), values.end(), array, [=](double value) { return factor * value; });
}

void addQuantities(vtkPolyData* output, const swellray::BreakerLines& lines)
{
  const double degrees = 180.0 / swellray::Pi;
  vtkPointData* out = output->GetPointData();
  addDoubles(out, "BreakerHeight", lines.height);
  addDoubles(out, "BreakerDepth", lines.depth);
  addDoubles(out, "BreakerAngle", lines.angle, degrees);
  addDoubles(out, "IribarrenNumber", lines.iribarrenOffshore);
  addDoubles(out, "BreakerIribarrenNumber", lines.iribarrenBreaking);
  std::copy(lines.type.begin(), lines.type.end(),
    swellray::addArray<vtkUnsignedCharArray>(out, "BreakerType", static_cast<vtkIdType>(lines.type.size())));
  std::copy(lines.typeAtBreaking.begin(), lines.typeAtBreaking.end(),
    swellray::addArray<vtkUnsignedCharArray>(
      out, "BreakerTypeAtBreaking", static_cast<vtkIdType>(lines.typeAtBreaking.size())));
  addDoubles(out, "PeelAngle", lines.peelAngle, degrees);
  addDoubles(out, "VortexRatio", lines.vortexRatio);
  addDoubles(out, "SetDown", lines.setDown);
  addDoubles(out, "SetUp", lines.setUp);
  addDoubles(out, "MaximumSetUp", lines.maximumSetUp);
  addDoubles(out, "LongshoreEnergyFlux", lines.longshoreFlux);
  addDoubles(out, "LongshoreTransport", lines.longshoreTransport);
  std::copy(lines.number.begin(), lines.number.end(),
    swellray::addArray<vtkIntArray>(
      output->GetCellData(), "BreakerNumber", static_cast<vtkIdType>(lines.number.size())));
}

}

vtkSwellBreakerLine::vtkSwellBreakerLine()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellBreakerLine::~vtkSwellBreakerLine() = default;

int vtkSwellBreakerLine::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkSwellBreakerLine::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    if (!(this->MaxGap >= 0.0))
    {
      throw std::invalid_argument("MaxGap is " + std::to_string(this->MaxGap) + "; it must be 0 (no limit) or more");
    }
    const double maxGap =
      this->MaxGapOfRays ? GapOverMaxSpacing * swellray::fieldValue(input, "MaxSpacing").value_or(0.0) : this->MaxGap;
    swellray::BreakerSea sea;
    sea.wave = swellray::tracedWave(input);
    const std::string rule = swellray::fieldString(input, "BreakingRule").value_or("");
    sea.random = rule == swellray::breakingRuleName(swellray::BreakingRule::BattjesJanssen) ||
      rule == swellray::breakingRuleName(swellray::BreakingRule::Baldock);
    const auto seafloor = this->Seafloor->get(image, this->GetInputArrayToProcess(0, inputVector));

    const std::vector<std::int64_t> offsets = swellray::rayOffsets(input);
    const auto count = static_cast<vtkIdType>(offsets.size() - 1);
    const vtkIdType points = input->GetNumberOfPoints();
    vtkPointData* in = input->GetPointData();
    const auto positions = swellray::positionsOf(input);
    const auto direction = swellray::requireDoubles(in, "Direction", points, 3);
    const auto depth = swellray::requireDoubles(in, "Depth", points);
    const auto wavenumber = swellray::requireDoubles(in, "Wavenumber", points);
    const auto groupSpeed = swellray::requireDoubles(in, "GroupSpeed", points);
    const auto shoaling = swellray::requireDoubles(in, "ShoalingCoefficient", points);
    const auto refraction = swellray::requireDoubles(in, "RefractionCoefficient", points);
    const auto height = swellray::requireDoubles(in, "WaveHeight", points);
    const auto distance = swellray::requireDoubles(in, "BreakingDistance", points);
    const auto breaking = swellray::requireBytes(in, "Breaking", points);
    const auto parameter = swellray::requireDoubles(input->GetCellData(), "LaunchParameter", count);
    const auto segment = swellray::requireIntegers(input->GetCellData(), "LaunchSegment", count);

    const std::shared_ptr<const swellray::Obstacles> obstacles = swellray::obstaclesOf(input);
    swellray::BreakerRays rays;
    rays.obstacles = obstacles.get();
    rays.rays = static_cast<std::size_t>(count);
    rays.offsets = offsets.data();
    rays.launchParameter = parameter->GetPointer(0);
    rays.launchSegment = segment->GetPointer(0);
    rays.positions = positions->GetPointer(0);
    const auto scale = swellray::mapScaleOf(input);
    rays.scale = scale ? scale->GetPointer(0) : nullptr;
    rays.direction = direction->GetPointer(0);
    rays.depth = depth->GetPointer(0);
    rays.wavenumber = wavenumber->GetPointer(0);
    rays.groupSpeed = groupSpeed->GetPointer(0);
    rays.shoaling = shoaling->GetPointer(0);
    rays.refraction = refraction->GetPointer(0);
    rays.height = height->GetPointer(0);
    rays.breakingDistance = distance->GetPointer(0);
    rays.breaking = breaking->GetPointer(0);
    const swellray::BreakerLines lines = swellray::extractBreakerLines(rays, *seafloor, sea, maxGap);

    vtkNew<vtkPoints> linePoints;
    linePoints->SetDataTypeToDouble();
    linePoints->SetNumberOfPoints(static_cast<vtkIdType>(lines.places.size()));
    for (std::size_t i = 0; i < lines.places.size(); ++i)
    {
      const swellray::RayPlace& place = lines.places[i];
      const double* a = rays.positions + 3 * place.point;
      linePoints->SetPoint(static_cast<vtkIdType>(i), a[0] + place.weight * (a[3] - a[0]),
        a[1] + place.weight * (a[4] - a[1]), a[2] + place.weight * (a[5] - a[2]));
    }
    output->SetPoints(linePoints);
    output->SetLines(swellray::linesInOrder(lines.offsets));
    addQuantities(output, lines);
    swellray::addLongitudeLatitude(output);
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellBreakerLine::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaxGap: " << this->MaxGap << "\n";
  os << indent << "MaxGapOfRays: " << (this->MaxGapOfRays ? "on" : "off") << "\n";
}
