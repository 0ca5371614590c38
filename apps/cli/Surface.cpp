#include "Commands.h"
#include "Failure.h"
#include "FieldValues.h"
#include "FrameSeries.h"
#include "OptionGroups.h"
#include "OptionKinds.h"
#include "Pipeline.h"
#include "RayStarts.h"
#include "RenderScene.h"
#include "SurfaceOptions.h"
#include "SurfaceTable.h"
#include "TimeSeriesOption.h"
#include "WorkPlan.h"

#include <fmt/format.h>

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace swellray::cli
{

namespace
{

// The picture of a camera.
constexpr std::array<int, 2> StandardPicture{ 1600, 900 };
constexpr int StandardStep = 8; // pixels

void checkSurface(Request& request)
{
  checkRays(request.rays);
  checkPlane(request, "surface");
  const SurfaceRequest& surface = request.surface;
  if (surface.at.empty() != request.output.table.empty())
  {
    throw UsageError("--at and --table belong together; give both");
  }
  if (request.planOnly && (!surface.components.empty() || request.render.sceneOnly))
  {
    throw UsageError("--dry-run plans the surface of one wave by its rays; leave out --component and --camera");
  }
  if (request.output.file.empty() && request.output.spray.empty() && request.output.foam.empty() &&
    request.output.table.empty() && !request.planOnly)
  {
    throw UsageError("surface has nothing to write: give -o FILE.vtp, -o FILE.pvd with --times, --spray FILE, --foam "
                     "FILE, or --at POINTS.csv --table FILE.csv");
  }
  if (surface.time && surface.times)
  {
    throw UsageError("--time and --times exclude each other; leave out one of the two");
  }
  for (const std::string& file : { request.output.file, request.output.spray, request.output.foam })
  {
    if (!file.empty() && isSeries(file) != surface.times.has_value())
    {
      throw UsageError(
        isSeries(file) ? "a .pvd series needs --times T0:T1:DT" : "--times needs a series to write: -o FILE.pvd");
    }
  }
  if (surface.straightPhase && (!request.output.spray.empty() || !request.output.foam.empty() || !surface.at.empty()))
  {
    throw UsageError("--spray, --foam and --at follow the traced phase; leave out --phase straight");
  }
  if ((surface.sprayRate || surface.spraySteepness) && request.output.spray.empty())
  {
    throw UsageError("--spray-rate and --spray-steepness need --spray FILE");
  }
  checkSurfaceOptions(surface);
  if (request.render.sceneOnly && (request.output.file.empty() || surface.straightPhase))
  {
    throw UsageError("--camera samples the surface of -o FILE by the traced phase; give -o, and leave out --phase "
                     "straight");
  }
  if (!request.render.sceneOnly && (request.render.size || surface.pixelStep))
  {
    throw UsageError("--size and --pixel-step need --camera");
  }
  if (surface.foamSpacing && request.output.foam.empty())
  {
    throw UsageError("--foam-spacing needs --foam FILE");
  }
  checkOutputs(request.output);
}

void saySurface(vtkDataSet* surface, const Console& console)
{
  console.say(fmt::format("surface  {}: {} points, {} triangles", fieldText(surface, "Section"),
    surface->GetNumberOfPoints(), surface->GetNumberOfCells()));
}

void saySpray(vtkDataSet* spray, const Console& console)
{
  console.say(fmt::format("spray    {} particles", spray->GetNumberOfPoints()));
}

void sayFoam(vtkDataSet* foam, const Console& console)
{
  int nodes[3];
  double spacing[3];
  vtkImageData::SafeDownCast(foam)->GetDimensions(nodes);
  vtkImageData::SafeDownCast(foam)->GetSpacing(spacing);
  console.say(fmt::format("foam     {} x {} nodes, {:g} x {:g} m apart", nodes[0], nodes[1], spacing[0], spacing[1]));
}

// What rays and surface will take, by those of a few rays: its points are as many as the rays'.
void planSurface(const Request& request, Console& console)
{
  Pipeline pipeline(request, console);
  pipeline.readSeafloor();
  const RayPlan plan = pipeline.planRays();
  sayPlan(plan, console);
  const SurfaceRequest& asked = request.surface;
  const auto begin = std::chrono::steady_clock::now();
  vtkPolyData* surface = pipeline.makeSurface(asked.times ? asked.times->first : asked.time.value_or(0.0));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const double frames = asked.times ? static_cast<double>(asked.times->count()) : 1.0;
  const Estimate share = (1.0 / plan.sampled) * plan.rays;
  constexpr double Kibibyte = 1024.0;
  console.say(fmt::format("surface  {} points, {} of memory, in each of {:.0f} frames; {} for all of them",
    (static_cast<double>(surface->GetNumberOfPoints()) * share).text(),
    memoryText(Kibibyte * static_cast<double>(surface->GetActualMemorySize()) * share), frames,
    timeText(frames * seconds.count() * share)));
}

void runSurface(const Request& request, Console& console)
{
  if (request.planOnly)
  {
    planSurface(request, console);
    return;
  }
  // Every file is opened, and the points are read, before the work that they wait for.
  const SurfaceRequest& surface = request.surface;
  const std::vector<std::string> inputs = inputFiles(request);
  std::vector<std::unique_ptr<OutputFile>> files;
  const auto open = [&](const std::string& path)
  {
    files.push_back(path.empty() ? nullptr : std::make_unique<OutputFile>(path, inputs));
    return files.back().get();
  };
  OutputFile* const surfaceFile = open(request.output.file);
  OutputFile* const sprayFile = open(request.output.spray);
  OutputFile* const foamFile = open(request.output.foam);
  OutputFile* const tableFile = open(request.output.table);
  std::optional<StationTable> points;
  if (tableFile)
  {
    points.emplace(surface.at);
  }
  Pipeline pipeline(request, console);
  vtkImageData* seafloor = pipeline.readSeafloor()->GetOutput();
  pipeline.traceRays();
  pipeline.computeHeights();
  std::vector<FrameSeries> series;
  std::vector<void (*)(vtkDataSet*, const Console&)> saying;
  const auto add = [&](OutputFile* file, const char* ending, auto make, auto say)
  {
    if (file)
    {
      series.push_back({ file, make, ending });
      saying.push_back(say);
    }
  };
  const bool seen = request.render.sceneOnly;
  const std::size_t workers = surface.times ? frameWorkers(surface.times->count()) : 1;
  std::vector<std::unique_ptr<Pipeline>> others;
  for (std::size_t i = 1; i < workers; ++i)
  {
    others.push_back(std::make_unique<Pipeline>(request, console));
    others.back()->shareWaves(pipeline);
  }
  const auto by = [&](std::size_t worker) -> Pipeline& { return worker == 0 ? pipeline : *others[worker - 1]; };
  for (std::size_t i = 0; seen && i < workers; ++i)
  {
    by(i).seeBy(cameraOf(request, seafloor), request.render.size.value_or(StandardPicture),
      surface.pixelStep.value_or(StandardStep));
  }
  add(
    surfaceFile, ".vtp",
    [&](std::size_t worker, double time)
    { return seen ? by(worker).makeSeenSurface(time) : by(worker).makeSurface(time); },
    saySurface);
  add(
    sprayFile, ".vtp", [&](std::size_t worker, double time) { return by(worker).makeSpray(time); }, saySpray);
  add(
    foamFile, ".vti", [&](std::size_t worker, double time) { return by(worker).makeFoamMap(time); }, sayFoam);
  if (surface.times && !series.empty())
  {
    writeFrames(
      series, *surface.times, request, console, workers, [&](vtkDataSet* data) { saying.front()(data, console); });
  }
  else
  {
    for (std::size_t i = 0; i < series.size(); ++i)
    {
      vtkDataSet* data = series[i].make(0, surface.time.value_or(0.0));
      saying[i](data, console);
      writeFrame(data, *series[i].file, request, console);
    }
  }
  if (tableFile)
  {
    writeSurfaceTable(pipeline, *points, seafloor, *tableFile, request, console);
  }
  for (const auto& written : files)
  {
    if (written)
    {
      written->commit();
      const bool table = written.get() == tableFile;
      console.say(table ? fmt::format("wrote    {}", written->path())
                        : fmt::format("wrote    {}; open with: paraview {}", written->path(), written->path()));
    }
  }
}

}

CommandSpec surfaceSpec(Request& request)
{
  CommandSpec spec{ "surface", "the breaking-wave surface with its foam and spray, at a time or as a series", true, {},
    {} };
  SurfaceRequest& surface = request.surface;
  OptionSpec points = number("--points-per-wave", "N", "points a wavelength along the rays", "as the profile needs",
    "Surface", surface.pointsPerWave, { "", 16.0, 10000.0 });
  OptionSpec camera = cameraOption(request.render);
  camera.help =
    "sample the surface of -o where this camera has pixels, not by the rays: on the beach, from the air, from "
    "above, or eye and what it looks at, in the grid's coordinates and metres of height";
  camera.standard = "none";
  camera.group = "Surface";
  OptionSpec size{ "--size", "WxH", "size of its picture, pixels", "1600x900", "Surface", false, {} };
  size.set = [&request](const std::string& typed) { request.render.size = parseSize("--size", typed); };
  OptionSpec step{ "--pixel-step", "N", "pixels from sample to sample", "8", "Surface", false, {} };
  step.set = [&surface](const std::string& typed)
  { surface.pixelStep = static_cast<int>(parseWhole("--pixel-step", typed, 1, 1000)); };
  spec.options = { outputFile("-o,--output", "surface, .vtp, or series, .pvd", request.output.file, { ".vtp", ".pvd" }),
    outputFile("--spray", "spray, .vtp, or series, .pvd", request.output.spray, { ".vtp", ".pvd" }),
    outputFile("--foam", "foam on a grid of still water, .vti, .nc or .tif, or series of .vti, .pvd",
      request.output.foam, { ".vti", ".nc", ".tif", ".pvd" }),
    text("--at", "FILE", "points x,y or lon,lat a line, and a column time where they have their own, .csv", "",
      "Output", surface.at),
    outputFile("--table", "the surface at these points, .csv", request.output.table, { ".csv" }),
    flag("--compress", "compress the files (smaller, slower)", "Output", request.output.compress),
    flag("--dry-run", "only say what rays and surface will take", "Output", request.planOnly), profileOption(surface),
    choice("--phase", "phase of the waves: as traced, or along straight lines (Peachey 1986)", "traced", "Surface",
      surface.straightPhase, std::vector<std::pair<std::string, bool>>{ { "traced", false }, { "straight", true } }),
    number("--time", "S", "time, s", "0", "Surface", surface.time, { "seconds" }),
    timesOption(surface.times, "Surface") };
  add(spec.options, surfaceOptions(surface));
  add(spec.options,
    { points,
      number("--foam-spacing", "M", "distance of the nodes of --foam, m", "that of the seafloor", "Surface",
        surface.foamSpacing, PositiveMetres),
      camera, size, step,
      number("--spray-rate", "N", "particles a metre of crest and metre by which its water is ahead of the wave", "20",
        "Surface", surface.sprayRate, { "", 0.0, 1e6 }),
      number("--spray-steepness", "R", "height over length from which on crests throw spray", "where the trace breaks",
        "Surface", surface.spraySteepness, { "", 0.0, 10.0, true }) });
  add(spec.options, waveOptions(request.rays, true));
  spec.options.push_back(launchOption(request.start));
  add(spec.options, rayOptions(request.rays));
  add(spec.options, seafloorOptions(request.seafloor.options));
  spec.examples =
    "  swellray surface babbage --period 6 --direction 15 --height 0.8 --time 3 -o babbage.vtp\n"
    "  swellray surface harbour.tif --period 14 --direction 135 --height 2 --profile jeschke --times 0:14:0.1 -o "
    "sea.pvd\n"
    "  swellray surface plane --period 12 --direction 270 --height 1.5 --profile vortex:threshold=0.1 -o tube.vtp\n"
    "  swellray surface babbage --period 6 --direction 0 --height 1.5 --times 0:6:0.04 -o sea.pvd --spray spray.pvd\n"
    "  swellray surface babbage --period 6 --direction 0 --height 1.5 --times 0:6:0.1 --foam foam.pvd --foam-spacing "
    "1\n"
    "  swellray surface bay --period 8 --direction 90 --height 1 --at buoys.csv --times 0:600:0.5 --table series.csv\n"
    "  swellray surface babbage --period 6 --direction 0 --height 1 --component 2,20,0.1 --component 2.5,-15,0.15 -o "
    "b.vtp\n"
    "  swellray surface babbage --period 6 --direction 0 --height 1.5 --group-waves 7 --times 0:84:0.1 -o sets.pvd\n"
    "  swellray surface babbage --period 6 --direction 0 --height 1.5 --camera shore --pixel-step 4 -o seen.vtp\n"
    "A series that was broken off goes on where it was when the same call is made again.\n";
  spec.check = checkSurface;
  spec.run = runSurface;
  return spec;
}

}
