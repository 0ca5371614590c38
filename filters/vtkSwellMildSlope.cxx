#include "vtkSwellMildSlope.h"

#include "AlgorithmExecution.h"
#include "FieldData.h"
#include "GeoreferenceField.h"
#include "MapNodes.h"
#include "ObstacleSource.h"
#include "RayArrays.h"
#include "SeafloorField.h"
#include "sim/MildSlope.h"

#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <map>
#include <optional>

vtkStandardNewMacro(vtkSwellMildSlope);

namespace
{

// Share of the progress that the solution takes; the rest is the map's.
constexpr double SolvingShare = 0.9;

// Of the machine's memory, unless a limit is set.
constexpr double MemoryShare = 0.8;

std::optional<double> unlessZero(double value)
{
  return value == 0.0 ? std::nullopt : std::optional<double>(value);
}

double machineMemory()
{
  vtksys::SystemInformation system;
  system.RunMemoryCheck();
  constexpr double mebibyte = 1024.0 * 1024.0;
  return static_cast<double>(system.GetTotalPhysicalMemory()) * mebibyte;
}

// Copy waves out, where there is water.
void addWaves(vtkPointData* out, const swellray::MildSlopeWaves& waves, const double* depth)
{
  const auto n = static_cast<vtkIdType>(waves.height.size());
  const auto copy = [&](const char* name, const std::vector<double>& values)
  {
    double* array = swellray::addArray<vtkDoubleArray>(out, name, n);
    for (vtkIdType i = 0; i < n; ++i)
    {
      array[i] = depth[i] > 0.0 ? values[static_cast<std::size_t>(i)] : std::numeric_limits<double>::quiet_NaN();
    }
  };
  copy("WaveHeight", waves.height);
  copy("DirectionFrom", waves.directionFrom);
  copy("Wavelength", waves.wavelength);
  copy("WavePhase", waves.phase);
  unsigned char* breaking = swellray::addArray<vtkUnsignedCharArray>(out, "Breaking", n);
  std::copy(waves.breaking.begin(), waves.breaking.end(), breaking);
}

/** Obstacles of one reflection coefficient. */
struct WallGroup
{
  double reflection = 0.0;
  swellray::Obstacles walls;
};

std::vector<WallGroup> groupWalls(const std::vector<swellray::Obstacle>& obstacles)
{
  std::map<double, std::vector<swellray::Obstacle>> sorted;
  for (const swellray::Obstacle& obstacle : obstacles)
  {
    sorted[obstacle.reflection].push_back(obstacle);
  }
  std::vector<WallGroup> groups;
  for (const auto& [reflection, list] : sorted)
  {
    groups.push_back({ reflection, swellray::Obstacles(list) });
  }
  return groups;
}

// What stands in an element: walls that cross it, or land that has its middle.
std::optional<double> wallIn(const std::vector<WallGroup>& groups, const swellray::Rectangle& element)
{
  const glm::dvec2& a = element.low;
  const glm::dvec2& b = element.high;
  for (const WallGroup& group : groups)
  {
    if (group.walls.inside(0.5 * (a + b)) || group.walls.crosses(a, b) ||
      group.walls.crosses({ a.x, b.y }, { b.x, a.y }))
    {
      return group.reflection;
    }
  }
  return {};
}

void setFields(
  vtkDataObject* output, const swellray::IncidentWave& wave, double waterLevel, const swellray::MildSlopePlan& plan)
{
  swellray::setFieldString(output, "Method", "mild-slope");
  swellray::setFieldValue(output, "Period", wave.period);
  swellray::setFieldValue(output, "DirectionFrom", wave.directionFrom);
  swellray::setFieldValue(output, "WaveHeight", wave.height);
  swellray::setFieldValue(output, "OffshoreDepth", wave.offshoreDepth);
  swellray::setFieldValue(output, "Gravity", wave.gravity);
  swellray::setFieldValue(output, "WaterLevel", waterLevel);
  swellray::setFieldInteger(output, "MeshColumns", static_cast<int>(plan.columns));
  swellray::setFieldInteger(output, "MeshRows", static_cast<int>(plan.rows));
  swellray::setFieldValue(output, "MeshSpacing", std::max(plan.spacing.x, plan.spacing.y));
  swellray::setFieldValue(output, "NodesPerWave", plan.nodesPerWave);
  swellray::setFieldValue(output, "MinimumDepth", plan.minDepth);
  swellray::setFieldValue(output, "Memory", plan.bytes);
  swellray::setFieldValue(output, "SolutionSeconds", plan.seconds);
  swellray::setFieldInteger(output, "Solutions", static_cast<int>(plan.solutions));
}

}

vtkSwellMildSlope::vtkSwellMildSlope()
  : Seafloor(std::make_unique<swellray::SeafloorField>())
  , Walls(std::make_unique<swellray::ObstacleField>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Elevation");
}

vtkSwellMildSlope::~vtkSwellMildSlope()
{
  delete[] this->Obstacles;
}

int vtkSwellMildSlope::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSwellMildSlope::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

int vtkSwellMildSlope::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  try
  {
    swellray::setMapNodes(
      inputVector[0]->GetInformationObject(0), outputVector->GetInformationObject(0), this->Spacing);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

int vtkSwellMildSlope::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* seafloor = inputVector[0]->GetInformationObject(0);
  std::array<int, 6> whole{};
  seafloor->Get(Pipeline::WHOLE_EXTENT(), whole.data());
  seafloor->Set(Pipeline::UPDATE_EXTENT(), whole.data(), 6);
  return 1;
}

int vtkSwellMildSlope::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkPolyData* stations = vtkPolyData::GetData(inputVector[1]);
  vtkImageData* map = vtkImageData::GetData(outputVector, 0);
  vtkPolyData* points = vtkPolyData::GetData(outputVector, 1);
  try
  {
    if (swellray::georeferenceOf(input).mercator())
    {
      throw std::invalid_argument("the mild-slope equation is solved on a plane: read the seafloor on the plane");
    }
    swellray::IncidentWave wave;
    wave.period = this->Period;
    wave.directionFrom = this->DirectionFrom;
    wave.height = this->WaveHeight;
    wave.offshoreDepth = unlessZero(this->OffshoreDepth).value_or(std::numeric_limits<double>::infinity());
    wave.gravity = this->Gravity;

    swellray::MildSlopeOptions options;
    options.spacing = unlessZero(this->NodeSpacing);
    options.minDepth = unlessZero(this->MinimumDepth);
    options.edge = static_cast<swellray::EdgeRule>(this->Edge);
    options.shoreNormal = this->UseShoreNormal ? std::optional<double>(this->ShoreNormal) : std::nullopt;
    options.sideWalls = this->SideWalls != 0;
    options.coastReflection = this->CoastReflection;
    options.dispersion = static_cast<swellray::WaveDispersion>(this->Dispersion);
    options.height.breaking = static_cast<swellray::BreakingRule>(this->BreakingRule);
    options.height.gamma = unlessZero(this->Gamma);
    options.height.friction = this->Friction;
    options.height.viscosity = this->Viscosity;
    options.memory = this->MemoryLimit > 0.0 ? this->MemoryLimit : MemoryShare * machineMemory();

    const std::shared_ptr<const swellray::Seafloor> seafloor =
      this->Seafloor->get(input, this->GetInputArrayToProcess(0, inputVector));
    std::vector<WallGroup> walls;
    if (this->Obstacles && *this->Obstacles)
    {
      this->Walls->get(this->Obstacles, swellray::georeferenceOf(input), seafloor->bounds(), this->Reflection);
      walls = groupWalls(this->Walls->list());
      options.wall = [&walls](const swellray::Rectangle& element) { return wallIn(walls, element); };
    }
    const swellray::MildSlopePlan plan = swellray::planMildSlope(*seafloor, this->WaterLevel, wave, options);
    for (vtkDataObject* output : { static_cast<vtkDataObject*>(map), static_cast<vtkDataObject*>(points) })
    {
      setFields(output, wave, this->WaterLevel, plan);
      if (options.wall)
      {
        swellray::setObstacles(output, this->Walls->list());
      }
    }
    if (this->PlanOnly)
    {
      return 1;
    }
    const swellray::MildSlopeField field = swellray::solveMildSlope(
      *seafloor, this->WaterLevel, wave, options, swellray::makeExecution(this, 0.0, SolvingShare));
    if (field.cancelled())
    {
      map->Initialize();
      points->Initialize();
      return 1;
    }
    const swellray::MapGrid grid = swellray::makeMapNodes(outputVector->GetInformationObject(0), map);
    const double* depth = swellray::addMapDepths(map, grid, *seafloor, this->WaterLevel);
    addWaves(map->GetPointData(), field.sample(grid, swellray::makeExecution(this, SolvingShare, 1.0)), depth);
    map->GetPointData()->SetActiveScalars("WaveHeight");

    if (stations)
    {
      const vtkIdType count = stations->GetNumberOfPoints();
      points->SetPoints(stations->GetPoints());
      points->GetPointData()->ShallowCopy(stations->GetPointData());
      vtkNew<vtkCellArray> vertices;
      std::vector<glm::dvec2> places;
      double* elevation = swellray::addArray<vtkDoubleArray>(points->GetPointData(), "Elevation", count);
      double* depths = swellray::addArray<vtkDoubleArray>(points->GetPointData(), "Depth", count);
      for (vtkIdType i = 0; i < count; ++i)
      {
        vertices->InsertNextCell(1, &i);
        std::array<double, 3> point{};
        stations->GetPoint(i, point.data());
        places.emplace_back(point[0], point[1]);
        const bool known = seafloor->bounds().contains(places.back()) && !seafloor->isHole(places.back());
        elevation[i] = known ? seafloor->elevation(places.back()) : std::numeric_limits<double>::quiet_NaN();
        depths[i] = this->WaterLevel - elevation[i];
      }
      points->SetVerts(vertices);
      addWaves(points->GetPointData(), field.sample(places), depths);
    }
    for (vtkDataObject* output : { static_cast<vtkDataObject*>(map), static_cast<vtkDataObject*>(points) })
    {
      swellray::setFieldInteger(output, "Solutions", static_cast<int>(field.solutions()));
      swellray::setFieldValue(output, "SolutionChange", field.change());
      swellray::setFieldValue(output, "Residual", field.residual());
    }
    for (const std::string& note : options.wall ? this->Walls->notes() : std::vector<std::string>())
    {
      vtkWarningMacro(<< note);
    }
    if (!field.converged())
    {
      vtkWarningMacro(<< "after " << field.solutions() << " solutions heights still change by "
                      << 100.0 * field.change() << " % (root mean square)");
    }
  }
  catch (const std::exception& error)
  {
    map->Initialize();
    points->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkSwellMildSlope::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Period: " << this->Period << "\n";
  os << indent << "DirectionFrom: " << this->DirectionFrom << "\n";
  os << indent << "WaveHeight: " << this->WaveHeight << "\n";
  os << indent << "OffshoreDepth: " << this->OffshoreDepth << "\n";
  os << indent << "Gravity: " << this->Gravity << "\n";
  os << indent << "WaterLevel: " << this->WaterLevel << "\n";
  os << indent << "Edge: " << this->Edge << "\n";
  os << indent << "ShoreNormal: " << this->ShoreNormal << (this->UseShoreNormal ? "" : " (not used)") << "\n";
  os << indent << "NodeSpacing: " << this->NodeSpacing << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "MinimumDepth: " << this->MinimumDepth << "\n";
  os << indent << "SideWalls: " << (this->SideWalls ? "on" : "off") << "\n";
  os << indent << "CoastReflection: " << this->CoastReflection << "\n";
  os << indent << "Obstacles: " << (this->Obstacles ? this->Obstacles : "(none)") << "\n";
  os << indent << "Reflection: " << this->Reflection << "\n";
  os << indent << "Dispersion: " << (this->Dispersion == NONLINEAR ? "nonlinear" : "linear") << "\n";
  os << indent << "BreakingRule: " << this->BreakingRule << "\n";
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Friction: " << this->Friction << "\n";
  os << indent << "Viscosity: " << this->Viscosity << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "PlanOnly: " << (this->PlanOnly ? "on" : "off") << "\n";
}
