#include "vtkSwellRayTracer.h"

#include "AlgorithmExecution.h"
#include "CausticField.h"
#include "CurrentSource.h"
#include "FieldData.h"
#include "GeoreferenceField.h"
#include "ObstacleSource.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "bathymetry/GeodesicSource.h"
#include "sim/Angles.h"
#include "sim/EllipsoidMercator.h"
#include "sim/PointSource.h"
#include "sim/RayQuantities.h"
#include "sim/WaveTracer.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSwellRayTracer);

namespace
{

// Share of the progress that tracing takes, before the arrays are filled.
constexpr double TracingShare = 0.9;

// Share of the refracted ray points from which on it is said that the grid is too coarse for them.
constexpr double CoarseShare = 0.01;

// 0 stands for "not set".
std::optional<double> unlessZero(double value)
{
  return value == 0.0 ? std::nullopt : std::optional<double>(value);
}

void setPoints(vtkPolyData* output, const swellray::RayField& field, const swellray::IncidentWave& wave,
  double waterLevel, bool withCurrent, const swellray::MapScale* map, const swellray::Execution& execution)
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
  if (withCurrent)
  {
    quantities.current = add("Current", 3);
  }
  quantities.directionFrom = add("DirectionFrom");
  quantities.krSpacing = add("KrSpacing");
  quantities.krTube = add("KrTube");
  quantities.tubeWidth = add("TubeWidth");
  quantities.shoaling = add("ShoalingCoefficient");
  if (map)
  {
    quantities.map = map;
    quantities.scale = add("MapScale");
  }
  quantities.caustics = swellray::addArray<vtkIntArray>(out, "Caustics", n);
  quantities.state = swellray::addArray<vtkUnsignedCharArray>(out, "RayState", n);
  swellray::computeRayQuantities(field, wave, waterLevel, quantities, execution);
}

void setCells(vtkPolyData* output, const swellray::RayField& field)
{
  const auto n = static_cast<vtkIdType>(field.rays.size());
  vtkCellData* out = output->GetCellData();
  int* id = swellray::addArray<vtkIntArray>(out, "RayId", n);
  double* launchParameter = swellray::addArray<vtkDoubleArray>(out, "LaunchParameter", n);
  int* parent = swellray::addArray<vtkIntArray>(out, "ParentRay", n);
  unsigned char* lee = swellray::addArray<vtkUnsignedCharArray>(out, "LeeRay", n);
  unsigned char* finalState = swellray::addArray<vtkUnsignedCharArray>(out, "FinalState", n);
  unsigned char* endReason = swellray::addArray<vtkUnsignedCharArray>(out, "EndReason", n);
  int* segment = swellray::addArray<vtkIntArray>(out, "LaunchSegment", n);
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    const swellray::RayInfo& ray = field.rays[i];
    id[i] = static_cast<int>(i);
    launchParameter[i] = ray.launchParameter;
    parent[i] = ray.parent;
    lee[i] = ray.lee ? 1 : 0;
    finalState[i] = static_cast<unsigned char>(ray.finalState);
    endReason[i] = static_cast<unsigned char>(ray.endReason);
    segment[i] = ray.launchSegment;
  }
}

void takeLaunch(vtkPolyData* launch, swellray::TraceOptions& options)
{
  if (!launch)
  {
    return;
  }
  const auto placeOf = [launch](vtkIdType id)
  {
    double p[3];
    launch->GetPoint(id, p);
    return glm::dvec2(p[0], p[1]);
  };
  for (vtkIdType line = 0; line < launch->GetNumberOfLines(); ++line)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    launch->GetLines()->GetCellAtId(line, count, ids);
    std::vector<glm::dvec2> points;
    for (vtkIdType i = 0; i < count; ++i)
    {
      points.push_back(placeOf(ids[i]));
    }
    options.launchLines.push_back(points);
  }
  if (!options.launchLines.empty())
  {
    return;
  }
  vtkDataArray* directions = launch->GetPointData()->GetArray("DirectionFrom");
  for (vtkIdType i = 0; i < launch->GetNumberOfPoints(); ++i)
  {
    swellray::LaunchPlace place;
    place.position = placeOf(i);
    const double from = directions ? directions->GetComponent(i, 0) : std::numeric_limits<double>::quiet_NaN();
    if (!std::isnan(from))
    {
      place.heading = swellray::headingFromNautical(from);
    }
    options.launchPlaces.push_back(place);
  }
  if (options.launchPlaces.empty())
  {
    throw std::invalid_argument("input 1 has neither launch lines nor launch points");
  }
}

void setReflections(vtkPolyData* output, const swellray::RayField& field)
{
  const auto n = static_cast<vtkIdType>(field.rays.size());
  int* reflections = swellray::addArray<vtkIntArray>(output->GetCellData(), "Reflections", n);
  double* coefficient = swellray::addArray<vtkDoubleArray>(output->GetCellData(), "ReflectionCoefficient", n);
  for (std::size_t i = 0; i < field.rays.size(); ++i)
  {
    reflections[i] = field.rays[i].reflections;
    coefficient[i] = field.rays[i].reflection;
  }
}

void setFields(
  vtkPolyData* output, const swellray::RayField& field, const swellray::IncidentWave& wave, double waterLevel)
{
  swellray::setFieldValue(output, "Period", wave.period);
  swellray::setFieldValue(output, "DirectionFrom", field.directionFrom);
  if (field.sourceDistance)
  {
    swellray::setFieldValue(output, "SourceDistance", *field.sourceDistance);
  }
  swellray::setFieldValue(output, "WaveHeight", wave.height);
  swellray::setFieldValue(output, "OffshoreDepth", wave.offshoreDepth);
  swellray::setFieldValue(output, "Gravity", wave.gravity);
  swellray::setFieldValue(output, "WaterLevel", waterLevel);
  swellray::setFieldValue(output, "LaunchSpacing", field.spacing);
  swellray::setFieldValue(output, "MaxSpacing", field.maxSpacing);
  swellray::setFieldValue(output, "LaunchWidth", field.launchWidth);
  swellray::setFieldValue(output, "StepsPerWave", field.stepsPerWave);
  swellray::setFieldInteger(output, "Fronts", static_cast<int>(field.fronts));
  swellray::setFieldValue(output, "RaySteps", static_cast<double>(field.steps));
  swellray::setFieldInteger(output, "RayCapReached", field.rayCapReached ? 1 : 0);
  swellray::setFieldInteger(output, "StepCapReached", field.stepCapReached ? 1 : 0);
  swellray::setCaustics(output, field.caustics);
  double dispersionError = 0.0;
  for (const swellray::RayInfo& ray : field.rays)
  {
    dispersionError = std::max(dispersionError, ray.dispersionError);
  }
  swellray::setFieldValue(output, "DispersionError", dispersionError);
  swellray::setFieldString(output, "SwellrayVersion", SWELLRAY_VERSION);
}

}

vtkSwellRayTracer::vtkSwellRayTracer()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Water(std::make_unique<swellray::CurrentField>())
  , Walls(std::make_unique<swellray::ObstacleField>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellRayTracer::~vtkSwellRayTracer()
{
  delete[] this->Current;
  delete[] this->Obstacles;
}

int vtkSwellRayTracer::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

std::unique_ptr<const swellray::WaveSource> vtkSwellRayTracer::makeSource(const swellray::Georeference& scene) const
{
  const glm::dvec2 position(this->SourcePosition[0], this->SourcePosition[1]);
  switch (this->Source)
  {
  case STORM:
    return std::make_unique<swellray::GeodesicSource>(position, scene);
  case POINT:
    if (scene.kind() == swellray::GeoreferenceKind::Geographic)
    {
      throw std::invalid_argument("waves from a point need a plane: over longitudes and latitudes take a storm");
    }
    return std::make_unique<swellray::PointSource>(scene.fromFile(position));
  default:
    return nullptr;
  }
}

int vtkSwellRayTracer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    swellray::IncidentWave wave;
    wave.period = this->Period;
    wave.directionFrom = this->DirectionFrom;
    wave.height = this->WaveHeight;
    wave.offshoreDepth = unlessZero(this->OffshoreDepth).value_or(std::numeric_limits<double>::infinity());
    wave.gravity = this->Gravity;
    wave.validate();

    if (this->MaximumNumberOfRays < 1 || this->MaximumNumberOfFronts < 1)
    {
      throw std::invalid_argument("the caps on rays (" + std::to_string(this->MaximumNumberOfRays) +
        ") and on fronts (" + std::to_string(this->MaximumNumberOfFronts) + ") must be 1 or more");
    }
    swellray::TraceOptions options;
    options.waterLevel = this->WaterLevel;
    options.spacing = unlessZero(this->Spacing);
    options.maxSpacing = unlessZero(this->MaxSpacing);
    options.stepsPerWave = unlessZero(this->StepsPerWave);
    options.step = unlessZero(this->Step);
    options.scheme = static_cast<swellray::TraceScheme>(this->Scheme);
    options.tolerance = this->Tolerance;
    options.insertion = static_cast<swellray::InsertionRule>(this->Insertion);
    options.leeRays = this->LeeRays != 0;
    if (this->FlatHeight != -1.0)
    {
      options.flatHeight = this->FlatHeight;
    }
    options.agroundDepth = unlessZero(this->AgroundDepth);
    options.edge = static_cast<swellray::EdgeRule>(this->Edge);
    options.shoreNormal = this->UseShoreNormal ? std::optional<double>(this->ShoreNormal) : std::nullopt;
    options.maxRays = static_cast<std::size_t>(this->MaximumNumberOfRays);
    options.maxFronts = static_cast<std::size_t>(this->MaximumNumberOfFronts);
    options.validate();

    const std::shared_ptr<const swellray::Seafloor> seafloor =
      this->Seafloor->get(input, this->GetInputArrayToProcess(0, inputVector));
    std::shared_ptr<const swellray::Current> current;
    if (this->Current && *this->Current)
    {
      current = this->Water->get(this->Current, swellray::georeferenceOf(input), seafloor->bounds());
      options.current = current.get();
      options.validate();
    }
    std::shared_ptr<const swellray::Obstacles> obstacles;
    if (this->Obstacles && *this->Obstacles)
    {
      if (this->MaximumReflections < 0)
      {
        throw std::invalid_argument(
          "the cap on reflections must be 0 or more, not " + std::to_string(this->MaximumReflections));
      }
      obstacles =
        this->Walls->get(this->Obstacles, swellray::georeferenceOf(input), seafloor->bounds(), this->Reflection);
      options.obstacles = obstacles.get();
      options.maxReflections = static_cast<std::size_t>(this->MaximumReflections);
    }
    swellray::dropGeographicGrid(output);
    const swellray::Georeference place = swellray::georeferenceOf(input);
    options.map = place.mercator().get();
    const std::unique_ptr<const swellray::WaveSource> source = this->makeSource(place);
    options.source = source.get();
    takeLaunch(vtkPolyData::GetData(inputVector[1]), options);
    options.validate();
    const swellray::RayField field =
      swellray::traceWaves(*seafloor, wave, options, swellray::makeExecution(this, 0.0, TracingShare));

    output->SetLines(swellray::linesInOrder(field.offsets));
    setPoints(output, field, wave, this->WaterLevel, current != nullptr, options.map, swellray::makeExecution(this));
    setCells(output, field);
    setFields(output, field, wave, this->WaterLevel);
    if (!options.launchPlaces.empty())
    {
      swellray::setFieldInteger(output, "LaunchPoints", static_cast<int>(options.launchPlaces.size()));
    }
    if (obstacles)
    {
      setReflections(output, field);
      swellray::setObstacles(output, this->Walls->list());
    }
    if (this->LongitudeLatitude)
    {
      swellray::addLongitudeLatitude(output);
    }

    for (const std::string& note : current ? this->Water->notes() : std::vector<std::string>())
    {
      vtkWarningMacro(<< note);
    }
    for (const std::string& note : obstacles ? this->Walls->notes() : std::vector<std::string>())
    {
      vtkWarningMacro(<< note);
    }
    if (field.rayCapReached)
    {
      vtkWarningMacro("the cap of " << this->MaximumNumberOfRays << " rays was reached: no more rays were inserted");
    }
    if (field.stepCapReached)
    {
      vtkWarningMacro("the cap of " << this->MaximumNumberOfFronts
                                    << " fronts was reached: the rays that were still going end there");
    }
    // NaN, and nothing to say, where no wave feels the bottom.
    const double coarse = static_cast<double>(field.coarsePoints) / static_cast<double>(field.refractingPoints);
    if (coarse > CoarseShare)
    {
      vtkWarningMacro("the seafloor grid, with cells of " << seafloor->cellSize() << " m, is coarse for this wave: at "
                                                          << std::lround(100.0 * coarse)
                                                          << " % of the ray points that feel the bottom a wavelength "
                                                             "has fewer than 5 cells");
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

void vtkSwellRayTracer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Period: " << this->Period << "\n";
  os << indent << "DirectionFrom: " << this->DirectionFrom << "\n";
  const char* sources[] = { "plane wave", "storm", "point" };
  os << indent << "Source: " << sources[this->Source] << "\n";
  os << indent << "SourcePosition: " << this->SourcePosition[0] << ", " << this->SourcePosition[1] << "\n";
  os << indent << "WaveHeight: " << this->WaveHeight << "\n";
  os << indent << "OffshoreDepth: " << this->OffshoreDepth << "\n";
  os << indent << "Gravity: " << this->Gravity << "\n";
  os << indent << "WaterLevel: " << this->WaterLevel << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "MaxSpacing: " << this->MaxSpacing << "\n";
  os << indent << "StepsPerWave: " << this->StepsPerWave << "\n";
  os << indent << "Step: " << this->Step << "\n";
  os << indent << "Scheme: " << (this->Scheme == SNELL ? "snell" : "ode") << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  const char* insertions[] = { "none", "retrace", "interpolate" };
  os << indent << "Insertion: " << insertions[this->Insertion] << "\n";
  os << indent << "LeeRays: " << (this->LeeRays ? "on" : "off") << "\n";
  os << indent << "FlatHeight: " << this->FlatHeight << "\n";
  os << indent << "AgroundDepth: " << this->AgroundDepth << "\n";
  const char* edges[] = { "contours", "edge", "none" };
  os << indent << "Edge: " << edges[this->Edge] << "\n";
  os << indent << "UseShoreNormal: " << (this->UseShoreNormal ? "on" : "off") << "\n";
  os << indent << "ShoreNormal: " << this->ShoreNormal << "\n";
  os << indent << "Current: " << (this->Current ? this->Current : "(none)") << "\n";
  os << indent << "Obstacles: " << (this->Obstacles ? this->Obstacles : "(none)") << "\n";
  os << indent << "Reflection: " << this->Reflection << "\n";
  os << indent << "MaximumReflections: " << this->MaximumReflections << "\n";
  os << indent << "LongitudeLatitude: " << (this->LongitudeLatitude ? "on" : "off") << "\n";
  os << indent << "MaximumNumberOfRays: " << this->MaximumNumberOfRays << "\n";
  os << indent << "MaximumNumberOfFronts: " << this->MaximumNumberOfFronts << "\n";
}
