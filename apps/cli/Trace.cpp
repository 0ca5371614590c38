#include "Commands.h"
#include "Failure.h"
#include "OptionGroups.h"
#include "OptionKinds.h"

#include "FieldValues.h"
#include "LineOutput.h"
#include "MapOutput.h"
#include "MildSlopeRun.h"
#include "Pipeline.h"
#include "RayStarts.h"
#include "RayValues.h"
#include "StationTable.h"
#include "Sweep.h"
#include "WaterLevelSeries.h"

#include "sim/Angles.h"
#include "sim/RayField.h"

#include <fmt/format.h>

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace swellray::cli
{

namespace
{

class Stopwatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

void sayRays(vtkPolyData* rays, const Console& console)
{
  vtkDataArray* parents = rays->GetCellData()->GetArray("ParentRay");
  vtkDataArray* lees = rays->GetCellData()->GetArray("LeeRay");
  vtkDataArray* reflections = rays->GetCellData()->GetArray("Reflections");
  vtkIdType inserted = 0;
  vtkIdType lee = 0;
  vtkIdType reflected = 0;
  for (vtkIdType i = 0; i < rays->GetNumberOfCells(); ++i)
  {
    const bool isReflected = reflections && reflections->GetComponent(i, 0) != 0.0;
    const bool isLee = !isReflected && lees && lees->GetComponent(i, 0) != 0.0;
    reflected += isReflected ? 1 : 0;
    lee += isLee ? 1 : 0;
    inserted += !isReflected && !isLee && parents && parents->GetComponent(i, 0) >= 0.0 ? 1 : 0;
  }
  console.say(fmt::format("rays     {}: {} launched, {} inserted, {} in the lee{}; {} points on {:g} fronts, "
                          "{:.0f} steps",
    rays->GetNumberOfCells(), rays->GetNumberOfCells() - inserted - lee - reflected, inserted, lee,
    reflections ? fmt::format(", {} reflected", reflected) : "", rays->GetNumberOfPoints(),
    fieldNumber(rays, "Fronts").value_or(0.0), fieldNumber(rays, "RaySteps").value_or(0.0)));
  console.say("states   " + tally(rays, "FinalState", { "dead", "alive", "flat", "aground" }));
  console.say("ended    " + tally(rays, "EndReason", endReasonWords()));
}

void sayHeights(vtkPolyData* rays, const Console& console)
{
  vtkDataArray* heights = rays->GetPointData()->GetArray("WaveHeight");
  vtkDataArray* breaking = rays->GetPointData()->GetArray("Breaking");
  if (!heights)
  {
    return;
  }
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  vtkIdType broken = 0;
  vtkIdType infinite = 0;
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    const double height = heights->GetComponent(i, 0);
    broken += breaking && breaking->GetComponent(i, 0) != 0.0 ? 1 : 0;
    if (!std::isfinite(height))
    {
      ++infinite;
      continue;
    }
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (low <= high)
  {
    console.say(fmt::format("heights  {:.3g} to {:.3g} m, broken at {:.3g} % of the points{}", low, high,
      100.0 * static_cast<double>(broken) / static_cast<double>(heights->GetNumberOfTuples()),
      infinite > 0 ? fmt::format(", infinite at {}", infinite) : ""));
  }
}

std::string breakingInWords(const RayRequest& rays)
{
  const HeightOptions& options = rays.height;
  const std::string friction = options.friction > 0.0 ? fmt::format(", bottom friction {:g}", options.friction)
    : options.viscosity > 0.0 ? fmt::format(", laminar at the bed, {:g} m2/s", options.viscosity)
                              : "";
  const double gamma = breakerIndex(options, rays.wave);
  switch (options.breaking)
  {
  case BreakingRule::None:
  case BreakingRule::Weggel:
  case BreakingRule::Miche:
    return breakingRuleName(options.breaking) + friction;
  case BreakingRule::Gamma:
    return fmt::format("H <= {:.3g} h", gamma) + friction;
  case BreakingRule::Baldock:
    if (!options.gamma)
    {
      return fmt::format("{}, gamma by the kh of each place", breakingRuleName(options.breaking)) + friction;
    }
    [[fallthrough]];
  default:
    return fmt::format("{}, gamma {:.3g}", breakingRuleName(options.breaking), gamma) + friction;
  }
}

void sayBreakers(vtkPolyData* lines, const Console& console)
{
  double range[2] = { 0.0, 0.0 };
  if (lines->GetNumberOfPoints() > 0)
  {
    lines->GetPointData()->GetArray("BreakerHeight")->GetRange(range);
  }
  console.say(lines->GetNumberOfLines() == 0
      ? "breakers none: no wave begins to break on neighbouring rays"
      : fmt::format("breakers {} lines of {} points, {:.3g} to {:.3g} m high", lines->GetNumberOfLines(),
          lines->GetNumberOfPoints(), range[0], range[1]));
}

// Of waves from a storm or a point: how far they have come, and the directions that they bring to the edges.
void saySource(vtkPolyData* rays, const Console& console)
{
  const auto distance = fieldNumber(rays, "SourceDistance");
  vtkDataArray* directions = rays->GetPointData()->GetArray("DirectionFrom");
  vtkDataArray* parents = rays->GetCellData()->GetArray("ParentRay");
  if (!distance || !directions || !parents)
  {
    return;
  }
  const double first = fieldNumber(rays, "DirectionFrom").value_or(0.0);
  double low = 0.0;
  double high = 0.0;
  for (vtkIdType ray = 0; ray < rays->GetNumberOfCells(); ++ray)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    rays->GetCellPoints(ray, count, ids);
    if (count > 0 && parents->GetComponent(ray, 0) < 0.0)
    {
      const double turn = std::remainder(directions->GetComponent(ids[0], 0) - first, 360.0);
      low = std::min(low, turn);
      high = std::max(high, turn);
    }
  }
  console.say(fmt::format(
    "source   {:.4g} m away; the waves first arrive from {:.5g} degrees, over the edges from {:.5g} to {:.5g}",
    *distance, first, wrapDegrees(first + low), wrapDegrees(first + high)));
}

// The choices that the scene made, where the call left them open.
void sayDefaults(vtkPolyData* rays, const Request& request, const Console& console)
{
  const TraceOptions& trace = request.rays.trace;
  const auto value = [&](const char* name) { return fieldNumber(rays, name).value_or(0.0); };
  const auto origin = [](bool given) { return given ? "" : " (from the scene)"; };
  if (!request.start.launch.empty() && rays->GetFieldData()->HasArray("LaunchPoints"))
  {
    console.say(fmt::format("launch   {:g} points of '{}', a ray each", value("LaunchPoints"), request.start.launch));
  }
  else
  {
    console.say(fmt::format("spacing  {:.4g} m{} over {:.4g} m of crest; a ray is inserted beyond {:.4g} m{}",
      value("LaunchSpacing"), origin(trace.spacing.has_value()), value("LaunchWidth"), value("MaxSpacing"),
      trace.maxSpacing ? "" : " (1.5 times that)"));
  }
  console.say((trace.step ? fmt::format("fronts   every {:.4g} m", *trace.step)
                          : fmt::format("fronts   {:.4g} a wavelength{}", value("StepsPerWave"),
                              origin(trace.stepsPerWave.has_value()))) +
    fmt::format("; amplitude by {}; breaking: {}",
      request.rays.height.amplitude == AmplitudeRule::Tube ? "the tube equation" : "ray spacing",
      breakingInWords(request.rays)));
}

void checkTrace(Request& request)
{
  checkRays(request.rays);
  checkMildSlope(request);
  checkEarth(request);
  checkStart(request);
  if (request.planOnly && (request.start.site || !request.map.waterLevels.empty() || !request.variation.empty()))
  {
    throw UsageError("--dry-run plans one trace; leave out --from-site, --water-levels and lists of values");
  }
  const OutputRequest& output = request.output;
  checkOutputs(output);
  if (output.table.empty() != request.map.stations.empty())
  {
    throw UsageError("--stations and --table belong together; give both");
  }
  if (output.file.empty() && output.crests.empty() && output.breakerLine.empty() && output.map.empty() &&
    output.table.empty() && !request.planOnly)
  {
    throw UsageError("trace has nothing to write: give -o FILE.vtp, --crests FILE.vtp, --breaker-line FILE.vtp, --map "
                     "FILE or --table FILE.csv");
  }
  if (!output.breakerLine.empty() && request.rays.height.breaking == BreakingRule::None)
  {
    throw UsageError("--breaker-line needs waves that break; leave out --breaking none");
  }
  checkLines(output);
  if (!request.map.waterLevels.empty())
  {
    if (output.table.empty() || !output.file.empty() || !output.crests.empty() || !output.breakerLine.empty() ||
      !output.map.empty())
    {
      throw UsageError("--water-levels makes a table of a series: give --stations and --table, and no other output");
    }
    if (request.seafloor.options.waterLevel != 0.0)
    {
      throw UsageError("--water-levels stands in place of --water-level; leave out one of the two");
    }
  }
  if (request.map.spacing && output.map.empty())
  {
    throw UsageError("--map-spacing needs --map FILE");
  }
}

void runTrace(const Request& request, Console& console)
{
  if (!request.map.waterLevels.empty())
  {
    traceWaterLevels(request, console);
    return;
  }
  if (request.start.site)
  {
    runFromSite(request, console);
    return;
  }
  if (request.mildSlope.wanted)
  {
    runMildSlope(request, console);
    return;
  }
  if (request.planOnly)
  {
    Pipeline pipeline(request, console);
    pipeline.readSeafloor();
    sayPlan(pipeline.planRays(), console);
    return;
  }
  // Every file is opened, and the stations are read, before the work that they wait for.
  const std::vector<std::string> inputs = inputFiles(request);
  std::vector<std::unique_ptr<OutputFile>> files;
  const auto open = [&](const std::string& path) -> const OutputFile*
  { return path.empty() ? nullptr : files.emplace_back(std::make_unique<OutputFile>(path, inputs)).get(); };
  const OutputFile* const raysFile = open(request.output.file);
  const OutputFile* const crestsFile = open(request.output.crests);
  const OutputFile* const breakerFile = open(request.output.breakerLine);
  const OutputFile* const mapFile = open(request.output.map);
  const OutputFile* const tableFile = open(request.output.table);
  std::optional<StationTable> stations;
  if (tableFile)
  {
    stations.emplace(request.map.stations);
  }

  Pipeline pipeline(request, console);
  const Stopwatch reading;
  vtkImageData* seafloor = pipeline.readSeafloor()->GetOutput();
  const double readSeconds = reading.seconds();
  const Stopwatch tracing;
  vtkPolyData* traced = pipeline.traceRays();
  saySource(traced, console);
  sayDefaults(traced, request, console);
  vtkPolyData* rays = pipeline.computeHeights();
  const double traceSeconds = tracing.seconds();

  const Stopwatch writing;
  if (raysFile)
  {
    writeLines(rays, "rays", *raysFile, request, console);
  }
  if (crestsFile)
  {
    writeLines(pipeline.makeCrests(), "crests", *crestsFile, request, console);
  }
  if (breakerFile)
  {
    vtkPolyData* lines = pipeline.makeBreakerLines();
    sayBreakers(lines, console);
    writeLines(lines, "breakers", *breakerFile, request, console);
  }
  if (mapFile)
  {
    writeMap(mapOfRays(rays, seafloor, request, console), *mapFile, request, console);
  }
  if (tableFile)
  {
    const auto places = stations->places(georeferenceOf(seafloor));
    const auto waves = wavesAt(places, rays, seafloor, request, console);
    stations->write(waves->GetPointData(), stationColumns(), "WaveHeight", *tableFile, console);
  }
  for (const auto& file : files)
  {
    file->commit();
  }

  sayRays(rays, console);
  sayHeights(rays, console);
  console.say(fmt::format(
    "time     {:.2f} s to read, {:.2f} s to trace, {:.2f} s to write", readSeconds, traceSeconds, writing.seconds()));
  std::string written;
  std::map<std::string, std::string> viewers;
  for (const auto& file : files)
  {
    written += (written.empty() ? "" : " and ") + file->path();
    if (file.get() != tableFile)
    {
      viewers[viewerOf(file->path())] += " " + file->path();
    }
  }
  std::string viewing;
  for (const auto& [viewer, names] : viewers)
  {
    viewing += (viewing.empty() ? "; open with: " : ", ") + viewer + names;
  }
  console.say(fmt::format("wrote    {}{}", written, viewing));
}

}

CommandSpec traceSpec(Request& request)
{
  CommandSpec spec{ "trace", "trace wave rays over a seafloor: states, directions, heights", true, {}, {} };
  spec.options = { outputFile("-o,--output", "rays, .vtp, .gpkg or .geojson", request.output.file, lineEndings()),
    outputFile("--crests", "crest lines, .vtp, .gpkg or .geojson", request.output.crests, lineEndings()),
    outputFile("--breaker-line", "lines where waves begin to break, .vtp, .gpkg or .geojson",
      request.output.breakerLine, lineEndings()),
    outputFile("--map", "wave heights and directions on a grid, .vti, .nc or .tif", request.output.map,
      { ".vti", ".nc", ".tif" }),
    text("--stations", "FILE", "points x,y or lon,lat a line, .csv", "", "Output", request.map.stations),
    outputFile("--table", "waves at the stations, .csv", request.output.table, { ".csv" }),
    text("--water-levels", "FILE", "series time,level (.csv): a row of the table a station and time", "", "Output",
      request.map.waterLevels),
    flag("--dry-run", "only say what the work will take", "Output", request.planOnly) };
  add(spec.options, lineOptions(request.output));
  add(spec.options, waveOptions(request.rays, true));
  add(spec.options, startOptions(request.start));
  add(spec.options, rayOptions(request.rays));
  add(spec.options, mildSlopeOptions(request.mildSlope));
  add(spec.options, mapOptions(request.map));
  add(spec.options, seafloorOptions(request.seafloor.options));
  allowLists(spec.options, { "--period", "--direction", "--height", "--water-level" });
  spec.examples =
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 -o rays.vtp --crests crests.vtp\n"
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 -o rays.gpkg --breaker-line breakers.geojson\n"
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 --map heights.nc --map-spacing 25\n"
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 --stations buoys.csv --table waves.csv\n"
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 --stations buoys.csv --water-levels tide.csv "
    "--table waves.csv\n"
    "  swellray trace shoal --period 10 --direction 270 --height 1 --current eddy:U0=1.5,R=400 -o rays.vtp\n"
    "  swellray trace harbour.tif --period 12 --direction 20 --height 2 --obstacles breakwater.geojson --reflection "
    "0.5 "
    "-o rays.vtp\n"
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 --method mild-slope --map heights.nc\n"
    "  swellray trace pacific.nc --earth ellipsoid --period 16 --from-storm 170,-50 --height 2 -o rays.vtp\n"
    "  swellray trace harbour.tif --period 8,12,16 --direction 200:260:10 --height 2 --stations buoys.csv --table "
    "waves.csv\n"
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 --spacing 10 --dry-run\n"
    "  swellray trace harbour.tif --period 14 --direction 135 --height 2 --launch offshore.geojson -o rays.vtp\n"
    "  swellray trace harbour.tif --period 14 --from-site 512300,6121400 --directions 180 -o ways.vtp\n"
    "  swellray trace babbage --period 10 --direction 270 --height 1 --spacing 5 -o rays.vtp\n"
    "  swellray trace bar --period 9 --direction 90 --height 1.5 --breaking dally --breaker-line breakers.vtp\n"
    "  swellray trace harbour.nc --water-level 1.2 --period 8 --direction 300 --height 1.5 --amplitude tube -o "
    "rays.vtp\n";
  spec.check = checkTrace;
  spec.run = runTrace;
  return spec;
}

}
