#include "RayStarts.h"

#include "Failure.h"
#include "FieldValues.h"
#include "FilterRun.h"
#include "LineOutput.h"
#include "OptionGroups.h"
#include "OptionKinds.h"
#include "Pipeline.h"
#include "StationTable.h"

#include "bathymetry/LineReader.h"
#include "sim/Angles.h"

#include <fmt/format.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSwellBackwardRays.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace swellray::cli
{

namespace
{

constexpr int UsualDirections = 72;

constexpr const char* StartGroup = "Where rays start";

vtkSmartPointer<vtkPolyData> readLaunchLines(const std::string& path, const Georeference& scene)
{
  std::vector<std::vector<glm::dvec2>> lines;
  try
  {
    lines = readPolyLines(path, scene);
  }
  catch (const std::runtime_error& error)
  {
    throw WorkError(fmt::format("launch {}", error.what()));
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const std::vector<glm::dvec2>& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const glm::dvec2& p : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(p.x, p.y, 0.0));
    }
  }
  auto launch = vtkSmartPointer<vtkPolyData>::New();
  launch->SetPoints(points);
  launch->SetLines(cells);
  return launch;
}

vtkSmartPointer<vtkPolyData> readLaunchPoints(const std::string& path, const Georeference& scene)
{
  const StationTable table(path);
  vtkSmartPointer<vtkPolyData> launch = table.places(scene);
  if (const auto numbers = table.numbers({ "direction", "directionfrom" }))
  {
    vtkNew<vtkDoubleArray> directions;
    directions->SetName("DirectionFrom");
    for (const double direction : *numbers)
    {
      directions->InsertNextValue(direction);
    }
    launch->GetPointData()->AddArray(directions);
  }
  return launch;
}

// The fan, in words: how much of it comes from offshore, and from where.
void sayFan(vtkPolyData* ways, const Console& console)
{
  vtkDataArray* offshore = ways->GetCellData()->GetArray("OffshoreDirectionFrom");
  vtkDataArray* time = ways->GetCellData()->GetArray("TravelTime");
  vtkDataArray* gain = ways->GetCellData()->GetArray("EnergyGain");
  vtkIdType come = 0;
  double earliest = 0.0;
  double latest = 0.0;
  double highest = 0.0;
  for (vtkIdType i = 0; i < ways->GetNumberOfCells(); ++i)
  {
    if (std::isfinite(offshore->GetComponent(i, 0)))
    {
      const double t = time->GetComponent(i, 0);
      earliest = come == 0 ? t : std::min(earliest, t);
      latest = std::max(latest, t);
      highest = std::max(highest, gain->GetComponent(i, 0));
      ++come;
    }
  }
  console.say(fmt::format("site     {:.4g} m deep; waves come there from offshore in {} of {} directions{}",
    ways->GetPointData()->GetArray("Depth")->GetComponent(ways->GetNumberOfPoints() - 1, 0), come,
    ways->GetNumberOfCells(),
    come > 0 ? fmt::format(", in {:.3g} to {:.3g} s from the edge, with up to {:.3g} times the energy a direction",
                 earliest, latest, highest)
             : ""));
  console.say("followed back " + tally(ways, "EndReason", endReasonWords()));
}

}

std::string tally(vtkPolyData* rays, const char* name, const std::vector<std::string>& words)
{
  std::vector<vtkIdType> counts(words.size(), 0);
  vtkDataArray* codes = rays->GetCellData()->GetArray(name);
  for (vtkIdType i = 0; codes && i < codes->GetNumberOfTuples(); ++i)
  {
    ++counts.at(static_cast<std::size_t>(codes->GetComponent(i, 0)));
  }
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    if (counts[i] > 0)
    {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[i], words[i]);
    }
  }
  return text;
}

const std::vector<std::string>& endReasonWords()
{
  static const std::vector<std::string> words{ "at a cap", "left the scene", "entered a hole", "aground",
    "between aground rays", "cancelled", "blocked by a current", "stopped by an obstacle" };
  return words;
}

OptionSpec launchOption(StartRequest& start)
{
  return text("--launch", "FILE",
    "lines (.geojson .gpkg .shp) or points (.csv: x,y or lon,lat, and a column direction) in place of the scene's "
    "edges",
    "", StartGroup, start.launch);
}

std::vector<OptionSpec> startOptions(StartRequest& start)
{
  const char* group = StartGroup;
  OptionSpec site{ "--from-site", "X,Y", "follow rays back to offshore from here, in the grid's own coordinates", "",
    group, false, {} };
  site.set = [&start](const std::string& typed)
  {
    const auto values = parseNumbers("--from-site", typed, PlainNumber);
    if (values.size() != 2)
    {
      throw UsageError(fmt::format("--from-site needs X,Y, not '{}'", typed));
    }
    start.site = { values[0], values[1] };
  };
  OptionSpec directions{ "--directions", "N", "directions at the site, around the circle",
    fmt::format("{}", UsualDirections), group, false, {} };
  directions.set = [&start](const std::string& typed)
  { start.directions = static_cast<int>(parseWhole("--directions", typed, 1, 1'000'000)); };
  return { launchOption(start), site, directions };
}

void checkStart(const Request& request)
{
  const StartRequest& start = request.start;
  if (start.directions && !start.site)
  {
    throw UsageError("--directions needs --from-site X,Y");
  }
  if (!start.launch.empty() && request.mildSlope.wanted)
  {
    throw UsageError("--launch is for rays; leave out --method mild-slope");
  }
  if (!start.site)
  {
    return;
  }
  checkPlane(request, "--from-site");
  const RayRequest& rays = request.rays;
  if (!start.launch.empty() || rays.directed || rays.source != RayRequest::Source::PlaneWave ||
    request.mildSlope.wanted)
  {
    throw UsageError("--from-site follows rays back from all directions; leave out --direction, --from-storm, "
                     "--from-point, --launch and --method mild-slope");
  }
  if (rays.trace.scheme == TraceScheme::Snell || rays.trace.step || rays.trace.spacing)
  {
    throw UsageError("--from-site takes neither --scheme snell, --step nor --spacing; --directions says how many rays");
  }
  const OutputRequest& output = request.output;
  if (output.file.empty() || !output.crests.empty() || !output.breakerLine.empty() || !output.map.empty() ||
    !output.table.empty())
  {
    throw UsageError("--from-site writes rays only: give -o FILE.vtp, .gpkg or .geojson");
  }
}

vtkSmartPointer<vtkPolyData> readLaunch(const Request& request, const Georeference& scene)
{
  const std::string& path = request.start.launch;
  const bool table = std::filesystem::path(path).extension() == ".csv";
  vtkSmartPointer<vtkPolyData> launch = table ? readLaunchPoints(path, scene) : readLaunchLines(path, scene);
  if (request.rays.directed || request.rays.source != RayRequest::Source::PlaneWave)
  {
    return launch;
  }
  vtkDataArray* directions = launch->GetPointData()->GetArray("DirectionFrom");
  bool known = directions != nullptr;
  for (vtkIdType i = 0; known && i < directions->GetNumberOfTuples(); ++i)
  {
    known = std::isfinite(directions->GetComponent(i, 0));
  }
  if (!known)
  {
    throw UsageError(fmt::format("trace needs --direction DEG: '{}' has no direction for {}", path,
      table ? "every point (column 'direction')" : "its lines"));
  }
  return launch;
}

void runFromSite(const Request& request, Console& console)
{
  OutputFile file(request.output.file, inputFiles(request));
  Pipeline pipeline(request, console);
  vtkSwellSeafloorReader* reader = pipeline.readSeafloor();
  const RayRequest& rays = request.rays;
  vtkNew<vtkSwellBackwardRays> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetSite((*request.start.site)[0], (*request.start.site)[1]);
  filter->SetNumberOfDirections(request.start.directions.value_or(UsualDirections));
  filter->SetPeriod(rays.wave.period);
  filter->SetOffshoreDepth(rays.wave.offshoreDepth);
  filter->SetGravity(rays.wave.gravity);
  filter->SetWaterLevel(request.seafloor.options.waterLevel);
  filter->SetTolerance(rays.trace.tolerance);
  if (rays.trace.stepsPerWave)
  {
    filter->SetStepsPerWave(*rays.trace.stepsPerWave);
  }
  if (rays.trace.agroundDepth)
  {
    filter->SetAgroundDepth(*rays.trace.agroundDepth);
  }
  filter->SetEdge(rays.trace.edge == EdgeRule::Edge ? vtkSwellBackwardRays::EDGE_EDGE
      : rays.trace.edge == EdgeRule::None           ? vtkSwellBackwardRays::EDGE_NONE
                                                    : vtkSwellBackwardRays::EDGE_CONTOURS);
  if (rays.trace.shoreNormal)
  {
    filter->UseShoreNormalOn();
    filter->SetShoreNormal(*rays.trace.shoreNormal);
  }
  filter->SetCurrent(rays.current.empty() ? nullptr : rays.current.c_str());
  filter->SetObstacles(rays.obstacles.empty() ? nullptr : rays.obstacles.c_str());
  runFilter(filter, "tracing", console);
  vtkPolyData* ways = filter->GetOutput();
  writeLines(ways, "ways", file, request, console);
  file.commit();
  sayFan(ways, console);
  console.say(fmt::format("wrote    {}; open with: {} {}", file.path(), viewerOf(file.path()), file.path()));
}

}
