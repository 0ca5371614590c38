#include "MildSlopeRun.h"

#include "Failure.h"
#include "FieldValues.h"
#include "FilterRun.h"
#include "MapOutput.h"
#include "OptionGroups.h"
#include "OptionKinds.h"
#include "Pipeline.h"
#include "StationTable.h"

#include "sim/RayField.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSwellMildSlope.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

namespace swellray::cli
{

namespace
{

const NumberRule Reflection{ "", 0.0, 1.0 };

constexpr double Gigabyte = 1e9;

void setUp(vtkSwellMildSlope* filter, const Request& request)
{
  const IncidentWave& wave = request.rays.wave;
  filter->SetPeriod(wave.period);
  filter->SetDirectionFrom(wave.directionFrom);
  filter->SetWaveHeight(wave.height);
  filter->SetOffshoreDepth(wave.offshoreDepth);
  filter->SetGravity(wave.gravity);
  filter->SetWaterLevel(request.seafloor.options.waterLevel);
  const TraceOptions& trace = request.rays.trace;
  filter->SetEdge(trace.edge == EdgeRule::Edge ? vtkSwellMildSlope::EDGE_EDGE
      : trace.edge == EdgeRule::None           ? vtkSwellMildSlope::EDGE_NONE
                                               : vtkSwellMildSlope::EDGE_CONTOURS);
  if (trace.shoreNormal)
  {
    filter->UseShoreNormalOn();
    filter->SetShoreNormal(*trace.shoreNormal);
  }
  filter->SetObstacles(request.rays.obstacles.empty() ? nullptr : request.rays.obstacles.c_str());
  filter->SetReflection(request.rays.reflection.value_or(0.0));
  const HeightOptions& height = request.rays.height;
  filter->SetBreakingRule(static_cast<int>(height.breaking));
  filter->SetGamma(height.gamma.value_or(0.0));
  filter->SetFriction(height.friction);
  filter->SetViscosity(height.viscosity);
  const MildSlopeRequest& asked = request.mildSlope;
  filter->SetNodeSpacing(asked.nodeSpacing.value_or(0.0));
  filter->SetMinimumDepth(asked.minDepth.value_or(0.0));
  filter->SetMemoryLimit(Gigabyte * asked.memory.value_or(0.0));
  filter->SetCoastReflection(asked.coastReflection.value_or(0.0));
  filter->SetSideWalls(asked.sideWalls);
  filter->SetDispersion(
    asked.dispersion == WaveDispersion::Nonlinear ? vtkSwellMildSlope::NONLINEAR : vtkSwellMildSlope::LINEAR);
  filter->SetSpacing(request.map.spacing.value_or(0.0));
}

void sayPlan(vtkDataObject* data, const Console& console)
{
  const auto value = [&](const char* name) { return fieldNumber(data, name).value_or(0.0); };
  console.say(
    fmt::format("mesh     {:g} x {:g} nodes {:.4g} m apart, {:.3g} in the shortest wavelength; coast where the "
                "depth is below {:.3g} m",
      value("MeshColumns"), value("MeshRows"), value("MeshSpacing"), value("NodesPerWave"), value("MinimumDepth")));
  const double solutions = value("Solutions");
  console.say(fmt::format("cost     {:.3g} GB of memory and about {:.2g} s on one thread{}", value("Memory") / Gigabyte,
    value("SolutionSeconds"),
    solutions > 1.0 ? fmt::format(" a solution; some 5 to 15 of them, {:g} at most", solutions) : ""));
}

void sayHeights(vtkImageData* map, const Console& console)
{
  vtkPointData* values = map->GetPointData();
  vtkDataArray* heights = values->GetArray("WaveHeight");
  vtkDataArray* breaking = values->GetArray("Breaking");
  double highest = 0.0;
  vtkIdType known = 0;
  vtkIdType broken = 0;
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    const double height = heights->GetComponent(i, 0);
    if (!std::isnan(height))
    {
      ++known;
      highest = std::max(highest, height);
      broken += breaking->GetComponent(i, 0) != 0.0 ? 1 : 0;
    }
  }
  console.say(fmt::format("heights  up to {:.3g} m on {} nodes in water, breaking on {:.3g} % of them", highest, known,
    known > 0 ? 100.0 * static_cast<double>(broken) / static_cast<double>(known) : 0.0));
}

}

std::vector<OptionSpec> mildSlopeOptions(MildSlopeRequest& mildSlope)
{
  const char* group = "Mild slope";
  return {
    choice("--method", "rays, or the mild-slope equation: diffraction, reflection", "rays", group, mildSlope.wanted,
      std::vector<std::pair<std::string, bool>>{ { "rays", false }, { "mild-slope", true } }),
    choice("--dispersion", "wavenumber of linear waves, or of waves of their height", "linear", group,
      mildSlope.dispersion,
      std::vector<std::pair<std::string, WaveDispersion>>{
        { "linear", WaveDispersion::Linear }, { "nonlinear", WaveDispersion::Nonlinear } }),
    number("--node-spacing", "M", "distance of the nodes of the solution, m", "a tenth of the shortest wave", group,
      mildSlope.nodeSpacing, PositiveMetres),
    number("--min-depth", "M", "depth where the coast begins, m", "half the breaker depth", group, mildSlope.minDepth,
      PositiveMetres),
    number("--coast-reflection", "R", "height that a coast reflects over that which comes in, 0 to 1", "0", group,
      mildSlope.coastReflection, Reflection),
    flag("--side-walls", "walls on the two sides along which the wave runs", group, mildSlope.sideWalls),
    number("--max-memory", "GB", "memory that the solution may take", "four fifths of the machine's", group,
      mildSlope.memory, PositiveNumber),
  };
}

void checkMildSlope(const Request& request)
{
  const MildSlopeRequest& asked = request.mildSlope;
  if (!asked.wanted)
  {
    const bool given = asked.nodeSpacing || asked.minDepth || asked.memory || asked.coastReflection ||
      asked.sideWalls || asked.dispersion != WaveDispersion::Linear;
    if (given)
    {
      throw UsageError("--dispersion nonlinear, --node-spacing, --min-depth, --coast-reflection, --side-walls "
                       "and --max-memory belong to --method mild-slope");
    }
    return;
  }
  checkPlane(request, "--method mild-slope");
  if (!request.map.waterLevels.empty())
  {
    throw UsageError("--water-levels belongs to --method rays; give one --water-level");
  }
  const OutputRequest& output = request.output;
  if (!output.file.empty() || !output.crests.empty() || !output.breakerLine.empty())
  {
    throw UsageError("--method mild-slope has no rays to write with --output, --crests or --breaker-line; take --map "
                     "FILE, or --stations with --table");
  }
  if (!request.map.waterLevels.empty())
  {
    throw UsageError("--method mild-slope knows one water level; leave out --water-levels, or take --method rays");
  }
  if (request.rays.source != RayRequest::Source::PlaneWave)
  {
    throw UsageError("--method mild-slope takes a plane wave; give its --direction, or take --method rays");
  }
  if (!request.rays.current.empty())
  {
    throw UsageError("--method mild-slope knows no current; leave out --current, or take --method rays");
  }
}

void runMildSlope(const Request& request, Console& console)
{
  using Clock = std::chrono::steady_clock;
  const std::vector<std::string> inputs = inputFiles(request);
  std::optional<OutputFile> mapFile;
  std::optional<OutputFile> tableFile;
  std::optional<StationTable> stations;
  if (!request.planOnly)
  {
    if (!request.output.map.empty())
    {
      mapFile.emplace(request.output.map, inputs);
    }
    if (!request.output.table.empty())
    {
      tableFile.emplace(request.output.table, inputs);
      stations.emplace(request.map.stations);
    }
  }

  Pipeline pipeline(request, console);
  vtkImageData* seafloor = pipeline.readSeafloor()->GetOutput();
  vtkNew<vtkSwellMildSlope> filter;
  setUp(filter, request);
  filter->SetInputData(0, seafloor);
  filter->PlanOnlyOn();
  runFilter(filter, "planning", console);
  sayPlan(filter->GetOutputDataObject(0), console);
  if (request.planOnly)
  {
    return;
  }
  if (stations)
  {
    filter->SetInputData(1, stations->places(georeferenceOf(seafloor)));
  }
  filter->PlanOnlyOff();
  const Clock::time_point start = Clock::now();
  runFilter(filter, "waves", console);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  auto* map = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  auto* points = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));

  std::string written;
  if (mapFile)
  {
    writeMap(map, *mapFile, request, console);
  }
  if (tableFile)
  {
    stations->write(points->GetPointData(),
      { "Elevation", "Depth", "WaveHeight", "DirectionFrom", "Wavelength", "Breaking", "WavePhase" }, "WaveHeight",
      *tableFile, console);
  }
  if (mapFile)
  {
    mapFile->commit();
    written = mapFile->path();
  }
  if (tableFile)
  {
    tableFile->commit();
    written += (written.empty() ? "" : " and ") + tableFile->path();
  }
  sayHeights(map, console);
  console.say(
    fmt::format("time     {:.2f} s for {:g} solutions", seconds, fieldNumber(map, "Solutions").value_or(0.0)));
  console.say(fmt::format("wrote    {}{}", written, mapFile ? "; open with: paraview " + mapFile->path() : ""));
}

}
